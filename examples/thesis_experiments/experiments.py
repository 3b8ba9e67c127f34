# SPDX-License-Identifier: GPL-3.0-or-later
"""Which foams are run by which methods: the experiments of the thesis's chapters 4 and 6 and its appendix A."""
from dataclasses import dataclass, field, replace

from thesis_experiments import published
from thesis_experiments.foams import Method, newton, thesis

ENERGY_DECAY = thesis("Energy Decay", energy_decay=True, orientation_invariant=False)
ORIENTATION_INVARIANT = thesis("Orientation Invariant", energy_decay=False, orientation_invariant=True)
BOTH = thesis("both constraints", energy_decay=True, orientation_invariant=True)
NEITHER = thesis("no constraint", energy_decay=False, orientation_invariant=False)


def energies(target):
    """The root search that Section 7.1.1 proposes, without the constraints that it is to make superfluous."""
    return thesis(f"energies, target {target}", energy_decay=False, orientation_invariant=False,
                  RootSearch="Energies", EnergyTarget=target)


@dataclass(frozen=True)
class Run:
    """One foam, coarsened by one method."""
    name: str
    method: Method
    bubbles: int
    frames: int  # of the thesis's length Δt
    frames_per_step: int = 1  # a step of the run is so many of them
    properties: dict = field(default_factory=dict)  # of FoamCoarsen, beside the method's
    until_bubbles: int = 0  # the run is complete when so few are left
    pictures: tuple = ()  # numbers of the frames to be drawn; the first is 1
    examine_every: int = 0  # steps between frames whose quality is measured; 0: never
    energy_every: int = 0  # of the examined frames, each so many-th is compared with Newton's equilibrium

    @property
    def steps(self):
        return -(-self.frames // self.frames_per_step)

    def miniature(self):
        """The same with a few bubbles and long time steps, so that much happens in a second."""
        return replace(self, bubbles=min(self.bubbles, 50), frames=720, frames_per_step=30,
                       pictures=tuple(range(1, 722, 144)), examine_every=4 if self.examine_every else 0,
                       energy_every=1 if self.energy_every else 0)


@dataclass(frozen=True)
class Experiment:
    """A section of the page: the runs that it compares."""
    name: str  # on the command line and in file names
    section: str  # of the thesis, the key of published.csv
    title: str
    runs: tuple


@dataclass(frozen=True)
class Sweeps:
    """Figure 4.13: first equilibria of many foams."""
    name: str = "sweeps"
    section: str = "4.13"
    title: str = "Gauss–Seidel against Jacobi"
    bubbles: int = int(published.number("4.13", "bubbles"))
    foams: int = int(published.number("4.13", "simulations"))
    minutes: float = 15

    def miniature(self):
        return replace(self, bubbles=50, foams=3)


def evolution(name, section, what, method, newton_frames_per_step, examine_every, **options):
    """The thesis's method and Newton on the same points for the thesis's number of frames.

    Newton lands on every event whatever its step is, so its steps may be long.
    """
    common = {"bubbles": int(published.number(section, "bubbles")), "frames": int(published.number(section, "frames")),
              "pictures": tuple(published.frames(section)), **options}
    title = f"{common['bubbles']:,} bubbles {what}"
    return Experiment(name, section, title, (
        Run("thesis", method, examine_every=examine_every, **common),
        Run("newton", newton(), frames_per_step=newton_frames_per_step,
            examine_every=max(1, examine_every // newton_frames_per_step), **common)))


def distance():
    """Every method on the same foam, its frames measured against Newton's equilibria."""
    common = {"bubbles": int(published.number("A.2", "bubbles")), "frames": 1000, "examine_every": 10}
    methods = {"energy-decay": ENERGY_DECAY, "orientation-invariant": ORIENTATION_INVARIANT, "both": BOTH,
               "neither": NEITHER, "energies-zero": energies("Zero"), "energies-straight": energies("Straight"),
               "newton": newton()}
    return Experiment("distance", "6.4", "How far from equilibrium each method stops",
                      tuple(Run(name, method, energy_every=5, **common) for name, method in methods.items()))


def algorithms():
    """The topological algorithms of Section 4.3 on the foam of appendix A.1."""
    common = {"bubbles": int(published.number("A.1", "bubbles")), "frames": int(published.number("A.1", "frames")),
              "examine_every": 1}
    return Experiment("algorithms", "4.3", "The topological algorithms", tuple(
        Run(name.lower(), thesis(f"{name} (Figure {figure})", energy_decay=True, orientation_invariant=False,
                                 TopologicalAlgorithm=name), **common)
        for name, figure in (("Original", "4.4"), ("Improved", "4.6"), ("Final", "4.8"))))


SWEEPS = Sweeps()
EVOLUTIONS = (
    evolution("lower-extreme", "6.1.1", "until three are left", ENERGY_DECAY, 1, 10, frames=6000,
              until_bubbles=3, pictures=tuple(range(1, 2002, 400)), properties={"ChordError": 0.01}),
    evolution("energy-decay", "6.1.2", "with the Energy Decay Constraint", ENERGY_DECAY, 30, 30),
    evolution("orientation-invariant", "6.1.3", "with the Orientation Invariant Constraint",
              ORIENTATION_INVARIANT, 30, 30),
    evolution("small", "A.1", "with the Energy Decay Constraint", ENERGY_DECAY, 10, 10),
    evolution("middle-energy-decay", "A.2", "with the Energy Decay Constraint", ENERGY_DECAY, 10, 100),
    evolution("middle-orientation-invariant", "A.3", "with the Orientation Invariant Constraint",
              ORIENTATION_INVARIANT, 10, 100),
    evolution("equilibrium", "6.2", "without diffusion", ENERGY_DECAY, 1, 10,
              properties={"Permeability": 0}),
)
DISTANCE = distance()
ALGORITHMS = algorithms()
ALL = (SWEEPS, *EVOLUTIONS, DISTANCE, ALGORITHMS)
