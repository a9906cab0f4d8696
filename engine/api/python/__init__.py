"""sluice in Python: scenes, simulations whose fields are NumPy arrays, and whole runs. engine/USING.md has examples."""
import json as _json
import os as _os
from pathlib import Path as _Path


def _load():
    """GCC's OpenMP reads its settings once, when it is loaded. Left alone its threads spin for a millisecond at each barrier,
    which is ruinous where another program runs too (1,500 steps of the small gate on two busy processors: 6 to 13 s
    against 0.75 s); the command sets the same."""
    name = "GOMP_SPINCOUNT"
    ours = not any(key in _os.environ for key in (name, "OMP_WAIT_POLICY"))
    if ours:
        _os.environ[name] = "1000"
    try:
        from . import _sluice
    finally:
        if ours:
            del _os.environ[name]
    return _sluice


_engine = _load()
__version__ = _engine.__version__
CheckpointError, Error, NumericalError, OutputError = (
    _engine.CheckpointError, _engine.Error, _engine.NumericalError, _engine.OutputError)
Particles, Scene, SceneError = _engine.Particles, _engine.Scene, _engine.SceneError
for _class in (CheckpointError, Error, NumericalError, OutputError, Particles, Scene, SceneError):
    _class.__module__ = __name__


class Simulation(_engine.Simulation):
    """A scene that is stepped through time. `scene` is a Scene or the path of a scene file, `set` holds changes to a file
    as with --set, `threads` = 0 takes as many as OpenMP offers."""

    def __init__(self, scene, set=(), threads=0):
        super().__init__(_scene(scene, set), threads)


def _scene(scene, changes):
    if not isinstance(scene, Scene):
        return Scene.from_file(str(scene), list(changes))
    if changes:
        raise TypeError("`set` belongs to a scene file; give it to Scene.from_file or Scene.from_text")
    return scene


def _summary(directory):
    return _json.loads((_Path(directory) / "summary.json").read_text())


def run(scene, directory, set=(), until=None, threads=0, progress=False):
    """Runs a scene as `sluice run` does, with its files in `directory`; returns what is in summary.json.

    Ctrl-C writes a checkpoint and raises KeyboardInterrupt; `resume` goes on from there. Raises SceneError,
    NumericalError (what was written before stays readable), OutputError."""
    _engine.run(_scene(scene, set), str(directory), until, threads, progress)
    return _summary(directory)


def resume(directory, until=None, threads=0, progress=False):
    """Goes on with a stopped run, to the same results as if it had not been stopped; returns what is in summary.json."""
    _engine.resume(str(directory), until, threads, progress)
    return _summary(directory)
