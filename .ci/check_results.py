#!/usr/bin/env python3
"""Reads back what a run wrote, with the libraries that users read it with: h5py and VTK.

Usage: check_results.py FOLDER     a folder of results of a deck in SI units with hdf5, plots and profiles

  results.h5      opens; every column of every profile_*.csv is there with the same numbers, units and description, chunked
                  and compressed; rows of summary.csv and limits.csv are attributes; deck text, version, compiler, time
                  the contacts of contacts_*.csv
  view_*.hdf      VTK reads the string: every column that has values, off the hole axis as far as `displacement` says
  hole_*.hdf      VTK reads the tube: its wall stands off the axis by half the hole
"""
import csv
import pathlib
import sys

import h5py
import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import VTK_POLY_LINE, VTK_TRIANGLE_STRIP
from vtkmodules.vtkCommonCore import vtkVersion
from vtkmodules.vtkIOHDF import vtkHDFReader

SAME = 1.0e-9      # CSV files have ten digits
# Positions are differences of kilometres; clock angles pass through text of ten digits: 1e-9 of them is no more than this [m].
NEAR = 1.0e-6
DIGIT = 1.0e-6     # last digit of a depth in CSV files [m]
MOST_PLAIN = 8192   # numbers of a dataset that is stored as it is (most_plain in src/report/files/hdf5_file.f90)
ROOT = ("deck", "deck_path", "title", "program", "version", "compiler", "compiler_options", "time", "unit_system")

faults = []


def expect(condition, message):
    if not condition:
        faults.append(message)


def table(path):
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def column(rows, name):
    return numpy.array([float(row[name]) if row[name] else numpy.nan for row in rows])


def same(one, other):
    scale = numpy.nanmax(numpy.abs(other), initial=0.0)
    return one.shape == other.shape and numpy.allclose(one, other, rtol=SAME, atol=SAME*scale, equal_nan=True)


def check_attributes(group, row, what):
    for name, text in row.items():
        if name in ("case", "model"):
            continue
        if text == "":
            expect(name not in group.attrs or group.attrs[name] == "", f"{group.name}: {name} is empty in {what}")
        elif name not in group.attrs:
            faults.append(f"{group.name}: no attribute {name} of {what}")
        elif isinstance(group.attrs[name], str):
            expect(group.attrs[name] == text, f"{group.name}: {name} is not as in {what}")
        else:
            expect(same(numpy.array(float(group.attrs[name])), numpy.array(float(text))),
                   f"{group.name}: {name} = {group.attrs[name]} is not {text}")


def check_group(group, rows):
    for name in rows[0]:
        if name not in group:
            faults.append(f"{group.name}: no dataset {name}")
            continue
        data = group[name]
        expect("units" in data.attrs and data.attrs.get("description"), f"{data.name}: no units or description")
        if data.size > MOST_PLAIN:
            expect(data.compression == "gzip" and data.chunks, f"{data.name}: not chunked and compressed")
        else:
            expect(not data.chunks, f"{data.name}: small, but chunked")
        if "values" in data.attrs:
            words = {int(word.split()[0]): word.split()[1].replace("(empty)", "") for word in data.attrs["values"].split(", ")}
            expect([words[int(code)] for code in data] == [row[name] for row in rows], f"{data.name} differs from the profile")
        else:
            expect(same(data[:], column(rows, name)), f"{data.name} differs from the profile")
    expect(set(group) - {"history", "gaps", "contacts"} == set(rows[0]), f"{group.name}: columns that the profile does not have")
    if int(group.attrs["iterations"]) > 0:
        history = group["history"]
        expect(len(history["iteration"]) > 0 and history["residual_kN"].attrs["units"] == "kN", f"{history.name}: incomplete")
        gaps = group["gaps"]
        for code, state in enumerate(("free", "elastic", "rigid")):
            expect(numpy.count_nonzero(gaps["state"][:] == code) == group.attrs[f"gaps_{state}"], f"{gaps.name}: gaps {state}")
        expect(sum(gaps["flips"]) == group.attrs["flips"] and sum(gaps["moves"]) == group.attrs["moves"], f"{gaps.name}: flips, moves")
        expect(same(numpy.array(numpy.sum(gaps["force_kN"])), numpy.array(group.attrs["normal_force_kN"])), f"{gaps.name}: forces")


def check_contacts(group, path):
    """The concentrated contacts as in their own file, which only cases with moments of mcge have."""
    rows = table(path) if path.exists() else []
    expect(("contacts" in group) == bool(rows), f"{group.name}: contacts are not those of {path.name}")
    for name in rows[0] if rows else ():
        data = group["contacts"][name]
        if name == "kind":
            words = dict(word.split(" ", 1) for word in data.attrs["values"].split(", "))
            expect([words[str(int(code))] for code in data] == [row[name] for row in rows], f"{data.name} differs from {path.name}")
        else:
            expect(same(data[:], column(rows, name)), f"{data.name} differs from {path.name}")


