# SPDX-License-Identifier: GPL-3.0-or-later
"""Foam in a channel coarsens: a table of how many bubbles there are, and how many of them are bamboo.

    pvpython examples/foam_in_channel.py [--bubbles 120] [--length 12] [--width 3] [--output output/channel]

The channel is periodic along x, and films slide along its walls. A narrow one ends as bamboo, straight films from wall
to wall, a wider one as a double row: there all bubbles have four sides, one or two of them walls, and keep their gas.
"""
from foam_plugin import *


def main():
    options = read_options(__doc__, "output/channel", bubbles=120, length=12.0, width=3.0)
    spacing = math.sqrt(options.length * options.width / options.bubbles)
    random = np.random.default_rng(1)
    columns, rows = round(options.length / spacing), round(options.width / spacing)
    points = [((x + random.uniform(0.1, 0.9)) * options.length / columns,
               (y + random.uniform(0.1, 0.9)) * options.width / rows, 0) for x in range(columns) for y in range(rows)]
    foam = FoamFromPoints(Input=PolyLineSource(Points=np.ravel(points)), Boundary="Container", Container="Channel",
                          ContainerBounds=[0, options.length, 0, options.width])
    coarsen = FoamCoarsen(Input=foam, TimeStep=spacing * spacing / 5, NumberOfFrames=100)
    table = []
    for time in coarsen.TimestepValues:
        films, bubbles = (result(coarsen, port, time) for port in (0, 1))
        of_films = arrays(films.GetCellData())
        walls = of_films["Kind"] == 1
        beside = np.maximum(of_films["LeftBubble"][walls], of_films["RightBubble"][walls])
        names, stretches = np.unique(beside, return_counts=True)
        sides = dict(zip(*(arrays(bubbles.GetCellData())[name] for name in ("BubbleId", "Sides"))))
        across = sum(count == 2 and sides[name] == 4 for name, count in zip(names, stretches))
        table.append({"Time": time, "Bubbles": bubbles.GetNumberOfCells(), "Bamboo": int(across),
                      "Energy": arrays(films.GetFieldData())["Energy"][0]})
    print("From {Bubbles} bubbles".format(**table[0]),
          "to {Bubbles}, of which {Bamboo} have two films and two walls, at t = {Time:.1f} s".format(**table[-1]))
    write_table(options.output / "channel.csv", table)


if __name__ == "__main__":
    run(main)
