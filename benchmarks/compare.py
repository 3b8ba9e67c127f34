# SPDX-License-Identifier: GPL-3.0-or-later
"""Times the core beside Surface Evolver, in one run on one core, and writes the figures and a page.

    /usr/bin/python3 benchmarks/compare.py build/release/benchmarks/foam_benchmark --output output/benchmarks
    /usr/bin/python3 benchmarks/compare.py … --quick              a minute: small foams, figures printed alone
    /usr/bin/python3 benchmarks/compare.py … --page docs/benchmarks/README.md    the page from figures that are there

Both start from the same foam, which foam_benchmark writes as a Surface Evolver file. Processor time is compared, and
everything but what is said to use all cores is bound to one. Surface Evolver is Debian's package evolver; without it
its columns stay empty.
"""
import argparse
import json
import os
import platform
import re
import shutil
import signal
import subprocess
import sys
from pathlib import Path

import benchmark_page

HERE = Path(__file__).resolve().parent
CORES = os.sched_getaffinity(0)
STEPS = 50  # of evolver/coarsen.cmd too
PATIENCE = 1800  # s of wall time for one run of a program


def parse_arguments():
    parser = argparse.ArgumentParser(prog="compare.py", description="Times the core beside Surface Evolver.")
    parser.add_argument("program", type=Path, help="foam_benchmark, built with optimisation")
    parser.add_argument("--output", type=Path, default=Path("output/benchmarks"), help="folder for the figures")
    parser.add_argument("--quick", action="store_true", help="small foams only")
    parser.add_argument("--page", type=Path, metavar="FILE", help="write the page to FILE and measure nothing")
    return parser.parse_args()


class Measurement:
    """Runs the two programs and keeps what they print, as soon as it is there."""

    def __init__(self, program, output):
        self.program = program.resolve()
        self.output = output
        self.output.mkdir(parents=True, exist_ok=True)
        self.figures = {"machine": machine(), "load": os.getloadavg()[0], "foam": [], "evolver": []}

    def foam(self, *arguments, cores=1):
        os.sched_setaffinity(0, CORES if cores > 1 else {min(CORES)})
        text = run_to_end([self.program, *map(str, arguments)])
        for line in text.splitlines():
            self.keep("foam", json.loads(line) | {"cores": cores})

    def evolver(self, work, bubbles, start, scripts):
        """Runs Surface Evolver's scripts; the last prints its processor time as 'cpu' or 'per step'."""
        if not shutil.which("evolver"):
            return
        os.sched_setaffinity(0, {min(CORES)})
        commands = "".join((HERE / "evolver" / script).read_text() for script in scripts)
        if not commands.rstrip().endswith("quit"):
            commands += "quit\n"
        script = self.output / "evolver.cmd"
        script.write_text(commands)
        text = run_to_end(["evolver", f"-f{script}", start])
        energies = re.findall(r"E ([\d.]+)", text)
        seconds = re.search(r"per step ([\d.]+)" if work == "steps" else r"FINAL .* cpu ([\d.]+)", text)
        if not energies or not seconds:
            raise ValueError(f"evolver does not say how long its {work} of {bubbles} bubbles took, but: {text[-400:]}")
        self.keep("evolver", {"work": work, "bubbles": bubbles, "cpu": float(seconds[1]), "length": float(energies[-1])})

    def keep(self, program, figures):
        print(program, json.dumps(figures), flush=True)
        self.figures[program].append(figures)
        (self.output / "figures.json").write_text(json.dumps(self.figures, indent=1))


def run_to_end(command):
    """A program's output. It does not outlive this one, though Surface Evolver ignores a polite request to end."""
    with subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, text=True) as program:
        try:
            text, _ = program.communicate(timeout=PATIENCE)
        finally:
            program.kill()
    if program.returncode:
        raise subprocess.CalledProcessError(program.returncode, command)
    return text


def machine():
    model = re.search(r"model name\s*: (.*)", Path("/proc/cpuinfo").read_text())
    return f"{model[1] if model else platform.processor()}, {len(CORES)} cores"


def measure(measurement, quick):
    start = measurement.output / "start.fe"
    for bubbles in (100, 1000) if quick else (100, 300, 1000, 3000, 10000):
        measurement.foam("equilibrium", bubbles, start)
        measurement.evolver("equilibrium", bubbles, start, ["relax.cmd"])
        measurement.foam("steps", bubbles, STEPS)
        if bubbles <= (100 if quick else 3000):
            measurement.evolver("steps", bubbles, start, ["relax.cmd", "coarsen.cmd"])
    if quick:
        measurement.foam("frames", 2000, 10, 1e-6)
        return
    for bubbles in (30000, 100000):
        measurement.foam("equilibrium", bubbles)
        measurement.foam("steps", bubbles, STEPS)
    for bubbles in (100, 300, 1000, 3000, 10000, 30000, 100000):
        measurement.foam("frames", bubbles, 100, 1e-6)
    measurement.foam("frames", 10000, 100, 1e-6, cores=len(CORES))
    measurement.foam("thesis")
    measurement.foam("thesis", cores=len(CORES))
    measurement.foam("memory", 100000)
    measurement.foam("build", 1000000)
    measurement.foam("frames", 100000, 100, 1e-6, cores=len(CORES))


def main():
    arguments = parse_arguments()
    if not arguments.page:
        measure(Measurement(arguments.program, arguments.output), arguments.quick)
    if arguments.page:
        benchmark_page.write(arguments.page, json.loads((arguments.output / "figures.json").read_text()))


if __name__ == "__main__":
    signal.signal(signal.SIGTERM, lambda *_: sys.exit("compare.py: stopped"))
    try:
        main()
    except (OSError, ValueError, subprocess.SubprocessError) as error:
        sys.exit(f"compare.py: {error}")
