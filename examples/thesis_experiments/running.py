# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the experiments and leaves their results."""
import os
import time

import numpy as np

from thesis_experiments import measures, published, scale
from thesis_experiments.experiments import Sweeps
from thesis_experiments.foams import Coarsening, FoamFailure, Source, field_value, newton, thesis
from thesis_experiments.results import Table, write_json, write_whole

SECONDS_BETWEEN_REPORTS = 20


def run(experiment, wanted, folder, minutes, quick):
    """Runs an experiment, or those of its runs that are wanted by name, each for so many minutes at most."""
    if isinstance(experiment, Sweeps):
        run_sweeps(experiment.miniature() if quick else experiment, folder, minutes)
        return
    for one in experiment.runs:
        if experiment.name in wanted or f"{experiment.name}/{one.name}" in wanted:
            Recording(one.miniature() if quick else one, folder / experiment.name, minutes).go()


class Recording:
    """Coarsens one foam until its frames are done, its foam has ended, or the minutes are over; keeps the results."""

    def __init__(self, run, folder, minutes):
        self.run = run
        self.path = lambda ending: folder / f"{run.name}.{ending}"
        self.title = f"{folder.name}/{run.name}"
        self.deadline = time.monotonic() + 60 * minutes
        self.about = {
            "label": run.method.label, "bubbles": run.bubbles, "spacing": scale.spacing(), "steps": run.steps,
            "frames_per_step": run.frames_per_step, "time_step": run.frames_per_step * scale.time_step(),
            "examine_every": run.examine_every, "cores": os.cpu_count(), "status": "running", "snapshots": []}
        self.films = {}

    def go(self):
        if missing := self.run.method.missing_properties():
            self.about["status"] = f"skipped: the filters have no {' and no '.join(missing)}"
            print(f"{self.title}: {self.about['status']}", flush=True)
            write_json(self.path("json"), self.about)
            return
        write_json(self.path("json"), self.about)
        table = Table(self.path("csv"))
        quality = Table(self.path("quality.csv")) if self.run.examine_every else None
        begin = reported = time.monotonic()
        clocks = time.perf_counter(), time.process_time()
        try:
            coarsening = Coarsening(Source(self.run.bubbles, self.run.method), self.run.method,
                                    self.about["time_step"], self.run.steps, **self.run.properties)
            for step in range(self.run.steps + 1):
                coarsening.go_to(step)
                row = self._row(coarsening, step, clocks)
                self.about["status"] = self._status(coarsening, row, step)
                if coarsening.ended:
                    self._take_snapshot(coarsening, before)
                    break
                before = row
                table.add(row)
                last = self.about["status"] != "running"
                if last or row["Frame"] in self._picture_frames():
                    self._take_snapshot(coarsening, row)
                if quality and step % self.run.examine_every == 0:
                    quality.add({"Frame": row["Frame"], **self._quality(coarsening, step)})
                if time.monotonic() - reported > SECONDS_BETWEEN_REPORTS or last:
                    reported = time.monotonic()
                    print(f"{self.title}: frame {row['Frame']} of {self.run.frames + 1}, t = {row['Time']:.2f} s, "
                          f"{row['Bubbles']} bubbles, {reported - begin:.0f} s", flush=True)
                if last:
                    break
                clocks = time.perf_counter(), time.process_time()
        except FoamFailure as failure:
            self.about["status"] = f"went wrong: {failure}"
        self.about["seconds"] = time.monotonic() - begin
        print(f"{self.title}: {self.about['status']}", flush=True)
        write_json(self.path("json"), self.about)
        table.close()

    def _row(self, coarsening, step, clocks):
        """What is kept of the step that has just been computed since the clocks were read, wall and processor."""
        wall, cpu = time.perf_counter() - clocks[0], time.process_time() - clocks[1]
        every, bulk = ({name: values[0] for name, values in coarsening.statistics(0, boundary).items()}
                       for boundary in (True, False))
        films = coarsening.films
        return {"Frame": 1 + step * self.run.frames_per_step,
                **{name: every[name] for name in ("Time", "Bubbles", "Mu2", "MeanArea", "Energy", "T1Count", "T2Count",
                                                  "T3Count", "Iterations", "MaxAngleError", "MaxAreaError")},
                "BulkBubbles": bulk["Bubbles"], "BulkMu2": bulk["Mu2"], "BulkMeanArea": bulk["MeanArea"],
                "SmallestArea": measures.cell_array(coarsening.bubbles, "Area").min(),
                "Gas": measures.cell_array(coarsening.bubbles, "TargetArea").sum(),
                "Converged": int(field_value(films, "Converged")), "WallSeconds": wall, "CpuSeconds": cpu}

    def _status(self, coarsening, row, step):
        if coarsening.ended:
            return "the foam ended"
        if row["Bubbles"] <= self.run.until_bubbles:
            return f"{row['Bubbles']} bubbles left"
        if step == self.run.steps:
            return "complete"
        return "out of time" if time.monotonic() > self.deadline else "running"

    def _picture_frames(self):
        """The run's own frames, of those that the thesis shows or the last ones before them."""
        per_step = self.run.frames_per_step
        return {1 + (frame - 1) // per_step * per_step for frame in self.run.pictures}

    def _take_snapshot(self, coarsening, row):
        frame = row["Frame"]
        lines = measures.polylines(coarsening.films)
        self.films[f"points{frame}"] = np.concatenate(lines).astype(np.float32)
        self.films[f"offsets{frame}"] = np.cumsum([0] + [len(line) for line in lines])
        self.about["snapshots"].append({
            "frame": frame, "time": row["Time"], "bubbles": row["Bubbles"],
            "sides": coarsening.statistics(1, True), "bulk_sides": coarsening.statistics(1, False)})
        write_whole(self.path("films.npz"), self._write_films)
        write_json(self.path("json"), self.about)

    def _write_films(self, path):
        with open(path, "wb") as file:
            np.savez_compressed(file, **self.films)

    def _quality(self, coarsening, step):
        constants = published.constants()
        quality = measures.quality(coarsening.films, coarsening.bubbles, constants["T2Area"])
        if self.run.energy_every:
            due = step // self.run.examine_every % self.run.energy_every == 0
            quality.update(measures.excess_energy(coarsening.films, coarsening.bubbles) if due else measures.NO_EXCESS)
        return quality


SWEEP_METHODS = {
    # Early versions of both, without the Energy Decay Constraint (4.4.2).
    "GaussSeidel": thesis("Gauss–Seidel", energy_decay=False, orientation_invariant=False, Sweep="GaussSeidel"),
    "Jacobi": thesis("Jacobi", energy_decay=False, orientation_invariant=False, Sweep="Jacobi"),
    "Newton": newton(),
}


def run_sweeps(sweeps, folder, minutes):
    """First equilibria of as many foams as the minutes allow, a row per foam (Figure 4.13)."""
    table = Table(folder / sweeps.name / "foams.csv")
    deadline = time.monotonic() + 60 * min(minutes, sweeps.minutes)
    done = 0
    while done < sweeps.foams and (done == 0 or time.monotonic() < deadline):
        done += 1
        row = {"Seed": done}
        for name, method in SWEEP_METHODS.items():
            source = Source(sweeps.bubbles, method, seed=done)
            source.points.Update()
            wall, cpu = time.perf_counter(), time.process_time()
            films = source.films()
            row.update({f"{name}WallSeconds": time.perf_counter() - wall,
                        f"{name}CpuSeconds": time.process_time() - cpu,
                        f"{name}Iterations": field_value(films, "Iterations"),
                        f"{name}Converged": field_value(films, "Converged"),
                        f"{name}MaxAngleError": field_value(films, "MaxAngleError")})
        table.add(row)
    print(f"{sweeps.name}: {done} foams of {sweeps.foams}", flush=True)
    write_json(folder / sweeps.name / "foams.json", {"bubbles": sweeps.bubbles, "foams": done,
                                                     "spacing": scale.spacing()})
    table.close()
