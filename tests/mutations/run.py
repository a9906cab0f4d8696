#!/usr/bin/python3
"""Shows that the tests notice broken physics: breaks one thing after the other and tells which tests see it.

The sources are copied to a scratch folder once. There each mutation of mutations.toml is applied by itself, what depends on
it is built, and the validation cases that it names run in their quick form, and the unit tests that are linked with the
mutated file. Checks that were made before with the same sources are not made again, so that it may be stopped at any time
(Ctrl-C) and started again. Writes results.md.

Exit code: 0 if every mutation is noticed, 1 if not, 2 if a mutation cannot be applied or built.
"""
import argparse
import hashlib
import json
import os
import re
import signal
import subprocess
import sys
import time
import tomllib
from contextlib import contextmanager, suppress
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
UNMUTATED = {"name": "(none)"}
MATTER = (".hpp", ".cpp", ".def", ".py", ".toml", ".csv", ".txt")  # files that the outcome of a check depends on
# What takes longer than this hangs: unmutated, the longest case takes 30 s of two cores, test_engine some minutes. [s]
LONGEST = {"validation": 600.0, "test": 900.0}
STOPPED = {-signal.SIGINT, -signal.SIGKILL, -signal.SIGTERM}  # exit codes that tell nothing of the program
# Instruction sets of neighbor/isa.cmake, worst first, and what a processor says if it has them.
LEVELS = {"baseline": set(), "avx2": {"avx2", "fma"}, "avx512": {"avx512f", "avx512bw", "avx512dq", "avx512vl"}}


class Error(Exception):
    """Of the list or of the build; the text is for the user."""


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--scratch", type=Path, default=ROOT / "results" / "mutations",
                        help="folder of copy and build [%(default)s]")
    parser.add_argument("--only", nargs="+", metavar="NAME", help="mutations of this list alone")
    parser.add_argument("--tests", nargs="*", choices=("kernels", "engine"), default=["kernels"],
                        help="unit tests to run beside the validation cases [kernels]")
    parser.add_argument("--first", action="store_true",
                        help="no further case for a mutation that one has noticed: for a quick look")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="of the build, and runs at a time [%(default)s]")
    parser.add_argument("--again", action="store_true", help="make also the checks that were made before")
    parser.add_argument("--report", action="store_true", help="only write results.md from the checks that were made")
    return parser.parse_args()


# The list

def read_mutations():
    mutations = tomllib.loads((HERE / "mutations.toml").read_text())["mutation"]
    names = [m["name"] for m in mutations]
    if double := {name for name in names if names.count(name) > 1}:
        raise Error(f"mutations.toml: found twice: {', '.join(sorted(double))}")
    for m in mutations:
        mutated_text(m)
    return mutations


def mutated_text(mutation):
    """The file's text with the mutation applied."""
    text = (ROOT / mutation["file"]).read_text()
    found = text.count(mutation["old"])
    if found != 1:
        raise Error(f"{mutation['name']}: found {found} times in {mutation['file']}, expected once: {mutation['old']}")
    return text.replace(mutation["old"], mutation["new"])


def case_names():
    """As validation/CMakeLists.txt finds them."""
    scripts = [path for path in sorted((ROOT / "validation").glob("*/*.py"))
               if re.search(r"^CASE = [a-z]+\.[A-Za-z_]+\(", path.read_text(), re.MULTILINE)]
    return sorted(path.parent.name + ("" if path.stem == "compare" else f"_{path.stem}") for path in scripts)


def checks_of(mutation, tests):
    """("validation" | "test", name); a unit test that is not linked with the file cannot notice."""
    for case in mutation["cases"]:
        yield "validation", case
    for test in tests:
        if test == "engine" or not mutation["file"].startswith("engine/"):
            yield "test", test


# The copy

def tracked_files():
    listed = subprocess.run(["git", "ls-files", "-z"], cwd=ROOT, capture_output=True, check=True).stdout.decode()
    return [name for name in listed.split("\0") if name and (ROOT / name).is_file()]


def copy_sources(source):
    """Writes what differs only: what is unchanged is not built again. This also takes back a mutation that was left."""
    for name in tracked_files():
        there, ours = source / name, (ROOT / name).read_bytes()
        if there.exists() and there.read_bytes() == ours:
            continue
        there.parent.mkdir(parents=True, exist_ok=True)
        there.write_bytes(ours)
        there.chmod((ROOT / name).stat().st_mode)


