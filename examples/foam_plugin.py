# SPDX-License-Identifier: GPL-3.0-or-later
"""What the examples share: ParaView's functions with the plugin's among them, options, results as numpy arrays.

    from foam_plugin import *

takes the plugin that `pvpython --plugins=Foam` has loaded, the one that FOAM_PLUGIN names, or the newest build.
"""
import argparse
import csv
import math
import os
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")  # plots go to files
import matplotlib.pyplot as plt
import numpy as np
from paraview import servermanager
from paraview.simple import *
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter

ROOT = Path(__file__).resolve().parent.parent


def find_plugin():
    """The plugin's file."""
    named = os.environ.get("FOAM_PLUGIN")
    built = sorted(ROOT.glob("build/*/Foam.so"), key=lambda path: path.stat().st_mtime)
    if named and not Path(named).is_file():
        sys.exit(f"There is no plugin at FOAM_PLUGIN={named}")
    if not named and not built:
        sys.exit("The plugin is not built: run scripts/run, or name its Foam.so in FOAM_PLUGIN")
    return str(named or built[-1])


if "FoamFromPoints" not in globals():
    LoadPlugin(find_plugin(), remote=False, ns=globals())


def option_kind(default):
    """What argparse is to make of an option: a switch, a list, a fixed number of values, or one value."""
    if isinstance(default, bool):
        return {"action": "store_true"}
    if isinstance(default, (list, tuple)):
        return {"type": type(default[0]), "nargs": "+" if isinstance(default, list) else len(default)}
    return {"type": type(default)}


def read_options(description, output, **options):
    """The command line's values of --output, a folder, which is made, and of options that are given with their
    defaults: a number, a text, a list for one or more values, a tuple for as many as it has, False for a switch."""
    parser = argparse.ArgumentParser(description=description, formatter_class=argparse.RawDescriptionHelpFormatter)
    for name, default in {"output": Path(output), **options}.items():
        parser.add_argument(f"--{name}", default=default, help=f"default: {default}", **option_kind(default))
    found = parser.parse_args()
    found.output.mkdir(parents=True, exist_ok=True)
    return found


def run(main):
    """Runs an example. What cannot be read or written ends it with one line; views are closed before Python ends."""
    try:
        main()
    except OSError as error:
        sys.exit(str(error))
    finally:
        Disconnect()


def result(proxy, port=0, time=None):
    """A proxy's output at a time (s), brought here from wherever it was computed."""
    proxy.UpdatePipeline(*([] if time is None else [time]))
    data = servermanager.Fetch(proxy, idx=port)
    if data.GetNumberOfElements(6 if data.IsA("vtkTable") else 1) == 0:
        sys.exit(f"{proxy.GetXMLLabel()} gave nothing: see the message above")
    return data


def arrays(attributes):
    """Field, cell or row data as a dictionary of numpy arrays."""
    found = [attributes.GetArray(i) for i in range(attributes.GetNumberOfArrays())]
    return {array.GetName(): vtk_to_numpy(array).copy() for array in found if array}


def add_arrays(attributes, given):
    """Adds a dictionary of lists of numbers to field, cell or point data."""
    for name, values in given.items():
        array = numpy_to_vtk(np.array(values, float), deep=1)
        array.SetName(name)
        attributes.AddArray(array)


def rows_of(table):
    """A table's rows as dictionaries."""
    numbers = {name: column.tolist() for name, column in arrays(table.GetRowData()).items()}
    columns = [table.GetColumnName(i) for i in range(table.GetNumberOfColumns())]
    return [{name: numbers[name][i] if name in numbers else table.GetValueByName(i, name).ToString()
             for name in columns} for i in range(table.GetNumberOfRows())]


def first_row(proxy, time=None):
    """The figures in the only row of a table."""
    return rows_of(result(proxy, 0, time))[0]


