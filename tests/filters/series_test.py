# SPDX-License-Identifier: GPL-3.0-or-later
"""Series on disk: whole at every moment, continued after a stop; what is told when there is trouble."""

import errno
import os
import resource
import signal
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree
from pathlib import Path

from foam.vtkFoamFilters import vtkFoamFromPoints, vtkFoamSeriesWriter
from foam_testing import (Messages, coarsening_of, differences, foam_of_points, go_to, points_of, read,
                          times)

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
            self.assertEqual(differences(read(file), frame[port]), [], file)
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
        self.assertEqual(differences(read(file), self.frames[0][0]), [])


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
        for file in data.glob(".unfinished*"):
            file.unlink()
        self.go_on_from(10)


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
