# SPDX-License-Identifier: GPL-3.0-or-later
"""The thesis's own numbers, from published.csv, with where they stand in it.

B. K. Vedel-Larsen, Quasi-static Simulation of Foam in the Vertex Model, University of Copenhagen, 2010. Most of its
results are pictures; what can be quoted is what its text, tables and captions say.
"""
import csv
from pathlib import Path

with open(Path(__file__).with_name("published.csv"), newline="") as file:
    _ROWS = {(row["experiment"], row["quantity"]): row for row in csv.DictReader(file)}


def text(experiment, quantity):
    """As the thesis writes it, or a dash where it does not say."""
    row = _ROWS.get((experiment, quantity))
    return row["value"] if row else "–"


def number(experiment, quantity):
    return float(_ROWS[experiment, quantity]["value"])


def frames(experiment):
    """The frames that the thesis shows; none where it does not number them."""
    row = _ROWS.get((experiment, "pictures"))
    return [int(frame) for frame in row["value"].split()] if row else []


def where(experiment):
    """The sections and figures that an experiment's numbers stand in."""
    return "; ".join(dict.fromkeys(row["where"] for (name, _), row in _ROWS.items() if name == experiment))


def constants():
    """The constants of all experiments (Figures 4.19 and 6.2), by the names of the filters' properties."""
    return {name: number("constants", name) for experiment, name in _ROWS
            if experiment == "constants" and name != "frames_per_second"}
