# SPDX-License-Identifier: GPL-3.0-or-later
"""Films to draw, pictures of them as numbers, and where exact arcs lie in a picture."""

import math
import tempfile
from pathlib import Path

import numpy as np
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import (vtkDoubleArray, vtkOutputWindow, vtkPoints, vtkStringArray,
                                      vtkStringOutputWindow)
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkIOImage import vtkPNGReader

simple._DisableFirstRenderCameraReset()  # pictures are taken from where they are said to be

CHORD_ONLY = 2  # samples of a film


class Messages:
    """What VTK says while this is entered."""

    def __enter__(self):
        self.window = vtkStringOutputWindow()
        self.before = vtkOutputWindow.GetInstance()
        vtkOutputWindow.SetInstance(self.window)
        return self

    def __exit__(self, *_):
        vtkOutputWindow.SetInstance(self.before)

    def text(self):
        return self.window.GetOutput()


def arc_points(start, end, half_angle, count):
    """Points along an arc that bulges to the right where half_angle > 0."""
    a, b = np.array(start, float), np.array(end, float)
    s = np.linspace(0, 1, count)[:, None]
    chord = b - a
    left = np.array([-chord[1], chord[0]])
    if half_angle == 0:
        return a + s * chord
    scale = np.sin(s * half_angle) / math.sin(half_angle)
    turn = half_angle * (s - 1)
    return a + scale * (np.cos(turn) * chord + np.sin(turn) * left)


def polylines(arcs, samples=CHORD_ONLY, **arrays):
    """Films (start, end, half-angle) as polylines that share end points, with cell arrays."""
    data, points, lines = vtkPolyData(), vtkPoints(), vtkCellArray()
    points.SetDataTypeToDouble()
    numbers = {}
    for start, end, half_angle in arcs:
        lines.InsertNextCell(samples)
        for i, p in enumerate(arc_points(start, end, half_angle, samples)):
            key = tuple((start, end)[i > 0]) if i in (0, samples - 1) else (id(lines), len(numbers))
            if key not in numbers:
                numbers[key] = points.InsertNextPoint(p[0], p[1], 0)
            lines.InsertCellPoint(numbers[key])
    data.SetPoints(points)
    data.SetLines(lines)
    add_cell_arrays(data, {"HalfAngle": [arc[2] for arc in arcs], **arrays})
    return data


def squares(count, **arrays):
    """A row of squares of side 1 around the origin, with cell arrays."""
    data, points, polygons = vtkPolyData(), vtkPoints(), vtkCellArray()
    for i in range(count):
        polygons.InsertNextCell(4)
        for dx, y in ((0, -0.5), (1, -0.5), (1, 0.5), (0, 0.5)):
            polygons.InsertCellPoint(points.InsertNextPoint(i - count / 2 + dx, y, 0))
    data.SetPoints(points)
    data.SetPolys(polygons)
    add_cell_arrays(data, arrays)
    return data


def add_cell_arrays(data, arrays):
    for name, values in arrays.items():
        if values is None:
            continue
        array = vtkStringArray() if isinstance(values[0], str) else vtkDoubleArray()
        array.SetName(name)
        for value in values:
            array.InsertNextValue(value)
        data.GetCellData().AddArray(array)


def source_of(data):
    producer = simple.TrivialProducer()
    producer.GetClientSideObject().SetOutput(data)
    producer.UpdatePipeline()
    return producer


def view_of(size=(400, 400), scale=1.5, centre=(0, 0), **properties):
    """A white view from above; `scale` is half its height (cm)."""
    return simple.CreateRenderView(**{
        "ViewSize": size, "InteractionMode": "2D", "CameraParallelProjection": 1,
        "OrientationAxesVisibility": 0, "UseColorPaletteForBackground": 0, "Background": [1, 1, 1],
        "CameraPosition": [*centre, 10], "CameraFocalPoint": [*centre, 0],
        "CameraViewUp": [0, 1, 0], "CameraParallelScale": scale, "UseFXAA": 0, **properties})


def show(data, view, **properties):
    """Shows films, black unless they are to have another colour."""
    source = data if hasattr(data, "SMProxy") else source_of(data)
    display = simple.Show(source, view)
    display.Representation = "Foam Films"
    simple.SetProperties(display, **{"ColorArrayName": [None, ""], "AmbientColor": [0, 0, 0],
                                     "DiffuseColor": [0, 0, 0], **properties})
    return display


def read_picture(path):
    """A .png file: rows from the bottom, columns, red-green-blue, from 0 to 1."""
    reader = vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    image = reader.GetOutput()
    width, height, _ = image.GetDimensions()
    values = vtk_to_numpy(image.GetPointData().GetScalars())
    return values.reshape(height, width, -1)[:, :, :3] / 255


def picture(view):
    """What the view shows, as read_picture has it."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "picture.png"
        simple.SaveScreenshot(str(path), view, ImageResolution=list(view.ViewSize))
        return read_picture(path)


def darkness(view):
    """1 where the view is black, 0 where it is white."""
    return 1 - picture(view).mean(axis=2)


def pixel_size(view):
    return 2 * view.CameraParallelScale / view.ViewSize[1]


def pixel_centres(view):
    """Where the centres of pixels lie in the plane: x and y (cm), each a row by row array."""
    width, height = view.ViewSize
    size = pixel_size(view)
    x = view.CameraFocalPoint[0] + (np.arange(width) + 0.5 - width / 2) * size
    y = view.CameraFocalPoint[1] + (np.arange(height) + 0.5 - height / 2) * size
    return np.meshgrid(x, y)


def distance_to_arc(x, y, start, end, half_angle):
    """Distance (cm) of places from an arc: from its circle, or from its nearer end."""
    a, b = np.array(start, float), np.array(end, float)
    to_ends = np.minimum(np.hypot(x - a[0], y - a[1]), np.hypot(x - b[0], y - b[1]))
    chord = b - a
    length = np.hypot(*chord)
    left = np.array([-chord[1], chord[0]]) / length
    middle = (a + b) / 2
    if half_angle == 0:
        along = ((x - a[0]) * chord[0] + (y - a[1]) * chord[1]) / length
        across = np.abs((x - a[0]) * left[0] + (y - a[1]) * left[1])
        return np.where((along >= 0) & (along <= length), across, to_ends)
    radius = length / 2 / math.sin(abs(half_angle))
    centre = middle + left * math.copysign(radius, half_angle) * math.cos(half_angle)
    outward = -left * math.copysign(1, half_angle)
    dx, dy = x - centre[0], y - centre[1]
    turn = np.arctan2(outward[0] * dy - outward[1] * dx, outward[0] * dx + outward[1] * dy)
    return np.where(np.abs(turn) <= abs(half_angle), np.abs(np.hypot(dx, dy) - radius), to_ends)


def arc_length(start, end, half_angle):
    chord = math.dist(start, end)
    return chord if half_angle == 0 else chord * half_angle / math.sin(half_angle)
