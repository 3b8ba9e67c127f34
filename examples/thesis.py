# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the thesis's experiments again, by its own method and by Newton, and writes a page about them.

Run it with ParaView's Python:

    pvpython examples/thesis.py --quick              all experiments in miniature, in less than a minute
    pvpython examples/thesis.py --only small         one experiment, or one run of it: --only small/newton
    pvpython examples/thesis.py --page docs/thesis.md    the page alone, from the results that are there

Experiments can run in several processes at the same time. What each has found is kept in the output folder while it
runs, and the page shows what is there; --list names the experiments and their runs.
"""
import argparse
import sys
from pathlib import Path

import foam_filters  # lets Python find the filters
from thesis_experiments import experiments, page, running


def parse_arguments():
    parser = argparse.ArgumentParser(prog="thesis.py", description="Runs the thesis's experiments again.")
    parser.add_argument("--output", type=Path, default=Path("output/thesis"),
                        help="folder for the results (default: %(default)s)")
    parser.add_argument("--only", nargs="+", metavar="NAME", help="run these experiments, or runs of them, alone")
    parser.add_argument("--budget", type=float, default=55, metavar="MINUTES",
                        help="longest time for a run; it keeps what it has by then (default: %(default)s)")
    parser.add_argument("--quick", action="store_true", help="run everything in miniature")
    parser.add_argument("--page", type=Path, metavar="FILE",
                        help="write the page to FILE, its figures beside it, and run nothing")
    parser.add_argument("--list", action="store_true", help="name the experiments and their runs")
    arguments = parser.parse_args()
    if not arguments.budget > 0:
        parser.error(f"--budget must be greater than 0, not {arguments.budget}")
    return arguments


def names(experiment):
    """The experiment's name and those of its runs."""
    return [experiment.name] + [f"{experiment.name}/{run.name}" for run in getattr(experiment, "runs", ())]


def main():
    arguments = parse_arguments()

    known = [name for experiment in experiments.ALL for name in names(experiment)]
    if arguments.list:
        print("\n".join(known))
        return
    for name in arguments.only or ():
        if name not in known:
            sys.exit(f"There is no experiment '{name}'; --list names them")

    if not arguments.page:
        for experiment in experiments.ALL:
            wanted = [name for name in names(experiment) if not arguments.only or name in arguments.only]
            if wanted:
                running.run(experiment, wanted, arguments.output, arguments.budget, arguments.quick)
    written = arguments.page or arguments.output / "thesis.md"
    page.write(written, arguments.output)
    print(f"The page is {written}")


if __name__ == "__main__":
    try:
        main()
    except OSError as error:
        sys.exit(str(error))
