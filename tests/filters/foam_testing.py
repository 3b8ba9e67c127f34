# SPDX-License-Identifier: GPL-3.0-or-later
"""What the tests of the filters share."""

from vtkmodules.util.misc import calldata_type
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.util.vtkConstants import VTK_STRING
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPolyDataWriter

from foam.vtkFoamFilters import vtkFoamCoarsen, vtkFoamDeform, vtkFoamFromPoints, vtkFoamPoints


class Messages:
    """The errors and warnings that an algorithm and its executive have given."""

    def __init__(self, algorithm):
        self.errors = []
        self.warnings = []
        for source in (algorithm, algorithm.GetExecutive()):
            self._observe(source, "ErrorEvent", self.errors)
            self._observe(source, "WarningEvent", self.warnings)

    @staticmethod
    def _observe(source, event, messages):
        @calldata_type(VTK_STRING)
        def note(_source, _event, text):
            messages.append(text)

        source.AddObserver(event, note)


def points_of(coordinates, **arrays):
    """A data set of points with point arrays of doubles."""
    data = vtkPolyData()
    points = vtkPoints()
    points.SetDataTypeToDouble()
    for p in coordinates:
        points.InsertNextPoint(*p, *([0.0] * (3 - len(p))))
    data.SetPoints(points)
    for name, values in arrays.items():
        data.GetPointData().AddArray(array_of(name, values))
    return data


def array_of(name, values):
    array = vtkDoubleArray()
    array.SetName(name)
    for value in values:
        array.InsertNextValue(value)
    return array


def skewed_torus(count=60):
    """The periods of a torus that is no rectangle, of this area."""
    side = count ** 0.5
    return side, 0.1 * side, 0.3 * side, 1.03 * side


def with_tensions(films, spread=0.2):
    """The films with tensions of their own: (1 ± spread)·2γ. They are not in equilibrium."""
    result = copy(films)
    reference = 2 * single(films, "SurfaceTension")
    count = films.GetNumberOfLines()
    tensions = [reference * (1 + spread * (7 * i % 11 - 5) / 5) for i in range(count)]
    result.GetCellData().AddArray(array_of("FilmTension", tensions))
    return result


def foam_of_points(count=60, periodic=False, **properties):
    """An equilibrated foam of random points, as the filter that makes it."""
    points = vtkFoamPoints()
    points.SetNumberOfPoints(count)
    foam = vtkFoamFromPoints()
    foam.SetInputConnection(points.GetOutputPort())
    if periodic:
        foam.SetBoundary(vtkFoamFromPoints.Periodic)
    set_properties(foam, properties)
    return foam


def outlines(*polygons, closed=True):
    """Polylines through the corners of polygons, and back to the first."""
    data = vtkPolyData()
    points = vtkPoints()
    points.SetDataTypeToDouble()
    lines = vtkCellArray()
    for polygon in polygons:
        first = points.GetNumberOfPoints()
        for x, y in polygon:
            points.InsertNextPoint(x, y, 0)
        ids = list(range(first, points.GetNumberOfPoints())) + ([first] if closed else [])
        lines.InsertNextCell(len(ids), ids)
    data.SetPoints(points)
    data.SetLines(lines)
    return data


def coarsening_of(source, **properties):
    """FoamCoarsen of an algorithm's first output, or of films."""
    return _filter_of(vtkFoamCoarsen(), source, properties)


def deformation_of(source, **properties):
    """FoamDeform likewise."""
    return _filter_of(vtkFoamDeform(), source, properties)


def _filter_of(algorithm, source, properties):
    if isinstance(source, vtkPolyData):
        algorithm.SetInputData(source)
    else:
        algorithm.SetInputConnection(source.GetOutputPort(0))
    set_properties(algorithm, properties)
    return algorithm


def set_properties(algorithm, properties):
    for name, value in properties.items():
        getattr(algorithm, "Set" + name)(value)


def times(algorithm):
    """The time steps that an algorithm offers."""
    algorithm.UpdateInformation()
    information = algorithm.GetOutputInformation(0)
    key = vtkStreamingDemandDrivenPipeline.TIME_STEPS()
    return [information.Get(key, i) for i in range(information.Length(key))]


def go_to(coarsen, frame):
    """Updates to a frame and returns copies of the films and bubbles."""
    coarsen.UpdateTimeStep(times(coarsen)[frame])
    return copy(coarsen.GetOutput(0)), copy(coarsen.GetOutput(1))


def copy(data):
    result = data.NewInstance()
    result.DeepCopy(data)
    return result


def single(data, name):
    """The one value of a field array."""
    array = data.GetFieldData().GetArray(name)
    assert array and array.GetNumberOfValues() == 1, name
    return array.GetValue(0)


def column(attributes, name):
    array = attributes.GetArray(name)
    assert array, name
    return vtk_to_numpy(array)


def bits(data):
    """All of a data set's points, cells and arrays, bit for bit."""
    result = {"points": b"", "cells": {}}
    if data.GetPoints():
        result["points"] = vtk_to_numpy(data.GetPoints().GetData()).tobytes()
    for kind in ("Lines", "Polys"):
        cells = getattr(data, "Get" + kind)()
        result["cells"][kind] = [
            vtk_to_numpy(a).astype("int64").tobytes()
            for a in (cells.GetOffsetsArray(), cells.GetConnectivityArray())
            if a.GetNumberOfValues()
        ]
    for kind in ("PointData", "CellData", "FieldData"):
        attributes = getattr(data, "Get" + kind)()
        for i in range(attributes.GetNumberOfArrays()):
            array = attributes.GetAbstractArray(i)
            if attributes.GetArray(i):
                values = vtk_to_numpy(array)
                result[kind + " " + array.GetName()] = (str(values.dtype), values.shape, values.tobytes())
            else:
                result[kind + " " + array.GetName()] = [array.GetValue(k) for k in range(array.GetNumberOfValues())]
    return result


def differences(a, b):
    """The names of what differs between two data sets."""
    x, y = bits(a), bits(b)
    return sorted(name for name in x.keys() | y.keys() if x.get(name) != y.get(name))


def differences_of_foams(a, b):
    """The same, but for what a foam that coarsens says of its coarsening."""
    return [name for name in differences(a, b)
            if name not in ("FieldData TimeStep", "FieldData GrowthConstant", "FieldData T1Length", "FieldData T2Area")]


def write(data, path):
    writer = vtkXMLPolyDataWriter()
    writer.SetFileName(str(path))
    writer.SetInputData(data)
    assert writer.Write()


def read(path):
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()
