// SPDX-License-Identifier: GPL-3.0-or-later
#include "construct/from_labels.h"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <optional>
#include <string>
#include <utility>

#include "base/error.h"

namespace foam {
namespace {

using std::to_string;

/// What is not in the foam.
constexpr Index kOutside = kNone;

class Picture {
public:
  Picture(const LabelImage& image, const LabelOptions& options)
      : image_(image), options_(options), wraps_(options.border == PictureBorder::Torus) {
    check();
  }

  LabelFoam run() {
    close_lines();
    find_regions();
    if (const std::optional<LabelImage> plane = unrolled()) {
      LabelOptions free = options_;
      free.border = PictureBorder::Films;
      return Picture(*plane, free).run();
    }
    leave_out_background();
    if (options_.border == PictureBorder::LeftOut) {
      leave_out_border();
    }
    Division division = sides();
    keep_largest_piece(division);
    name_regions(division);
    const auto outline =
        options_.border == PictureBorder::Wall ? DivisionOutline::Wall : DivisionOutline::Films;
    static_cast<DivisionFoam&>(result_) =
        foam_of_division(division, outline, options_.surface_tension);
    return std::move(result_);
  }

private:
  void check() const {
    require(image_.pixel.x > 0, "the width of a pixel", "positive", image_.pixel.x);
    require(image_.pixel.y > 0, "the height of a pixel", "positive", image_.pixel.y);
    for (const std::int64_t label : image_.labels) {
      if (label < 0 && label != options_.background) {
        throw FoamError("labels must not be negative, but one is " + to_string(label));
      }
    }
  }

  std::size_t pixel(Index x, Index y) const {
    return place_of(y) * place_of(image_.width) + place_of(x);
  }
  template <class Visit> void for_each_pixel(Visit&& visit) const {
    for (Index y = 0; y < image_.height; ++y) {
      for (Index x = 0; x < image_.width; ++x) {
        visit(x, y, pixel(x, y));
      }
    }
  }
  /// Calls visit(p) for the pixels above, below, left and right.
  template <class Visit> void for_each_beside(Index x, Index y, Visit&& visit) const {
    const Index w = image_.width;
    const Index h = image_.height;
    if (x > 0 || wraps_) {
      visit(pixel(x > 0 ? x - 1 : w - 1, y));
    }
    if (x + 1 < w || wraps_) {
      visit(pixel(x + 1 < w ? x + 1 : 0, y));
    }
    if (y > 0 || wraps_) {
      visit(pixel(x, y > 0 ? y - 1 : h - 1));
    }
    if (y + 1 < h || wraps_) {
      visit(pixel(x, y + 1 < h ? y + 1 : 0));
    }
  }

  /// The least of each pixel and those beside it in its row and column, or the most.
  template <class Of> std::vector<char> over_squares(const std::vector<char>& of, Of least) const {
    const Index w = image_.width;
    const Index h = image_.height;
    const auto around = [&](Index i, Index n, int by) {
      return wraps_ ? (i + by + n) % n : std::clamp(i + by, Index{0}, n - 1);
    };
    std::vector<char> in_rows(of.size());
    for_each_pixel([&](Index x, Index y, std::size_t p) {
      in_rows[p] =
          least(of[p], least(of[pixel(around(x, w, -1), y)], of[pixel(around(x, w, 1), y)]));
    });
    std::vector<char> result(of.size());
    for_each_pixel([&](Index x, Index y, std::size_t p) {
      result[p] = least(in_rows[p], least(in_rows[pixel(x, around(y, h, -1))],
                                          in_rows[pixel(x, around(y, h, 1))]));
    });
    return result;
  }

