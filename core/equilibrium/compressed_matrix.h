// SPDX-License-Identifier: GPL-3.0-or-later
//
// The matrix of matrix_free.h entry by entry, for those who factorise it.
#pragma once

#include "algebra/compressed_rows.h"
#include "equilibrium/matrix_free.h"
#include "equilibrium/zero_modes.h"

namespace foam::newton {

/// WholeFoamMatrix with kRegularisation, and for every element that is absent or held an equation
/// of its own, x = 0. For CompressedRows: its groups are junctions, with two rows each, then
/// bubbles.
struct CompressedMatrix {
  WholeFoamMatrix matrix;

  Index size() const { return size_of(matrix.mesh); }
  Index groups() const { return matrix.mesh.junctions + matrix.mesh.bubbles; }

  FOAM_HOST_DEVICE void bound(Index i, Index* bounds) const {
    const ConstFoamView& mesh = matrix.mesh;
    if (i < mesh.junctions) {
      const Index x = 2 * i;
      bounds[x] = bounds[x + 1] = mesh.moves(Junction(i)) ? 8 : 1; // it and three others
    } else {
      const Bubble bubble(i - mesh.junctions);
      bounds[mesh.junctions + i] =
          mesh.has_bubble(bubble) ? 3 * mesh.sides[bubble] + 1 : 1; // junctions, neighbours, it
    }
  }

  FOAM_HOST_DEVICE void list(Index i, const GrowingRows& rows) const {
    if (i < matrix.mesh.junctions) {
      list_junction(Junction(i), rows);
    } else {
      list_bubble(Bubble(i - matrix.mesh.junctions), rows);
    }
  }

private:
  FOAM_HOST_DEVICE void list_junction(Junction junction, const GrowingRows& rows) const {
    const ConstFoamView& mesh = matrix.mesh;
    const Index own = 2 * junction.index();
    GrowingRow x = rows.begun(own);
    GrowingRow y = rows.begun(own + 1);
    const double diagonal = mesh.moves(junction) ? kRegularisation : 1;
    x.add(own, diagonal);
    y.add(own + 1, diagonal);
    if (mesh.moves(junction)) {
      for (const Half h : mesh.junction_half[junction]) {
        const auto film = matrix.film_matrix(h.film());
        const std::size_t first = h.reversed() ? 2 : 0;
        add(x, h.film(), film[first]);
        add(y, h.film(), film[first + 1]);
      }
    }
    rows.finish(x);
    rows.finish(y);
  }

  FOAM_HOST_DEVICE void list_bubble(Bubble bubble, const GrowingRows& rows) const {
    const ConstFoamView& mesh = matrix.mesh;
    GrowingRow row = rows.begun(2 * mesh.junctions + bubble.index());
    row.add(row.row, mesh.has_bubble(bubble) ? -kRegularisation : 1);
    if (mesh.has_bubble(bubble)) {
      for_each_half(mesh, bubble, [&](Half h) {
        add(row, h.film(), matrix.film_matrix(h.film())[h.reversed() ? 5 : 4]);
      });
    }
    rows.finish(row);
  }

  /// Adds a row of a film's matrix, but for what is held.
  FOAM_HOST_DEVICE void add(GrowingRow& row, Film film,
                            const std::array<double, 6>& entries) const {
    const ConstFoamView& mesh = matrix.mesh;
    const Half h = film.half();
    for (std::size_t end = 0; end < 2; ++end) {
      const Junction junction = end == 0 ? mesh.start(h) : mesh.end(h);
      if (mesh.moves(junction)) {
        row.add(2 * junction.index(), entries[2 * end]);
        row.add(2 * junction.index() + 1, entries[2 * end + 1]);
      }
      const Bubble bubble = end == 0 ? mesh.left(h) : mesh.right(h);
      if (!bubble.is_outside()) {
        row.add(2 * mesh.junctions + bubble.index(), entries[4 + end]);
      }
    }
  }
};

} // namespace foam::newton
