# SPDX-License-Identifier: GPL-3.0-or-later
"""The bubbles of a picture, between dark films or bright ones, for foam_from_picture.py; and whether it is such a
picture."""
import sys

import numpy as np
from scipy.ndimage import distance_transform_edt
from skimage import filters, io, measure, morphology, segmentation

MOST_COLOURS = 12  # of what is drawn
SURROUNDINGS = 20  # pixels that the brightness of a place's surroundings is taken from
LEAST_ENCLOSED = 0.02  # part of a picture that is not yet much of it
LEAST_ONE_SIDED = 0.6  # 0 for noise and steps, 1 for films without gaps


def read_picture(path, left, right, top, bottom):
    """The part of a picture that is to be looked at, from 0 to 1. Ends with a word if it can be no picture of films."""
    try:
        whole = io.imread(path, as_gray=True).astype(float)
    except FileNotFoundError:
        raise
    except Exception as error:  # as many kinds as there are readers of pictures
        sys.exit(f"{path} cannot be read as a picture: {str(error).splitlines()[0]}")
    if whole.ndim != 2:
        sys.exit(f"{path} is not one picture: its shape is {whole.shape}")
    picture = whole[top:bottom or None, left:right or None]
    if min(picture.shape) < 32:
        sys.exit(f"{path}: there are {picture.shape[1]} x {picture.shape[0]} pixels to look at, too few for a foam")
    if not np.isfinite(picture).all() or picture.max() == picture.min():
        sys.exit(f"{path} is blank: all pixels are {picture.flat[0]:g}")
    values = flat_values(picture)
    if len(values) > MOST_COLOURS:
        sys.exit(f"{path} has flat regions of {len(values)} values, as a picture of numbered regions has: draw their "
                 "borders, dark on white")
    return (picture - picture.min()) / np.ptp(picture)


def flat_values(picture):
    """The values of pixels that are as their neighbours, where most are, and 0.2 % or more of one value; the most
    frequent first."""
    inner = picture[1:-1, 1:-1]
    beside = picture[:-2, 1:-1], picture[2:, 1:-1], picture[1:-1, :-2], picture[1:-1, 2:]
    flat = np.logical_and.reduce([inner == other for other in beside])
    values, counts = np.unique(inner[flat], return_counts=True)
    order = np.argsort(-counts)
    return values[order][counts[order] > 0.002 * picture.size] if flat.mean() > 0.5 else values[:0]


def enclosed(mask):
    """How much of a picture pieces of a mask take that lie inside it: all but the largest, which may be a network."""
    pieces = measure.label(mask, connectivity=1)
    areas = np.bincount(pieces.ravel())
    areas[0] = 0
    areas[areas.argmax()] = 0
    areas[np.r_[pieces[0], pieces[-1], pieces[:, 0], pieces[:, -1]]] = 0
    return areas.sum() / mask.size


def films_in(picture):
    """Where films are, dark or bright: they hang together, and what they enclose falls into pieces. What is dark is
    told by one brightness for all of the picture or, where that is lit unevenly, by that of the surroundings."""
    smooth = filters.gaussian(picture, 1)
    most, films = 0, None
    for threshold in ((filters.threshold_otsu(smooth) - filters.threshold_otsu(-smooth)) / 2,  # the same upside down
                      filters.gaussian(smooth, SURROUNDINGS)):
        dark = smooth <= threshold
        by_dark, by_bright = enclosed(~dark), enclosed(dark)
        one_sided = (by_dark - by_bright) / (by_dark + by_bright + LEAST_ENCLOSED)
        if abs(one_sided) > most:
            most, films = abs(one_sided), dark if one_sided > 0 else ~dark
    if most < LEAST_ONE_SIDED:
        sys.exit("there are no films that hang together: neither what is dark nor what is bright encloses the other "
                 f"(by {most:.2f}, where films do by {LEAST_ONE_SIDED} to 1)")
    return films


def bubbles_in(picture):
    """The number of the bubble that each pixel belongs to, from 1: basins around the places farthest from films."""
    depth = filters.gaussian(distance_transform_edt(~films_in(picture)), 1)
    basins = segmentation.watershed(-depth, measure.label(morphology.h_maxima(depth, 1)))
    areas = np.bincount(basins.ravel())
    usual = (areas > np.median(areas) / 20) & (areas < 5 * np.median(areas))  # neither specks nor the world
    labels = segmentation.relabel_sequential(segmentation.clear_border(np.where(usual[basins], basins, 0)))[0]
    if labels.max() < 3:
        sys.exit(f"{labels.max()} bubbles were found, too few for a foam: they should be 20 to 60 pixels wide")
    return labels


def neighbours_in(labels):
    """Pairs of bubbles, counted from 0, with three or more pixels of border between them."""
    beside = ((labels[1:], labels[:-1]), (labels[:, 1:], labels[:, :-1]))
    sides = np.sort(np.vstack([np.c_[a.ravel(), b.ravel()] - 1 for a, b in beside]), axis=1)
    pairs, lengths = np.unique(sides[(sides[:, 0] >= 0) & (sides[:, 0] < sides[:, 1])], axis=0, return_counts=True)
    return {tuple(pair) for pair in pairs[lengths >= 3]}