@contextmanager
def applied(shop, mutation):
    """The mutated file is as old as it was: only what is deleted is built again."""
    if mutation is UNMUTATED:
        yield
        return
    path, start = shop.source / mutation["file"], time.time()
    old = path.stat()
    path.write_text(mutated_text(mutation))
    os.utime(path, ns=(old.st_atime_ns, old.st_mtime_ns))
    try:
        shop.forget(mutation, everything=False)
        yield
    finally:
        path.write_bytes((ROOT / mutation["file"]).read_bytes())
        os.utime(path, ns=(old.st_atime_ns, old.st_mtime_ns))
        shop.forget(mutation, everything=True, since=start - 1)


# Building and checking

class Workshop:
    """The copy, its build, and what was found out so far."""

    def __init__(self, options):
        # The build within the copy, as in a clone: so a compiler cache (ccache) knows what it has built there.
        self.source, self.build = options.scratch / "source", options.scratch / "source" / "build"
        self.runs, self.jobs = options.scratch / "runs", options.jobs
        self.store = options.scratch / "checks.json"
        self.found = json.loads(self.store.read_text()) if self.store.exists() else {}
        self.digests = {}

    def prepare(self):
        copy_sources(self.source)
        if not (self.build / "build.ninja").exists():  # a mutation may leave a name unused: no warning counts
            self.call(["cmake", "-S", self.source, "-B", self.build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
                       "-DSLUICE_BENCH=OFF", "-DSLUICE_FEW_PIECES=OFF"])
        self.make(["sluice_command"])  # without a mutation

    def forget(self, mutation, everything, since=0.0):
        """Deletes the objects that a mutation concerns, so that they are built again. Not everything: not the loops of
        instruction sets that do not run, nor what only includes the mutated file where the list names its callers. These would
        take most of a build."""
        slow = tuple(f"_{level}.dir" for level in LEVELS if level != best_level())
        callers = [Path(caller).name + ".o" for caller in mutation.get("callers", ())]
        for path in self.objects_of(mutation["file"]):
            left = path.parent.name.endswith(slow) or callers and path.name not in callers
            if path.exists() and path.stat().st_mtime >= since and (everything or not left):
                path.unlink()

    def objects_of(self, file):
        """That include it, as far as they are built."""
        told = subprocess.run(["ninja", "-C", self.build, "-t", "deps"], stdout=subprocess.PIPE, text=True, check=True).stdout
        for block in told.split("\n\n"):
            name, *files = block.split("\n")
            if any(one.endswith(f"/{file}") for one in files):
                yield self.build / name.split(":")[0]

    def make(self, targets):
        self.call(["ninja", "-C", self.build, "-j", str(self.jobs), *targets])

    def call(self, command):
        pipes = {"stdout": subprocess.PIPE, "stderr": subprocess.STDOUT, "text": True}
        with subprocess.Popen([*map(str, command)], **pipes) as child:
            try:
                said, _ = child.communicate()
            except KeyboardInterrupt:  # no compiler may read the sources that are taken back: a cache would keep what it makes
                child.terminate()
                child.communicate()
                raise
        if child.returncode:
            raise Error(said[-4000:])

    def check(self, kind, name):
        """What noticed: an empty text if the check passes."""
        words, code, said = self.command(kind, name), None, ""
        pipes = {"stdout": subprocess.PIPE, "stderr": subprocess.STDOUT, "text": True}
        with subprocess.Popen(words, **pipes, start_new_session=True) as child:
            try:
                said, _ = child.communicate(timeout=LONGEST[kind])
                code = child.returncode
            except (subprocess.TimeoutExpired, KeyboardInterrupt) as reason:
                with suppress(ProcessLookupError):  # it may just have ended
                    os.killpg(child.pid, signal.SIGTERM)  # the runs that it has started too
                child.communicate()
                if isinstance(reason, KeyboardInterrupt):
                    raise
        if code in STOPPED:
            raise Error(f"{name}: stopped from outside")
        return "" if code == 0 else symptom(kind, code, said)

    def command(self, kind, name):
        if kind == "test":
            return [self.build / "bin" / f"test_{name}"]
        return [self.source / "validation" / "book.py", self.runs, "--quick", "--again", "--jobs", str(self.jobs),
                "--only", name, "--sluice", self.build / "bin" / "sluice"]

    def key(self, mutation, kind, name):
        """Of a check: changes with all that its outcome depends on."""
        parts = ["neighbor", "kernels"] + (["engine"] if kind == "validation" or name == "engine" else [])
        parts += [f"tests/{name}"] if kind == "test" else [f"validation/{folder_of(name)}", "validation/lib"]
        change = [mutation.get(word, "") for word in ("file", "old", "new")]
        return f"{mutation['name']} {name} " + digest([*change, *(self.digest_of(part) for part in parts)])

    def digest_of(self, part):
        if part not in self.digests:
            files = [path for path in sorted((ROOT / part).rglob("*")) if path.suffix in MATTER]
            self.digests[part] = digest(text for path in files for text in (str(path.relative_to(ROOT)), path.read_text()))
        return self.digests[part]

    def keep(self, key, outcome):
        self.found[key] = outcome
        fresh = self.store.with_suffix(".new")
        fresh.write_text(json.dumps(self.found, indent=1))
        fresh.replace(self.store)


