"""What the tests of a run's files have in common."""
import subprocess

SKIPPED = 77


def run(program, scene, folder, *settings, until=None, expect=0):
    """A run by the command; `settings` as for --set."""
    command = [program, "run", str(scene), "-o", str(folder)]
    for setting in settings:
        command += ["--set", setting]
    if until:
        command += ["--until", str(until)]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode != expect:
        raise SystemExit(f"{' '.join(command)}: exit code {done.returncode}, expected {expect}\n{done.stderr[-2000:]}")
    return folder
