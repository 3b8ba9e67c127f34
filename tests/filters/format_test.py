# SPDX-License-Identifier: GPL-3.0-or-later
"""Films of version 1 of the format are read for ever: tests/data/version-1, with what its own time made of them."""

import json
import unittest
from pathlib import Path

import numpy
from foam.vtkFoamFilters import vtkFoamCoarsen, vtkFoamStatistics

from foam_testing import coarsening_of, column, go_to, read, single

DATA = Path(__file__).resolve().parents[1] / "data/version-1"
STATE = {"PointData": ["JunctionId"], "CellData": ["LeftBubble", "RightBubble", "HalfAngle"],
         "FieldData": ["BubbleId", "BubblePressure", "BubbleTargetArea", "TimeValue", "SurfaceTension", "Boundary",
                       "T1Count", "T2Count", "T3Count", "Converged", "Iterations", "MaxAngleError", "MaxAreaError",
                       "Residual"]}


class Version1(unittest.TestCase):
    def setUp(self):
        self.films = {name: read(DATA / f"{name}.vtp") for name in ("free", "periodic", "fixed")}
        self.expected = {name: json.loads((DATA / f"{name}.json").read_text()) for name in self.films}

    def frames(self, name):
        """The films as they are read, and five frames later, each with the bubbles and what was made of them then."""
        coarsen = coarsening_of(self.films[name], ChordError=0.5, TimeStep=0.05, Thresholds=vtkFoamCoarsen.Absolute)
        for frame, when in ((0, "read"), (5, "later")):
            yield *go_to(coarsen, frame), self.expected[name][when]

    def test_version(self):
        for films in self.films.values():
            self.assertEqual(single(films, "FormatVersion"), 1)

    def test_state_is_read_to_the_last_bit(self):
        for name, films in self.films.items():
            written, _, _ = next(self.frames(name))
            self.assertEqual(single(written, "FormatVersion"), 2)
            for kind, arrays in STATE.items():
                for array in arrays:
                    with self.subTest(name, array=array):
                        old, new = (column(getattr(data, "Get" + kind)(), array) for data in (films, written))
                        self.assertEqual(list(new), list(old))
            junctions = column(films.GetPointData(), "JunctionId").max() + 1
            self.assertEqual([written.GetPoint(i) for i in range(junctions)],
                             [films.GetPoint(i) for i in range(junctions)])
            numpy.testing.assert_allclose(column(written.GetFieldData(), "PeriodicBounds"),
                                          column(films.GetFieldData(), "PeriodicBounds"), rtol=1e-15)

    def test_figures_and_frames(self):
        for name in self.films:
            for films, bubbles, expected in self.frames(name):
                with self.subTest(name, time=single(films, "TimeValue")):
                    for count in ("T1Count", "T2Count", "T3Count"):
                        self.assertEqual(single(films, count), expected[count])
                    found = {"Energy": single(films, "Energy"), "Area": column(bubbles.GetCellData(), "Area"),
                             "Length": column(films.GetCellData(), "Length")}
                    if "Points" in expected:
                        found["Points"] = [films.GetPoint(i)[:2] for i in range(len(expected["Points"]))]
                    later = single(films, "TimeValue") != single(self.films[name], "TimeValue")
                    for key in ("Energy", "Area") if later else found:
                        # Events were not at their own time then, and the last gas of bubbles went elsewhere.
                        error = 0.03 if later else 1e-9
                        numpy.testing.assert_allclose(found[key], expected[key], rtol=error, atol=error, err_msg=key)

    def test_statistics(self):
        for name, films in self.films.items():
            statistics = vtkFoamStatistics()
            statistics.SetInputData(films)
            statistics.Update()
            energy = statistics.GetOutput(0).GetValueByName(0, "Energy").ToDouble()
            self.assertAlmostEqual(energy / self.expected[name]["read"]["Energy"], 1, 13)


if __name__ == "__main__":
    unittest.main()
