# SPDX-License-Identifier: GPL-3.0-or-later
"""FoamCoarsen in time: any order of frames, keyframes, changed properties, abort, the end."""

import math
import resource
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

from vtkmodules.util.vtkAlgorithm import VTKPythonAlgorithmBase
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline, vtkTrivialProducer

from foam.vtkFoamFilters import vtkFoamCoarsen, vtkFoamFromPoints
from foam_testing import (Messages, coarsening_of, column, copy, differences, foam_of_points, go_to,
                          points_of, read, set_properties, single, times, write)


def work(action):
    """Processor time that an action takes, s."""
    start = time.process_time()
    action()
    return time.process_time() - start


class Later(VTKPythonAlgorithmBase):
    """Films that are shown at other times than they carry."""

    def __init__(self, films):
        super().__init__(nInputPorts=0, nOutputPorts=1, outputType="vtkPolyData")
        self.films = films

    def RequestInformation(self, _request, _inputs, outputs):
        information = outputs.GetInformationObject(0)
        information.Set(vtkStreamingDemandDrivenPipeline.TIME_STEPS(), [100.0, 200.0], 2)
        information.Set(vtkStreamingDemandDrivenPipeline.TIME_RANGE(), [100.0, 200.0], 2)
        return 1

    def RequestData(self, _request, _inputs, outputs):
        vtkPolyData.GetData(outputs).ShallowCopy(self.films)
        return 1