def digest(texts):
    return hashlib.sha256("\0".join(texts).encode()).hexdigest()[:16]


def best_level():
    """That the program takes (neighbor/isa.cpp)."""
    flags = set(Path("/proc/cpuinfo").read_text().split())
    return max((level for level in LEVELS if LEVELS[level] <= flags), key=list(LEVELS).index)


def folder_of(case):
    return max((path.name for path in (ROOT / "validation").iterdir() if case.startswith(path.name)), key=len)


def symptom(kind, code, said):
    """A few words: the first criterion that failed, how a run ended, or how many unit tests failed."""
    if code is None:
        return "no end"
    if kind == "test":
        counts = re.search(r"test cases: *\d+ \|.*?(\d+) failed", said)
        return f"{counts[1]} failed" if counts else f"exit code {code}"
    if failed := re.findall(r"^ *FAIL +(.*)$", said, re.MULTILINE):
        return failed[0]
    if wrong := re.findall(r"^\S*Error: .*$", said, re.MULTILINE):
        return f"cannot be judged: {wrong[-1]}"
    ended = re.search(r"BROKEN\n.*?: (.*)", said)
    return f"the run failed: {ended[1]}" if ended else f"exit code {code}"


# The way through the list

class Progress:
    def __init__(self, count):
        self.count, self.done, self.start = count, 0, time.monotonic()

    def say(self, mutation, text):
        self.done += 1
        left = (time.monotonic() - self.start) / self.done * (self.count - self.done)
        print(f"[{self.done:3} of {self.count}, {left / 60:4.0f} min left] {mutation['name']}: {text}", flush=True)


def work(shop, mutations, options):
    """Makes all checks that are lacking, first those of the unmutated program: what fails there proves nothing. Returns how
    many mutations could not be built."""
    todo = plan(shop, mutations, options)
    progress = Progress(sum(len(checks) for _, checks in todo))
    failed_builds = 0
    for m, checks in todo:
        try:
            with applied(shop, m):
                run_checks(shop, m, checks, progress, options.first)
        except Error as error:
            if m is UNMUTATED:
                raise
            failed_builds += 1
            progress.done += len(checks)
            print(f"{m['name']}: cannot be built or checked\n{error}", file=sys.stderr)
        write_results(shop, read_mutations())
    return failed_builds


def plan(shop, mutations, options):
    """(mutation, [(key, kind, name)]) of all that has something lacking."""
    lists = [(m, list(checks_of(m, options.tests))) for m in mutations]
    needed = sorted({check for _, checks in lists for check in checks}, key=lambda check: (check[0] == "test", check[1]))
    todo = []
    for m, checks in [(UNMUTATED, needed), *lists]:
        keyed = [(shop.key(m, *check), *check) for check in checks]
        lacking = [one for one in keyed if options.again or one[0] not in shop.found]
        noticed = m is not UNMUTATED and any(shop.found.get(key) for key, kind, _ in keyed if kind == "validation")
        if options.first and noticed and not options.again:
            lacking = [one for one in lacking if one[1] == "test"]
        if lacking:
            todo.append((m, lacking))
    return todo


def run_checks(shop, mutation, checks, progress, first):
    """Validation cases first: the command is built sooner than the tests."""
    for kind in ("validation", "test"):
        ours = [one for one in checks if one[1] == kind]
        if not ours:
            continue
        if kind == "test" and mutation is not UNMUTATED:
            shop.forget(mutation, everything=True)  # they compare the instruction sets
        shop.make(sorted({target(kind, name) for _, _, name in ours}))
        for key, _, name in ours:
            seen = shop.check(kind, name)
            shop.keep(key, seen)
            progress.say(mutation, f"{name} " + (f"noticed ({seen})" if seen else "passed"))
            if seen and first and kind == "validation" and mutation is not UNMUTATED:
                break


