# SPDX-License-Identifier: GPL-3.0-or-later
"""Continues a run from the last .vtp of its series, and appends to the series.

    pvpython examples/continue_run.py [--frames 100] [--output output/film]

--output is the folder with films.pvd, such as film.py leaves. If that run had other constants than the defaults, give
FoamCoarsen the same.
"""
import xml.etree.ElementTree as ElementTree

from foam_plugin import *


def main():
    options = read_options(__doc__, "output/film", frames=100)
    series = options.output / "films.pvd"
    try:
        frames = ElementTree.parse(series).findall("./Collection/DataSet")
        last = series.parent / frames[-1].get("file")
    except (OSError, ElementTree.ParseError, IndexError) as error:
        sys.exit(f"{series} is no series of frames: {error}")

    films = XMLPolyDataReader(FileName=[str(last)])
    coarsen = FoamCoarsen(Input=films, NumberOfFrames=options.frames)
    moments = coarsen.TimestepValues[0], coarsen.TimestepValues[-1]
    bubbles = [result(coarsen, 1, time).GetNumberOfCells() for time in moments]
    SaveData(str(series), proxy=OutputPort(coarsen, 0), WriteTimeSteps=1, Append=1)
    print(f"Continued {series} from t = {moments[0]:.3f} s with {bubbles[0]} bubbles "
          f"to t = {moments[1]:.3f} s with {bubbles[1]}")


if __name__ == "__main__":
    run(main)
