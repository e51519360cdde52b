"""Run by pvpython: compares the pulsating sphere that ParaView reads with the one that was written."""

import sys

from paraview.simple import OpenDataFile

TIMES = [0, 0.5, 1, 1.5]
VERTICES, FACES = 642, 1280


def expect(what, found, expected, tolerance=0.0):
    found, expected = list(found), list(expected)
    same = len(found) == len(expected) and all(abs(f - e) <= tolerance for f, e in zip(found, expected))
    if not same:
        sys.exit(f"{what}: ParaView has {found}, written was {expected}")


def check_time(reader, kt):
    reader.UpdatePipeline(kt)
    data = reader.GetDataInformation()
    radius = 1 + kt / 2
    expect(f"points and cells at {kt}", [data.GetNumberOfPoints(), data.GetNumberOfCells()], [VERTICES, FACES])
    expect(f"bounds at {kt}", data.GetBounds(), [-radius, radius] * 3, 1e-12)
    for name, magnitude in [("velocity", 0.5), ("force", 3 * radius)]:
        field = reader.PointData[name]
        expect(f"components of {name}", [field.GetNumberOfComponents()], [3])
        expect(f"|{name}| at {kt}", field.GetRange(-1), [magnitude, magnitude], 1e-12)
        expect(f"{name}_x at {kt}", field.GetRange(0), [-magnitude, magnitude], 1e-12)
    expect(f"stretch at {kt}", reader.PointData["stretch"].GetRange(0), [radius, radius], 1e-12)


reader = OpenDataFile(sys.argv[1])
if reader.GetXMLName() != "XdmfReader":
    sys.exit(f"ParaView chose {reader.GetXMLName()}, and not the reader for XDMF version 2")
expect("times", reader.TimestepValues, TIMES)
for kt in reversed(TIMES):
    check_time(reader, kt)
