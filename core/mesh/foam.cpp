// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/foam.h"

#include <algorithm>

#include "mesh/element_measures.h"

namespace foam {
namespace {

/// \pre a wall of one piece is a line along x
WallSymmetry symmetry_of(const std::vector<Wall>& walls) {
  constexpr double kSame = 1e-9; // of a radius
  const auto are_all = [&](const auto& are) {
    return std::ranges::all_of(walls, [&](const Wall& wall) {
      return wall.contact == WallContact::Slip && are(wall.pieces);
    });
  };
  if (are_all([](const std::vector<WallPiece>& pieces) { return pieces.size() == 1; })) {
    return WallSymmetry::Line;
  }
  const WallPiece& first = walls[0].pieces[0];
  const auto has_its_centre = [&](const WallPiece& piece) {
    return piece.half_angle != 0 &&
           norm(piece.centre() - first.centre()) * std::abs(first.curvature()) < kSame;
  };
  return first.half_angle != 0 && are_all([&](const std::vector<WallPiece>& pieces) {
           return std::ranges::all_of(pieces, has_its_centre);
         })
             ? WallSymmetry::Circle
             : WallSymmetry::None;
}

} // namespace

Index Foam::bubble_count() const {
  return static_cast<Index>(std::ranges::count_if(bubble_half, [](Half h) { return h != kNone; }));
}

Index Foam::film_count() const {
  return static_cast<Index>(
             std::ranges::count_if(half_junction, [](Junction j) { return j != kNone; })) /
         2;
}

Index Foam::junction_count() const {
  return static_cast<Index>(
      std::ranges::count_if(junction_half, [](const auto& h) { return h[0] != kNone; }));
}

double Foam::energy() const {
  double total = 0;
  for (const Film f : film_slots()) {
    total += tense_length(*this, f);
  }
  return reference_tension() * total;
}

double Foam::mean_area() const {
  double total = 0;
  Index count = 0;
  for (const Bubble b : bubble_slots()) {
    if (has_bubble(b)) {
      total += target_area[b];
      ++count;
    }
  }
  return total / std::max(count, Index{1});
}

double Foam::mean_spacing() const {
  return std::sqrt(mean_area());
}

void Foam::clear(Index bubbles, Index films, Index junctions) {
  for_each_array(
      [&]<class Element, class T>(Field<Element, T>& field) {
        if constexpr (std::is_same_v<Element, Bubble>) {
          field.assign(static_cast<std::size_t>(bubbles), T{});
        } else if constexpr (std::is_same_v<Element, Film>) {
          field.assign(static_cast<std::size_t>(films), T{});
        } else if constexpr (std::is_same_v<Element, Half>) {
          field.assign(2 * static_cast<std::size_t>(films), T{});
        } else if constexpr (std::is_same_v<Element, Junction>) {
          field.assign(static_cast<std::size_t>(junctions), T{});
        }
      },
      *this);
  film_tension.clear();
  junction_piece.clear();
}

void Foam::make_room(Index films, Index junctions) {
  const auto lengthen = [](auto& field, Index by) {
    field.resize(field.size() + static_cast<std::size_t>(by));
  };
  for_each_array(
      [&]<class Element, class T>(Field<Element, T>& field) {
        if (field.empty()) {
          return;
        }
        if constexpr (std::is_same_v<Element, Film>) {
          lengthen(field, films);
        } else if constexpr (std::is_same_v<Element, Half>) {
          lengthen(field, 2 * films);
        } else if constexpr (std::is_same_v<Element, Junction>) {
          lengthen(field, junctions);
        }
      },
      *this);
}

void Foam::surround(const Surroundings& with) {
  surroundings = with;
  exterior.assign(with.periodic() ? 0 : 1, Exterior{});
  wall_piece.clear();
  piece_outside.clear();
  junction_piece.clear();
}

void Foam::set_walls(const std::vector<Wall>& walls) {
  exterior.clear();
  wall_piece.clear();
  piece_outside.clear();
  for (const Wall& wall : walls) {
    Exterior solid;
    solid.kind = Exterior::Kind::Solid;
    solid.contact = wall.contact;
    solid.first_piece = count(wall_piece);
    solid.pieces = static_cast<Index>(wall.pieces.size());
    wall_piece.insert(wall_piece.end(), wall.pieces.begin(), wall.pieces.end());
    piece_outside.resize(wall_piece.size(), Outside(count(exterior)));
    exterior.push_back(solid);
  }
  find_pieces();
  surroundings.wall_symmetry = symmetry_of(walls);
  surroundings.centre =
      surroundings.wall_symmetry == WallSymmetry::Circle ? walls[0].pieces[0].centre() : Vec2{};
}

void Foam::find_pieces() {
  junction_piece.assign(position.size(), kNone);
  for (const Half h : half_slots()) {
    if (start(h) != kNone && left(h).is_outside() && solid(left(h))) {
      junction_piece[start(h)] = nearest_piece(*this, left(h).outside(), position[start(h)]);
    }
  }
}

void Foam::seal_outline() {
  Half first = kNone;
  for (const Half h : half_slots()) {
    if (first == kNone && start(h) != kNone && right(h) == kWorld) {
      first = h;
    }
  }
  Wall outline{{}, WallContact::Pinned};
  Half h = first;
  do {
    outline.pieces.push_back({position[start(h)], chord(h), 0});
    h = previous_in_bubble(h.twin()).twin();
  } while (h != first);
  surroundings.boundary = Boundary::Fixed;
  set_walls({outline});
}

std::vector<TopologicalEvent> events_of(const Foam& foam) {
  std::vector<TopologicalEvent> events;
  events.reserve(foam.operations.size());
  for (const TopologicalOperation& done : foam.operations) {
    TopologicalEvent& event =
        events.emplace_back(TopologicalEvent{done.kind, done.time, done.strain, done.place, {}});
    std::ranges::transform(done.bubbles, event.bubbles.begin(), [&](Bubble b) {
      return b.is_outside() ? std::int64_t{-1} : foam.bubble_id[b];
    });
  }
  return events;
}

} // namespace foam
