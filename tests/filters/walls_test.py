# SPDX-License-Identifier: GPL-3.0-or-later
"""Containers: what their films and bubbles show, and what is no container."""

import math
import unittest

from foam_testing import Messages, column, differences_of_foams, outlines, points_of, set_properties, single

from foam.vtkFoamFilters import vtkFoamCoarsen, vtkFoamFromPoints

RECTANGLE, DISC, ANNULUS, CHANNEL, OUTLINE = range(5)
POINTS = [(0.3, 0.2), (1.6, 0.4), (0.5, 1.4), (1.7, 1.5), (1.1, 0.9)]


def container(shape, walls=None, points=POINTS, **properties):
    foam = vtkFoamFromPoints()
    foam.SetInputDataObject(points_of([(x, y, 0) for x, y in points]))
    if walls:
        foam.SetInputDataObject(1, walls)
    set_properties(foam, {"Boundary": 3, "Container": shape, **properties})
    return foam


class Walls(unittest.TestCase):
    def errors(self, foam):
        messages = Messages(foam)
        foam.Update()
        self.assertEqual(foam.GetOutput(0).GetNumberOfCells(), 0)
        self.assertEqual(len(messages.errors), 1, messages.errors)
        return messages.errors[0]

    def test_bubbles_fill_the_container(self):
        square = outlines([(-1, -1), (3, -1), (3, 3), (-1, 3)])
        around = [(0.6 * math.cos(k), 0.6 * math.sin(k)) for k in range(6)]
        wide, round_ = (-0.5, 2.5, 0, 2), (-1, 1, -1, 1)
        for shape, walls, points, bounds, area in (
                (RECTANGLE, None, POINTS, wide, 6), (DISC, None, around, round_, math.pi),
                (ANNULUS, None, around, round_, 0.9375 * math.pi), (CHANNEL, None, POINTS, wide, 6),
                (OUTLINE, square, POINTS, wide, 16)):
            foam = container(shape, walls, points, ContainerBounds=bounds, InnerRadius=0.25)
            foam.Update()
            films, bubbles = foam.GetOutput(0), foam.GetOutput(1)
            self.assertEqual(single(films, "Converged"), 1, shape)
            self.assertAlmostEqual(column(bubbles.GetCellData(), "Area").sum(), area, 9)
            kind = column(films.GetCellData(), "Kind")
            length = column(films.GetCellData(), "Length")
            self.assertAlmostEqual(length[kind == 0].sum() * 0.5, single(films, "Energy"), 9)
            self.assertTrue((column(films.GetCellData(), "OnBoundary")[kind == 1] == 1).all())

    def test_an_obstacle_in_a_bubble_is_drawn_and_takes_its_area(self):
        square = [(-1, -1), (3, -1), (3, 3), (-1, 3)]
        small = [(0.2, 0.1), (0.3, 0.1), (0.3, 0.2)]
        foam = container(OUTLINE, outlines(square, small))
        foam.Update()
        films, bubbles = foam.GetOutput(0), foam.GetOutput(1)
        self.assertAlmostEqual(column(bubbles.GetCellData(), "Area").sum(), 16 - 0.005, 12)
        of_obstacle = column(films.GetCellData(), "RightBubble") == -2
        self.assertEqual(of_obstacle.sum(), 3)
        self.assertAlmostEqual(column(films.GetCellData(), "Length")[of_obstacle].sum(), 0.2 + 0.1 * 2**0.5, 12)
        self.assertTrue((column(films.GetCellData(), "Kind")[of_obstacle] == 1).all())
        again = vtkFoamCoarsen()
        again.SetInputDataObject(films)
        again.Update()
        self.assertEqual(differences_of_foams(again.GetOutput(0), films), [])

    def test_a_closed_wall_is_as_long_as_it_is(self):
        foam = container(DISC, points=[(0.1, 0.1), (-0.3, 0.2), (0, -0.5)], ContainerBounds=(-1, 1, -1, 1))
        foam.Update()
        films = foam.GetOutput(0)
        walls = column(films.GetCellData(), "Kind") == 1
        self.assertAlmostEqual(column(films.GetCellData(), "Length")[walls].sum(), 2 * math.pi, 12)
        self.assertAlmostEqual(column(films.GetCellData(), "HalfAngle")[walls].sum(), math.pi, 12)

    def test_bad_input(self):
        far = (10, 20, 10, 20)
        self.assertIn("point 0 at (0.3, 0.2) lies on a wall, or outside",
                      self.errors(container(RECTANGLE, ContainerBounds=far)))
        self.assertIn("inner radius of an annulus must lie between 0 and the outer one, 1, but is 2",
                      self.errors(container(ANNULUS, ContainerBounds=(0, 2, 0, 2), InnerRadius=2)))
        self.assertIn("enclose nothing", self.errors(container(RECTANGLE, ContainerBounds=(2, 0, 0, 2))))
        self.assertIn("there are none", self.errors(container(OUTLINE)))
        square = [(-1, -1), (3, -1), (3, 3), (-1, 3)]
        self.assertIn("is open: it begins at (-1, -1) and ends at (-1, 3)",
                      self.errors(container(OUTLINE, outlines(square, closed=False))))
        bow = [(-1, -1), (3, 3), (3, -1), (-1, 3)]
        self.assertIn("outline 0 crosses itself", self.errors(container(OUTLINE, outlines(bow))))
        outside = [(8, 8), (9, 8), (9, 9)]
        self.assertIn("outline 1, an obstacle, lies at (8, 8), outside of the container",
                      self.errors(container(OUTLINE, outlines(square, outside))))


if __name__ == "__main__":
    unittest.main()