def grid(path):
    reader = vtkHDFReader()
    expect(reader.CanReadFile(str(path)), f"{path.name}: VTK cannot read it")
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutputDataObject(0)


def cells(data, kind):
    """Whether all cells are of a kind, and how many they are."""
    number = data.GetNumberOfCells()
    return number if all(data.GetCellType(i) == kind for i in range(number)) else 0


def points(data):
    return vtk_to_numpy(data.GetPoints().GetData())


def field(data, name):
    array = data.GetPointData().GetArray(name)
    return None if array is None else vtk_to_numpy(array)


def check_view(path, hole_path, rows):
    string, hole = grid(path), grid(hole_path)
    pieces = 1 + sum(row["side"] == "below" for row in rows)
    expect(cells(string, VTK_POLY_LINE) == pieces and string.GetNumberOfPoints() == len(rows), f"{path.name}: the string is no line")
    for name in rows[0]:
        if name in ("gap_state", "buckling", "side"):
            expect(field(string, name) is not None, f"{path.name}: no field {name}")
        elif not numpy.isnan(column(rows, name)).all():
            expect(field(string, name) is not None and same(field(string, name), column(rows, name)), f"{path.name}: field {name}")
    axis = numpy.column_stack([column(rows, "east_m"), column(rows, "north_m"), -column(rows, "tvd_m")])
    off = numpy.linalg.norm(points(string) - axis, axis=1)
    expect(numpy.allclose(off, column(rows, "displacement_mm")/1000.0, rtol=0.0, atol=NEAR), f"{path.name}: string off its place")
    expect(numpy.allclose(points(string) - axis, field(string, "offset_m"), rtol=0.0, atol=NEAR), f"{path.name}: offset_m")
    # every ring of the tube is round its row of the axis
    # at a depth with two rows, round one of them
    depths = field(hole, "md_m")
    rings = numpy.searchsorted(column(rows, "md_m"), depths + DIGIT, side="right") - 1
    expect(numpy.abs(column(rows, "md_m")[rings] - depths).max() < DIGIT, f"{path.name}: a ring at a depth without a row")
    uppers = rings - numpy.array([rows[i]["side"] == "below" for i in rings])
    off = numpy.linalg.norm(points(hole) - axis[rings], axis=1)
    wrong = [numpy.abs(off - column(rows, "hole_mm")[of]/2000.0) for of in (rings, uppers)]
    expect(numpy.minimum(*wrong).max() < NEAR, f"{path.name}: the tube is not round")
    expect(cells(hole, VTK_TRIANGLE_STRIP) > 2 and rings[0] == 0 and rings[-1] == len(rows) - 1, f"{path.name}: the tube has no wall")
    expect(set(numpy.unique(strip_points(hole))) == set(range(hole.GetNumberOfPoints())), f"{path.name}: loose points of the tube")


def strip_points(hole):
    return vtk_to_numpy(hole.GetCells().GetConnectivityArray())


def main(folder):
    folder = pathlib.Path(folder)
    summary, limits = table(folder/"summary.csv"), table(folder/"limits.csv")
    expect(not list(folder.glob("*.unfinished")), "unfinished files are left")
    views = 0
    with h5py.File(folder/"results.h5") as results:
        for name in ROOT:
            expect(isinstance(results.attrs.get(name), str), f"results.h5: no root attribute {name}")
        path = pathlib.Path(results.attrs["deck_path"])
        if path.is_file():
            expect(results.attrs["deck"].splitlines() == path.read_text(encoding="utf-8").splitlines(), "results.h5: the deck's text")
        expect({"md_m", "inclination_deg", "azimuth_deg"} == set(results["survey"]), "results.h5: survey")
        for row, limit in zip(summary, limits, strict=True):
            group = results[f"cases/{row['case']}/{row['model']}"]
            ending = f"{row['case']}_{row['model']}"
            check_attributes(group, row, "summary.csv")
            check_attributes(group, limit, "limits.csv")
            if row["status"] == "not_converged":
                expect(not (folder/f"profile_{ending}.csv").exists() and "md_m" not in group, f"{ending}: a failed case has a profile")
                continue
            rows = table(folder/f"profile_{ending}.csv")
            check_group(group, rows)
            check_contacts(group, folder/f"contacts_{ending}.csv")
            check_view(folder/f"view_{ending}.hdf", folder/f"hole_{ending}.hdf", rows)
            views += 1
    print(f"{views} results of results.h5 read by h5py {h5py.__version__}, {views} views read by VTK {vtkVersion.GetVTKVersion()}")
    for fault in faults:
        print("FAULT", fault)
    return 1 if faults else 0


if __name__ == "__main__":
    if len(sys.argv) != 2:
        raise SystemExit(__doc__)
    sys.exit(main(sys.argv[1]))
