// SPDX-License-Identifier: GPL-3.0-or-later
//
// The arrays of a foam, listed once, whoever holds them: vectors, pointers to where they lie, a
// device's memory.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/lattice.h"
#include "geometry/vec2.h"
#include "geometry/wall_piece.h"
#include "mesh/ids.h"
#include "mesh/surroundings.h"

namespace foam {

/// A value for each element of a kind.
template <class Element, class T> class Field : public std::vector<T> {
public:
  using element = Element;
  using std::vector<T>::vector;

  constexpr T& operator[](Element e) { return std::vector<T>::operator[](e.place()); }
  constexpr const T& operator[](Element e) const { return std::vector<T>::operator[](e.place()); }
};

/// The same where it lies; null where there is none. Owns nothing.
template <class Element, class T> class FieldView {
public:
  using element = Element;

  FieldView() = default;
  FOAM_HOST_DEVICE explicit FieldView(T* values) : values_(values) {}

  FOAM_HOST_DEVICE T& operator[](Element e) const {
    // NOLINTNEXTLINE(clang-analyzer-core.uninitialized.UndefReturn): what is empty has no element
    return values_[e.index()];
  }
  FOAM_HOST_DEVICE T* data() const { return values_; }
  FOAM_HOST_DEVICE bool empty() const { return values_ == nullptr; }

private:
  T* values_ = nullptr;
};

/// The same to be looked at. A class of its own, as nvcc takes an alias that is a template's
/// argument for what it stands for, and forgets the const.
template <class Element, class T> class ConstFieldView : public FieldView<Element, const T> {
public:
  using FieldView<Element, const T>::FieldView;
};

/// \tparam Array of an element and a type, such as Field.
template <template <class, class> class Array> struct FoamArrays {
  // Bubbles.
  Array<Bubble, Half> bubble_half;       ///< one with the bubble on its left; none if gone
  Array<Bubble, Index> sides;            ///< number of films
  Array<Bubble, double> pressure;        ///< N/cm²
  Array<Bubble, double> target_area;     ///< A^τ, cm²
  Array<Bubble, std::int64_t> bubble_id; ///< persistent name of a bubble

  // Half-films.
  Array<Half, Junction> half_junction; ///< where it starts; none if gone
  Array<Half, Bubble> half_bubble;     ///< on its left

  // Films; values as seen from their half().
  Array<Film, double> film_angle;   ///< half-angle α, rad
  Array<Film, Wrap> film_wrap;      ///< periods from start to end
  Array<Film, double> film_tension; ///< N/cm; empty where all have 2γ

  // Junctions.
  Array<Junction, Vec2> position;                     ///< cm
  Array<Junction, std::array<Half, 3>> junction_half; ///< outgoing, counter-clockwise; none if gone
  Array<Junction, Piece> junction_piece; ///< of the wall that it lies on; empty without walls

  // Outsides, and the pieces of their walls in the order of the outsides.
  Array<Outside, Exterior> exterior;
  Array<Piece, WallPiece> wall_piece;
  Array<Piece, Outside> piece_outside;
};

/// Calls visit(array of the first, array of the second, …) for each of the arrays.
template <class Visit, class... Arrays>
void for_each_array(const Visit& visit, Arrays&&... arrays) {
  visit(arrays.bubble_half...);
  visit(arrays.sides...);
  visit(arrays.pressure...);
  visit(arrays.target_area...);
  visit(arrays.bubble_id...);
  visit(arrays.half_junction...);
  visit(arrays.half_bubble...);
  visit(arrays.film_angle...);
  visit(arrays.film_wrap...);
  visit(arrays.film_tension...);
  visit(arrays.position...);
  visit(arrays.junction_half...);
  visit(arrays.junction_piece...);
  visit(arrays.exterior...);
  visit(arrays.wall_piece...);
  visit(arrays.piece_outside...);
}

} // namespace foam
