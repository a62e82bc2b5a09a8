"""Reads snapshots back with VTK's own reader, vtkHDFReader, and compares every value.

usage: read_snapshots.py PROGRAM   (the one that wrote them: write_snapshots.cpp has the formulas)
Ends with 77, which ctest reports as skipped, when VTK for Python is not installed.
"""

import json
import pathlib
import subprocess
import sys
import tempfile

try:
    from vtkmodules.vtkCommonCore import vtkVersion
    from vtkmodules.vtkIOHDF import vtkHDFReader
except ImportError as error:
    print(f"skipped: VTK's reader is not installed (package python3-vtk9): {error}")
    sys.exit(77)

N = 10  # particles owned; three images must not appear


def value(offset, component, i):
    return offset + 10 * component + i / 3


# Place of each component of a field among those in the file, by dimension
AXES = {1: [0], 2: [0, 2], 3: [0, 1, 2]}
PLACES = {
    "velocity": (200, 3, AXES),
    "depth": (300, 1, {1: [0], 2: [0], 3: [0]}),
    # xx yy zz xy yz xz in the file; the store goes through the rows of the upper triangle
    "stress": (400, 6, {1: [0], 2: [0, 5, 2], 3: [0, 3, 5, 1, 4, 2]}),
    "velocity_gradient": (500, 9, {1: [0], 2: [0, 2, 6, 8], 3: list(range(9))}),
}


def check(name, found, expected):
    if found != expected:
        sys.exit(f"{name}: VTK reads {found}, written was {expected}")


def read(path):
    reader = vtkHDFReader()
    if not reader.CanReadFile(str(path)):
        sys.exit(f"VTK cannot read {path}")
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def check_snapshot(grid, dim, time, step):
    check("class", grid.GetClassName(), "vtkUnstructuredGrid")
    check("points", grid.GetNumberOfPoints(), N)
    check("cells", grid.GetNumberOfCells(), N)
    for i in range(N):
        place = [0.0, 0.0, 0.0]
        for component, axis in enumerate(AXES[dim]):
            place[axis] = value(100, component, i)
        check(f"place of {i}", list(grid.GetPoint(i)), place)
        check(f"type of cell {i}", grid.GetCellType(i), 1)  # VTK_VERTEX
        check(f"point of cell {i}", grid.GetCell(i).GetPointId(0), i)
    data = grid.GetPointData()
    names = sorted(data.GetArrayName(k) for k in range(data.GetNumberOfArrays()))
    check("arrays", names, sorted([*PLACES, "id", "role"]))
    for name, (offset, width, places) in PLACES.items():
        array = data.GetArray(name)
        check(f"{name} type", array.GetDataTypeAsString(), "double")
        check(f"{name} width", array.GetNumberOfComponents(), width)
        for i in range(N):
            row = [0.0] * width
            for component, place in enumerate(places[dim]):
                row[place] = value(offset, component, i)
            check(f"{name} of {i}", list(array.GetTuple(i)), row)
    check("id", [int(data.GetArray("id").GetTuple1(i)) for i in range(N)], [1000 - i for i in range(N)])
    check("role", [int(data.GetArray("role").GetTuple1(i)) for i in range(N)], [0] * 5 + [2] * 5)
    check("TimeValue", grid.GetFieldData().GetArray("TimeValue").GetTuple1(0), time)
    check("step", grid.GetFieldData().GetArray("step").GetTuple1(0), step)


with tempfile.TemporaryDirectory() as folder:
    subprocess.run([sys.argv[1], folder], check=True)
    for dim in (1, 2, 3):
        run = pathlib.Path(folder) / f"{dim}d"
        # As ParaView does: names in the index are relative to the index.
        files = json.loads((run / "snapshots.hdf.series").read_text())["files"]
        check("times", [f["time"] for f in files], [0.0, 0.1 + 0.2])
        for entry, step in zip(files, (0, 42)):
            check_snapshot(read(run / entry["name"]), dim, entry["time"], step)
print(f"VTK {vtkVersion.GetVTKVersion()} reads back what was written, in 1, 2 and 3 dimensions")
