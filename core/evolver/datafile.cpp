// SPDX-License-Identifier: GPL-3.0-or-later
#include "evolver/datafile.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "base/error.h"
#include "base/number.h"
#include "evolver/expression.h"
#include "evolver/tokens.h"

namespace foam::evolver {
namespace {

/// What to do about a keyword of the header or an attribute of an element.
enum class Treatment : std::uint8_t {
  Flag,   ///< nothing: it stands alone and changes no foam
  Values, ///< skip the values, which change no foam
  Refuse  ///< an error: it changes the foam
};
struct Keyword {
  Treatment treatment;
  int values = 0;          ///< as many expressions; of a statement, 0 goes on to the next statement
  const char* reason = ""; ///< for which it is refused
};
using Keywords = std::map<std::string_view, Keyword>;

/// Of those that the reader takes no values from.
const Keywords& header_keywords() {
  using enum Treatment;
  static const Keywords keywords = {
      {"linear", {Flag}},
      {"quadratic", {Flag}},
      {"fixed", {Flag}}, // the scale
      {"keep_originals", {Flag}},
      {"approximate_curvature", {Flag}},
      {"approximate_curvatures", {Flag}},
      {"area_normalization", {Flag}},
      {"autopop", {Flag}},
      {"convert_to_quantities", {Flag}},
      {"effective_area", {Flag}},
      {"everything_quantities", {Flag}},
      {"no_dump", {Flag}},
      {"runge_kutta", {Flag}},
      {"autochop", {Values, 1}},
      {"bodies_predicted", {Values, 1}},
      {"constraint_tolerance", {Values, 1}},
      {"diffusion", {Values, 1}},
      {"edges_predicted", {Values, 1}},
      {"facetedges_predicted", {Values, 1}},
      {"facets_predicted", {Values, 1}},
      {"gap_constant", {Values, 1}},
      {"gravity_constant", {Values, 1}}, // acts on bodies with a density, which are refused
      {"integral_order", {Values, 1}},
      {"integral_order_1d", {Values, 1}},
      {"integral_order_2d", {Values, 1}},
      {"jiggle_temperature", {Values, 1}},
      {"lagrange_order", {Values, 1}},
      {"method_instances_predicted", {Values, 1}},
      {"mobility", {Values, 1}},
      {"quantities_predicted", {Values, 1}},
      {"scale", {Values, 1}},
      {"scale_limit", {Values, 1}},
      {"suppress_warning", {Values, 1}},
      {"target_tolerance", {Values, 1}},
      {"temperature", {Values, 1}},
      {"thickness", {Values, 1}},
      {"unsuppress_warning", {Values, 1}},
      {"vertices_predicted", {Values, 1}},
      {"viscosity", {Values, 1}},
      {"zoom_radius", {Values, 1}},
      {"zoom_vertex", {Values, 1}},
      {"clip_coeff", {Values}},
      {"evolver_version", {Values}},
      {"function", {Values}},
      {"method_instance", {Values}},
      {"procedure", {Values}},
      {"slice_coeff", {Values}},
      {"view_matrix", {Values}},
      {"view_transform_generators", {Values}},
      {"view_transforms", {Values}},
      {"conformal_metric", {Refuse, 0, "gives lengths another metric"}},
      {"klein_metric", {Refuse, 0, "gives lengths another metric"}},
      {"lagrange", {Refuse, 0, "makes edges of many points; command lagrange_to_quadratic first"}},
      {"metric", {Refuse, 0, "gives lengths another metric"}},
      {"optimizing_parameter", {Refuse, 0, "lets a parameter vary"}},
      {"phasefile", {Refuse, 0, "takes tensions from another file"}},
      {"pressure", {Refuse, 0, "makes gas compressible"}},
      {"simplex_representation", {Refuse, 0, "is not the STRING model"}},
      {"soapfilm", {Refuse, 0, "is not the STRING model, which has two dimensions"}},
      {"square_curvature", {Refuse, 0, "gives films another energy"}},
      {"symmetry_group", {Refuse, 0, "wraps films in another way than a torus does"}},
      {"wulff", {Refuse, 0, "gives films another energy"}},
  };
  return keywords;
}

/// Of those that elements of several kinds have.
const Keywords& attribute_keywords() {
  using enum Treatment;
  static const Keywords keywords = {
      {"actual_volume", {Values}},
      {"backcolor", {Values}},
      {"bare", {Flag}},
      {"centerofmass", {Values}},
      {"color", {Values}},
      {"frontcolor", {Values}},
      {"hidden", {Flag}},
      {"hit_constraint", {Values}},
      {"no_display", {Flag}},
      {"no_refine", {Flag}},
      {"nodisplay", {Flag}},
      {"nonwall", {Flag}},
      {"norefine", {Flag}},
      {"opacity", {Values}},
      {"orientation", {Values}},
      {"original", {Values}},
      {"axial_point", {Refuse, 0, "belongs to a symmetry group"}},
      {"phase", {Refuse, 0, "takes tensions from a PHASEFILE"}},
  };
  return keywords;
}

/// What the reader takes values from, and sections.
constexpr std::string_view kStatements[] = {
    "area_method_name",   "boundary",  "constraint",     "define",       "display_origin",
    "length_method_name", "parameter", "parameter_file", "periods",      "quantity",
    "space_dimension",    "string",    "torus",          "torus_filled", "total_time",
    "volume_method_name"};
constexpr std::string_view kSections[] = {"vertices",   "edges",  "faces", "facets",
                                          "facetedges", "bodies", "read"};

/// The parts of a CONSTRAINT or a BOUNDARY, and what may stand between them.
constexpr std::string_view kCurveParts[] = {
    "formula", "function", "equation",    "energy",      "content", "e1",        "e2",
    "e3",      "c1",       "c2",          "c3",          "x1",      "x2",        "x3",
    "convex",  "global",   "nonnegative", "nonpositive", "nonwall", "parameters"};

template <class Names> bool is_one_of(const Names& names, std::string_view word) {
  return std::ranges::find(names, word) != std::end(names);
}

bool begins_section(const Token& token) {
  return token.kind == Token::Kind::End ||
         (token.kind == Token::Kind::Word && token.starts_line && is_one_of(kSections, token.word));
}

bool begins_statement(const Token& token) {
  return begins_section(token) ||
         (token.kind == Token::Kind::Word && token.starts_line &&
          (is_one_of(kStatements, token.word) || header_keywords().contains(token.word)));
}

/// Whether an element, or its section, ends before the token.
bool ends_element(const Token& token) {
  return begins_section(token) || (token.starts_line && token.is_integer());
}

/// The places of elements by their numbers.
class Numbers {
public:
  explicit Numbers(const char* kind) : kind_(kind) {}