class Times(unittest.TestCase):
    def test_offered(self):
        coarsen = coarsening_of(foam_of_points(), NumberOfFrames=3, TimeStep=0.1)
        self.assertEqual(times(coarsen), [0, 0.1, 0.2, 3 * 0.1])

    def test_are_multiples_and_no_sums(self):
        """So that a frame is found at the time that a user would write, and a resumed run has its times."""
        for step in (0.1, 1 / 30, 0.7, 1e-3, 3e5):
            coarsen = coarsening_of(foam_of_points(20), NumberOfFrames=1000, TimeStep=step, Permeability=0)
            offered = times(coarsen)
            self.assertEqual(offered, [k * step for k in range(1001)])
            for k in (20, 23):
                films, bubbles = go_to(coarsen, k)
                self.assertEqual([single(data, "TimeValue") for data in (films, bubbles)], 2 * [offered[k]])
                resumed = coarsening_of(films, NumberOfFrames=1000 - k, TimeStep=step)
                self.assertEqual(times(resumed), offered[k:])

    def test_off_the_grid(self):
        films, _ = go_to(coarsening_of(foam_of_points(20), TimeStep=0.1), 3)
        films.GetFieldData().GetArray("TimeValue").SetValue(0, 0.05)
        self.assertEqual(times(coarsening_of(films, TimeStep=0.1, NumberOfFrames=9)),
                         [0.05 + k * 0.1 for k in range(10)])

    def test_begin_at_the_time_of_the_input(self):
        first = coarsening_of(foam_of_points(), NumberOfFrames=20)
        films, _ = go_to(first, 20)
        second = coarsening_of(films, NumberOfFrames=5)
        offered = times(second)
        self.assertEqual(offered[0], times(first)[20])
        self.assertEqual(single(go_to(second, 5)[0], "TimeValue"), offered[5])

    def test_temporal_input_is_taken_at_its_last_time(self):
        first = coarsening_of(foam_of_points(), NumberOfFrames=10)
        second = coarsening_of(first, NumberOfFrames=3)
        self.assertEqual(times(second), times(coarsening_of(foam_of_points(), NumberOfFrames=13))[10:])
        self.assertEqual(second.GetStartTime(), times(first)[10])
        reference = coarsening_of(foam_of_points(), NumberOfFrames=13)
        for frame in (0, 3, 1):
            go_to(first, frame)
            self.assertEqual(differences(go_to(second, frame)[0], go_to(reference, 10 + frame)[0]), [])

    def test_temporal_input_is_taken_at_its_first_time(self):
        first = coarsening_of(foam_of_points(), NumberOfFrames=4)
        second = coarsening_of(first, NumberOfFrames=3, TimeStep=0.01, StartFrom=vtkFoamCoarsen.First)
        reference = [go_to(coarsening_of(foam_of_points(), TimeStep=0.01), k)[0] for k in range(4)]
        for frame in (0, 3, 1):
            go_to(first, frame)
            self.assertEqual(differences(go_to(second, frame)[0], reference[frame]), [])

    def test_a_run_upstream_is_computed_when_it_is_asked_for(self):
        """Its end, and not before; the times are announced without it."""
        for step in (0, 0.03):
            for start, at in ((vtkFoamCoarsen.Last, 10), (vtkFoamCoarsen.First, 0)):
                first = coarsening_of(foam_of_points(), NumberOfFrames=10)
                computed = []
                first.AddObserver("StartEvent", lambda *_: computed.append(None))
                second = coarsening_of(first, NumberOfFrames=3, StartFrom=start, TimeStep=step)
                offered = times(second)
                self.assertEqual(computed, [])
                known = times(first)
                step_in_force = step or known[1]
                self.assertEqual(offered[0], known[at])
                self.assertAlmostEqual(offered[3] - offered[0], 3 * step_in_force, 14)
                self.assertEqual(second.GetStartTime(), known[at])
                films, _ = go_to(second, 0)
                self.assertGreater(len(computed), 0)
                self.assertEqual(single(films, "TimeValue"), offered[0])
                self.assertEqual(times(second), offered)

    def test_a_run_upstream_that_ends(self):
        """What follows begins where it ended, and the times that were announced are corrected."""
        first = coarsening_of(foam_of_points(6), NumberOfFrames=400, TimeStep=0.05)
        second = coarsening_of(first, NumberOfFrames=3, TimeStep=0.01, TargetAreas=vtkFoamCoarsen.Measured)
        Messages(first)
        Messages(second)
        self.assertEqual(times(second)[0], 400 * 0.05)
        second.Update()
        films = second.GetOutput(0)
        end = times(first)[-1]
        self.assertLess(end, 400 * 0.05)
        self.assertEqual(single(films, "TimeValue"), end)
        self.assertEqual((times(second)[0], second.GetStartTime()), (end, end))

    def test_start_time_is_that_of_the_data(self):
        """Whatever time a pipeline shows them at."""
        films, _ = go_to(coarsening_of(foam_of_points()), 4)
        later = Later(films)
        second = coarsening_of(later, NumberOfFrames=2)
        offered = times(second)
        self.assertEqual((second.GetStartTime(), offered[0]), 2 * (single(films, "TimeValue"),))

    def test_between_frames(self):
        coarsen = coarsening_of(foam_of_points())
        offered = times(coarsen)
        for time_asked, frame in [(-1, 0), (offered[2] * (1 + 1e-12), 2), (offered[3] - 1e-12, 3),
                                  (0.9 * offered[4] + 0.1 * offered[3], 3)]:
            coarsen.UpdateTimeStep(time_asked)
            self.assertEqual(single(coarsen.GetOutput(0), "TimeValue"), offered[frame])

    def test_after_the_last_frame(self):
        coarsen = coarsening_of(foam_of_points(), NumberOfFrames=2)
        coarsen.UpdateTimeStep(100)
        self.assertEqual(single(coarsen.GetOutput(0), "TimeValue"), times(coarsen)[2])

    def test_no_time_asked(self):
        coarsen = coarsening_of(foam_of_points())
        coarsen.Update()
        self.assertEqual(single(coarsen.GetOutput(0), "TimeValue"), 0)


class FixedSteps(unittest.TestCase):
    """Newton in fixed steps."""

    def test_equilibria_in_any_order_and_resumed(self):
        foam = foam_of_points(periodic=True)
        stepping = {"Stepping": vtkFoamCoarsen.FixedSteps}
        forward = coarsening_of(foam, **stepping)
        frames = [go_to(forward, k)[0] for k in range(41)]
        for films in frames:
            self.assertEqual(single(films, "Converged"), 1)
            self.assertLess(single(films, "MaxAngleError"), 1e-8)
        self.assertGreater(single(frames[40], "T1Count"), 0)
        self.assertGreater(single(frames[40], "T2Count"), 0)
        for frame in (25, 3, 31):
            self.assertEqual(differences(go_to(forward, frame)[0], frames[frame]), [])
        resumed = coarsening_of(frames[30], **stepping)
        self.assertEqual(differences(go_to(resumed, 10)[0], frames[40]), [])
        by_events, _ = go_to(coarsening_of(foam), 40)
        self.assertAlmostEqual(single(frames[40], "Energy") / single(by_events, "Energy"), 1, delta=0.02)


