"""What cases/*.toml state: a scene, its variants, the settings that are changed one at a time, limits with their reasons."""
import tomllib
from dataclasses import dataclass, field
from pathlib import Path

FOLDER = Path(__file__).resolve().parent
AXES = {"resolution": "method.spacing", "courant": "method.courant", "precision": "method.precision", "preset": "method.preset"}
KEYS = {"title", "scene", "asks", "set", "variant", "axes", "limits", "fast", "known", "scale"}


@dataclass
class Job:
    """One run, or one refusal, and what is expected of it."""
    case: str
    variant: str
    setting: str                  # "as stated", or what differs from it: "courant 0.1"
    scene: Path
    set: dict
    limits: dict
    threads: int = 1
    expect: list = field(default_factory=lambda: ["ok"])
    breaks: list = field(default_factory=list)  # the figures that must be beyond their limits if "out" is expected
    scale: object = "kinetic"
    twin: "Job" = None            # the run that this one must agree with
    known: list = field(default_factory=list)

    @property
    def name(self):
        return f"{self.case} / {self.variant} / {self.setting}"

    def folder(self, root):
        return root / self.case / _file_name(self.variant) / _file_name(self.setting)


@dataclass
class Case:
    name: str
    title: str
    asks: str
    limits: dict
    jobs: list


def load_cases(names=(), fast=False):
    """All cases, or those whose name starts with one of `names`; of each the full list of runs or the fast one."""
    paths = sorted((FOLDER / "cases").glob("*.toml"))
    chosen = [p for p in paths if not names or any(p.stem.startswith(n) for n in names)]
    cases = [_load(path, fast) for path in chosen]
    return [case for case in cases if case.jobs]


def _load(path, fast):
    data = tomllib.loads(path.read_text())
    unknown = set(data) - KEYS
    if unknown:
        raise SystemExit(f"{path}: unknown key {', '.join(sorted(unknown))}; known: {', '.join(sorted(KEYS))}")
    for name, limit in data["limits"].items():
        if "why" not in limit:
            raise SystemExit(f"{path}: limits.{name} has no `why`")
    base = {variant["name"]: variant for variant in data.get("variant", [{"name": "base"}])}
    jobs = _fast_jobs(path.stem, data, base) if fast else _all_jobs(path.stem, data, base)
    return Case(path.stem, data["title"], data["asks"], data["limits"], jobs)


def _all_jobs(case, data, variants):
    jobs = {}
    for name, variant in variants.items():
        jobs[name] = _job(case, data, variant, "as stated", {})
    listed = list(jobs.values())
    for axes in data.get("axes", []):
        for of in axes["of"]:
            for axis, values in axes.items():
                if axis != "of":
                    listed += [_axis_job(case, data, variants[of], jobs[of], axis, value) for value in values]
    for job in listed:
        if "twin" in variants[job.variant] and job.twin is None:
            job.twin = jobs[variants[job.variant]["twin"]]
    return listed


def _axis_job(case, data, variant, base, axis, value):
    """A setting that is no number or word is a table: its name, what it sets, what is then expected."""
    if axis == "threads":
        job = _job(case, data, variant, f"{value} threads", {})
        job.threads, job.twin = value, base
        job.limits = {**job.limits, "bits": {"most": 0, "why": "gather only, in a fixed order"}}
        return job
    if isinstance(value, dict):
        return _job(case, data, {**variant, **{k: value[k] for k in ("expect", "limits") if k in value}},
                    f"{axis} {value['name']}", value["set"])
    return _job(case, data, variant, f"{axis} {value}", {AXES[axis]: value})


def _fast_jobs(case, data, variants):
    listed = []
    for fast in data.get("fast", []):
        variant = dict(variants[fast.get("variant", "base")])
        variant["limits"] = {**variant.get("limits", {}), **fast.get("limits", {})}
        variant["expect"] = fast.get("expect", variant.get("expect", ["ok"]))
        name = ", ".join(word for word in (fast.get("name"), "fast") if word)
        job = _job(case, data, variant, name, fast.get("set", {}))
        listed.append(job)
        if fast.get("threads"):
            listed.append(_axis_job(case, data, {**variant, "set": {**variant.get("set", {}), **fast.get("set", {})}}, job,
                                    "threads", fast["threads"]))
            listed[-1].setting += ", fast"
    return listed


def _job(case, data, variant, setting, extra):
    """Limits of the variant replace those of the case by name; false takes one away."""
    limits = {**data["limits"], **variant.get("limits", {})}
    limits = {name: limit for name, limit in limits.items() if limit is not False}
    scene = FOLDER / "scenes" / variant.get("scene", data.get("scene", ""))
    job = Job(case, variant["name"], setting, scene, {**data.get("set", {}), **variant.get("set", {}), **extra}, limits)
    job.expect, job.breaks = variant.get("expect", ["ok"]), variant.get("breaks", [])
    if "out" in job.expect and not job.breaks:
        raise SystemExit(f"{case}: {variant['name']} expects \"out\" without `breaks`")
    job.scale = variant.get("scale", data.get("scale", "kinetic"))
    job.known = data.get("known", [])
    return job


def _file_name(text):
    return "".join(c if c.isalnum() or c in ".-" else "_" for c in text)
