"""A finished run as `sluice run` leaves it: summary.json, probes.csv, and one VTKHDF file per frame."""
import csv
import json
from pathlib import Path

import h5py
import numpy as np

FLUID, SOLID, WALL = 0, 1, 2  # values of the field `phase`


class RunError(Exception):
    """A run that cannot be read."""


class Frame:
    """One frame; fields are read when asked for."""

    def __init__(self, path, time):
        self.path, self.time = path, time
        with h5py.File(path, "r") as file:
            group = file["VTKHDF"]
            self.in_space = np.asarray(group["Points"], dtype=float)  # x, y, z
            self.points = self.in_space[:, :2]
            self._fields = {name: np.asarray(data) for name, data in group["PointData"].items()}

    def __getitem__(self, name):
        return self._fields[name]

    def __contains__(self, name):
        return name in self._fields

    def of(self, phase):
        """Mask of the particles of one phase."""
        return self["phase"].astype(int) == phase

    def speed(self):
        return np.linalg.norm(np.asarray(self["velocity"], dtype=float), axis=1)


class RunOutput:
    def __init__(self, folder):
        self.folder = Path(folder)
        self.summary = _read_summary(self.folder / "summary.json")
        self.probes = _read_probes(self.folder / "probes.csv")
        self._frames = _list_frames(self.folder / "frames")

    @property
    def time(self):
        return self.probes["t"]

    def probe(self, name):
        """One column of probes.csv, without its unit: `free_end.x`."""
        if name not in self.probes:
            raise RunError(f"{self.folder}/probes.csv: no column {name}; it has {', '.join(self.probes)}")
        return self.probes[name]

    def frames(self):
        """Every frame in turn, each read once and then let go."""
        for path, time in self._frames:
            yield Frame(path, time)

    def frame_times(self):
        return np.array([time for _, time in self._frames])

    def frame_near(self, time):
        path, at = min(self._frames, key=lambda entry: abs(entry[1] - time))
        return Frame(path, at)


def _read_summary(path):
    if not path.exists():
        raise RunError(f"{path}: not found; is this the folder of a finished run?")
    return json.loads(path.read_text())


def _read_probes(path):
    if not path.exists():
        return {"t": np.empty(0)}
    with open(path, newline="") as file:
        rows = [row for row in csv.reader(file) if row and not row[0].startswith("#")]
    values = np.array([[float(cell) if cell else np.nan for cell in row] for row in rows[1:]])
    values = values.reshape(len(rows) - 1, len(rows[0]))
    return {name.split(" [")[0].strip(): values[:, i] for i, name in enumerate(rows[0])}


def _list_frames(folder):
    """(path, time) of each frame, from the series file that ParaView reads too."""
    series = sorted(folder.glob("*.series"))
    if not series:
        return []
    files = json.loads(series[0].read_text())["files"]
    return [(folder / entry["name"], float(entry["time"])) for entry in files]
