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
        const FilmStiffness& f = matrix.film[h.film()];
        add_block(x, y, own, f, 1, 0);
        if (mesh.moves(mesh.end(h))) {
          add_block(x, y, 2 * mesh.end(h).index(), f, -1, h.reversed() ? -f.jump : f.jump);
        }
      }
    }
    rows.finish(x);
    rows.finish(y);
  }

  /// sign · (xx, xy; xy, yy) + jump · (0, −1; 1, 0)
  FOAM_HOST_DEVICE static void add_block(GrowingRow& x, GrowingRow& y, Index at,
                                         const FilmStiffness& f, double sign, double jump) {
    x.add(at, sign * f.xx);
    x.add(at + 1, sign * f.xy - jump);
    y.add(at, sign * f.xy + jump);
    y.add(at + 1, sign * f.yy);
  }

  FOAM_HOST_DEVICE void list_bubble(Bubble bubble, const GrowingRows& rows) const {
    const ConstFoamView& mesh = matrix.mesh;
    const Index first = 2 * mesh.junctions;
    const Index own = first + bubble.index();
    GrowingRow row = rows.begun(own);
    row.add(own, mesh.has_bubble(bubble) ? -kRegularisation : 1);
    if (mesh.has_bubble(bubble)) {
      for_each_half(mesh, bubble, [&](Half h) {
        const FilmStiffness& f = matrix.film[h.film()];
        add_slope(row, mesh.start(h), f.start_slope(h));
        add_slope(row, mesh.end(h), f.end_slope(h));
        row.add(own, -f.compliance);
        if (!mesh.right(h).is_outside()) {
          row.add(first + mesh.right(h).index(), f.compliance);
        }
      });
    }
    rows.finish(row);
  }

  FOAM_HOST_DEVICE void add_slope(GrowingRow& row, Junction junction, Vec2 slope) const {
    if (matrix.mesh.moves(junction)) {
      row.add(2 * junction.index(), -slope.x);
      row.add(2 * junction.index() + 1, -slope.y);
    }
  }
};

} // namespace foam::newton
