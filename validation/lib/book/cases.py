"""Finding the cases: every script of a case's folder that defines CASE."""
import importlib.util
import re
import sys

from lib.case import VALIDATION


def scripts():
    return [path for path in sorted(VALIDATION.glob("*/*.py"))
            if path.parent.name not in ("lib", "book") and re.search(r"^CASE = \w+\.\w+\(", path.read_text(), re.MULTILINE)]


def folders():
    """Of all cases, those without criteria too."""
    return sorted({scene.parent for scene in VALIDATION.glob("*/*.toml")})


def load_all():
    """Cases by name, in the order of their names."""
    cases = [load(path) for path in scripts()]
    return {case.name: case for case in sorted(cases, key=lambda case: case.name)}


def load(path):
    """The CASE of a script. Scripts of different folders have modules of the same name (compare, measures, …): those are
    forgotten again, so that each finds its own."""
    spec = importlib.util.spec_from_file_location(f"{path.parent.name}.{path.stem}", path)
    module = importlib.util.module_from_spec(spec)
    sys.path.insert(0, str(path.parent))
    try:
        spec.loader.exec_module(module)
    finally:
        sys.path.remove(str(path.parent))
        for name, other in list(sys.modules.items()):
            if str(getattr(other, "__file__", None) or "").startswith(f"{path.parent}/"):
                del sys.modules[name]
    wanted = path.parent.name if path.stem == "compare" else f"{path.parent.name}_{path.stem}"
    if module.CASE.name != wanted:
        raise ValueError(f"{path}: found the case {module.CASE.name}, expected {wanted}: its part is the script's name")
    return module.CASE
