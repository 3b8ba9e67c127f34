# SPDX-License-Identifier: GPL-3.0-or-later
"""What experiments leave in the output folder, written as it comes and read back for the page.

For every run of an experiment <experiment>/<run>.json (what was run and how it went), .csv (a row per frame),
.quality.csv (a row per examined frame) and .films.npz (polylines of the frames to be drawn).
"""
import csv
import json
import os

import numpy as np


class Table:
    """A CSV file that grows by a row at a time, so that a run that is cut off keeps what it has."""

    def __init__(self, path):
        path.parent.mkdir(parents=True, exist_ok=True)
        self._file = open(path, "w", newline="")
        self._writer = None

    def add(self, row):
        if not self._writer:
            self._writer = csv.DictWriter(self._file, fieldnames=row)
            self._writer.writeheader()
        self._writer.writerow(row)
        self._file.flush()

    def close(self):
        self._file.close()


def columns(path):
    """The columns of a Table as arrays of floats, but for a last row that was cut off; none of a table without rows."""
    with open(path, newline="") as file:
        rows = list(csv.reader(file))
    rows = [row for row in rows if len(row) == len(rows[0])]
    if len(rows) < 2:
        return {}
    values = np.array(rows[1:], dtype=float).reshape(-1, len(rows[0]))
    return {name: values[:, i] for i, name in enumerate(rows[0])}


def write_whole(path, write):
    """Lets write(path) write under another name first: what has its name is complete."""
    path.parent.mkdir(parents=True, exist_ok=True)
    unfinished = path.with_name(f".unfinished-{path.name}")
    write(unfinished)
    os.replace(unfinished, path)


def write_json(path, content):
    write_whole(path, lambda unfinished: unfinished.write_text(json.dumps(content, indent=1) + "\n"))


class Result:
    """A run's results, read back."""

    def __init__(self, folder, run_name):
        self.about = json.loads((folder / f"{run_name}.json").read_text())
        if self.about["status"] == "running":
            self.about["status"] = "still running, or stopped, when the page was written"
        self.frames = columns(folder / f"{run_name}.csv")
        quality = folder / f"{run_name}.quality.csv"
        self.quality = columns(quality) if quality.exists() else {}
        films = folder / f"{run_name}.films.npz"
        self.films = dict(np.load(films)) if films.exists() else {}

    def last(self, column):
        return self.frames[column][-1]

    def at(self, seconds, column):
        """A column's value in the last frame that is not later."""
        return self.frames[column][max(0, np.searchsorted(self.frames["Time"], seconds + 1e-6) - 1)]

    def drawn_lines(self, frame):
        """The polylines of a drawn frame."""
        return np.split(self.films[f"points{frame}"], self.films[f"offsets{frame}"][1:-1])


def read(folder, experiment):
    """The results of an experiment's runs by their names, of those that are there and got anywhere."""
    there = {run.name: Result(folder / experiment.name, run.name) for run in experiment.runs
             if (folder / experiment.name / f"{run.name}.csv").exists()}
    return {name: result for name, result in there.items() if result.frames}
