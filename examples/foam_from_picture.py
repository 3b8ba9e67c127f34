# SPDX-License-Identifier: GPL-3.0-or-later
"""From a picture of a real foam, dark films on a bright ground, to a simulated one, drawn over the picture.

    pvpython examples/foam_from_picture.py --picture foam.png [--crop LEFT RIGHT TOP BOTTOM] [--walls]

Bubbles should be 20 to 60 pixels wide. --crop names the part to look at (pixels), --walls is for foams
that walls, or the crop, hold where they are. A length of 1 in the foam is the root of the mean bubble area.
"""
from foam_plugin import *
from matplotlib.collections import LineCollection
from scipy.ndimage import distance_transform_edt
from skimage import filters, io, measure, morphology, segmentation


def bubbles_in(picture):
    """The number of the bubble that each pixel belongs to, from 1: basins around the places farthest from films."""
    smooth = filters.gaussian(picture, 1)
    depth = filters.gaussian(distance_transform_edt(smooth > filters.threshold_local(smooth, 31, offset=0.02)), 1)
    basins = segmentation.watershed(-depth, measure.label(morphology.h_maxima(depth, 1)))
    areas = np.bincount(basins.ravel())
    usual = (areas > np.median(areas) / 20) & (areas < 5 * np.median(areas))  # neither specks nor the world
    return segmentation.relabel_sequential(segmentation.clear_border(np.where(usual[basins], basins, 0)))[0]


def neighbours_in(labels):
    """Pairs of bubbles, counted from 0, with three or more pixels of border between them."""
    beside = ((labels[1:], labels[:-1]), (labels[:, 1:], labels[:, :-1]))
    sides = np.sort(np.vstack([np.c_[a.ravel(), b.ravel()] - 1 for a, b in beside]), axis=1)
    pairs, lengths = np.unique(sides[(sides[:, 0] >= 0) & (sides[:, 0] < sides[:, 1])], axis=0, return_counts=True)
    return {tuple(pair) for pair in pairs[lengths >= 3]}


def main():
    options = read_options(__doc__, "output/picture", picture="foam.png", crop=(0, 0, 0, 0), walls=False)
    left, right, top, bottom = options.crop
    picture = io.imread(options.picture, as_gray=True)[top:bottom or None, left:right or None]
    labels = bubbles_in(picture / picture.max())
    table = options.output / "bubbles.csv"
    write_table(table, [{"x": r.centroid[1] + 0.5, "y": len(picture) - r.centroid[0] - 0.5, "area": r.area}
                        for r in measure.regionprops(labels)])
    walls = {"Boundary": "Fixed", "TargetAreas": "Initial", "FinSize": 0.5} if options.walls else {}
    foam, scale = foam_of_measured_points(table, **walls)
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
