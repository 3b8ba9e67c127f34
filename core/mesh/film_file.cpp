// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/film_file.h"

#include <charconv>
#include <cstdint>
#include <fstream>
#include <string>

#include "mesh/number.h"

namespace foam {
namespace {

constexpr const char* kFormat = "foam-films-1";

class Reader {
public:
  explicit Reader(const std::filesystem::path& path) : path_(path), file_(path) {
    if (!file_) {
      throw FoamError("cannot read " + path_.string());
    }
  }

  void expect(const std::string& name) {
    if (word() != name) {
      fail(name);
    }
  }

  template <class Number> void value(Number& number, const std::string& name) {
    const std::string text = word();
    const char* const end = text.data() + text.size();
    const auto result = std::from_chars(text.data(), end, number);
    if (result.ec != std::errc{} || result.ptr != end) {
      fail(name);
    }
  }

  std::size_t count(const std::string& name) {
    expect(name);
    std::uint32_t count = 0;
    value(count, "the number of " + name);
    return count;
  }

private:
  std::string word() {
    std::string text;
    file_ >> text;
    last_ = text;
    return text;
  }

  [[noreturn]] void fail(const std::string& expected) const {
    throw FoamError(path_.string() + ": expected " + expected + ", but found \"" + last_ + "\"");
  }

  std::filesystem::path path_;
  std::ifstream file_;
  std::string last_;
};

} // namespace

void write_film_file(const std::filesystem::path& path, const FilmSet& set) {
  std::ofstream file(path);
  file << kFormat << "\nboundary " << static_cast<int>(set.boundary) << "\nbox "
       << number(set.box.xmin) << ' ' << number(set.box.xmax) << ' ' << number(set.box.ymin) << ' '
       << number(set.box.ymax) << "\nsurface_tension " << number(set.surface_tension) << "\ntime "
       << number(set.time) << "\ncounts " << set.t1_count << ' ' << set.t2_count << ' '
       << set.t3_count << "\njunctions " << set.junctions.size() << '\n';
  for (const Vec2 x : set.junctions) {
    file << number(x.x) << ' ' << number(x.y) << '\n';
  }
  file << "films " << set.films.size() << '\n';
  for (const FilmSet::Film& film : set.films) {
    file << film.start << ' ' << film.end << ' ' << film.left << ' ' << film.right << ' '
         << number(film.half_angle) << ' ' << film.wrap.x << ' ' << film.wrap.y << '\n';
  }
  file << "bubbles " << set.bubbles.size() << '\n';
  for (const FilmSet::Bubble& bubble : set.bubbles) {
    file << bubble.id << ' ' << number(bubble.pressure) << ' ' << number(bubble.target_area)
         << '\n';
  }
  if (!file.flush()) {
    throw FoamError("cannot write " + path.string());
  }
}

FilmSet read_film_file(const std::filesystem::path& path) {
  Reader reader(path);
  FilmSet set;
  reader.expect(kFormat);
  reader.expect("boundary");
  int boundary = 0;
  reader.value(boundary, "a boundary");
  if (boundary < 0 || boundary > static_cast<int>(Boundary::Fixed)) {
    throw FoamError(path.string() + ": there is no boundary " + std::to_string(boundary));
  }
  set.boundary = static_cast<Boundary>(boundary);
  reader.expect("box");
  for (double* bound : {&set.box.xmin, &set.box.xmax, &set.box.ymin, &set.box.ymax}) {
    reader.value(*bound, "a bound of the box");
  }
  reader.expect("surface_tension");
  reader.value(set.surface_tension, "a surface tension");
  reader.expect("time");
  reader.value(set.time, "a time");
  reader.expect("counts");
  for (std::int64_t* count : {&set.t1_count, &set.t2_count, &set.t3_count}) {
    reader.value(*count, "a count of operations");
  }
  set.junctions.resize(reader.count("junctions"));
  for (Vec2& x : set.junctions) {
    reader.value(x.x, "a junction's x");
    reader.value(x.y, "a junction's y");
  }
  set.films.resize(reader.count("films"));
  for (FilmSet::Film& film : set.films) {
    reader.value(film.start, "a film's start");
    reader.value(film.end, "a film's end");
    reader.value(film.left, "a film's left bubble");
    reader.value(film.right, "a film's right bubble");
    reader.value(film.half_angle, "a film's half-angle");
    reader.value(film.wrap.x, "a film's periods along x");
    reader.value(film.wrap.y, "a film's periods along y");
  }
  set.bubbles.resize(reader.count("bubbles"));
  for (FilmSet::Bubble& bubble : set.bubbles) {
    reader.value(bubble.id, "a bubble's id");
    reader.value(bubble.pressure, "a bubble's pressure");
    reader.value(bubble.target_area, "a bubble's target area");
  }
  return set;
}

} // namespace foam
