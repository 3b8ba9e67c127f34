# SPDX-License-Identifier: GPL-3.0-or-later
"""Series on disk: whole at every moment, continued after a stop, never at the cost of another; what is told."""

import errno
import os
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree
from pathlib import Path

from vtkmodules.util.vtkAlgorithm import VTKPythonAlgorithmBase
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkMultiBlockDataSet, vtkPolyData, vtkTable
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline, vtkTrivialProducer

from foam.vtkFoamFilters import vtkFoamFromPoints, vtkFoamSeriesWriter
from foam_testing import (Messages, coarsening_of, differences, differences_of_foams, foam_of_points, go_to,
                          points_of, read, single, times)

FRAMES = 24
NOBODY = 65534


def writer_of(source, path, port=0, **properties):
    writer = vtkFoamSeriesWriter()
    writer.SetInputConnection(source.GetOutputPort(port))
    writer.SetFileName(str(path))
    for name, value in properties.items():
        getattr(writer, "Set" + name)(value)
    return writer


def entries(path):
    """Times and files that a .pvd lists."""
    listed = ElementTree.parse(path).getroot().findall("./Collection/DataSet")
    return [(float(e.get("timestep")), path.parent / e.get("file")) for e in listed]


class Reader(VTKPythonAlgorithmBase):
    """A series read frame by frame, when each is asked for, at times scaled by a factor; or backwards."""

    def __init__(self, path, factor=1, backwards=False):
        super().__init__(nInputPorts=0, nOutputPorts=1, outputType="vtkPolyData")
        listed_times, listed_files = zip(*entries(path))
        self.entries = list(zip([factor * time for time in listed_times],
                                reversed(listed_files) if backwards else listed_files))

    def RequestInformation(self, _request, _inputs, outputs):
        offered = [time for time, _ in self.entries]
        information = outputs.GetInformationObject(0)
        information.Set(vtkStreamingDemandDrivenPipeline.TIME_STEPS(), offered, len(offered))
        information.Set(vtkStreamingDemandDrivenPipeline.TIME_RANGE(), [offered[0], offered[-1]], 2)
        return 1

    def RequestData(self, _request, _inputs, outputs):
        asked = outputs.GetInformationObject(0).Get(vtkStreamingDemandDrivenPipeline.UPDATE_TIME_STEP())
        time, file = min(self.entries, key=lambda entry: abs(entry[0] - asked))
        output = vtkPolyData.GetData(outputs)
        output.ShallowCopy(read(file))
        output.GetInformation().Set(output.DATA_TIME_STEP(), time)
        return 1


def files(folder):
    return sorted(p.relative_to(folder).as_posix() for p in folder.rglob("*") if p.is_file())


