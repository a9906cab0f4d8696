"""VTK's own reader, which is ParaView's, sees in the frames what h5py sees. Usage: test_vtk.py PROGRAM SCENES

77 = skipped: no vtk (python3-vtk9) here.
"""
import json
import sys
import tempfile
from pathlib import Path

from program import SKIPPED, run

try:
    import h5py
    import numpy
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOHDF import vtkHDFReader
except ImportError as missing:
    print(f"skipped: {missing}")
    raise SystemExit(SKIPPED)


def check(condition, words):
    if not condition:
        raise SystemExit(f"test_vtk: {words}")


def read(file):
    reader = vtkHDFReader()
    check(reader.CanReadFile(str(file)), f"{file}: the reader does not know it")
    reader.SetFileName(str(file))
    reader.Update()
    return reader.GetOutput()


def same(a, b):
    return a.shape == b.shape and a.dtype == b.dtype and numpy.array_equal(a, b, equal_nan=a.dtype.kind == "f")


def compare(file):
    """The particles of one frame, once read by each."""
    grid = read(file)
    with h5py.File(file) as hdf:
        group = hdf["VTKHDF"]
        count = group["NumberOfPoints"][0]
        check(grid.GetClassName() == "vtkUnstructuredGrid", f"{file}: read as {grid.GetClassName()}")
        check(count > 0 and grid.GetNumberOfPoints() == count == grid.GetNumberOfCells(),
              f"{file}: {grid.GetNumberOfPoints()} points and {grid.GetNumberOfCells()} cells, expected {count} of each")
        check(same(vtk_to_numpy(grid.GetPoints().GetData()), group["Points"][:]), f"{file}: the coordinates differ")
        check(all(grid.GetCellType(k) == 1 and grid.GetCell(k).GetPointId(0) == k for k in (0, count // 2, count - 1)),
              f"{file}: a cell is not the vertex of its particle")
        data = grid.GetPointData()
        names = {data.GetArrayName(k) for k in range(data.GetNumberOfArrays())}
        check(names == set(group["PointData"]), f"{file}: fields {sorted(names)}, expected {sorted(group['PointData'])}")
        for name in names:
            check(same(vtk_to_numpy(data.GetArray(name)), group["PointData"][name][:]), f"{file}: {name} differs")
        return hdf["sluice"].attrs["time"], count, names


def compare_series(folder, frames):
    """All frames of a run; the list that ParaView opens names them with the times that they have."""
    series = json.loads((folder / "frames" / "frames.hdf.series").read_text())
    check(series["file-series-version"] == "1.0", "version of the series")
    check(len(series["files"]) == frames, f"{folder}: {len(series['files'])} frames, expected {frames}")
    check(len(list((folder / "frames").glob("*.hdf"))) == frames, f"{folder}: a frame is not in the list")
    seen = [compare(folder / "frames" / entry["name"]) for entry in series["files"]]
    times = [entry["time"] for entry in series["files"]]
    check(times == [time for time, *_ in seen] and times == sorted(times), f"{folder}: times {times}, {seen}")
    check(len({count for _, count, _ in seen}) == 1, f"{folder}: particles come or go")
    return seen[0]


def main(program, scenes):
    with tempfile.TemporaryDirectory() as scratch:
        scratch = Path(scratch)
        paper = compare_series(run(program, scenes / "small_gate.toml", scratch / "paper"), frames=3)
        check({"velocity", "pressure", "stress_zz", "von_mises", "phase", "body", "id"} <= paper[2], sorted(paper[2]))
        modern = compare_series(run(program, scenes / "small_gate.toml", scratch / "modern", 'method.preset="modern"'), 3)
        check("green_strain_xy" in modern[2], sorted(modern[2]))
        compare_series(run(program, scenes / "still_water_3d.toml", scratch / "water", until=0.004), frames=3)
    print("test_vtk: passed")


main(sys.argv[1], Path(sys.argv[2]))