  /// Gives background in which no square of three by three pixels has room to the labels beside it,
  /// those that are nearer first.
  void close_lines() {
    labels_ = image_.labels;
    if (!options_.background || std::ranges::find(labels_, *options_.background) == labels_.end()) {
      return;
    }
    const std::int64_t background = *options_.background;
    std::vector<char> empty(labels_.size());
    std::ranges::transform(labels_, empty.begin(),
                           [&](std::int64_t l) { return static_cast<char>(l == background); });
    const auto min = [](char a, char b) { return std::min(a, b); };
    const auto max = [](char a, char b) { return std::max(a, b); };
    const std::vector<char> wide = over_squares(over_squares(empty, min), max);

    const auto label_beside = [&](std::size_t p) {
      std::int64_t found = background;
      for_each_beside(static_cast<Index>(p % place_of(image_.width)),
                      static_cast<Index>(p / place_of(image_.width)), [&](std::size_t q) {
                        if (labels_[q] != background && found == background) {
                          found = labels_[q];
                        }
                      });
      return found;
    };
    std::vector<std::size_t> lines;
    for (std::size_t p = 0; p < labels_.size(); ++p) {
      if (empty[p] != 0 && wide[p] == 0) {
        lines.push_back(p);
      }
    }
    while (true) { // a layer each time
      std::vector<std::pair<std::size_t, std::int64_t>> closed;
      std::vector<std::size_t> open;
      for (const std::size_t p : lines) {
        const std::int64_t label = label_beside(p);
        if (label == background) {
          open.push_back(p);
        } else {
          closed.emplace_back(p, label);
        }
      }
      for (const auto& [p, label] : closed) {
        labels_[p] = label;
      }
      if (closed.empty()) {
        return;
      }
      lines = std::move(open);
    }
  }

  /// What hangs together of a label, or of the background, by the sides of pixels.
  void find_regions() {
    std::vector<Index> parent(labels_.size());
    std::iota(parent.begin(), parent.end(), Index{0});
    const auto root = [&](Index p) {
      while (parent[place_of(p)] != p) {
        p = parent[place_of(p)] = parent[place_of(parent[place_of(p)])];
      }
      return p;
    };
    const auto join = [&](std::size_t p, std::size_t q) {
      if (labels_[p] == labels_[q]) {
        const auto [low, high] =
            std::minmax({root(static_cast<Index>(p)), root(static_cast<Index>(q))});
        parent[place_of(high)] = low; // the first pixel of a region stands for it
      }
    };
    for_each_pixel([&](Index x, Index y, std::size_t p) {
      if (x > 0) {
        join(p, p - 1);
      } else if (wraps_) {
        join(p, pixel(image_.width - 1, y));
      }
      if (y > 0) {
        join(p, p - place_of(image_.width));
      } else if (wraps_) {
        join(p, pixel(x, image_.height - 1));
      }
    });
    region_.resize(labels_.size());
    for (std::size_t p = 0; p < labels_.size(); ++p) {
      const Index r = root(static_cast<Index>(p));
      if (place_of(r) == p) {
        region_[p] = static_cast<Index>(label_.size());
        label_.push_back(labels_[p]);
        pixels_.push_back(0);
      } else {
        region_[p] = region_[place_of(r)];
      }
      ++pixels_[place_of(region_[p])];
    }
  }

  /// The picture of a torus on which background goes all round the foam, as one in the plane; none
  /// if it is no such torus.
  std::optional<LabelImage> unrolled() const {
    Index around = kNone; // the largest region of background
    for (Index r = 0; place_of(r) < label_.size(); ++r) {
      if (wraps_ && label_[place_of(r)] == options_.background &&
          (around == kNone || pixels_[place_of(r)] > pixels_[place_of(around)])) {
        around = r;
      }
    }
    if (around == kNone) {
      return std::nullopt;
    }
    // Where pixels lie that hang together, from the first of them on.
    const Index w = image_.width;
    const Index h = image_.height;
    std::vector<std::array<Index, 2>> place(labels_.size());
    std::vector<char> placed(labels_.size(), 0);
    std::array<Index, 2> low{0, 0};
    std::array<Index, 2> high{w - 1, h - 1};
    std::vector<std::size_t> found;
    for (std::size_t first = 0; first < labels_.size(); ++first) {
      if (region_[first] == around || placed[first] != 0) {
        continue;
      }
      place[first] = {static_cast<Index>(first % place_of(w)),
                      static_cast<Index>(first / place_of(w))};
      placed[first] = 1;
      found.assign(1, first);
      while (!found.empty()) {
        const auto [x, y] = place[found.back()];
        found.pop_back();
        for (const auto& [i, k] : {std::array{x - 1, y}, {x + 1, y}, {x, y - 1}, {x, y + 1}}) {
          const std::size_t p = pixel(((i % w) + w) % w, ((k % h) + h) % h);
          if (region_[p] == around) {
            continue;
          }
          if (placed[p] != 0) {
            if (place[p] != std::array{i, k}) {
              return std::nullopt; // it goes round the torus
            }
            continue;
          }
          place[p] = {i, k};
          placed[p] = 1;
          low = {std::min(low[0], i), std::min(low[1], k)};
          high = {std::max(high[0], i), std::max(high[1], k)};
          found.push_back(p);
        }
      }
    }
    LabelImage plane;
    plane.pixel = image_.pixel;
    plane.corner = image_.corner + Vec2{low[0] * image_.pixel.x, low[1] * image_.pixel.y};
    plane.width = high[0] - low[0] + 1;
    plane.height = high[1] - low[1] + 1;
    plane.labels.assign(place_of(plane.width) * place_of(plane.height), *options_.background);
    for (std::size_t p = 0; p < labels_.size(); ++p) {
      if (region_[p] != around) {
        plane.labels[place_of(place[p][1] - low[1]) * place_of(plane.width) +
                     place_of(place[p][0] - low[0])] = labels_[p];
      }
    }
    return plane;
  }

