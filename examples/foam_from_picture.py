# SPDX-License-Identifier: GPL-3.0-or-later
"""From a picture of a real foam, with dark films or bright ones, to a simulated one, drawn over the picture.

    pvpython examples/foam_from_picture.py --picture foam.png [--crop LEFT RIGHT TOP BOTTOM] [--walls]

Bubbles should be 20 to 60 pixels wide, and get the neighbours that they have in the picture. --crop names the part to
look at (pixels), --walls is for foams that walls, or the crop, hold where they are: a foam of the bubbles' places then. A
length of 1 in the foam is the root of the mean bubble area.
Numbered regions, blank pictures and those without films are refused: foam_in_picture.py, which finds the bubbles, says
why.
"""
from foam_plugin import *
from foam_in_picture import bubbles_in, neighbours_in, read_picture
from matplotlib.collections import LineCollection
from skimage import measure


def main():
    options = read_options(__doc__, "output/picture", picture="foam.png", crop=(0, 0, 0, 0), walls=False)
    picture = read_picture(options.picture, *options.crop)
    labels = bubbles_in(picture)
    table = options.output / "bubbles.csv"
    write_table(table, [{"x": r.centroid[1] + 0.5, "y": len(picture) - r.centroid[0] - 0.5, "area": r.area}
                        for r in measure.regionprops(labels)])
    if options.walls:
        foam, scale = foam_of_measured_points(table, Boundary="Fixed", TargetAreas="Initial", FinSize=0.5)
    else:
        foam, scale = foam_of_labels(labels, options.output / "labels.vti")
    films = result(foam)
    SaveData(str(options.output / "films.vtp"), proxy=OutputPort(foam, 0))
    sides = arrays(films.GetCellData())
    made = {tuple(sorted(pair)) for pair in zip(sides["LeftBubble"], sides["RightBubble"]) if min(pair) >= 0}
    seen = neighbours_in(labels)
    print(f"{labels.max()} bubbles; neighbours: {len(seen)} pairs seen, {len(made)} made, {len(seen & made)} both")

    plt.figure(figsize=(12, 12 * picture.shape[0] / picture.shape[1]), dpi=120)
    plt.imshow(picture, cmap="gray", extent=(0, picture.shape[1], 0, picture.shape[0]))
    plt.gca().add_collection(LineCollection([line / scale for line in polylines(films)], colors="#e8590c"))
    plt.axis("off")
    plt.savefig(options.output / "overlay.png", bbox_inches="tight", pad_inches=0)
    print(f"bubbles.csv, films.vtp and the films drawn over the picture, overlay.png, are in {options.output}/")


if __name__ == "__main__":
    run(main)
