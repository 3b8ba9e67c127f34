// SPDX-License-Identifier: GPL-3.0-or-later
#include "FilmReading.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>
#include <vector>

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>

#include "FoamWriting.h"
#include "Message.h"

namespace foam::filters {
namespace {

/// Integers up to here survive as double.
constexpr double kLargestInteger = 9007199254740992.0;

/// Largest difference in z, relative to the extents in x and y.
constexpr double kPlaneTolerance = 1e-9;

/// A position is a junction's image if it lies this close to it, in periods,
constexpr double kImageTolerance = 1e-6;
/// or as close as coordinates' rounding tells, where that still tells images apart.
constexpr double kLargestImageTolerance = 0.1;

template <class... Parts> [[noreturn]] void not_a_foam(const Parts&... parts) {
  fail("the input is not a foam: ", parts...);
}

/// A named array with one value for each of `count` elements.
class Column {
public:
  Column(vtkFieldData* data, const char* name, vtkIdType count, const char* element)
      : array_(find(data, name)), element_(element) {
    if (array_->GetNumberOfComponents() != 1) {
      not_a_foam("array ", name, " has ", array_->GetNumberOfComponents(), " components, not 1");
    }
    if (array_->GetNumberOfTuples() != count) {
      not_a_foam("array ", name, " has ", array_->GetNumberOfTuples(), " values for ", count, " ",
                 element, "s");
    }
  }

  double real(vtkIdType i) const {
    const double value = array_->GetComponent(i, 0);
    if (!std::isfinite(value)) {
      not_a_foam(array_->GetName(), " of ", element_, " ", i, " is ", value);
    }
    return value;
  }

  std::int64_t integer(vtkIdType i, double least, double largest = kLargestInteger) const {
    const double value = array_->GetComponent(i, 0);
    if (!(value >= least && value <= largest) || value != std::trunc(value)) {
      not_a_foam(array_->GetName(), " of ", element_, " ", i, " is ", value);
    }
    return static_cast<std::int64_t>(value);
  }