class Scrubbing(unittest.TestCase):
    ORDER = [35, 12, 13, 0, 40, 9, 10, 11, 31, 30, 29, 3]

    @classmethod
    def setUpClass(cls):
        cls.foam = foam_of_points()
        forward = coarsening_of(cls.foam)
        cls.frames = [go_to(forward, k) for k in range(41)]

    def check(self, coarsen, order=None):
        for frame in order or self.ORDER:
            films, bubbles = go_to(coarsen, frame)
            self.assertEqual(differences(films, self.frames[frame][0]), [], frame)
            self.assertEqual(differences(bubbles, self.frames[frame][1]), [], frame)

    def test_same_bits_in_any_order(self):
        self.check(coarsening_of(self.foam))

    def test_little_memory(self):
        for memory in (0, 1):
            self.check(coarsening_of(self.foam, KeyframeMemory=memory))

    def test_memory_taken_away(self):
        coarsen = coarsening_of(self.foam)
        self.check(coarsen, [40])
        coarsen.SetKeyframeMemory(0)
        self.check(coarsen, [40, 39])

    def test_keyframes_and_looks_spare_work(self):
        coarsen = coarsening_of(foam_of_points(500, periodic=True))
        go_to(coarsen, 0)
        full = work(lambda: go_to(coarsen, 40))
        self.assertLess(work(lambda: go_to(coarsen, 30)), full / 4)
        self.assertLess(work(lambda: go_to(coarsen, 40)), full / 4)
        for name, value in [("ChordError", 0.01), ("NumberOfFrames", 50), ("KeyframeMemory", 7)]:
            getattr(coarsen, "Set" + name)(value)
            self.assertLess(work(lambda: go_to(coarsen, 40)), full / 4, name)

    def test_looks_keep_the_frames(self):
        coarsen = coarsening_of(self.foam, ChordError=0.001, NumberOfFrames=50, KeyframeMemory=7)
        go_to(coarsen, 25)
        set_properties(coarsen, {"ChordError": 0, "NumberOfFrames": 45, "KeyframeMemory": 9})
        self.check(coarsen, [25, 26])

    def test_physics_begin_anew(self):
        changes = {"TimeStep": 0.02, "Permeability": 2, "T1Length": 0.1, "T2Area": 0.1,
                   "Thresholds": vtkFoamCoarsen.Relative, "TwoSidedBubbles": vtkFoamCoarsen.Slide,
                   "KeyframeInterval": 7, "Tolerance": 1e-7, "MaximumIterations": 100}
        coarsen = coarsening_of(self.foam)
        for name, value in changes.items():
            default = getattr(coarsen, "Get" + name)()
            go_to(coarsen, 22)
            getattr(coarsen, "Set" + name)(value)
            changed, _ = go_to(coarsen, 22)
            fresh, _ = go_to(coarsening_of(self.foam, **{name: value}), 22)
            self.assertEqual(differences(changed, fresh), [], name)
            getattr(coarsen, "Set" + name)(default)
        self.check(coarsen, [22])

    def test_new_input_begins_anew(self):
        foam = foam_of_points()
        coarsen = coarsening_of(foam)
        go_to(coarsen, 5)
        foam.SetSurfaceTension(0.5)
        films, _ = go_to(coarsen, 5)
        self.assertEqual(single(films, "SurfaceTension"), 0.5)
        foam.SetSurfaceTension(0.25)
        self.check(coarsen, [5])

    def test_same_input_again_does_not(self):
        foam = foam_of_points(500, periodic=True)
        coarsen = coarsening_of(foam)
        full = work(lambda: go_to(coarsen, 40))
        foam.Modified()
        self.assertLess(work(lambda: go_to(coarsen, 40)), full / 2)

    def test_two_runs_give_the_same_bits(self):
        for k in (1, 40):
            films, bubbles = go_to(coarsening_of(foam_of_points()), k)
            self.assertEqual(differences(films, self.frames[k][0]), [])
            self.assertEqual(differences(bubbles, self.frames[k][1]), [])


