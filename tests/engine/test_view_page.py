"""The page of `sluice view` in a browser. Usage: test_view_page.py PROGRAM SCENES [FOLDER FOR SCREENSHOTS]

77 = skipped: no chromium here.
"""
import subprocess
import sys
import tempfile
from pathlib import Path

from browser import Browser, find_browser

SKIPPED = 77
SHOW = "(() => { const s = document.getElementById('slider'); s.value = %d; s.oninput(); })()"
PIXELS = """const c = document.getElementById('picture'), gl = c.getContext('webgl2');
    const p = new Uint8Array(4 * c.width * c.height);
    gl.readPixels(0, 0, c.width, c.height, gl.RGBA, gl.UNSIGNED_BYTE, p);"""
# How many pixels are not background.
INK = f"""(() => {{
    {PIXELS}
    let n = 0;
    for (let i = 3; i < p.length; i += 4) n += p[i] > 0;
    return n;
}})()"""
# A number that is another one for another picture; the second frame from now is drawn by what is set now.
HASH = f"""new Promise(done => requestAnimationFrame(() => requestAnimationFrame(() => {{
    {PIXELS}
    let h = 0;
    for (const x of p) h = (31 * h + x) | 0;
    done(h);
}})))"""
COLORS = "document.querySelectorAll('#colors select')[0]"


def make_run(program, scene, folder, settings):
    words = [program, "run", str(scene), "-o", str(folder)]
    for setting in settings:
        words += ["--set", setting]
    subprocess.run(words, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    subprocess.run([program, "view", str(folder)], check=True, stdout=subprocess.DEVNULL)


def counts(folder):
    import json
    summary = json.loads((folder / "summary.json").read_text())
    series = json.loads((folder / "frames" / "frames.hdf.series").read_text())
    particles = sum(summary["particles"][kind] for kind in ("fluid", "solid", "wall"))
    return particles, len(series["files"])


def check(condition, words):
    if not condition:
        raise AssertionError(words)


def check_page(browser, address, folder):
    browser.open(address)
    browser.wait_for("window.sluice && window.sluice.ready")
    particles, frames = counts(folder)
    status = browser.value("window.sluice")
    check(status["particles"] == particles, f"{status['particles']} particles, expected {particles}")
    check(status["frames"] == frames, f"{status['frames']} frames, expected {frames}")
    browser.wait_for(f"window.sluice.drawn == {particles}")
    check(browser.value(INK) > 100, "nothing is drawn")

    # The slider, the keys, and playing.
    browser.value(SHOW % (frames - 1))
    browser.wait_for(f"window.sluice.frame == {frames - 1}")
    browser.press("Home")
    browser.wait_for("window.sluice.frame == 0")
    browser.press(" ")
    browser.wait_for("window.sluice.playing && window.sluice.frame >= 2")
    browser.press(" ")
    browser.wait_for("!window.sluice.playing")

    # Hiding every group leaves nothing; the theme turns.
    boxes = "document.querySelectorAll('#groups input').forEach(box => box.click())"
    browser.value(boxes)
    browser.wait_for(f"{INK} == 0")
    browser.value(boxes)
    browser.wait_for(f"{INK} > 100")
    theme = browser.value("document.documentElement.dataset.theme")
    browser.press("t")
    browser.wait_for(f"document.documentElement.dataset.theme != '{theme}'")
    browser.press("t")

    # Every field of the fluid can be shown, and all but one colour differ from it: the water is deep and moves.
    pictures = {}
    for field in browser.value(f"[...{COLORS}.options].map(option => option.value)"):
        browser.value(f"(() => {{ const s = {COLORS}; s.value = '{field}'; s.onchange(); }})()")
        pictures[field] = browser.value(HASH)
    check({"", "speed", "pressure"} <= set(pictures), f"fields {sorted(pictures)}")
    for field in ("speed", "pressure"):
        check(pictures[field] != pictures[""], f"{field} is drawn in one colour")
        browser.value(f"(() => {{ const s = {COLORS}; s.value = '{field}'; s.onchange(); }})()")
        check(browser.value(HASH) == pictures[field], f"{field} is drawn in other colours the second time")

    # A click on a particle shows its values, one on a curve leads to its time.
    centre = browser.value(f"""(() => {{
        {PIXELS}
        const r = c.getBoundingClientRect(), inked = [];
        for (let i = 0; i < c.width * c.height; ++i) if (p[4 * i + 3] == 255) inked.push(i);
        const i = inked[inked.length >> 1];
        return [r.x + i % c.width, r.y + c.height - Math.floor(i / c.width)];
    }})()""")
    browser.click(*centre)
    browser.wait_for("document.querySelectorAll('#pick tr').length > 3")
    if browser.value("document.querySelector('.u-over') !== null"):
        at = browser.value("(() => { const r = document.querySelector('.u-over').getBoundingClientRect();"
                           " return [r.right - 2, r.y + 0.5 * r.height]; })()")
        browser.click(*at)
        browser.wait_for(f"window.sluice.frame == {frames - 1}")
    check(browser.value("window.sluice.errors") == [], "the page reports errors")
    check(browser.problems == [], f"the console says {browser.problems}")


def check_served(program, folder):
    server = subprocess.Popen([program, "view", str(folder), "--serve=0"], stdout=subprocess.PIPE, text=True)
    try:
        address = next(word for word in server.stdout.readline().split() if word.startswith("http://127.0.0.1:"))
        with Browser() as browser:
            browser.open(address)
            browser.wait_for("window.sluice && window.sluice.ready")
            particles, frames = counts(folder)
            browser.wait_for(f"window.sluice.frames == {frames} && window.sluice.particles == {particles}")
            check(browser.value("window.sluice.errors") == [], "the served page reports errors")
    finally:
        server.kill()
        server.wait()


def main():
    if not find_browser():
        print("skipped: no chromium here (Debian: apt install chromium)")
        return SKIPPED
    program, scenes = sys.argv[1], Path(sys.argv[2])
    pictures = Path(sys.argv[3]) if len(sys.argv) > 3 else None
    with tempfile.TemporaryDirectory() as work:
        runs = {"gate": ("small_gate.toml", []), "water_3d": ("still_water_3d.toml", [])}
        for name, (scene, settings) in runs.items():
            folder = Path(work) / name
            make_run(program, scenes / scene, folder, settings)
            with Browser() as browser:
                check_page(browser, (folder / "view.html").as_uri(), folder)
                asked = [url for url in browser.requests if url.startswith("http")]
                check(asked == [], f"a page on the disk asks the network for {asked}")
                if pictures:
                    browser.screenshot(pictures / f"{name}.png")
        check_served(program, Path(work) / "gate")
    print("the page shows its runs")
    return 0


if __name__ == "__main__":
    sys.exit(main())