  static vtkDataArray* find(vtkFieldData* data, const char* name) {
    vtkDataArray* array = data->GetArray(name);
    if (!array) {
      not_a_foam("array ", name, data->GetAbstractArray(name) ? " is not numeric" : " is missing");
    }
    return array;
  }

private:
  vtkDataArray* array_;
  const char* element_;
};

double single(vtkFieldData* data, const char* name) {
  return Column(data, name, 1, "foam").real(0);
}

std::int64_t single_integer(vtkFieldData* data, const char* name, double least, double largest) {
  return Column(data, name, 1, "foam").integer(0, least, largest);
}

std::array<double, 4> four_numbers(vtkFieldData* data, const char* name) {
  vtkDataArray* array = Column::find(data, name);
  if (array->GetNumberOfValues() != 4) {
    not_a_foam("array ", name, " has ", array->GetNumberOfValues(), " values, not 4");
  }
  std::array<double, 4> numbers{};
  for (int i = 0; i < 4; ++i) {
    const int components = array->GetNumberOfComponents();
    const double value = array->GetComponent(i / components, i % components);
    if (!std::isfinite(value)) {
      not_a_foam(name, " hold ", value);
    }
    numbers[static_cast<std::size_t>(i)] = value;
  }
  return numbers;
}

/// Only that of a torus has to have an area.
Lattice read_lattice(vtkFieldData* data, bool periodic) {
  const char* name = "PeriodicBounds";
  auto numbers = four_numbers(data, name);
  Lattice lattice = Lattice::rectangle(numbers[0], numbers[1], numbers[2], numbers[3]);
  bool any_area = lattice.first.x > 0 && lattice.second.y > 0;
  if (data->HasArray("PeriodVectors")) {
    name = "PeriodVectors";
    numbers = four_numbers(data, name);
    lattice.first = {numbers[0], numbers[1]};
    lattice.second = {numbers[2], numbers[3]};
    any_area = lattice.area() > 0;
  }
  if (periodic && !any_area) {
    not_a_foam(name, " enclose no area: ", numbers[0], " ", numbers[1], " ", numbers[2], " ",
               numbers[3]);
  }
  return lattice;
}

void read_state(vtkFieldData* data, FilmSet& set) {
  set.time = single(data, "TimeValue");
  set.surface_tension = single(data, "SurfaceTension");
  set.surroundings.boundary = static_cast<Boundary>(single_integer(data, "Boundary", 0, 3));
  set.surroundings.lattice = read_lattice(data, set.surroundings.periodic());
  set.t1_count = single_integer(data, "T1Count", 0, kLargestInteger);
  set.t2_count = single_integer(data, "T2Count", 0, kLargestInteger);
  set.t3_count = single_integer(data, "T3Count", 0, kLargestInteger);
  set.report.converged = single_integer(data, "Converged", 0, 1) == 1;
  set.report.iterations =
      static_cast<int>(single_integer(data, "Iterations", 0, std::numeric_limits<int>::max()));
  set.report.max_angle_error = single(data, "MaxAngleError");
  set.report.max_area_error = single(data, "MaxAreaError");
  if (data->HasArray("Residual")) {
    set.report.residual = single(data, "Residual");
  }
  if (data->HasArray("TimeStep")) {
    set.time_step = single(data, "TimeStep");
    set.thresholds = {single(data, "T1Length"), single(data, "T2Area")};
  }
  if (data->HasArray("StrainDirection")) {
    set.strain = single(data, "Strain");
    set.strain_direction = static_cast<int>(single_integer(data, "StrainDirection", -1, 1));
  }
  if (data->HasArray("GrowthConstant")) {
    set.growth_constant = single(data, "GrowthConstant");
  }

  const vtkIdType count = Column::find(data, "BubbleId")->GetNumberOfTuples();
  const Column id(data, "BubbleId", count, "bubble");
  const Column pressure(data, "BubblePressure", count, "bubble");
  const Column target_area(data, "BubbleTargetArea", count, "bubble");
  for (vtkIdType i = 0; i < count; ++i) {
    set.bubbles.push_back({id.integer(i, 0), pressure.real(i), target_area.real(i)});
  }
  std::sort(set.bubbles.begin(), set.bubbles.end(),
            [](const auto& a, const auto& b) { return a.id < b.id; });
}

/// A point of the films, without its z.
Vec2 point(vtkPolyData* films, vtkIdType i) {
  double p[3];
  films->GetPoint(i, p);
  return {p[0], p[1]};
}

void read_junctions(vtkPolyData* films, const std::vector<Index>& junction_of, FilmSet& set) {
  const Index last = *std::max_element(junction_of.begin(), junction_of.end());
  set.junctions.resize(place_of(last + 1));
  std::vector<bool> found(set.junctions.size(), false);
  for (std::size_t i = 0; i < junction_of.size(); ++i) {
    const Index j = junction_of[i];
    if (j >= 0 && !found[place_of(j)]) {
      found[place_of(j)] = true;
      set.junctions[place_of(j)] = point(films, static_cast<vtkIdType>(i));
    }
  }
  const auto missing = std::find(found.begin(), found.end(), false);
  if (missing != found.end()) {
    not_a_foam("no point has JunctionId ", missing - found.begin());
  }
}

std::vector<Index> read_junction_ids(vtkPolyData* films) {
  const vtkIdType count = films->GetNumberOfPoints();
  const Column id(films->GetPointData(), "JunctionId", count, "point");
  std::vector<Index> junction_of(static_cast<std::size_t>(count));
  const double largest =
      std::min<double>(static_cast<double>(count) - 1, std::numeric_limits<Index>::max() - 1);
  for (vtkIdType i = 0; i < count; ++i) {
    junction_of[static_cast<std::size_t>(i)] = static_cast<Index>(id.integer(i, -1, largest));
  }
  return junction_of;
}

/// How many periods lie between a junction and one of its images. \param rounding of a coordinate
Wrap periods(const FilmSet& set, Vec2 image, Index junction, vtkIdType film, double rounding) {
  const Vec2 place = set.junctions[place_of(junction)];
  const auto& [origin, first, second] = set.surroundings.lattice;
  const bool periodic = set.surroundings.has_images();
  const double longest = std::max(norm(first), norm(second));
  const double area = set.surroundings.periodic() ? set.surroundings.lattice.area()
                                                  : longest * longest; // of a channel
  const double tolerance =
      std::clamp(4 * rounding * longest / area, kImageTolerance, kLargestImageTolerance);
  const Vec2 count = periodic ? Lattice{{}, first, second}.coordinates(image - place) : Vec2{};
  const auto whole = [&](double n) {
    return std::abs(n - std::round(n)) < tolerance && std::abs(n) < 1e6;
  };
  if (!(periodic ? whole(count.x) && whole(count.y) : image == place)) {
    not_a_foam(
        "film ", film, " ends in (", image.x, ", ", image.y, "), but junction ", junction,
        " lies in (", place.x, ", ", place.y, ")",
        periodic
            ? ", not whole periods away: the films do not fit their torus; were they transformed?"
            : "");
  }
  return {static_cast<Index>(std::round(count.x)), static_cast<Index>(std::round(count.y))};
}

/// How many of the lines are films. Those that follow are of walls on which no film ends, and have
/// no junctions.
vtkIdType count_films(vtkPolyData* films, const std::vector<Index>& junction_of) {
  vtkCellArray* lines = films->GetLines();
  vtkIdType count = lines->GetNumberOfCells();
  vtkDataArray* kind = films->GetCellData()->GetArray("Kind");
  if (!kind || kind->GetNumberOfTuples() != count) {
    return count;
  }
  const auto is_bare = [&](vtkIdType i) {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    lines->GetCellAtId(i, size, ids);
    return kind->GetComponent(i, 0) == 1 && std::all_of(ids, ids + size, [&](vtkIdType id) {
             return id >= 0 && id < films->GetNumberOfPoints() &&
                    junction_of[static_cast<std::size_t>(id)] < 0;
           });
  };
  while (count > 0 && is_bare(count - 1)) {
    --count;
  }
  return count;
}

void read_polylines(vtkPolyData* films, const std::vector<Index>& junction_of, FilmSet& set) {
  vtkCellArray* lines = films->GetLines();
  const vtkIdType all = lines->GetNumberOfCells();
  vtkFieldData* data = films->GetCellData();
  const Column left(data, "LeftBubble", all, "film");
  const Column right(data, "RightBubble", all, "film");
  const Column half_angle(data, "HalfAngle", all, "film");
  const double rounding = coordinate_rounding(films);
  const vtkIdType count = count_films(films, junction_of);
  set.films.resize(static_cast<std::size_t>(count));
  for (vtkIdType i = 0; i < count; ++i) {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    lines->GetCellAtId(i, size, ids);
    if (size < 2) {
      not_a_foam("film ", i, " has ", size, " points");
    }
    for (vtkIdType k = 0; k < size; ++k) {
      if (ids[k] < 0 || ids[k] >= films->GetNumberOfPoints()) {
        not_a_foam("film ", i, " names point ", ids[k], ", which does not exist");
      }
      const bool end = k == 0 || k == size - 1;
      const Index junction = junction_of[static_cast<std::size_t>(ids[k])];
      if (end != (junction >= 0)) {
        not_a_foam("film ", i, " has JunctionId ", junction, end ? " at an end" : " inside");
      }
    }
    auto& film = set.films[static_cast<std::size_t>(i)];
    const vtkIdType first = ids[0];
    const vtkIdType last = ids[size - 1];
    film.start = junction_of[static_cast<std::size_t>(first)];
    film.end = junction_of[static_cast<std::size_t>(last)];
    film.left = left.integer(i, -kLargestInteger);
    film.right = right.integer(i, -kLargestInteger);
    film.half_angle = half_angle.real(i);
    film.wrap = periods(set, point(films, last), film.end, i, rounding) -
                periods(set, point(films, first), film.start, i, rounding);
  }
}

void read_tensions(vtkPolyData* films, FilmSet& set) {
  vtkFieldData* data = films->GetCellData();
  if (!data->HasArray("FilmTension")) {
    return;
  }
  const Column tension(data, "FilmTension", films->GetNumberOfLines(), "film");
  for (vtkIdType i = 0; i < static_cast<vtkIdType>(set.films.size()); ++i) {
    set.tensions.push_back(tension.real(i));
  }
}

void read_outsides(vtkFieldData* data, FilmSet& set) {
  if (!data->HasArray("OutsidePressure")) {
    return;
  }
  std::int64_t last = 0;
  for (const auto& film : set.films) {
    last = std::min({last, film.left, film.right});
  }
  const bool walls = set.surroundings.has_walls();
  const vtkIdType listed = Column::find(data, "OutsidePressure")->GetNumberOfTuples();
  // Of walls there may be some on which no film ends.
  const vtkIdType count = walls ? std::max<vtkIdType>(listed, -last) : -last;
  const Column pressure(data, "OutsidePressure", count, "outside");
  const auto kind = walls ? Exterior::Kind::Solid : Exterior::Kind::Gas;
  for (vtkIdType i = 0; i < count; ++i) {
    set.exteriors.push_back({kind, pressure.real(i)});
  }
}

/// Moves walls as the films have been since they were written, by a Transform, say: as three of
/// their junctions have. \param rounding of a coordinate
void move_walls(vtkFieldData* data, double rounding, FilmSet& set) {
  constexpr double kSimilar = 1e-6;
  vtkDataArray* frame = Column::find(data, "WallFrame");
  if (frame->GetNumberOfComponents() != 3 || frame->GetNumberOfTuples() != 3) {
    not_a_foam("array WallFrame has ", frame->GetNumberOfValues(), " values, not 9");
  }
  std::array<Vec2, 3> before{};
  std::array<Vec2, 3> after{};
  bool moved = false;
  for (std::size_t i = 0; i < 3; ++i) {
    double tuple[3];
    frame->GetTuple(static_cast<vtkIdType>(i), tuple);
    if (!(tuple[0] >= 0 && tuple[0] < static_cast<double>(set.junctions.size()))) {
      not_a_foam("WallFrame names junction ", tuple[0], ", which does not exist");
    }
    before[i] = {tuple[1], tuple[2]};
    after[i] = set.junctions[static_cast<std::size_t>(tuple[0])];
    moved = moved || norm(after[i] - before[i]) > 4 * rounding;
  }
  if (!moved) {
    return;
  }
  const Vec2 a = before[1] - before[0];
  const Vec2 b = before[2] - before[0];
  const Vec2 c = after[1] - after[0];
  const Vec2 d = after[2] - after[0];
  const auto image = [&](Vec2 v) { // of a vector: what c and d are of a and b
    return (cross(v, b) / cross(a, b)) * c + (cross(a, v) / cross(a, b)) * d;
  };
  const Vec2 x = image({1, 0});
  const Vec2 y = image({0, 1});
  const bool mirrored = cross(x, y) < 0;
  const bool similar = norm((mirrored ? -y : y) - left_normal(x)) < kSimilar * norm(x);
  for (WallPiece& piece : set.wall_pieces) {
    if (!similar && piece.half_angle != 0) {
      not_a_foam("its round walls have been distorted: were the films transformed?");
    }
    const Vec2 way = image(piece.chord);
    piece.start = after[0] + image((mirrored ? piece.end() : piece.start) - before[0]);
    piece.chord = mirrored ? -way : way; // the foam is on the left again
  }
  for (const Exterior& wall : set.exteriors) {
    if (mirrored) {
      const auto first = set.wall_pieces.begin() + wall.first_piece;
      std::reverse(first, first + wall.pieces);
    }
  }
}

/// What write_walls() has written.
void read_walls(vtkFieldData* data, double rounding, FilmSet& set) {
  constexpr int kComponents = 6;
  if (!set.surroundings.has_walls() || !data->HasArray("WallPieces")) {
    return;
  }
  vtkDataArray* pieces = Column::find(data, "WallPieces");
  const vtkIdType count = Column::find(data, "WallContact")->GetNumberOfTuples();
  const Column contact(data, "WallContact", count, "wall");
  if (pieces->GetNumberOfComponents() != kComponents) {
    not_a_foam("array WallPieces has ", pieces->GetNumberOfComponents(), " components, not ",
               kComponents);
  }
  set.exteriors.resize(static_cast<std::size_t>(count));
  for (vtkIdType i = 0; i < count; ++i) {
    Exterior& wall = set.exteriors[static_cast<std::size_t>(i)];
    wall.kind = Exterior::Kind::Solid;
    wall.contact = static_cast<WallContact>(contact.integer(i, 0, 1));
  }
  vtkIdType last = 0;
  for (vtkIdType i = 0; i < pieces->GetNumberOfTuples(); ++i) {
    std::array<double, kComponents> p{};
    pieces->GetTuple(i, p.data());
    const auto wall = static_cast<vtkIdType>(p[0]);
    if (!std::ranges::all_of(p, [](double v) { return std::isfinite(v); }) || wall < last ||
        wall >= count || static_cast<double>(wall) != p[0]) {
      not_a_foam("piece ", i, " of WallPieces belongs to wall ", p[0]);
    }
    last = wall;
    Exterior& of = set.exteriors[static_cast<std::size_t>(wall)];
    of.first_piece = of.pieces == 0 ? static_cast<Index>(i) : of.first_piece;
    ++of.pieces;
    set.wall_pieces.push_back({{p[1], p[2]}, {p[3], p[4]}, p[5]});
  }
  move_walls(data, rounding, set);
  for (vtkIdType i = 0; i < count; ++i) {
    if (set.exteriors[static_cast<std::size_t>(i)].pieces == 0) {
      not_a_foam("wall ", i, " has no pieces");
    }
  }
}

/// A single value in the field data; 0 if there is none.
double value_or_zero(vtkPolyData* films, const char* name) {
  vtkDataArray* array = films ? films->GetFieldData()->GetArray(name) : nullptr;
  const double value = array && array->GetNumberOfValues() == 1 ? array->GetComponent(0, 0) : 0;
  return std::isfinite(value) ? value : 0;
}

/// In words, what is not films.
std::string what_it_is(vtkPolyData* data) {
  if (!data || data->GetNumberOfPoints() == 0) {
    return "is empty: was the file read completely, is there an error before?";
  }
  const vtkIdType polygons = data->GetNumberOfPolys() + data->GetNumberOfStrips();
  if (polygons > 0 && data->GetCellData()->HasArray("BubbleId")) {
    return message("is the ", polygons, " bubbles of a foam");
  }
  return polygons > 0 ? message("is a surface of ", polygons, " polygons")
                      : message("is ", data->GetNumberOfPoints(), " points");
}

constexpr const char* kWanted = "what is wanted are films, the first output of FoamFromPoints or "
                                "FoamCoarsen or a file of them";

/// Films that were turned out of their plane would be a foam of another shape.
void check_plane(vtkPolyData* films) {
  double bounds[6];
  films->GetBounds(bounds);
  const double width = std::max(bounds[1] - bounds[0], bounds[3] - bounds[2]);
  if (bounds[5] - bounds[4] > kPlaneTolerance * width) {
    not_a_foam("its points lie between z = ", bounds[4], " and ", bounds[5],
               ", not in a plane of constant z");
  }
}

/// Of the polygon through the ends of films on walls, walked with the foam on the left.
double area_between_contacts(const Foam& foam) {
  double area = 0;
  for (const Half h : foam.half_slots()) {
    if (foam.solid(foam.right(h))) {
      area += 0.5 * cross(foam.position[foam.start(h)] - foam.position[Junction(0)], foam.chord(h));
    }
  }
  return area;
}

/// \throws FoamError for bubbles that cover nothing, as mirrored ones do, and for a torus whose
/// bubbles do not cover its cell once, as one that was scaled by a whole number does not.
void check_cover(const Foam& foam) {
  double covered = 0;
  for (const Bubble b : foam.bubble_slots()) {
    covered += foam.area(b);
  }
  constexpr double kRounding = 1e-9;
  if (foam.surroundings.has_walls() && !foam.surroundings.has_images() &&
      area_between_contacts(foam) <
          -kRounding * std::abs(covered)) { // walls have been turned round
    covered = -std::abs(covered);
  }
  if (!(covered > 0)) {
    not_a_foam("the area of its bubbles is ", covered,
               covered < 0 ? ": was it mirrored? Then the points of each film are to be reversed"
                           : "");
  }
  const double cell = foam.surroundings.lattice.area();
  if (foam.surroundings.periodic() && !(std::abs(covered - cell) <= kImageTolerance * cell)) {
    not_a_foam("its bubbles cover ", covered, ", but its torus has an area of ", cell,
               ": the films do not fit their torus; were they transformed?");
  }
}

} // namespace

vtkPolyData* films_in(vtkDataObject* input) {
  auto* films = vtkPolyData::SafeDownCast(input);
  if (!films) {
    fail("the input is ",
         vtkCompositeDataSet::SafeDownCast(input) ? "blocks, of which Extract Block takes one"
                                                  : message("a ", input->GetClassName()),
         "; ", kWanted);
  }
  return films;
}

FilmSet read_films(vtkPolyData* films) {
  if (!films || films->GetNumberOfPoints() == 0 || films->GetNumberOfLines() == 0) {
    fail("the input has no films, but ", what_it_is(films), "; ", kWanted);
  }
  vtkFieldData* data = films->GetFieldData();
  if (!data->HasArray("FormatVersion") && !films->GetCellData()->HasArray("LeftBubble")) {
    fail("the input is not a foam: its ", films->GetNumberOfLines(),
         " lines have no arrays of films, FormatVersion is missing, for one; ", kWanted);
  }
  const auto version = single_integer(data, "FormatVersion", -kLargestInteger, kLargestInteger);
  if (version < 1 || version > kFormatVersion) {
    not_a_foam("its FormatVersion is ", version, ", and only 1 to ", kFormatVersion, " are known");
  }
  if (films->GetNumberOfCells() != films->GetNumberOfLines()) {
    not_a_foam(films->GetNumberOfCells() - films->GetNumberOfLines(),
               " of its cells are not polylines");
  }
  if (!films->GetLines()->IsValid()) {
    not_a_foam("the offsets of its polylines are inconsistent");
  }
  check_plane(films);
  FilmSet set;
  read_state(data, set);
  const auto junction_of = read_junction_ids(films);
  read_junctions(films, junction_of, set);
  read_polylines(films, junction_of, set);
  read_tensions(films, set);
  read_outsides(data, set);
  read_walls(data, coordinate_rounding(films), set);
  return set;
}

Foam checked_foam(const FilmSet& films) {
  Foam foam = foam_of(films);
  check_cover(foam);
  for (const Bubble b : foam.bubble_slots()) {
    const double area = foam.area(b);
    // The thesis's method may fold one that is to vanish.
    const bool to_vanish = foam.target_area[b] <= foam.thresholds.t2_area;
    if (to_vanish ? !std::isfinite(area) : !(area > 0)) {
      not_a_foam("the area of bubble ", foam.bubble_id[b], " is ", area);
    }
  }
  return foam;
}

Foam read_foam(vtkPolyData* films) {
  Foam foam = foam_of(read_films(films));
  check_cover(foam);
  return foam;
}

double coordinate_rounding(vtkPolyData* films) {
  vtkDataArray* half_angle = films->GetCellData()->GetArray("HalfAngle");
  const bool single_precision = films->GetPoints()->GetDataType() == VTK_FLOAT ||
                                (half_angle && half_angle->GetDataType() == VTK_FLOAT);
  double bounds[6];
  films->GetBounds(bounds);
  double farthest = 0;
  for (int i = 0; i < 4; ++i) {
    farthest = std::max(farthest, std::abs(bounds[i]));
  }
  return farthest * (single_precision ? double{std::numeric_limits<float>::epsilon()}
                                      : std::numeric_limits<double>::epsilon());
}

std::string doubt(const EquilibriumReport& given, const EquilibriumReport& found) {
  if (!given.converged || found.converged) {
    return {};
  }
  std::ostringstream words;
  words << std::setprecision(3)
        << "The films are said to be in equilibrium, but are not: angles are "
        << "off by up to " << found.max_angle_error << " rad, areas by up to "
        << found.max_area_error << " times their targets, the largest residual is "
        << found.residual
        << (found.residual > std::max(found.max_angle_error, found.max_area_error)
                ? ", as the pressures do not go with the films' arcs"
                : "")
        << ". Were they changed, by a Transform, say?";
  return words.str();
}

double read_time(vtkPolyData* films) {
  return value_or_zero(films, "TimeValue");
}

std::string read_end(vtkPolyData* data) {
  vtkFieldData* field = data->GetFieldData();
  vtkDataArray* ended = field->GetArray("Ended");
  if (!ended || ended->GetNumberOfValues() != 1 || ended->GetComponent(0, 0) == 0) {
    return {};
  }
  auto* why = vtkStringArray::SafeDownCast(field->GetAbstractArray("EndReason"));
  return why && why->GetNumberOfValues() == 1 ? why->GetValue(0) : "it does not say why";
}

} // namespace foam::filters
