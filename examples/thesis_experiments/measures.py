# SPDX-License-Identifier: GPL-3.0-or-later
"""What films and bubbles say about how good a foam is: distance from equilibrium, and anomalies."""
import warnings

import numpy as np
import shapely
from shapely.errors import ShapelyDeprecationWarning
from shapely.geometry import LineString, MultiLineString
from shapely.strtree import STRtree
from vtkmodules.util.numpy_support import vtk_to_numpy

from thesis_experiments.foams import Coarsening, FoamFailure, field_value, newton


def cell_array(data, name):
    return vtk_to_numpy(data.GetCellData().GetArray(name))


def polylines(films):
    """Each film's samples along its arc, a list of (k, 2) arrays."""
    points = vtk_to_numpy(films.GetPoints().GetData())[:, :2]
    lines = films.GetLines()
    offsets = vtk_to_numpy(lines.GetOffsetsArray())
    connectivity = vtk_to_numpy(lines.GetConnectivityArray())
    return np.split(points[connectivity], offsets[1:-1])


def junction_angles(films):
    """The three angles between the films of each junction, counter-clockwise from one film to the one that follows it
    by the bubbles around the junction, in [0, 2π); an (m, 3) array in rad.

    Around an inverted junction they add up to 4π instead of 2π.
    """
    junction_of_point = vtk_to_numpy(films.GetPointData().GetArray("JunctionId"))
    points = vtk_to_numpy(films.GetPoints().GetData())[:, :2]
    lines = films.GetLines()
    offsets = vtk_to_numpy(lines.GetOffsetsArray())
    connectivity = vtk_to_numpy(lines.GetConnectivityArray())
    start, end = connectivity[offsets[:-1]], connectivity[offsets[1:] - 1]
    chord = points[end] - points[start]
    direction = np.arctan2(chord[:, 1], chord[:, 0])
    # An arc with a positive half-angle bulges to the right: it begins turned clockwise from its chord.
    half_angle = cell_array(films, "HalfAngle")
    junction = junction_of_point[np.concatenate([start, end])]
    tangent = np.concatenate([direction - half_angle, direction + np.pi + half_angle])
    left, right = cell_array(films, "LeftBubble"), cell_array(films, "RightBubble")
    on_left, on_right = np.concatenate([left, right]), np.concatenate([right, left])

    order = np.argsort(junction, kind="stable").reshape(-1, 3)
    tangent, on_left, on_right = tangent[order], on_left[order], on_right[order]
    # The film that follows film 0 has film 0's left bubble on its right: film 1, or else film 2.
    swapped = on_left[:, 0] != on_right[:, 1]
    tangent[swapped] = tangent[swapped][:, [0, 2, 1]]
    return np.mod(np.roll(tangent, -1, axis=1) - tangent, 2 * np.pi)


def angle_errors(films):
    """Of each junction the largest deviation from 120°, rad."""
    return np.abs(junction_angles(films) - 2 * np.pi / 3).max(axis=1)


def area_errors(bubbles):
    """|A − A^τ|/A^τ of each bubble."""
    target = cell_array(bubbles, "TargetArea")
    return np.abs(cell_array(bubbles, "Area") - target) / target


def inverted_junctions(films):
    """The number of junctions whose films do not leave it counter-clockwise (thesis 3.5.1)."""
    return int(np.count_nonzero(junction_angles(films).sum(axis=1) > 3 * np.pi))


def neighbourhoods(lines):
    """A function of a line that gives the numbers of those whose bounds it meets."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", ShapelyDeprecationWarning)
        tree = STRtree(lines)
    if hasattr(shapely, "STRtree"):  # Shapely 2
        return tree.query
    number = {id(line): i for i, line in enumerate(lines)}
    return lambda line: [number[id(other)] for other in tree.query(line)]


def crossing_films(films):
    """The number of pairs of films, as sampled, that cross each other."""
    lines = [LineString(line) for line in polylines(films)]
    if MultiLineString(lines).is_simple:
        return 0
    near = neighbourhoods(lines)
    return sum(line.crosses(lines[other]) or line.overlaps(lines[other])
               for i, line in enumerate(lines) for other in near(line) if other > i)


def negative_areas(bubbles):
    """The number of bubbles whose area is not positive."""
    return int(np.count_nonzero(~(cell_array(bubbles, "Area") > 0)))


def unfinished_operations(bubbles, t2_area):
    """The number of three-sided bubbles that ought to have vanished before the frame was equilibrated."""
    return int(np.count_nonzero((cell_array(bubbles, "Sides") == 3) & (cell_array(bubbles, "TargetArea") <= t2_area)))


def quality(films, bubbles, t2_area):
    """Distance from equilibrium and anomalies of one frame."""
    angle, area = angle_errors(films), area_errors(bubbles)
    return {"MaxAngle": angle.max(), "MeanAngle": angle.mean(), "MaxArea": area.max(), "MeanArea": area.mean(),
            "Inverted": inverted_junctions(films), "Crossing": crossing_films(films),
            "NegativeArea": negative_areas(bubbles), "Unfinished": unfinished_operations(bubbles, t2_area)}


NO_EXCESS = {"Excess": np.nan, "ExcessAtTargets": np.nan}


def excess_energy(films, bubbles):
    """The frame's energy over that of Newton's equilibrium of it, relative: as it is, and with the work p·(A^τ − A)
    that it would take to give every bubble its target area, p being the pressures of the equilibrium.

    The equilibrium is a frame of FoamCoarsen without diffusion and without thresholds. NaN where Newton cannot begin
    with the frame, since a bubble of it is inside out, or finds no equilibrium.
    """
    # The filter works on a copy, for the pipeline's output is about to become the next frame.
    start = films.NewInstance()
    start.DeepCopy(films)
    relaxed = Coarsening(start, newton(), 1, 1, Permeability=0, T1Length=0, T2Area=0)
    try:
        relaxed.go_to(1)
    except FoamFailure:
        return NO_EXCESS
    lost = relaxed.bubbles.GetNumberOfCells() != bubbles.GetNumberOfCells()
    if lost or relaxed.ended or not field_value(relaxed.films, "Converged"):
        return NO_EXCESS
    energy = field_value(films, "Energy")
    equilibrium = field_value(relaxed.films, "Energy")
    pressure = cell_array(relaxed.bubbles, "Pressure")
    missing = cell_array(bubbles, "TargetArea") - cell_array(bubbles, "Area")
    return {"Excess": energy / equilibrium - 1, "ExcessAtTargets": (energy + pressure @ missing) / equilibrium - 1}