  void add(std::int64_t number, int line) {
    if (number <= 0 || !places_.emplace(number, static_cast<Index>(places_.size())).second) {
      fail_at(line, name(number) + " is listed twice, or is no number of an element");
    }
  }
  Index find(std::int64_t number, int line) const {
    const auto found = places_.find(number);
    if (found == places_.end()) {
      fail_at(line, name(number) + " is not listed before it is used");
    }
    return found->second;
  }
  std::string name(std::int64_t number) const { return kind_ + (" " + std::to_string(number)); }

private:
  const char* kind_;
  std::unordered_map<std::int64_t, Index> places_;
};

class Parser {
public:
  Parser(std::string text, std::function<std::string(const std::string&)> include)
      : tokens_(std::move(text), std::move(include)) {}

  Datafile run() {
    header();
    while (tokens_.peek().kind != Token::Kind::End) {
      const Token name = tokens_.take();
      if (name.word == "vertices") {
        rows([&](std::int64_t number, int line) { vertex(number, line); });
      } else if (name.word == "edges") {
        rows([&](std::int64_t number, int line) { edge(number, line); });
      } else if (name.word == "faces" || name.word == "facets") {
        rows([&](std::int64_t number, int line) { face(number, line); });
      } else if (name.word == "bodies") {
        rows([&](std::int64_t number, int line) { body(number, line); });
      } else if (name.word == "facetedges") {
        rows([&](std::int64_t, int) {
          skip_while([](const Token& t) { return !ends_element(t); });
        });
      } else { // commands follow
        if (tokens_.peek().kind != Token::Kind::End) {
          warn(name.line, "the commands after READ are not obeyed");
        }
        break;
      }
    }
    for (const auto& [keyword, skipped] : skipped_) {
      warn(skipped.first,
           "'" + keyword + "' is not known and was skipped" +
               (skipped.second > 1
                    ? ", here and in " + std::to_string(skipped.second - 1) + " more places"
                    : ""));
    }
    return std::move(file_);
  }

private:
  double expression() { return take_expression(tokens_, parameters_); }

