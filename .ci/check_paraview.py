"""Opens views of a run in ParaView as a user does, draws them, and looks at the picture.

Usage: xvfb-run -a pvpython check_paraview.py FOLDER PICTURE [NUMBER]

Each view_*.hdf of the output folder (NUMBER of them; else all) with its hole_*.hdf: found by their names, fields there, finite
places, the tube of `Extract Surface` and `Tube`, and on a picture of each its colour: the hole is thinner than the tube that is seen.
"""
import pathlib
import sys

from paraview import simple, servermanager
from paraview.vtk.util.numpy_support import vtk_to_numpy

COLOURED = 50     # pixels of each that a view of 600 x 400 has at least


def opened(path):
    source = simple.OpenDataFile(str(path))
    source.UpdatePipeline()
    return source


def drawn(view, picture):
    """Pixels that are red (the string) and blue (the hole)."""
    simple.SaveScreenshot(str(picture), view)
    reader = simple.PNGSeriesReader(FileNames=[str(picture)])
    reader.UpdatePipeline()
    pixels = vtk_to_numpy(servermanager.Fetch(reader).GetPointData().GetScalars())[:, :3].astype(int)
    simple.Delete(reader)
    red, green, blue = pixels.T
    return int(((red > 150) & (green < 90) & (blue < 90)).sum()), int(((blue > red + 40) & (blue > 100)).sum())


def check(path, picture):
    string, hole = opened(path), opened(path.with_name(path.name.replace("view_", "hole_", 1)))
    faults = []
    names = set(string.PointData.keys())
    faults += [f"no field {name}" for name in ("axial_kN", "side_force_kN_m", "offset_m") if name not in names]
    for source in (string, hole):
        information = source.GetDataInformation()
        if information.GetNumberOfPoints() < 2 or information.GetNumberOfCells() < 1 or max(map(abs, information.GetBounds())) > 1e6:
            faults.append(f"points {information.GetNumberOfPoints()}, cells {information.GetNumberOfCells()}, {information.GetBounds()}")
    moved = simple.WarpByVector(Input=string, Vectors=["POINTS", "offset_m"], ScaleFactor=100.0)
    tube = simple.Tube(Input=simple.ExtractSurface(Input=moved), Radius=15.0)
    view = simple.CreateView("RenderView")
    view.ViewSize, view.Background, view.OrientationAxesVisibility = [600, 400], [1.0, 1.0, 1.0], 0
    view.UseColorPaletteForBackground = 0
    shown = simple.Show(tube, view)
    shown.ColorArrayName = [None, ""]
    shown.AmbientColor = shown.DiffuseColor = [1.0, 0.0, 0.0]
    shown.Ambient, shown.Diffuse = 1.0, 0.0
    wall = simple.Show(hole, view)
    wall.ColorArrayName = [None, ""]
    wall.AmbientColor = wall.DiffuseColor = [0.0, 0.0, 1.0]
    wall.Ambient, wall.Diffuse, wall.Opacity, wall.LineWidth = 1.0, 0.0, 1.0, 3.0
    wall.SetRepresentationType("Wireframe")
    view.ViewSize = [600, 400]
    simple.ResetCamera(view)
    camera = view.GetActiveCamera()
    camera.Elevation(-80)
    simple.ResetCamera(view)
    red, _ = drawn(view, picture)
    simple.Hide(tube, view)
    _, blue = drawn(view, picture)
    if red < COLOURED or blue < COLOURED:
        faults.append(f"the picture has {red} pixels of the string, {blue} of the hole")
    for source in (tube, tube.Input, moved, hole, string):
        simple.Delete(source)
    simple.Delete(view)
    return faults


def main():
    paths = sorted(pathlib.Path(sys.argv[1]).glob("view_*.hdf"))[:int(sys.argv[3]) if len(sys.argv) > 3 else None]
    faults = [f"{path.name}: {fault}" for path in paths for fault in check(path, sys.argv[2])]
    manager = servermanager.vtkSMProxyManager
    version = f"{manager.GetVersionMajor()}.{manager.GetVersionMinor()}.{manager.GetVersionPatch()}"
    print(f"{len(paths)} views opened and drawn by ParaView {version}")
    for fault in faults if paths else ["no view_*.hdf there"]:
        print("FAULT", fault)
    return 1 if faults or not paths else 0


if __name__ == "__main__":
    sys.exit(main())
