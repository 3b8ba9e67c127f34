# SPDX-License-Identifier: GPL-3.0-or-later
"""The scale of the thesis's foams, which its constants leave open.

In the scaling state the mean area grows linearly, ⟨A⟩ = ⟨A⟩₀ + g·K·t with K = (2π/3)γκ and g = 0.93. While a foam keeps
its gas ⟨A⟩ is inversely proportional to the number of bubbles N, and the jittered grid has one point per s², so that

    s² (N₀/N − 1) = g·K·t.

A free foam loses gas through its boundary, which this leaves out.
"""
import math

from thesis_experiments import published

# Scaling states grow at 0.85 to 1.0 K; the middle of it.
GROWTH = 0.93


def diffusion_constant():
    """K of von Neumann's law dA/dt = K(n − 6), cm²/s (2.4.5)."""
    constants = published.constants()
    return 2 * math.pi / 3 * constants["SurfaceTension"] * constants["Permeability"]


def time_step():
    """Δt, s."""
    return 1 / published.number("constants", "frames_per_second")


def spacing_of(experiment):
    """s (cm) with which an experiment's bubbles become as few as the thesis reports."""
    ratio = published.number(experiment, "bubbles") / published.number(experiment, "bubbles left")
    seconds = published.number(experiment, "frames") * time_step()
    return math.sqrt(GROWTH * diffusion_constant() * seconds / (ratio - 1))


def spacing():
    """The spacing used in all experiments (cm): that of Section 6.1.2, to a tenth."""
    return round(spacing_of("6.1.2"), 1)
