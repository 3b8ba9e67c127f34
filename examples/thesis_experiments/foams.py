# SPDX-License-Identifier: GPL-3.0-or-later
"""Foams and their coarsening by one of the methods, through the VTK filters."""
from dataclasses import dataclass, field

from foam.vtkFoamFilters import vtkFoamCoarsen, vtkFoamFromPoints, vtkFoamPoints, vtkFoamStatistics
from vtkmodules.util.misc import calldata_type
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.util.vtkConstants import VTK_STRING

from thesis_experiments import published, scale


@dataclass(frozen=True)
class Method:
    """A way to equilibrate: its name and the properties that it sets, choices by their names."""
    label: str
    properties: dict = field(default_factory=dict)

    def missing_properties(self):
        """Those that the filters do not have."""
        return [name for name in self.properties if not hasattr(vtkFoamCoarsen, "Set" + name)]


def newton(**properties):
    return Method("Newton", {"Equilibrator": "Newton", **properties})


def thesis(label, energy_decay, orientation_invariant, **properties):
    """The thesis's method; two-sided bubbles slide to a corner (3.6.1)."""
    return Method(label, {"Equilibrator": "Junction", "EnergyDecay": energy_decay,
                          "OrientationInvariant": orientation_invariant, "TwoSidedBubbles": "Slide", **properties})


class FoamFailure(Exception):
    """A filter's error."""


class Watch:
    """Keeps an algorithm's warnings and raises its errors."""

    def __init__(self, algorithm):
        self.warnings = []
        self.errors = []
        for source in (algorithm, algorithm.GetExecutive()):
            self._observe(source, "WarningEvent", self.warnings)
            self._observe(source, "ErrorEvent", self.errors)

    @staticmethod
    def _observe(source, event, messages):
        @calldata_type(VTK_STRING)
        def note(_source, _event, message):
            messages.append(message)

        source.AddObserver(event, note)

    def check(self):
        if self.errors:
            # Without the class and address of the object that VTK puts before it.
            raise FoamFailure(self.errors[0].split("): ", 1)[-1].strip())

    @property
    def ended(self):
        return any("ended at time" in warning for warning in self.warnings)


def set_properties(algorithm, properties):
    """Sets those properties that the algorithm has; a choice is given by its name."""
    for name, value in properties.items():
        if hasattr(algorithm, "Set" + name):
            getattr(algorithm, "Set" + name)(getattr(algorithm, value) if isinstance(value, str) else value)


class Source:
    """A foam on a jittered grid (4.5.3), brought to its first equilibrium by a method."""

    def __init__(self, bubbles, method, seed=1):
        self.points = vtkFoamPoints()
        set_properties(self.points, {"NumberOfPoints": bubbles, "Spacing": scale.spacing(), "Seed": seed})
        self.filter = vtkFoamFromPoints()
        self.filter.SetInputConnection(self.points.GetOutputPort())
        set_properties(self.filter, {**_constants(), **method.properties})
        self.watch = Watch(self.filter)

    def films(self):
        self.filter.Update()
        self.watch.check()
        return self.filter.GetOutput(0)


class Coarsening:
    """A foam as it coarsens: go_to(step) makes films, bubbles and statistics those of the step."""

    def __init__(self, source, method, time_step, steps, **properties):
        self.filter = vtkFoamCoarsen()
        if isinstance(source, Source):
            self.filter.SetInputConnection(source.filter.GetOutputPort(0))
        else:
            self.filter.SetInputData(source)
        set_properties(self.filter, {"Thresholds": vtkFoamCoarsen.Absolute, **_constants(), **method.properties,
                                     "TimeStep": time_step, "NumberOfFrames": steps, **properties})
        self.watch = Watch(self.filter)
        self.start = field_value(source.films() if isinstance(source, Source) else source, "TimeValue")
        self.time_step = time_step
        self._statistics = {}
        for boundary in (False, True):
            statistics = vtkFoamStatistics()
            statistics.SetIncludeBoundary(boundary)
            statistics.SetInputConnection(self.filter.GetOutputPort(0))
            self._statistics[boundary] = statistics, Watch(statistics)

    def go_to(self, step):
        # A time between two frames shows the first of them, however the frames' times were rounded.
        self._time = self.start + (step + 0.25) * self.time_step
        self.filter.UpdateTimeStep(self._time)
        self.watch.check()

    @property
    def films(self):
        return self.filter.GetOutput(0)

    @property
    def bubbles(self):
        return self.filter.GetOutput(1)

    @property
    def ended(self):
        return self.watch.ended

    def statistics(self, table, include_boundary):
        """A table of vtkFoamStatistics as columns: 0 summary, 1 by sides, 2 bubbles."""
        statistics, watch = self._statistics[include_boundary]
        statistics.UpdateTimeStep(self._time)
        watch.check()
        output = statistics.GetOutput(table)
        return {output.GetColumnName(i): vtk_to_numpy(output.GetColumn(i)).tolist()
                for i in range(output.GetNumberOfColumns())}


def field_value(films, name):
    """A single value of the field data."""
    return films.GetFieldData().GetArray(name).GetTuple1(0)


def _constants():
    return {name: int(value) if name == "MaximumIterations" else value
            for name, value in published.constants().items()}
