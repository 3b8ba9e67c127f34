# SPDX-License-Identifier: GPL-3.0-or-later
"""The film series is a checkpoint: runs resumed in a new process go on as if not stopped."""

import math
import random
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from foam.vtkFoamFilters import vtkFoamFromPoints

from foam_testing import (coarsening_of, column, differences, foam_of_points, go_to, outlines, points_of,
                          read, set_properties, single, skewed_torus, times, with_tensions, write)

LAST = 40


def run(start, first, folder):
    """Coarsens from films that are frame `first` and writes every frame up to LAST."""
    coarsen = coarsening_of(start, NumberOfFrames=LAST - first)
    for frame in range(first, LAST + 1):
        films, bubbles = go_to(coarsen, frame - first)
        write(films, folder / f"films{frame}.vtp")
        write(bubbles, folder / f"bubbles{frame}.vtp")
    return times(coarsen)


def resume(folder, first):
    """Continues from a written frame, in another process."""
    resumed = folder / f"from{first}"
    resumed.mkdir()
    subprocess.run([sys.executable, __file__, "resume", folder / f"films{first}.vtp", str(first),
                    resumed], check=True)
    return resumed


def in_container(container, **properties):
    """The foam of 120 points at random, from 2 to 6 away from the middle and 0.5 from each other."""
    generator = random.Random(1)
    points = []
    while len(points) < 120:
        point = generator.uniform(-6, 6), generator.uniform(-6, 6), 0
        if 2 < math.hypot(*point) < 6 and all(math.dist(point, other) > 0.5 for other in points):
            points.append(point)
    foam = vtkFoamFromPoints()
    foam.SetInputDataObject(points_of(points))
    set_properties(foam, {"Boundary": foam.Container, "Container": container, **properties})
    return foam


def in_outline():
    """In an octagon, with a square in it, and a grain of sand that lies in a bubble."""
    octagon = [(7 * math.cos(k * math.pi / 4), 7 * math.sin(k * math.pi / 4)) for k in range(8)]
    square = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
    foam = in_container(vtkFoamFromPoints.Outline)
    sand = [(4, 0), (4.04, 0), (4.02, 0.03)]
    foam.SetInputDataObject(1, outlines(octagon, square, sand))
    return foam


class Checkpoint(unittest.TestCase):
    def check(self, start):
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            offered = run(start, 0, folder)
            last = read(folder / f"films{LAST}.vtp")
            self.assertGreater(single(last, "T2Count") + single(last, "T3Count"), 0)

            resumed = resume(folder, 20)
            for frame in range(20, LAST + 1):
                films = read(folder / f"films{frame}.vtp")
                self.assertEqual(single(films, "TimeValue"), offered[frame])
                self.assertEqual(single(films, "Converged"), 1)
                self.assertEqual(differences(films, read(resumed / f"films{frame}.vtp")), [], frame)
                if frame > 20:
                    self.assertEqual(differences(read(folder / f"bubbles{frame}.vtp"),
                                                 read(resumed / f"bubbles{frame}.vtp")), [], frame)

            resumed = resume(folder, 23)
            for frame in range(23, LAST + 1):
                films = read(folder / f"films{frame}.vtp")
                again = read(resumed / f"films{frame}.vtp")
                for count in ("T1Count", "T2Count", "T3Count"):
                    self.assertEqual(single(films, count), single(again, count), (frame, count))
                length = column(films.GetCellData(), "Length").sum()
                other = column(again.GetCellData(), "Length").sum()
                self.assertLess(abs(other / length - 1), 1e-8, frame)

    def test_free(self):
        self.check(foam_of_points())

    def test_periodic(self):
        self.check(foam_of_points(periodic=True))

    def test_skewed_torus(self):
        self.check(foam_of_points(periodic=True, PeriodVectors=skewed_torus()))

    def test_containers(self):
        for container in range(4):
            with self.subTest(container=container):
                self.check(in_container(container))

    def test_outline(self):
        self.check(in_outline())

    def test_own_tensions(self):
        foam = foam_of_points()
        foam.Update()
        self.check(with_tensions(foam.GetOutput(0)))


if __name__ == "__main__":
    if sys.argv[1:2] == ["resume"]:
        run(read(sys.argv[2]), int(sys.argv[3]), Path(sys.argv[4]))
    else:
        unittest.main()