class Progress(unittest.TestCase):
    def test_progress_and_abort(self):
        foam = foam_of_points(300, periodic=True)
        coarsen = coarsening_of(foam)
        go_to(coarsen, 0)
        seen = []

        def stop(*_):
            seen.append(coarsen.GetProgress())
            if coarsen.GetProgress() > 0.02:
                coarsen.SetAbortExecute(True)
                seen.append(time.perf_counter())

        tag = coarsen.AddObserver("ProgressEvent", stop)
        films, bubbles = go_to(coarsen, 300)
        self.assertLess(time.perf_counter() - seen[-1 if seen[-1] > 1 else -2], 1)
        reached = single(films, "TimeValue")
        offered = times(coarsen)
        frame = offered.index(reached)
        self.assertTrue(0 < frame < 300, frame)
        self.assertGreater(films.GetNumberOfLines(), 0)
        self.assertGreater(bubbles.GetNumberOfPolys(), 0)

        coarsen.RemoveObserver(tag)
        fresh = coarsening_of(foam)
        self.assertEqual(differences(go_to(fresh, frame)[0], films), [])
        self.assertEqual(differences(go_to(coarsen, frame + 3)[0], go_to(fresh, frame + 3)[0]), [])

    def test_progress_while_building(self):
        foam = foam_of_points(3000)
        seen = []
        foam.AddObserver("ProgressEvent", lambda *_: seen.append(foam.GetProgress()))
        foam.Update()
        self.assertEqual(seen, sorted(seen))
        self.assertEqual((seen[0], seen[-1]), (0, 1))
        self.assertGreater(len(set(seen)), 3, seen)

    def test_abort_while_building(self):
        foam = foam_of_points(3000)
        foam.AddObserver("ProgressEvent", lambda *_: foam.SetAbortExecute(foam.GetProgress() > 0))
        messages = Messages(foam)
        start = time.perf_counter()
        foam.Update()
        self.assertLess(time.perf_counter() - start, 3)
        self.assertEqual(messages.errors, [])
        self.assertEqual(foam.GetOutput(1).GetNumberOfPolys(), 3000)
        self.assertEqual(single(foam.GetOutput(0), "Converged"), 0)
        self.assertGreater(single(foam.GetOutput(0), "MaxAngleError"), 0)


class Memory(unittest.TestCase):
    """A frame that memory does not suffice for."""

    def test_the_last_whole_frame_is_kept(self):
        foam = foam_of_points(3000, periodic=True)
        foam.Update()
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "films.vtp"
            write(foam.GetOutput(0), path)
            subprocess.run([sys.executable, __file__, "in little memory", path], check=True)

    @staticmethod
    def run_in_little_memory(path):
        """In a process that has not computed before: nothing lies ready that was used once."""
        case = unittest.TestCase()
        coarsen = coarsening_of(read(path), TimeStep=0.01)
        first, _ = go_to(coarsen, 0)
        messages = Messages(coarsen)
        used = int(Path("/proc/self/statm").read_text().split()[0]) * resource.getpagesize()
        resource.setrlimit(resource.RLIMIT_AS, (used + (1 << 20), resource.RLIM_INFINITY))
        try:
            coarsen.UpdateTimeStep(times(coarsen)[1])
        finally:
            resource.setrlimit(resource.RLIMIT_AS, (resource.RLIM_INFINITY, resource.RLIM_INFINITY))
        case.assertEqual(len(messages.errors), 1)
        case.assertIn("Frame 1 could not be computed", messages.errors[0])
        case.assertEqual(differences(coarsen.GetOutput(0), first), [])
        coarsen.Modified()
        next_frame, _ = go_to(coarsen, 1)
        case.assertEqual(differences(next_frame, go_to(coarsening_of(first, TimeStep=0.01), 1)[0]), [])