class Series(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.foam = foam_of_points()
        coarsen = coarsening_of(cls.foam, NumberOfFrames=FRAMES)
        cls.times = times(coarsen)
        cls.frames = [go_to(coarsen, k) for k in range(FRAMES + 1)]

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.path = self.folder / "films.pvd"
        self.coarsen = coarsening_of(self.foam, NumberOfFrames=FRAMES)

    def check(self, count, port=0):
        """The series has the first frames of the run, whole, and there is no other file."""
        listed = entries(self.path)
        self.assertEqual([t for t, _ in listed], self.times[:count])
        for (_, file), frame in zip(listed, self.frames):
            self.assertEqual(differences_of_foams(read(file), frame[port]), [], file)
        names = [f"films/films_{k:04d}.vtp" for k in range(count)]
        self.assertEqual(files(self.folder), sorted(names + ["films.pvd"]))

    def write_until(self, frame, action):
        """Writes, and acts once that frame is there."""
        writer = writer_of(self.coarsen, self.path)

        def act(*_):
            if round(writer.GetProgress() * (FRAMES + 1)) == frame + 1:
                action(writer)

        writer.AddObserver("ProgressEvent", act)
        messages = Messages(writer)
        return writer.Write(), writer.GetErrorCode(), messages.errors

    def go_on_from(self, keyframe):
        """Continues the series from the file of a keyframe."""
        resumed = coarsening_of(read(self.folder / f"films/films_{keyframe:04d}.vtp"),
                                NumberOfFrames=FRAMES - keyframe)
        self.assertEqual(writer_of(resumed, self.path, Append=True).Write(), 1)
        self.check(FRAMES + 1)


class Listed(Series):
    def test_a_file_that_is_listed_twice_is_kept(self):
        """A series that was edited by hand to end with its first frame again goes on from frame 10."""
        writer_of(self.coarsen, self.path).Write()
        again = f'<DataSet timestep="{self.times[FRAMES] + 1}" part="0" file="films/films_0000.vtp"/>'
        self.path.write_text(self.path.read_text().replace("</Collection>", again + "</Collection>"))
        self.go_on_from(10)


    def test_what_entries_say_is_kept(self):
        writer_of(self.coarsen, self.path).Write()
        said = 'group="g" part="3" name="a &amp; b" '
        self.path.write_text(self.path.read_text().replace("file=", said + "file="))
        self.go_on_from(10)
        listed = ElementTree.parse(self.path).getroot().findall("./Collection/DataSet")
        kept = [(e.get("group"), e.get("part"), e.get("name")) for e in listed]
        self.assertEqual(kept, 10 * [("g", "3", "a & b")] + (FRAMES - 9) * [(None, None, None)])

    def test_a_link(self):
        """What it leads to is written, and continued."""
        (self.folder / "data").mkdir()
        self.path, link = self.folder / "data" / "films.pvd", self.folder / "latest.pvd"
        writer_of(coarsening_of(self.foam, NumberOfFrames=3), self.path).Write()
        link.symlink_to("data/films.pvd")
        for append in (True, False):
            self.assertEqual(writer_of(self.coarsen, link, Append=append).Write(), 1)
            self.assertTrue(link.is_symlink())
            self.assertEqual([t for t, _ in entries(self.path)], self.times)
        self.assertEqual(sorted(p.name for p in self.folder.iterdir()), ["data", "latest.pvd"])


class Writing(Series):
    def test_films(self):
        self.assertEqual(writer_of(self.coarsen, self.path).Write(), 1)
        self.check(FRAMES + 1)

    def test_bubbles(self):
        self.assertEqual(writer_of(self.coarsen, self.path, port=1).Write(), 1)
        self.check(FRAMES + 1, port=1)

    def test_whole_at_every_frame(self):
        seen = []
        writer = writer_of(self.coarsen, self.path)

        def look(*_):
            if 0 < writer.GetProgress() < 1:
                seen.append(len(entries(self.path)))
                self.check(seen[-1])

        writer.AddObserver("ProgressEvent", look)
        writer.Write()
        self.assertEqual(seen, list(range(1, FRAMES + 1)))

    def test_one_frame_at_a_time(self):
        for k in range(5):
            go_to(self.coarsen, k)
            writer = writer_of(self.coarsen, self.path, WriteTimeSteps=False, Append=k > 0)
            self.assertEqual(writer.Write(), 1)
            self.check(k + 1)

    def test_a_run_that_ends(self):
        """The frame of the end is the last that is written, and says so, in films and in bubbles."""
        foam = vtkFoamFromPoints()
        foam.SetInputData(points_of([(0, 0), (1, 0.1), (0.3, 1), (1.2, 1.3)]))
        for port in (0, 1):
            coarsen = coarsening_of(foam, NumberOfFrames=400, T2Area=0.001, T1Length=0.001)
            self.assertEqual(writer_of(coarsen, self.path, port=port).Write(), 1)
            listed = entries(self.path)
            self.assertLess(len(listed), 401)
            ended = [read(file).GetFieldData().HasArray("Ended") for _, file in listed]
            self.assertEqual(ended, [0] * (len(listed) - 1) + [1])
            coarsen.UpdateInformation()
            self.assertEqual([time for time, _ in listed], times(coarsen))

    def test_without_time(self):
        self.assertEqual(writer_of(self.foam, self.path).Write(), 1)
        self.check(1)

    def test_replaced(self):
        """A longer series gives way, and files that are not its own stay."""
        writer_of(self.coarsen, self.path).Write()
        note = self.folder / "films" / "note.txt"
        note.write_text("mine")
        self.coarsen.SetNumberOfFrames(7)
        writer_of(self.coarsen, self.path).Write()
        self.assertEqual(note.read_text(), "mine")
        note.unlink()
        self.check(8)

    def test_other_pieces_write_nothing(self):
        self.assertEqual(writer_of(self.coarsen, self.path, Piece=1, NumberOfPieces=2).Write(), 1)
        self.assertEqual(files(self.folder), [])

    def test_special_characters(self):
        self.path = self.folder / 'a "b" & <c> 100% é.pvd'
        writer_of(self.foam, self.path).Write()
        ((_, file),) = entries(self.path)
        self.assertEqual(differences_of_foams(read(file), self.frames[0][0]), [])


class Stopping(Series):
    def test_stopped_and_continued(self):
        """A long run is stopped after frame 14 and continued from keyframe 10: as one that was not."""
        self.coarsen.SetNumberOfFrames(400)
        writer = writer_of(self.coarsen, self.path)
        messages = Messages(writer)

        def stop(*_):
            if self.path.exists() and len(entries(self.path)) > 14:
                self.coarsen.SetAbortExecute(True)

        self.coarsen.AddObserver("ProgressEvent", stop)
        self.assertEqual(writer.Write(), 1)
        self.assertEqual(messages.errors, [])
        self.assertTrue(14 < len(entries(self.path)) < 400)
        self.go_on_from(10)

    def test_writer_stopped(self):
        self.write_until(5, lambda writer: writer.SetAbortExecute(True))
        self.check(7)

    def test_killed(self):
        """Killed in the middle of writing a file: what is listed is whole, and the run goes on."""
        for attempt in range(4):
            process = subprocess.Popen([sys.executable, __file__, "write", str(self.path)])
            data = self.folder / "films"
            unfinished = False
            while process.poll() is None:
                names = os.listdir(data) if data.exists() else []
                unfinished = any(n.startswith(".unfinished") for n in names)
                if unfinished and sum(n.endswith(".vtp") for n in names) > 11 + attempt:
                    break
            process.send_signal(signal.SIGKILL)
            process.wait()
            self.assertTrue(unfinished)
            listed = entries(self.path)
            self.assertGreater(len(listed), 10)
            self.assertEqual([t for t, _ in listed], self.times[:len(listed)])
            for file in data.glob("films_*.vtp"):
                k = int(file.stem.split("_")[1])
                self.assertEqual(differences(read(file), self.frames[k][0]), [], file)
        known = {file for _, file in listed}
        for file in (f for f in data.iterdir() if f not in known):
            file.unlink()
        self.go_on_from(10)


def contents(path):
    """What lies on the disk of a series."""
    return {p: p.read_bytes() for p in [path, *(file for _, file in entries(path))]}


class InPlaceOfAnother(Series):
    """A series takes the name of another that is there."""

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.original = Path(folder.name)
        writer_of(coarsening_of(cls.foam, NumberOfFrames=FRAMES), cls.original / "films.pvd").Write()

    def setUp(self):
        super().setUp()
        shutil.copytree(self.original, self.folder, dirs_exist_ok=True)

    def thin(self, kept):
        """Leaves of the series the frames of these numbers alone."""
        root = ElementTree.parse(self.path)
        collection = root.find("Collection")
        for k, element in enumerate(collection.findall("DataSet")):
            if k not in kept:
                collection.remove(element)
                (self.folder / element.get("file")).unlink()
        root.write(self.path)

    def check_frames(self, numbers, shown_at=None, path=None):
        """The frames of these numbers, at their times or at those that they are shown at."""
        listed = entries(path or self.path)
        self.assertEqual([t for t, _ in listed], shown_at or [self.times[k] for k in numbers])
        for (time, file), k in zip(listed, numbers):
            films = read(file)
            other = ["FieldData TimeValue"] if time != self.times[k] else []
            self.assertEqual(differences(films, self.frames[k][0]), other, file)
            self.assertEqual(single(films, "TimeValue"), time)

    def test_under_the_name_that_it_is_read_from(self):
        self.assertEqual(writer_of(Reader(self.path), self.path).Write(), 1)
        self.check(FRAMES + 1)

    def test_thinned_under_the_name_that_it_is_read_from(self):
        """The new frames would have names of old ones that are still to be read."""
        kept = [0, 1, 5, 6, 7, 20]
        self.thin(kept)
        self.assertEqual(writer_of(Reader(self.path), self.path).Write(), 1)
        self.check_frames(kept)

    def test_read_in_another_order(self):
        """What is read last is what would be overwritten first."""
        self.assertEqual(writer_of(Reader(self.path, backwards=True), self.path).Write(), 1)
        self.check_frames(range(FRAMES, -1, -1), self.times)

    def test_stretched_and_continued(self):
        """Old frames that are given up are read to the end."""
        self.assertEqual(writer_of(Reader(self.path, factor=2), self.path, Append=True).Write(), 1)
        self.check_frames(range(FRAMES + 1), [2 * t for t in self.times])

    def check_untouched(self, before, messages):
        """The old series is there, and the new one as far as it came."""
        self.assertTrue(contents(self.path) == before)
        self.assertEqual(len(messages.warnings), 1, messages.warnings)
        unfinished = self.folder / ".unfinished-films.pvd"
        self.assertIn(str(unfinished), messages.warnings[0])
        self.check_frames(range(7), [2 * t for t in self.times[:7]], unfinished)

    def write_part(self, action):
        writer = writer_of(Reader(self.path, factor=2), self.path)
        writer.AddObserver("ProgressEvent", lambda *_: action(writer) if len(self.unfinished()) == 6 else None)
        messages = Messages(writer)
        return writer.Write(), messages

    def unfinished(self):
        path = self.folder / ".unfinished-films.pvd"
        return entries(path) if path.exists() else []

    def test_stopped(self):
        before = contents(self.path)
        written, messages = self.write_part(lambda writer: writer.SetAbortExecute(True))
        self.assertEqual(written, 1)
        self.check_untouched(before, messages)

    def test_source_fails(self):
        """An empty frame is an error, and what was to be replaced stays."""
        before = contents(self.path)

        reader = Reader(self.path, factor=2)
        whole = reader.RequestData
        frames = []

        def request_data(request, inputs, outputs):
            frames.append(None)
            return whole(request, inputs, outputs) if len(frames) < 8 else 1

        reader.RequestData = request_data
        writer = writer_of(reader, self.path)
        messages = Messages(writer)
        self.assertEqual(writer.Write(), 0)
        self.assertEqual(len(messages.errors), 1, messages.errors)
        self.check_untouched(before, messages)

    def write_without(self, empty, path):
        """Writes the series read from its files, of which some are empty."""
        reader = Reader(self.path)
        whole = reader.RequestData

        def request_data(request, inputs, outputs):
            asked = outputs.GetInformationObject(0).Get(vtkStreamingDemandDrivenPipeline.UPDATE_TIME_STEP())
            if asked in [self.times[k] for k in empty]:
                vtkPolyData.GetData(outputs).Initialize()
                return 1
            return whole(request, inputs, outputs)

        reader.RequestData = request_data
        writer = writer_of(reader, path)
        messages = Messages(writer)
        return writer.Write(), messages

    def test_empty_frames_are_left_out(self):
        for empty in ([0], [5], [3, 4, 20], [FRAMES]):
            path = self.folder / f"without_{empty[0]}.pvd"
            written, messages = self.write_without(empty, path)
            self.assertEqual((written, messages.errors, len(messages.warnings)), (1, [], 1))
            for part in (f"{len(empty)} of {FRAMES + 1}", f"{self.times[empty[0]]:g}"[:7]):
                self.assertIn(part, messages.warnings[0])
            left = [k for k in range(FRAMES + 1) if k not in empty]
            self.assertEqual([t for t, _ in entries(path)], [self.times[k] for k in left])
            for k, (_, file) in zip(left, entries(path)):
                self.assertEqual(differences_of_foams(read(file), self.frames[k][0]), [])

    def test_in_its_own_place_without_an_empty_frame(self):
        written, messages = self.write_without([5], self.path)
        self.assertEqual((written, messages.errors, len(messages.warnings)), (1, [], 1))
        self.check_frames([k for k in range(FRAMES + 1) if k != 5])

    def test_killed(self):
        before = contents(self.path)
        process = subprocess.Popen([sys.executable, __file__, "write", str(self.path)])
        while process.poll() is None and len(list(self.path.parent.glob("films/.unfinished-new-*"))) < 9:
            pass
        process.send_signal(signal.SIGKILL)
        process.wait()
        self.assertTrue(contents(self.path) == before)
        self.assertEqual(writer_of(Reader(self.path), self.path).Write(), 1)
        self.check_frames(range(FRAMES + 1))

    def test_thinned_and_continued(self):
        """Kept frames keep their names and bits, new ones get names that are free."""
        kept = [0, 3, 6, 9, 12, 20]
        self.thin(kept)
        before = {file: file.read_bytes() for time, file in entries(self.path) if time < self.times[20]}
        resumed = coarsening_of(self.frames[20][0], NumberOfFrames=FRAMES - 20)
        self.assertEqual(writer_of(resumed, self.path, Append=True).Write(), 1)
        self.check_frames([*kept, *range(21, FRAMES + 1)])
        now = contents(self.path)
        self.assertEqual([file for file in before if now.get(file) != before[file]], [])

    def test_a_file_that_is_not_listed_stays(self):
        self.thin(range(12))
        stray = self.folder / "films" / "films_0012.vtp"
        stray.write_text("mine")
        resumed = coarsening_of(self.frames[10][0], NumberOfFrames=FRAMES - 10)
        self.assertEqual(writer_of(resumed, self.path, Append=True).Write(), 1)
        self.check_frames(range(FRAMES + 1))
        self.assertEqual(stray.read_text(), "mine")

    def test_continued_from_before_its_end(self):
        """The old end is there until the new frames reach as far; from then on they are, one by one."""
        writer = writer_of(coarsening_of(self.frames[10][0], NumberOfFrames=FRAMES), self.path, Append=True)
        seen = []

        def look(*_):
            if 0 < writer.GetProgress() < 1:
                listed = entries(self.path)
                seen.append(len(listed))
                for time, file in listed[9::4]:
                    self.assertEqual(single(read(file), "TimeValue"), time)

        writer.AddObserver("ProgressEvent", look)
        self.assertEqual(writer.Write(), 1)
        self.assertEqual(seen, [max(k, FRAMES + 1) for k in range(11, 11 + FRAMES)])
        self.assertEqual(files(self.folder),
                         sorted([f"films/films_{k:04d}.vtp" for k in range(11 + FRAMES)] + ["films.pvd"]))


class Trouble(Series):
    def test_disk_full(self):
        """The system refuses to let a file grow: the frames before are whole, and the run goes on."""
        old = resource.getrlimit(resource.RLIMIT_FSIZE)

        def fill(_):
            resource.setrlimit(resource.RLIMIT_FSIZE, (2000, old[1]))

        try:
            written, error, errors = self.write_until(11, fill)
        finally:
            resource.setrlimit(resource.RLIMIT_FSIZE, old)
        self.assertEqual((written, error), (0, errno.EFBIG))
        self.assertEqual(len(errors), 1, errors)
        self.assertIn("films_0012.vtp", errors[0])
        self.assertIn(os.strerror(errno.EFBIG), errors[0])
        self.check(12)
        self.go_on_from(10)

    def test_read_only_folder(self):
        self.folder.chmod(0o555)
        root = os.geteuid() == 0  # whom permissions do not hold back
        try:
            if root:
                os.seteuid(NOBODY)
            writer = writer_of(self.coarsen, self.path)
            messages = Messages(writer)
            self.assertEqual(writer.Write(), 0)
            self.assertEqual(writer.GetErrorCode(), errno.EACCES)
        finally:
            if root:
                os.seteuid(0)
            self.folder.chmod(0o755)
        self.assertEqual(len(messages.errors), 1, messages.errors)
        self.assertIn(str(self.folder), messages.errors[0])
        self.assertEqual(files(self.folder), [])

    def test_no_foam(self):
        self.coarsen.SetTimeStep(-1)
        Messages(self.coarsen)
        writer = writer_of(self.coarsen, self.path)
        messages = Messages(writer)
        self.assertEqual(writer.Write(), 0)
        self.assertEqual(len(messages.errors), 1, messages.errors)
        self.assertEqual(files(self.folder), [])

    def test_what_cannot_be_films_or_bubbles(self):
        """Is named once, and a series that is there stays."""
        writer_of(self.coarsen, self.path).Write()
        blocks = vtkMultiBlockDataSet()
        blocks.SetBlock(0, self.frames[0][0])
        for data in (blocks, vtkTable(), vtkImageData()):
            producer = vtkTrivialProducer()
            producer.SetOutput(data)
            writer = writer_of(producer, self.path)
            messages = Messages(writer)
            self.assertEqual((writer.Write(), writer.GetErrorCode() != 0), (0, True))
            self.assertEqual((len(messages.errors), messages.warnings), (1, []), messages.errors)
            for part in (data.GetClassName(), "wanted", "films or bubbles"):
                self.assertIn(part, messages.errors[0])
        self.check(FRAMES + 1)

    def test_a_folder_of_the_name(self):
        self.path.mkdir()
        writer = writer_of(self.coarsen, self.path)
        messages = Messages(writer)
        self.assertEqual(writer.Write(), 0)
        self.assertEqual(len(messages.errors), 1, messages.errors)
        self.assertIn("is a folder", messages.errors[0])
        self.assertEqual(list(self.folder.rglob("*")), [self.path])

    def test_nothing_to_continue(self):
        self.path.write_text("<VTKFile/>")
        writer = writer_of(self.coarsen, self.path, Append=True)
        messages = Messages(writer)
        self.assertEqual(writer.Write(), 0)
        self.assertEqual(len(messages.errors), 1, messages.errors)
        self.assertIn(str(self.path), messages.errors[0])
        self.assertEqual(self.path.read_text(), "<VTKFile/>")
        self.assertEqual(writer_of(self.coarsen, self.path).Write(), 1)
        self.check(FRAMES + 1)


if __name__ == "__main__":
    if sys.argv[1:2] == ["write"]:
        writer_of(coarsening_of(foam_of_points(), NumberOfFrames=FRAMES), sys.argv[2]).Write()
    else:
        unittest.main()