  void warn(int line, const std::string& what) {
    file_.warnings.push_back("line " + std::to_string(line) + ": " + what);
  }
  void note_skipped(const Token& keyword) {
    const auto [entry, first] = skipped_.try_emplace(keyword.word, keyword.line, 0);
    ++entry->second.second;
  }
  [[noreturn]] static void refuse(const Token& keyword, const std::string& reason) {
    fail_at(keyword.line, "'" + keyword.word + "' " + reason);
  }

  /// Skips tokens, and all that is in brackets.
  template <class Goes> void skip_while(const Goes& goes) {
    int depth = 0;
    while (tokens_.peek().kind != Token::Kind::End && (depth > 0 || goes(tokens_.peek()))) {
      const Token token = tokens_.take();
      if (token.is('{') || token.is('(') || token.is('[')) {
        ++depth;
      } else if (token.is('}') || token.is(')') || token.is(']')) {
        --depth;
      }
    }
  }
  void skip_statement() {
    skip_while([](const Token& token) { return !begins_statement(token); });
  }
  void skip_separators() {
    while (tokens_.peek().kind == Token::Kind::Separator) {
      tokens_.take();
    }
  }
  Token take_word(const std::string& what) {
    Token token = tokens_.take();
    if (token.kind != Token::Kind::Word) {
      fail_at(token.line, "expected " + what + ", not " + described(token));
    }
    return token;
  }

  void header() {
    while (!begins_section(tokens_.peek())) {
      const Token token = tokens_.take();
      if (token.kind == Token::Kind::Separator) {
        continue;
      }
      if (token.kind != Token::Kind::Word) {
        fail_at(token.line, "expected a keyword, not " + described(token));
      }
      skip_separators();
      if (is_one_of(kStatements, token.word)) {
        statement(token);
      } else if (const auto found = header_keywords().find(token.word);
                 found != header_keywords().end()) {
        treat_statement(token, found->second);
      } else {
        note_skipped(token);
        skip_statement();
      }
    }
    if (!string_model_) {
      throw FoamError(
          "this is no two-dimensional foam of Surface Evolver's: it does not say STRING");
    }
    if (file_.torus && dimension_ != 2) {
      throw FoamError("a torus must have SPACE_DIMENSION 2, but has 3");
    }
  }

  void treat_statement(const Token& keyword, const Keyword& known) {
    if (known.treatment == Treatment::Refuse) {
      refuse(keyword, known.reason);
    }
    if (known.treatment == Treatment::Values && known.values == 0) {
      skip_statement();
    }
    for (int i = 0; i < known.values; ++i) {
      if (tokens_.peek().is('=')) {
        tokens_.take();
      }
      expression();
    }
  }

  void statement(const Token& keyword) {
    if (keyword.word == "string") {
      string_model_ = true;
    } else if (keyword.word == "space_dimension") {
      dimension_ = take_integer(tokens_, "a number of dimensions");
      if (dimension_ != 2 && dimension_ != 3) {
        refuse(keyword, "is " + std::to_string(dimension_));
      }
    } else if (keyword.word == "torus" || keyword.word == "torus_filled") {
      file_.torus = true;
    } else if (keyword.word == "periods") {
      file_.first_period = place();
      file_.second_period = place();
    } else if (keyword.word == "display_origin") {
      file_.origin = place();
    } else if (keyword.word == "total_time") {
      file_.time = expression();
    } else if (keyword.word == "constraint" || keyword.word == "boundary") {
      declare_curve(keyword);
    } else if (keyword.word == "define") {
      define();
    } else if (keyword.word == "quantity") {
      quantity(keyword);
    } else if (keyword.word == "parameter" || keyword.word == "parameter_file") {
      parameter(keyword);
    } else {
      method(keyword);
    }
  }