class Warnings(unittest.TestCase):
    def test_the_end_of_a_run(self):
        """Four bubbles coarsen to two; one would have no junction."""
        foam = vtkFoamFromPoints()
        foam.SetInputData(points_of([(0, 0), (1, 0.1), (0.3, 1), (1.2, 1.3)]))
        coarsen = coarsening_of(foam, NumberOfFrames=400, T2Area=0.001, T1Length=0.001)
        messages = Messages(coarsen)
        films, bubbles = go_to(coarsen, 400)
        self.assertEqual(messages.errors, [])
        self.assertEqual(len(messages.warnings), 1, messages.warnings)
        self.assertIn("ended at time", messages.warnings[0])
        self.assertEqual(bubbles.GetNumberOfPolys(), 2)
        end = single(films, "TimeValue")
        coarsen.UpdateInformation()
        offered = times(coarsen)
        self.assertLess(len(offered), 401)
        self.assertEqual(offered[-1], end)
        for output in (films, bubbles):
            field = output.GetFieldData()
            self.assertEqual(single(output, "Ended"), 1)
            reason = field.GetAbstractArray("EndReason").GetValue(0)
            self.assertIn("one of the last two", reason)
            self.assertIn("2 sides", reason)
        before, _ = go_to(coarsen, len(offered) - 2)
        self.assertFalse(before.GetFieldData().HasArray("Ended"))
        again, _ = go_to(coarsen, len(offered) - 1)
        self.assertEqual(differences(again, films), [])
        self.assertEqual(len(messages.warnings), 1)

        resumed = coarsening_of(films, T2Area=0.001, T1Length=0.001)
        messages = Messages(resumed)
        go_to(resumed, 0)
        self.assertIn("one of the last two", messages.warnings[0])
        again, _ = go_to(resumed, 5)
        self.assertEqual(list(column(again.GetCellData(), "Length")),
                         list(column(films.GetCellData(), "Length")))
        self.assertEqual(len(messages.warnings), 2)

    def test_not_converged(self):
        foam = foam_of_points()
        foam.SetMaximumIterations(1)
        messages = Messages(foam)
        foam.Update()
        self.assertEqual(len(messages.warnings), 1)
        self.assertIn("residual", messages.warnings[0])
        self.assertEqual(single(foam.GetOutput(0), "Converged"), 0)

        coarsen = coarsening_of(foam_of_points(), MaximumIterations=1, KeyframeInterval=2)
        messages = Messages(coarsen)
        films = []
        while len(films) < min(6, len(times(coarsen))):
            films.append(go_to(coarsen, len(films))[0])
        flagged = sum(single(f, "Converged") == 0 for f in films)
        ended = len(times(coarsen)) < 6
        self.assertGreater(flagged + ended, 0)
        self.assertEqual(len(messages.warnings), flagged + ended)
        self.assertEqual(messages.errors, [])
        go_to(coarsen, min(3, len(times(coarsen)) - 1))
        self.assertEqual(len(messages.warnings), flagged + ended)


class Static(unittest.TestCase):
    def test_films_without_a_pipeline(self):
        foam = foam_of_points()
        foam.Update()
        producer = vtkTrivialProducer()
        producer.SetOutput(copy(foam.GetOutput(0)))
        coarsen = vtkFoamCoarsen()
        coarsen.SetInputConnection(producer.GetOutputPort())
        films, _ = go_to(coarsen, 3)
        self.assertEqual(differences(films, go_to(coarsening_of(foam), 3)[0]), [])

    def test_no_diffusion_no_change(self):
        coarsen = coarsening_of(foam_of_points(), Permeability=0)
        settled, _ = go_to(coarsen, 1)  # bubbles that are small from the start have vanished
        last, _ = go_to(coarsen, 15)
        self.assertTrue(
            math.isclose(single(last, "Energy"), single(settled, "Energy"), rel_tol=1e-9))


if __name__ == "__main__":
    if sys.argv[1:2] == ["in little memory"]:
        Memory.run_in_little_memory(sys.argv[2])
    else:
        unittest.main()
