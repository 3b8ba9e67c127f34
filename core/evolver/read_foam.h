// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "mesh/foam.h"

namespace foam {

/// A foam as Surface Evolver has it.
struct EvolverFoam {
  Foam foam;
  /// What the file has that the foam does not, with line and keyword.
  std::vector<std::string> warnings;
  /// How far the farthest point of a film lies from the arc that stands for it, cm: 0 where each
  /// film is an edge of the circular model.
  double largest_misfit = 0;
};

/// The foam of a datafile or dump of Surface Evolver's in its two-dimensional STRING model (Brakke,
/// Surface Evolver Manual, "Datafile"): free, on a torus that it fills, or between walls.
///
/// Edges that meet in a vertex two by two are one film: the arc that has the same ends and the same
/// area beside it, so that bubbles keep their areas to the last digits. γ is half the tension that
/// films have, or half the median where they differ. VOLUME is the target area; on a torus and
/// between walls one body may leave it to the others, and pressures are above its. BubbleId is the
/// body's attribute of that name, its ORIGINAL, or its number. Commands are not obeyed.
///
/// Edges that keep to a CONSTRAINT or a BOUNDARY, or are FIXED, with a bubble on one side, are
/// walls: lines and circles along which films slip, or on which they are pinned where their
/// vertices are FIXED. Faces that are open along walls are closed. Walls enclose the foam, and on a
/// torus they make a channel; those with no bubble beside them are obstacles that no film touches.
///
/// \param include gives the content of a file that the text includes
/// \throws FoamError with line and cause for what is no such foam: fixed films, walls of
/// other shapes or beside gas, other energies, bubbles of free area, junctions of more or less than
/// three films
EvolverFoam read_evolver(std::string text, std::function<std::string(const std::string&)> include);

} // namespace foam
