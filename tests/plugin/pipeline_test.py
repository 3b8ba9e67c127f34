# SPDX-License-Identifier: GPL-3.0-or-later
"""From points to a written time series, as a user's script does it."""

import os
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree
from pathlib import Path

from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

simple.LoadPlugin(os.environ["FOAM_PLUGIN"], remote=False, ns=globals())


def fetch(source, port=0, time=None):
    """A copy of an output; the session is one process, so its data are here."""
    if time is None:
        source.SMProxy.UpdatePipeline()
    else:
        source.SMProxy.UpdatePipeline(time)
    output = source.GetClientSideObject().GetOutputDataObject(port)
    result = output.NewInstance()
    result.DeepCopy(output)
    return result


def values(data, name):
    return vtk_to_numpy(data.GetCellData().GetArray(name))


def film_bits(films):
    return [vtk_to_numpy(a).tobytes() for a in
            (films.GetPoints().GetData(), films.GetCellData().GetArray("HalfAngle"),
             films.GetFieldData().GetArray("BubblePressure"),
             films.GetFieldData().GetArray("TimeValue"))]


class Pipeline(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        points = FoamPoints(NumberOfPoints=60)
        self.foam = FoamFromPoints(Input=points, Boundary="Periodic")
        self.coarsen = FoamCoarsen(Input=self.foam, NumberOfFrames=25, TimeStep=1 / 30)
        self.expected = [k * (1 / 30) for k in range(26)]
        self.addCleanup(simple.ResetSession)

    def test_time_steps(self):
        self.assertEqual(list(self.coarsen.TimestepValues), self.expected)
        keeper = simple.GetTimeKeeper()
        self.assertEqual(list(keeper.TimestepValues), self.expected)

    def test_time_steps_follow_the_properties(self):
        self.coarsen.TimeStep = 0.5
        self.coarsen.NumberOfFrames = 2
        self.coarsen.UpdatePipelineInformation()
        self.assertEqual(list(self.coarsen.TimestepValues), [0, 0.5, 1])

    def test_frames(self):
        for k in (5, 25, 3):
            films = fetch(self.coarsen, time=self.expected[k])
            self.assertEqual(films.GetFieldData().GetArray("TimeValue").GetValue(0),
                             self.expected[k])
        bubbles = fetch(self.coarsen, 1, self.expected[3])
        self.assertEqual(bubbles.GetNumberOfPolys(), len(values(bubbles, "Area")))

    def write_series(self, name, port=0):
        path = self.folder / name
        simple.SaveData(str(path), proxy=servermanager.OutputPort(self.coarsen, port),
                        WriteTimeSteps=1)
        return path

    def test_series(self):
        for port in (0, 1):
            path = self.write_series(f"series{port}.pvd", port)
            sets = ElementTree.parse(path).getroot().findall("./Collection/DataSet")
            self.assertEqual([float(s.get("timestep")) for s in sets], self.expected)
            files = [path.parent / s.get("file") for s in sets]
            self.assertTrue(all(f.suffix == ".vtp" and f.exists() for f in files))

    def test_series_read_back(self):
        path = self.write_series("films.pvd")
        reader = simple.PVDReader(FileName=str(path))
        self.assertEqual(list(reader.TimestepValues), self.expected)
        for k in (0, 20, 24):
            self.assertEqual(film_bits(fetch(reader, time=reader.TimestepValues[k])),
                             film_bits(fetch(self.coarsen, time=self.expected[k])))

        # A file of the series alone, at a keyframe: the run goes on with the same bits.
        files = [s.get("file") for s in
                 ElementTree.parse(path).getroot().findall("./Collection/DataSet")]
        keyframe = simple.XMLPolyDataReader(FileName=[str(path.parent / files[20])])
        resumed = FoamCoarsen(Input=keyframe, NumberOfFrames=5)
        self.assertEqual(list(resumed.TimestepValues), self.expected[20:])
        for k in (20, 23, 25):
            self.assertEqual(film_bits(fetch(resumed, time=self.expected[k])),
                             film_bits(fetch(self.coarsen, time=self.expected[k])))

        # A series is taken at its last time or its first, at another through ForceTime.
        last = FoamCoarsen(Input=reader, NumberOfFrames=5)
        last.UpdatePipelineInformation()
        self.assertEqual((list(last.StartTime), last.TimestepValues[0]), ([self.expected[25]], self.expected[25]))
        self.assertEqual(film_bits(fetch(last, time=self.expected[25])),
                         film_bits(fetch(self.coarsen, time=self.expected[25])))
        first = FoamCoarsen(Input=reader, StartFrom="First", NumberOfFrames=25)
        self.assertEqual(list(first.StartTime), [0])
        self.assertEqual(list(resumed.StartTime), [self.expected[20]])
        self.assertEqual(film_bits(fetch(first, time=self.expected[21])),
                         film_bits(fetch(self.coarsen, time=self.expected[21])))
        forced = simple.ForceTime(Input=reader, ForcedTime=reader.TimestepValues[20])
        later = FoamCoarsen(Input=forced, NumberOfFrames=5)
        self.assertEqual(film_bits(fetch(later, time=self.expected[23])),
                         film_bits(fetch(self.coarsen, time=self.expected[23])))

    def test_the_end_of_a_run_is_in_the_time_line(self):
        """At once, and what goes on from there begins there, not before it is asked for a frame."""
        foam = FoamFromPoints(Input=FoamPoints(NumberOfPoints=6))
        run = FoamCoarsen(Input=foam, NumberOfFrames=400, TimeStep=0.05)
        after = FoamCoarsen(Input=run, NumberOfFrames=2, TimeStep=0.01, TargetAreas="Measured")
        self.assertEqual(len(run.TimestepValues), 401)
        self.assertEqual((after.StartTime[0], list(after.TimestepValues)[0]), (20, 20))
        after.UpdatePipeline()
        run.UpdatePipeline(20)
        end = run.TimestepValues[-1]
        self.assertLess(end, 20)
        self.assertEqual((after.StartTime[0], after.TimestepValues[0]), (end, end))
        after.StartFrom = "First"
        after.UpdatePipeline()
        self.assertEqual((after.StartTime[0], after.TimestepValues[0]), (0, 0))
        for proxy in (after, run):
            simple.Delete(proxy)

    def test_series_continued(self):
        path = self.write_series("films.pvd")
        last = simple.XMLPolyDataReader(FileName=[str(path.parent / "films/films_0020.vtp")])
        resumed = FoamCoarsen(Input=last, NumberOfFrames=12)
        simple.SaveData(str(path), proxy=resumed, Append=1)
        reader = simple.PVDReader(FileName=str(path))
        self.assertEqual(list(reader.TimestepValues),
                         self.expected[:20] + list(resumed.TimestepValues))
        self.assertEqual(film_bits(fetch(reader, time=self.expected[25])),
                         film_bits(fetch(self.coarsen, time=self.expected[25])))

    def test_saved_under_the_name_that_it_is_read_from(self):
        path = self.write_series("films.pvd")
        reader = simple.PVDReader(FileName=str(path))
        simple.SaveData(str(path), proxy=reader, WriteTimeSteps=1)
        again = simple.PVDReader(FileName=str(path))
        self.assertEqual(list(again.TimestepValues), self.expected)
        for time in self.expected:
            self.assertEqual(film_bits(fetch(again, time=time)), film_bits(fetch(self.coarsen, time=time)))
        self.assertEqual(sorted(p.name for p in self.folder.rglob("*.*")),
                         ["films.pvd", *(f"films_{k:04d}.vtp" for k in range(26))])

    def test_other_data_keep_their_writer(self):
        with_field_data = simple.TrivialProducer()
        data = fetch(simple.Sphere())
        data.GetFieldData().AddArray(fetch(self.coarsen).GetFieldData().GetArray("TimeValue"))
        with_field_data.GetClientSideObject().SetOutput(data)
        path = self.write_series("films.pvd")
        for source, port, writer in ((self.coarsen, 0, "FoamSeriesWriter"), (self.coarsen, 1, "FoamSeriesWriter"),
                                     (simple.PVDReader(FileName=str(path)), 0, "FoamSeriesWriter"),
                                     (simple.Transform(Input=self.coarsen), 0, "FoamSeriesWriter"),
                                     (simple.Sphere(), 0, "XMLPVDWriter"), (with_field_data, 0, "XMLPVDWriter"),
                                     (FoamPoints(), 0, "XMLPVDWriter")):
            made = simple.CreateWriter(str(self.folder / "some.pvd"), servermanager.OutputPort(source, port))
            self.assertEqual(made.GetXMLName(), writer)

    def test_statistics(self):
        statistics = FoamStatistics(Input=self.coarsen)
        for k in (0, 10):
            summary = fetch(statistics, 0, self.expected[k])
            self.assertEqual(summary.GetValueByName(0, "Time").ToDouble(), self.expected[k])
            self.assertEqual(summary.GetValueByName(0, "Bubbles").ToInt(),
                             fetch(self.coarsen, 1, self.expected[k]).GetNumberOfPolys())
        self.assertGreater(fetch(statistics, 1, 0).GetNumberOfRows(), 2)
        self.assertEqual(fetch(statistics, 2, 0).GetNumberOfRows(), 60)

    def test_target_areas_from_a_table(self):
        table = self.folder / "bubbles.csv"
        rows = [(x + 0.2 * (y % 2), y + 0.1 * (x % 3), 0.8 + 0.05 * ((x + y) % 3))
                for x in range(5) for y in range(5)]
        table.write_text("x,y,area\n" + "\n".join(f"{x},{y},{a}" for x, y, a in rows))
        reader = simple.CSVReader(FileName=[str(table)])
        points = simple.TableToPoints(Input=reader, XColumn="x", YColumn="y", a2DPoints=1)
        foam = FoamFromPoints(Input=points, TargetAreas="Array", TargetAreaArray="area")
        bubbles = fetch(foam, 1)
        self.assertEqual(list(values(bubbles, "TargetArea")), [a for _, _, a in rows])
        self.assertEqual(foam.TargetAreaArray, "area")

    def test_bad_input_gives_nothing(self):
        self.foam.SurfaceTension = -1
        self.assertEqual(fetch(self.foam).GetNumberOfLines(), 0)
        self.foam.SurfaceTension = 0.25
        self.assertGreater(fetch(self.foam).GetNumberOfLines(), 0)
        sphere = simple.Sphere()
        self.assertEqual(fetch(FoamCoarsen(Input=sphere)).GetNumberOfLines(), 0)
        self.assertEqual(fetch(FoamFromPoints(Input=sphere)).GetNumberOfLines(), 0)


if __name__ == "__main__":
    unittest.main()