def polylines(data):
    """The points of each line or polygon, (n, 2), in cm."""
    points = vtk_to_numpy(data.GetPoints().GetData())[:, :2]
    cells = data.GetLines() if data.GetNumberOfLines() else data.GetPolys()
    ends = vtk_to_numpy(cells.GetOffsetsArray())
    return [points[ids] for ids in np.split(vtk_to_numpy(cells.GetConnectivityArray()), ends[1:-1])]


def view_of(foam, size):
    """A square view of a foam, so many pixels wide: films, and bubbles of which blue ones shrink and red ones grow."""
    view = CreateRenderView(ViewSize=[size, size], InteractionMode="2D", OrientationAxesVisibility=0,
                            UseColorPaletteForBackground=0, Background=[1, 1, 1])
    Show(OutputPort(foam, 1), view, Ambient=1, Diffuse=0)
    Show(OutputPort(foam, 0), view, ColorArrayName=[None, ""], AmbientColor=[0.1, 0.14, 0.19], Ambient=1, Diffuse=0,
         LineWidth=3)
    return view


def write_table(path, rows):
    """A .csv of dictionaries."""
    with open(path, "w", newline="") as file:
        writer = csv.DictWriter(file, rows[0])
        writer.writeheader()
        writer.writerows(rows)


def mean_measured_area(path):
    """The mean of the column area of a .csv that must have x, y and area."""
    try:
        with open(path, newline="") as file:
            rows = list(csv.DictReader(file))
        columns = rows[0].keys() if rows else []
        for column in ("x", "y", "area"):
            if column not in columns:
                sys.exit(f"{path} has no column '{column}'")
        mean = float(np.mean([float(row["area"]) for row in rows]))
        if not 0 < mean < math.inf:
            sys.exit(f"The mean area in {path} is {mean}; it must be greater than 0")
        return mean
    except OSError as error:
        sys.exit(f"Cannot read {path}: {error.strerror}")
    except (TypeError, ValueError) as error:
        sys.exit(f"{path} is not a table of numbers: {error}")


def foam_of_measured_points(path, **properties):
    """A foam in equilibrium from a .csv with x, y and area of each bubble (pixels), and the scale (cm per pixel), which
    makes the mean area 1 cm². It is free and has these areas, unless FoamFromPoints is given other properties."""
    scale = 1 / math.sqrt(mean_measured_area(path))  # cm per pixel
    table = CSVReader(FileName=[str(path)])
    points = TableToPoints(Input=table, XColumn="x", YColumn="y", ZColumn="x", a2DPoints=1)
    areas = Calculator(Input=points, ResultArrayName="target_area", Function=f"area*{scale**2!r}")
    scaled = Calculator(Input=areas, CoordinateResults=1, Function=f"coords*{scale!r}")
    measured = {"Boundary": "Free", "TargetAreas": "Array", "TargetAreaArray": "target_area"}
    return FoamFromPoints(Input=scaled, **{**measured, **properties}), scale


def foam_of_labels(labels, path):
    """A foam in equilibrium with the neighbours and areas of a picture's bubbles, which are numbered from 1 there and from
    0 in the foam, and the scale as above. The labels are left in path, a .vti, with y upwards."""
    scale = 1 / math.sqrt(np.bincount(labels.ravel())[1:].mean())
    image = vtkImageData()
    image.SetDimensions(*labels.shape[::-1], 1)
    image.SetSpacing(scale, scale, 1)
    image.SetOrigin(scale / 2, scale / 2, 0)  # the middle of the lowest and leftmost pixel
    numbers = numpy_to_vtk(np.where(labels > 0, labels - 1, labels.max())[::-1].ravel(), deep=1)
    numbers.SetName("bubble")
    image.GetPointData().SetScalars(numbers)
    writer = vtkXMLImageDataWriter()
    writer.SetFileName(str(path))
    writer.SetInputData(image)
    if not writer.Write():
        raise OSError(f"cannot write {path}")
    picture = XMLImageDataReader(FileName=[str(path)])
    return FoamFromLabels(Input=picture, LabelArray="bubble", Background=labels.max()), scale
