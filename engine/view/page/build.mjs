// Builds viewer.html, the page without a run: `npm ci && npm run build`. The same sources give the same bytes.
// Usage: node build.mjs [OUTPUT]
import { readFile, writeFile } from "node:fs/promises";
import { build } from "esbuild";

const libraries = { "twgl.js": "LICENSE.md", uplot: "LICENSE" };

const bundled = async (entry) => {
    const result = await build({
        entryPoints: [entry],
        bundle: true,
        minify: true,
        write: false,
        format: "iife",
        target: "es2022",
        charset: "utf8",
        legalComments: "inline",
        logLevel: "warning",
    });
    return result.outputFiles[0].text.trim();
};

// The libraries' licences ask to be passed on with every copy.
const licences = async () => {
    const texts = [];
    for (const [name, file] of Object.entries(libraries)) {
        const { version } = JSON.parse(await readFile(`node_modules/${name}/package.json`, "utf8"));
        const text = (await readFile(`node_modules/${name}/${file}`, "utf8")).replaceAll("\r", "").trim();
        texts.push(`${name} ${version}\n\n${text.replaceAll("--", "- -")}`);
    }
    return texts.join("\n\n");
};

const page = await readFile("src/page.html", "utf8");
const script = (await bundled("src/main.ts")).replaceAll("</script", "<\\/script");
const parts = {
    "<!--LICENCES-->": `<!--\nThis page holds parts of\n\n${await licences()}\n-->`,
    "/*STYLE*/": await bundled("src/style.css"),
    "/*SCRIPT*/": script,
};
let text = page;
for (const [mark, content] of Object.entries(parts)) text = text.replace(mark, () => content);
await writeFile(process.argv[2] ?? "viewer.html", text);