def target(kind, name):
    return "sluice_command" if kind == "validation" else f"test_{name}"


# The report

def outcome(shop, mutation, kind, name):
    """None if the check has not been made, or fails without any mutation."""
    plain = shop.found.get(shop.key(UNMUTATED, kind, name))
    return shop.found.get(shop.key(mutation, kind, name)) if plain == "" else None


def row_of(shop, m):
    cases = {case: outcome(shop, m, "validation", case) for case in m["cases"]}
    seen = [f"{case}: {text.replace('|', '/')}" for case, text in cases.items() if text]
    passed = [case for case, text in cases.items() if text == ""]
    tests = {name: outcome(shop, m, kind, name) for kind, name in checks_of(m, ("kernels", "engine")) if kind == "test"}
    units = [f"{name}: {text or 'none'}" for name, text in tests.items() if text is not None]
    open_ones = [case for case, text in cases.items() if text is None]
    verdict = "; ".join(seen) or ("not yet run" if open_ones else f"**survives**. {m.get('survives', '')}".strip())
    return [f"`{m['name']}`", m["breaks"], verdict, ", ".join(passed) or "–", "; ".join(units) or "–"]


def write_results(shop, mutations):
    rows = [row_of(shop, m) for m in mutations]
    noticed = sum(any(outcome(shop, m, "validation", case) for case in m["cases"]) for m in mutations)
    survivors = sum("**survives**" in row[2] for row in rows)
    lines = ["# Mutations: results", "", "Written by `tests/mutations/run.py`. "
             f"{len(mutations)} mutations: {noticed} noticed by validation, {survivors} survive there, "
             f"{len(mutations) - noticed - survivors} not yet run.", "",
             *table(["mutation", "what it breaks", "noticed by", "passed all the same", "unit tests"], rows), "",
             "*Noticed by*: each validation case in its quick form, with the first criterion that failed. *Unit tests*: of "
             "`test_kernels` (and `test_engine`) how many test cases fail; – is for those not linked or not run.", "",
             "## Cases", "", *table(["case", "notices", "of"], [case_row(shop, mutations, case) for case in case_names()])]
    (HERE / "results.md").write_text("\n".join(lines) + "\n")


def case_row(shop, mutations, case):
    outcomes = {m["name"]: outcome(shop, m, "validation", case) for m in mutations if case in m["cases"]}
    made = {name: text for name, text in outcomes.items() if text is not None}
    return [case, ", ".join(f"`{name}`" for name, text in made.items() if text) or "–", str(len(made))]


def table(header, rows):
    return ["| " + " | ".join(row) + " |" for row in [header, ["---"] * len(header), *rows]]


def main():
    options = arguments()
    mutations = read_mutations()
    unnamed = set(case_names()) - {case for m in mutations for case in m["cases"]}
    if unnamed:
        raise Error(f"mutations.toml: no mutation for {', '.join(sorted(unnamed))}")
    unknown = {case for m in mutations for case in m["cases"]} - set(case_names())
    unknown |= set(options.only or ()) - {m["name"] for m in mutations}
    if unknown:
        raise Error(f"there is no {', '.join(sorted(unknown))}")
    os.nice(5)
    shop = Workshop(options)
    failed_builds = 0
    if not options.report:
        shop.prepare()
        failed_builds = work(shop, [m for m in mutations if not options.only or m["name"] in options.only], options)
    write_results(shop, mutations)
    survivors = [m["name"] for m in mutations if "**survives**" in row_of(shop, m)[2]]
    print(f"{HERE / 'results.md'}: " + (f"{len(survivors)} survive: {', '.join(survivors)}" if survivors else "no survivors"))
    return 2 if failed_builds else 1 if survivors else 0


if __name__ == "__main__":
    signal.signal(signal.SIGTERM, signal.default_int_handler)  # is Ctrl-C too: the program that runs must be stopped
    try:
        sys.exit(main())
    except KeyboardInterrupt:
        print("Stopped; what is done is kept, the same command goes on from here.")
        sys.exit(130)
    except Error as error:
        print(error, file=sys.stderr)
        sys.exit(2)