  template <class Visit> void for_each_on_border(Visit&& visit) const {
    for (Index x = 0; x < image_.width; ++x) {
      visit(pixel(x, 0));
      visit(pixel(x, image_.height - 1));
    }
    for (Index y = 0; y < image_.height; ++y) {
      visit(pixel(0, y));
      visit(pixel(image_.width - 1, y));
    }
  }
  /// Takes regions for the outside.
  void leave_out(const std::vector<char>& regions) {
    for (Index& r : region_) {
      if (r != kOutside && regions[place_of(r)] != 0) {
        r = kOutside;
      }
    }
  }

  /// Background that reaches the border is outside, and other is a bubble that nobody numbered.
  void leave_out_background() {
    if (!options_.background || wraps_) {
      return;
    }
    std::vector<char> outside(label_.size(), 0);
    bool any = false;
    for_each_on_border([&](std::size_t p) {
      if (labels_[p] == *options_.background) {
        outside[place_of(region_[p])] = 1;
        any = true;
      }
    });
    if (any && options_.border == PictureBorder::Wall) {
      throw FoamError("the picture's border cannot be a wall: there is background beside it");
    }
    if (any) {
      leave_out(outside);
    }
  }

  void leave_out_border() {
    std::vector<char> there(label_.size(), 0);
    for_each_on_border([&](std::size_t p) {
      if (region_[p] != kOutside) {
        there[place_of(region_[p])] = 1;
      }
    });
    leave_out(there);
  }

  Index region(Index x, Index y) const {
    if (wraps_) {
      return region_[pixel((x + image_.width) % image_.width, (y + image_.height) % image_.height)];
    }
    const bool inside = x >= 0 && y >= 0 && x < image_.width && y < image_.height;
    return inside ? region_[pixel(x, y)] : Index{kOutside};
  }

  /// The sides of pixels between two regions.
  Division sides() const {
    Division division;
    const Index w = image_.width;
    const Index h = image_.height;
    const Index columns = wraps_ ? w : w + 1; // of corners
    const Index rows = wraps_ ? h : h + 1;
    std::vector<Index> corner(place_of(columns) * place_of(rows), kNone);
    const auto point = [&](Index x, Index y) {
      const Index column = x % columns;
      const Index row = y % rows;
      Index& number = corner[place_of(row) * place_of(columns) + place_of(column)];
      if (number == kNone) {
        number = static_cast<Index>(division.points.size());
        division.points.push_back(image_.corner +
                                  Vec2{column * image_.pixel.x, row * image_.pixel.y});
      }
      return number;
    };
    for (Index y = 0; y < rows; ++y) {
      for (Index x = 0; x < columns; ++x) {
        const Index here = region(x, y);
        if (const Index beside = region(x - 1, y); y < h && beside != here) {
          division.sides.push_back(
              {point(x, y), point(x, y + 1), beside, here, {0, (y + 1) / rows}});
        }
        if (const Index below = region(x, y - 1); x < w && below != here) {
          division.sides.push_back(
              {point(x, y), point(x + 1, y), here, below, {(x + 1) / columns, 0}});
        }
      }
    }
    if (wraps_) {
      division.torus = Lattice{image_.corner, {w * image_.pixel.x, 0}, {0, h * image_.pixel.y}};
    }
    return division;
  }

