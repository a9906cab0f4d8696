"""Starting `sluice run` for a list of settings, one at a time; what is done already is not run again."""
import json
import shlex
import subprocess
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SLUICE = ROOT / "build" / "bin" / "sluice"


def scene_hash(scene, settings, sluice=SLUICE):
    """Hash of the scene with its changes, as `sluice check` prints it."""
    text = subprocess.run([sluice, "check", scene, *_sets(settings)], check=True, capture_output=True, text=True).stdout
    return next(line.split()[-1] for line in text.splitlines() if line.startswith("scene hash"))


def run(scene, folder, settings, sluice=SLUICE, options=()):
    """Runs the scene into the folder, unless the folder holds the finished run of the very same scene."""
    folder = Path(folder)
    label = " ".join(f"{key}={value}" for key, value in settings.items()) or "as it stands"
    if _finished(folder, scene_hash(scene, settings, sluice)):
        print(f"{folder.name}: done before ({label})", flush=True)
        return
    print(f"{folder.name}: running ({label})", flush=True)
    command = [str(sluice), "run", str(scene), "-o", str(folder), *_sets(settings), *options]
    result = subprocess.run(command, capture_output=True, text=True)
    if result.returncode not in (0, 1):  # 1: it failed numerically, which is a result
        raise SystemExit(f"{shlex.join(command)}\n{result.stderr}")


def _sets(settings):
    return [word for key, value in settings.items() for word in ("--set", f"{key}={value}")]


def _finished(folder, wanted):
    try:
        summary = json.loads((folder / "summary.json").read_text())
    except (OSError, ValueError):
        return False
    return summary.get("status") == "done" and summary.get("scene_hash") == wanted