  Vec2 place() {
    const double x = coordinate();
    return {x, coordinate()};
  }
  double coordinate() {
    skip_separators();
    return expression();
  }

  void method(const Token& keyword) {
    const Token name = tokens_.take();
    std::string lower = name.word;
    std::ranges::transform(lower, lower.begin(), [](char c) {
      return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
    constexpr std::string_view kLengths[] = {"circular_arc_length", "edge_length", "edge_tension"};
    constexpr std::string_view kAreas[] = {"circular_arc_area", "edge_area", "facet_2d_volume"};
    const bool known = keyword.word == "length_method_name" ? is_one_of(kLengths, lower)
                                                            : is_one_of(kAreas, lower);
    if (!known) {
      refuse(keyword, "gives films another energy or bubbles another area: " + name.word);
    }
  }

  void define() {
    take_word("a kind of element");
    const Token attribute = take_word("'attribute'");
    if (attribute.word != "attribute") {
      fail_at(attribute.line, "expected 'attribute', not '" + attribute.word + "'");
    }
    named_.insert(take_word("the name of an attribute").word);
    skip_statement();
  }

  void quantity(const Token& keyword) {
    const Token name = take_word("the name of a QUANTITY");
    const Token use = tokens_.take();
    if (!use.is_word("info_only")) {
      refuse(keyword, name.word + " adds energy or a constraint, unless it is INFO_ONLY");
    }
    named_.insert(name.word);
    skip_statement();
  }

  void parameter(const Token& keyword) {
    const std::string name = take_word("the name of a PARAMETER").word;
    if (tokens_.peek().is('=')) {
      tokens_.take();
    }
    if (keyword.word == "parameter_file" || tokens_.peek().kind == Token::Kind::Text) {
      tokens_.take();
    } else {
      parameters_[name] = expression();
    }
    while (tokens_.peek().is_word("on_assign_call") || tokens_.peek().is_word("pdelta") ||
           tokens_.peek().is_word("pscale")) {
      const Token option = tokens_.take();
      if (option.word == "on_assign_call") {
        take_word("the name of a procedure");
      } else {
        treat_statement(option, {Treatment::Values, 1});
      }
    }
  }

  /// A CONSTRAINT or a BOUNDARY as it is written. What curve it is, is found when an element keeps
  /// to it.
  struct Declared {
    std::string name;
    std::map<std::string, std::vector<Token>, std::less<>> parts; ///< FORMULA, X1, E1 and the like
    bool one_sided = false;
    bool known = false; ///< whether the curve has been found
  };

  void declare_curve(const Token& keyword) {
    const std::int64_t number = take_integer(tokens_, "the number of a " + keyword.word);
    const auto [place, is_new] =
        curve_numbers_[keyword.word].try_emplace(number, static_cast<Index>(declared_.size()));
    Declared& declared = declared_.emplace_back();
    declared.name = keyword.word + " " + std::to_string(number);
    if (!is_new) {
      fail_at(keyword.line, declared.name + " is declared twice");
    }
    while (true) {
      skip_separators();
      if (tokens_.peek().kind == Token::Kind::Word && is_one_of(kCurveParts, tokens_.peek().word)) {
        take_part(declared);
      } else if (begins_statement(tokens_.peek())) {
        break;
      } else {
        tokens_.take(); // the name of a quantity, say
      }
    }
  }

  void take_part(Declared& declared) {
    const Token part = tokens_.take();
    if (part.word == "global") {
      refuse(part, "makes " + declared.name + " that of all vertices");
    }
    declared.one_sided =
        declared.one_sided || part.word == "nonnegative" || part.word == "nonpositive";
    if (part.word == "parameters") {
      expression();
      return;
    }
    constexpr std::string_view kFormulas[] = {"formula", "function", "equation"};
    const bool formula = is_one_of(kFormulas, part.word);
    skip_separators();
    std::vector<Token>& tokens = declared.parts[formula ? "formula" : part.word];
    const auto goes_on = [&](const Token& next) {
      return next.kind != Token::Kind::Word ||
             (!is_one_of(kCurveParts, next.word) && !begins_statement(next));
    };
    while (tokens_.peek().kind != Token::Kind::End && goes_on(tokens_.peek())) {
      tokens.push_back(tokens_.take());
    }
  }

  /// What a part of a declaration is in a point.
  Jet part_at(const Declared& declared, const char* part, const Variables<Jet>& variables) const {
    const auto tokens = declared.parts.find(part);
    if (tokens == declared.parts.end()) {
      return Jet::unknown();
    }
    return jet_of(tokens->second, parameters_, variables);
  }
  static Variables<Jet> at(Vec2 p) {
    const Jet x = Jet::x(p.x);
    const Jet y = Jet::y(p.y);
    return {{"x", x}, {"x1", x}, {"y", y}, {"x2", y}, {"z", {}}, {"x3", {}}};
  }

  /// Takes the numbers of the constraints, or of the one boundary, that an element keeps to.
  bool take_curves(const Token& keyword, const std::string& element, std::vector<Index>& curves) {
    const bool boundary = keyword.word == "boundary";
    if (!boundary && keyword.word != "constraint" && keyword.word != "constraints") {
      return false;
    }
    const auto& numbers = curve_numbers_[boundary ? "boundary" : "constraint"];
    do {
      const std::int64_t number = take_integer(tokens_, "a number of " + keyword.word);
      const auto found = numbers.find(number);
      const std::string lies = "'" + keyword.word + "': " + element + " lies on " +
                               (boundary ? "boundary " : "constraint ") + std::to_string(number);
      if (found == numbers.end()) {
        fail_at(keyword.line, lies + ", which is not declared");
      }
      if (declared_[place_of(found->second)].one_sided) {
        fail_at(keyword.line,
                lies + ", which it may leave to one side, and films do not leave walls");
      }
      curves.push_back(found->second);
      skip_separators();
    } while (!boundary && tokens_.peek().is_integer() && !tokens_.peek().starts_line);
    return true;
  }

  /// The point of a curve near a place. \param parameter of a boundary
  /// \param element that keeps to it, in a line
  Vec2 point_on(Index c, Vec2 near, double parameter, const std::string& element, int line) {
    Declared& declared = declared_[place_of(c)];
    const auto coordinate = [&](const char* which) {
      return [&, which](double p) { return part_at(declared, which, {{"p1", Jet::x(p)}}); };
    };
    const std::optional<Curve> found =
        declared.parts.contains("x1")
            ? curve_of_parameter(coordinate("x1"), coordinate("x2"), parameter)
            : curve_of_formula([&](Vec2 p) { return part_at(declared, "formula", at(p)); }, near);
    file_.curves.resize(declared_.size());
    Curve& curve = file_.curves[place_of(c)];
    if (found && !declared.known) {
      curve = *found;
      declared.known = true;
    }
    constexpr double kSame = 1e-9; // of a length that belongs to the curve
    if (!found || !(std::abs(curve.distance(found->point)) <= kSame * curve.scale())) {
      fail_at(line, "'constraint': " + element + " lies on " + declared.name +
                        ", which is neither one straight line nor one circle");
    }
    return found->point;
  }

  void put_on_curves(Datafile::Vertex& vertex, const std::string& name, double parameter) {
    for (const Index c : vertex.curves) {
      vertex.place = point_on(c, vertex.place, parameter, name, vertex.line);
      check_energy(declared_[place_of(c)], file_.curves[place_of(c)], vertex, name);
    }
    if (vertex.curves.size() > 1) {
      const std::vector<Vec2> corners = crossings(file_.curves[place_of(vertex.curves[0])],
                                                  file_.curves[place_of(vertex.curves[1])]);
      if (!corners.empty()) {
        vertex.place = *std::ranges::min_element(
            corners, {}, [&](Vec2 corner) { return norm(corner - vertex.place); });
      }
    }
  }

  /// A constraint's energy pulls at films along it, unless it is the same all along.
  void check_energy(const Declared& declared, const Curve& curve, const Datafile::Vertex& vertex,
                    const std::string& name) const {
    for (const char* part : {"e1", "e2", "e3"}) {
      if (declared.parts.contains(part)) {
        const Jet energy = part_at(declared, part, at(vertex.place));
        const double along = cross(curve.normal(vertex.place), energy.gradient);
        if (!(std::abs(along) <= 1e-12 * norm(energy.gradient))) {
          fail_at(vertex.line, "'constraint': " + name + " lies on " + declared.name +
                                   ", which has ENERGY, and films meet walls at 90 degrees");
        }
      }
    }
  }

  /// The elements of a section: each begins with its number, at a line's start.
  template <class Row> void rows(const Row& row) {
    while (!begins_section(tokens_.peek())) {
      const Token number = tokens_.take();
      if (!number.is_integer() || !number.starts_line || number.value > 1e15) {
        fail_at(number.line, "expected the number of an element, not " + described(number));
      }
      row(static_cast<std::int64_t>(number.value), number.line);
    }
  }

  /// The attributes of an element. \param take whether it is one that the element's kind has, whose
  /// values it takes then
  template <class Take> void attributes(const std::string& element, const Take& take) {
    while (!ends_element(tokens_.peek())) {
      const Token token = tokens_.take();
      if (token.kind == Token::Kind::Separator) {
        continue;
      }
      if (token.kind != Token::Kind::Word) {
        fail_at(token.line, "unexpected " + described(token) + " after " + element);
      }
      if (take(token)) {
        continue;
      }
      const auto known = attribute_keywords().find(token.word);
      if (known != attribute_keywords().end() && known->second.treatment == Treatment::Refuse) {
        fail_at(token.line, "'" + token.word + "': " + element + " " + known->second.reason);
      }
      if (known == attribute_keywords().end() && !named_.contains(token.word)) {
        note_skipped(token);
      }
      if (known == attribute_keywords().end() || known->second.treatment == Treatment::Values) {
        skip_while([](const Token& next) {
          return !ends_element(next) && next.kind != Token::Kind::Word;
        });
      }
    }
  }

  bool more_numbers() {
    skip_separators();
    const Token& next = tokens_.peek();
    return !ends_element(next) && !next.starts_line &&
           (next.kind != Token::Kind::Word || parameters_.contains(next.word));
  }

  void vertex(std::int64_t number, int line) {
    vertex_numbers_.add(number, line);
    const std::string name = vertex_numbers_.name(number);
    Datafile::Vertex& vertex = file_.vertices.emplace_back();
    vertex.number = number;
    vertex.line = line;
    double coordinates[3] = {0, 0, 0};
    int count = 0;
    skip_separators();
    while (count < dimension_ && !ends_element(tokens_.peek()) && begins_number()) {
      coordinates[count++] = expression();
      skip_separators();
    }
    bool on_boundary = false;
    attributes(name, [&](const Token& keyword) {
      vertex.fixed = vertex.fixed || keyword.word == "fixed";
      on_boundary = on_boundary || keyword.word == "boundary";
      return keyword.word == "fixed" || take_curves(keyword, name, vertex.curves);
    });
    const int wanted = on_boundary ? 1 : 2; // a boundary's parameter
    if (count < wanted) {
      fail_at(line, name + " has " + std::to_string(count) + " coordinates, not " +
                        std::to_string(wanted) + "; 3 +5 is one number, 3 -5 are two");
    }
    if (coordinates[2] != 0) {
      fail_at(line, name + " lies outside of the plane, at z " + foam::number(coordinates[2]));
    }
    vertex.place = {coordinates[0], coordinates[1]};
    put_on_curves(vertex, name, coordinates[0]);
  }

  /// Whether what follows is a coordinate, and no attribute.
  bool begins_number() {
    const Token& next = tokens_.peek();
    if (next.kind != Token::Kind::Word) {
      return true;
    }
    return parameters_.contains(next.word) || tokens_.peek(1).is('(') || next.word == "pi" ||
           next.word == "e";
  }

  void edge(std::int64_t number, int line) {
    edge_numbers_.add(number, line);
    const std::string name = edge_numbers_.name(number);
    Datafile::Edge& edge = file_.edges.emplace_back();
    edge.number = number;
    edge.line = line;
    edge.tail = end_of_edge(name);
    edge.head = end_of_edge(name);
    std::vector<int> signs;
    bool wrapped = false;
    while (!ends_element(tokens_.peek()) && tokens_.peek().kind != Token::Kind::Word) {
      const Token token = tokens_.peek();
      const auto sign = std::string_view("-*+").find(token.symbol);
      if (token.kind == Token::Kind::Symbol && sign != std::string_view::npos) {
        note_joined_signs(tokens_.take());
        signs.push_back(static_cast<int>(sign) - 1);
      } else if (token.is_integer() && edge.midpoint == kNone) {
        edge.midpoint = end_of_edge(name);
      } else if (token.kind == Token::Kind::Separator) {
        tokens_.take();
      } else {
        fail_at(token.line, "unexpected " + described(token) + " in " + name);
      }
    }
    attributes(name, [&](const Token& keyword) {
      if (keyword.word == "tension" || keyword.word == "density") {
        edge.tension = coordinate();
      } else if (keyword.word == "wrap") {
        edge.wrap = decoded(take_integer(tokens_, "a wrap"), keyword.line);
        wrapped = true;
      } else if (keyword.word == "fixed") {
        edge.fixed = true;
      } else {
        return take_curves(keyword, name, edge.curves);
      }
      return true;
    });
    take_signs(edge, signs, wrapped);
    for (const Index c : edge.curves) {
      if (!declared_[place_of(c)].known) { // no vertex lies on it
        point_on(c, file_.vertices[place_of(edge.tail)].place, 0, name, edge.line);
      }
    }
  }

  void take_signs(Datafile::Edge& edge, const std::vector<int>& signs, bool wrapped) {
    const std::string name = edge_numbers_.name(edge.number);
    if (!file_.torus) {
      if (!signs.empty() || !(edge.wrap == Wrap{})) {
        fail_at(edge.line, name + " wraps, but there is no TORUS");
      }
      return;
    }
    if (signs.size() == 2) {
      edge.wrap = {signs[0], signs[1]};
    } else if (!signs.empty()) {
      fail_at(edge.line, name + " has " + std::to_string(signs.size()) + " wraps, not 2");
    } else if (!wrapped && unwrapped_++ == 0) {
      warn(edge.line, name + " says nothing of its wraps, which is taken as none");
    }
  }

  /// Evolver itself takes ** and ++ for operators, and overlooks them.
  void note_joined_signs(const Token& sign) {
    const Token& next = tokens_.peek();
    if (!sign.space_after && !sign.is('-') && next.is(sign.symbol) && joined_signs_++ == 0) {
      warn(sign.line,
           std::string(2, sign.symbol) +
               " is read as two wraps; Surface Evolver overlooks them where no space is between");
    }
  }

  Index end_of_edge(const std::string& edge) {
    skip_separators();
    const int line = tokens_.peek().line;
    return vertex_numbers_.find(take_integer(tokens_, "a vertex of " + edge), line);
  }

  /// Six bits a dimension, the first lowest, of which five are a number in two's complement.
  static Wrap decoded(std::int64_t wrap, int line) {
    constexpr std::int64_t kMost = 1 << 12;
    if (wrap < 0 || wrap >= kMost) {
      fail_at(line, "'wrap' " + std::to_string(wrap) + " has more than two dimensions");
    }
    const auto period = [](std::int64_t bits) {
      const auto n = static_cast<std::int32_t>(bits & 31);
      return n < 16 ? n : n - 32;
    };
    return {period(wrap), period(wrap >> 6)};
  }

  void face(std::int64_t number, int line) {
    face_numbers_.add(number, line);
    const std::string name = face_numbers_.name(number);
    const auto begin = static_cast<Index>(file_.face_edges.size());
    skip_separators();
    while (!ends_element(tokens_.peek()) && tokens_.peek().kind != Token::Kind::Word) {
      const int at = tokens_.peek().line;
      const std::int64_t edge = take_integer(tokens_, "an edge of " + name);
      file_.face_edges.push_back({edge_numbers_.find(std::abs(edge), at), edge > 0});
      skip_separators();
    }
    file_.faces.push_back({number, begin, static_cast<Index>(file_.face_edges.size()), line});
    if (begin == file_.faces.back().end) {
      fail_at(line, name + " has no edges");
    }
    attributes(name, [&](const Token& keyword) { return density(keyword, name); });
  }

  /// That of a face, which is energy, or a body, which weighs.
  bool density(const Token& keyword, const std::string& name) {
    if (keyword.word != "density" && keyword.word != "tension") {
      return false;
    }
    if (const double value = coordinate(); value != 0) {
      fail_at(keyword.line, "'" + keyword.word + "': " + name + " has " + foam::number(value) +
                                ", and only films may have any");
    }
    return true;
  }

  void body(std::int64_t number, int line) {
    body_numbers_.add(number, line);
    const std::string name = body_numbers_.name(number);
    Datafile::Body& body = file_.bodies.emplace_back();
    body.number = number;
    body.line = line;
    skip_separators();
    const int at = tokens_.peek().line;
    const std::int64_t face = take_integer(tokens_, "the face of " + name);
    body.face = face_numbers_.find(std::abs(face), at);
    body.forwards = face > 0;
    if (more_numbers()) {
      fail_at(line, name + " has several faces, and bubbles have one");
    }
    std::optional<std::int64_t> original;
    attributes(name, [&](const Token& keyword) {
      if (keyword.word == "volume") {
        body.volume = coordinate();
      } else if (keyword.word == "volconst") {
        body.volume_constant = coordinate();
      } else if (keyword.word == "lagrange_multiplier") {
        body.pressure = coordinate();
      } else if (keyword.word == "original") {
        original = take_integer(tokens_, "a number");
      } else if (keyword.word == "bubbleid" && named_.contains(keyword.word)) {
        body.name = take_integer(tokens_, "a number");
      } else if (keyword.word == "pressure") {
        fail_at(keyword.line,
                "'pressure': " + name + " has a given pressure, and bubbles a given area");
      } else {
        return density(keyword, name);
      }
      return true;
    });
    body.name = body.name ? body.name : original;
  }

  Tokens tokens_;
  Parameters parameters_;
  Datafile file_;
  bool string_model_ = false;
  std::int64_t dimension_ = 3;
  std::set<std::string, std::less<>> named_; ///< attributes, and quantities that change nothing
  std::map<std::string, std::pair<int, int>>
      skipped_; ///< first line and number of unknown keywords
  std::map<std::string, std::map<std::int64_t, Index>, std::less<>>
      curve_numbers_; ///< of constraints and of boundaries
  std::vector<Declared> declared_;
  int unwrapped_ = 0;
  int joined_signs_ = 0;
  Numbers vertex_numbers_{"vertex"};
  Numbers edge_numbers_{"edge"};
  Numbers face_numbers_{"face"};
  Numbers body_numbers_{"body"};
};

} // namespace

Datafile parse_datafile(std::string text, std::function<std::string(const std::string&)> include) {
  return Parser(std::move(text), std::move(include)).run();
}

bool is_string_model(const std::string& start) {
  try {
    Tokens tokens(start, [](const std::string&) { return std::string(); });
    bool found = false;
    while (!begins_section(tokens.peek())) {
      const Token token = tokens.take();
      found = found || (token.is_word("string") && token.starts_line);
    }
    return found && tokens.peek().is_word("vertices");
  } catch (const FoamError&) {
    return false;
  }
}

} // namespace foam::evolver