  /// What lies inside a single bubble, or apart from the foam, goes.
  void keep_largest_piece(Division& division) {
    if (division.sides.empty()) {
      throw FoamError("the picture shows no bubbles");
    }
    const std::vector<Index> piece = pieces_of(division);
    std::vector<std::size_t> sizes(place_of(*std::ranges::max_element(piece)) + 1, 0);
    for (const Index k : piece) {
      ++sizes[place_of(k)];
    }
    const auto largest = static_cast<Index>(std::ranges::max_element(sizes) - sizes.begin());
    kept_.assign(label_.size(), 0);
    std::vector<char> there(label_.size(), 0);
    const auto note = [](std::vector<char>& of, const Side& side) {
      for (const Index r : {side.left, side.right}) {
        if (r != kOutside) {
          of[place_of(r)] = 1;
        }
      }
    };
    for (std::size_t s = 0; s < piece.size(); ++s) {
      note(there, division.sides[s]);
      if (piece[s] == largest) {
        note(kept_, division.sides[s]);
      }
    }
    const auto is_kept = [&](Index r) { return r != kOutside && kept_[place_of(r)] != 0; };
    std::vector<char> inside(sizes.size(), 0); // whether a piece lies in a bubble
    std::vector<Index> piece_of(label_.size(), kNone);
    for (std::size_t s = 0; s < piece.size(); ++s) {
      for (const Index r : {division.sides[s].left, division.sides[s].right}) {
        if (is_kept(r)) {
          inside[place_of(piece[s])] = 1;
        } else if (r != kOutside) {
          piece_of[place_of(r)] = piece[s];
        }
      }
    }
    for (std::size_t r = 0; r < label_.size(); ++r) {
      if (there[r] != 0 && kept_[r] == 0) {
        ++(inside[place_of(piece_of[r])] != 0 ? result_.holes : result_.left_out);
      }
    }
    std::size_t next = 0;
    for (std::size_t s = 0; s < piece.size(); ++s) {
      if (piece[s] == largest) {
        division.sides[next++] = division.sides[s];
      }
    }
    division.sides.resize(next);
  }

  /// The largest part of a label is its bubble. Numbers regions by their ids.
  void name_regions(Division& division) {
    std::map<std::int64_t, Index> largest;
    std::int64_t highest = -1;
    for (Index r = 0; place_of(r) < label_.size(); ++r) {
      const std::int64_t label = label_[place_of(r)];
      highest = std::max(highest, label);
      if (kept_[place_of(r)] != 0 && label != options_.background) {
        const auto [part, is_first] = largest.emplace(label, r);
        result_.split_labels += is_first ? 0 : 1;
        if (pixels_[place_of(r)] > pixels_[place_of(part->second)]) {
          part->second = r;
        }
      }
    }
    std::vector<std::pair<std::int64_t, Index>> named;
    for (Index r = 0; place_of(r) < label_.size(); ++r) {
      if (kept_[place_of(r)] == 0) {
        continue;
      }
      const std::int64_t label = label_[place_of(r)];
      const bool pocket = label == options_.background;
      result_.pockets += pocket ? 1 : 0;
      const bool has_label = !pocket && largest.at(label) == r;
      named.emplace_back(has_label ? label : ++highest, r);
    }
    std::ranges::sort(named);
    std::vector<Index> number(label_.size(), kNone);
    for (const auto& [id, r] : named) {
      number[place_of(r)] = static_cast<Index>(division.ids.size());
      division.ids.push_back(id);
    }
    const auto numbered = [&](Index r) { return r == kOutside ? r : number[place_of(r)]; };
    for (Side& side : division.sides) {
      side.left = numbered(side.left);
      side.right = numbered(side.right);
    }
  }

  const LabelImage& image_;
  const LabelOptions& options_;
  bool wraps_;
  LabelFoam result_;
  std::vector<std::int64_t> labels_; ///< of the pixels
  std::vector<Index> region_;        ///< of the pixels
  std::vector<std::int64_t> label_;  ///< of the regions
  std::vector<std::int64_t> pixels_; ///< of the regions
  std::vector<char> kept_;           ///< whether a region is in the foam
};

} // namespace

LabelFoam build_from_labels(const LabelImage& image, const LabelOptions& options) {
  if (image.width < 1 || image.height < 1 ||
      image.labels.size() != place_of(image.width) * place_of(image.height)) {
    throw FoamError("a picture of " + to_string(image.width) + " x " + to_string(image.height) +
                    " pixels cannot have " + to_string(image.labels.size()) + " labels");
  }
  constexpr std::size_t kMostPixels = 500'000'000; // which can be numbered, and their sides
  if (image.labels.size() > kMostPixels) {
    throw FoamError("the picture has " + to_string(image.labels.size()) + " pixels, but at most " +
                    to_string(kMostPixels) + " can be numbered");
  }
  return Picture(image, options).run();
}

} // namespace foam
