// SPDX-License-Identifier: GPL-3.0-or-later
#include "evolver/expression.h"

#include <array>
#include <cmath>
#include <numbers>
#include <string_view>
#include <utility>
#include <vector>

#include "base/number.h"

namespace foam::evolver {
namespace {

/// Parentheses, signs and powers in each other.
constexpr int kDeepest = 200;

using OfOne = double (*)(double);
using OfTwo = double (*)(double, double);

constexpr std::array<std::pair<std::string_view, OfOne>, 20> kOfOne = {{
    {"abs", [](double x) { return std::abs(x); }},
    {"acos", [](double x) { return std::acos(x); }},
    {"acosh", [](double x) { return std::acosh(x); }},
    {"asin", [](double x) { return std::asin(x); }},
    {"asinh", [](double x) { return std::asinh(x); }},
    {"atan", [](double x) { return std::atan(x); }},
    {"atanh", [](double x) { return std::atanh(x); }},
    {"ceil", [](double x) { return std::ceil(x); }},
    {"ceiling", [](double x) { return std::ceil(x); }},
    {"cos", [](double x) { return std::cos(x); }},
    {"cosh", [](double x) { return std::cosh(x); }},
    {"exp", [](double x) { return std::exp(x); }},
    {"floor", [](double x) { return std::floor(x); }},
    {"log", [](double x) { return std::log(x); }},
    {"sin", [](double x) { return std::sin(x); }},
    {"sinh", [](double x) { return std::sinh(x); }},
    {"sqr", [](double x) { return x * x; }},
    {"sqrt", [](double x) { return std::sqrt(x); }},
    {"tan", [](double x) { return std::tan(x); }},
    {"tanh", [](double x) { return std::tanh(x); }},
}};

constexpr std::array<std::pair<std::string_view, OfTwo>, 4> kOfTwo = {{
    {"atan2", [](double y, double x) { return std::atan2(y, x); }},
    {"maximum", [](double x, double y) { return std::fmax(x, y); }},
    {"minimum", [](double x, double y) { return std::fmin(x, y); }},
    {"pow", [](double x, double y) { return std::pow(x, y); }},
}};

constexpr std::array<std::pair<std::string_view, double>, 2> kConstants = {{
    {"e", std::numbers::e},
    {"pi", std::numbers::pi},
}};

template <class Table> const auto* find(const Table& table, std::string_view name) {
  for (const auto& [listed, meaning] : table) {
    if (listed == name) {
      return &meaning;
    }
  }
  return static_cast<decltype(&table[0].second)>(nullptr);
}

/// By descent, an operator of lower precedence first.
class Expression {
public:
  Expression(Tokens& tokens, const Parameters& parameters)
      : tokens_(tokens), parameters_(parameters) {}

  double conditional() {
    const Deeper deeper(*this);
    const double condition = either();
    if (!tokens_.peek().is('?')) {
      return condition;
    }
    tokens_.take();
    const double if_true = conditional();
    take(':');
    const double if_false = conditional();
    return condition != 0 ? if_true : if_false;
  }

private:
  /// A level of depth, for as long as it lives.
  struct Deeper {
    explicit Deeper(Expression& of) : depth(of.depth_) {
      if (++depth > kDeepest) {
        fail_at(of.tokens_.peek().line, "an expression is nested too deeply");
      }
    }
    Deeper(const Deeper&) = delete;
    Deeper& operator=(const Deeper&) = delete;
    ~Deeper() { --depth; }
    int& depth;
  };

  void take(char symbol) {
    const Token token = tokens_.take();
    if (token.symbol != symbol) {
      fail_at(token.line,
              std::string("expected ") + symbol + " in an expression, not " + described(token));
    }
  }
  bool next_are(char first, char second) {
    return tokens_.peek().is(first) && !tokens_.peek().space_after && tokens_.peek(1).is(second);
  }
  bool take_both(char first, char second) {
    const bool both = next_are(first, second);
    if (both) {
      tokens_.take();
      tokens_.take();
    }
    return both;
  }
  bool take_if(char symbol) {
    const bool found = tokens_.peek().is(symbol);
    if (found) {
      tokens_.take();
    }
    return found;
  }
  bool take_word(std::string_view word) {
    const bool found = tokens_.peek().is_word(word);
    if (found) {
      tokens_.take();
    }
    return found;
  }

  double either() {
    double value = both();
    while (take_both('|', '|') || take_word("or")) {
      const double other = both();
      value = value != 0 || other != 0 ? 1 : 0;
    }
    return value;
  }
  double both() {
    double value = comparison();
    while (take_both('&', '&') || take_word("and")) {
      const double other = comparison();
      value = value != 0 && other != 0 ? 1 : 0;
    }
    return value;
  }
  double comparison() {
    const double value = equation();
    if (take_both('=', '=')) {
      return value == equation() ? 1 : 0;
    }
    if (take_both('!', '=')) {
      return value != equation() ? 1 : 0;
    }
    if (take_both('<', '=')) {
      return value <= equation() ? 1 : 0;
    }
    if (take_both('>', '=')) {
      return value >= equation() ? 1 : 0;
    }
    if (take_if('<')) {
      return value < equation() ? 1 : 0;
    }
    if (take_if('>')) {
      return value > equation() ? 1 : 0;
    }
    return value;
  }
  /// The equals sign is a minus that binds less.
  double equation() {
    double value = sum();
    while (tokens_.peek().is('=') && !next_are('=', '=')) {
      tokens_.take();
      value -= sum();
    }
    return value;
  }
  double sum() {
    double value = product();
    while (true) {
      const Token& next = tokens_.peek();
      const bool begins_another = parentheses_ == 0 && next.space_before && !next.space_after;
      if (next.is('+')) {
        tokens_.take();
        value += product();
      } else if (next.is('-') && !begins_another) {
        tokens_.take();
        value -= product();
      } else {
        return value;
      }
    }
  }
  double product() {
    double value = signed_power();
    while (true) {
      if (tokens_.peek().is('*') && !next_are('*', '*')) {
        tokens_.take();
        value *= signed_power();
      } else if (take_if('/')) {
        value /= signed_power();
      } else if (take_if('%') || take_word("mod")) {
        const double divisor = signed_power();
        value -= divisor * std::floor(value / divisor);
      } else if (take_word("idiv")) {
        value = std::trunc(value / signed_power());
      } else if (take_word("imod")) {
        const double divisor = std::floor(signed_power());
        value = std::floor(value) - divisor * std::floor(std::floor(value) / divisor);
      } else {
        return value;
      }
    }
  }
  double signed_power() {
    const Deeper deeper(*this);
    if (take_if('-')) {
      return -signed_power();
    }
    if (take_if('+')) {
      return signed_power();
    }
    if (take_if('!') || take_word("not")) {
      return signed_power() == 0 ? 1 : 0;
    }
    const double base = operand();
    return take_both('*', '*') || take_if('^') ? std::pow(base, signed_power()) : base;
  }
  double in_parentheses() {
    ++parentheses_;
    const double value = conditional();
    --parentheses_;
    return value;
  }
  double operand() {
    const Token token = tokens_.take();
    if (token.kind == Token::Kind::Number) {
      return token.value;
    }
    if (token.is('(')) {
      const double value = in_parentheses();
      take(')');
      return value;
    }
    if (token.kind == Token::Kind::Word) {
      if (const OfOne* function = find(kOfOne, token.word)) {
        take('(');
        const double argument = in_parentheses();
        take(')');
        return (*function)(argument);
      }
      if (const OfTwo* function = find(kOfTwo, token.word)) {
        take('(');
        const double first = in_parentheses();
        take(',');
        const double second = in_parentheses();
        take(')');
        return (*function)(first, second);
      }
      if (const auto found = parameters_.find(token.word); found != parameters_.end()) {
        return found->second;
      }
      if (const double* constant = find(kConstants, token.word)) {
        return *constant;
      }
    }
    fail_at(token.line, "expected a number or a PARAMETER, not " + described(token));
  }

  Tokens& tokens_;
  const Parameters& parameters_;
  int depth_ = 0;
  int parentheses_ = 0;
};

} // namespace

double take_expression(Tokens& tokens, const Parameters& parameters) {
  return Expression(tokens, parameters).conditional();
}

long long take_integer(Tokens& tokens, const std::string& what) {
  constexpr double kLargest = 1e15;
  const Token first = tokens.take();
  const bool has_sign = first.is('-') || first.is('+');
  const Token digits = has_sign ? tokens.take() : first;
  if (!digits.is_integer() || digits.value > kLargest) {
    fail_at(digits.line, "expected " + what + ", not " + described(digits));
  }
  const auto value = static_cast<long long>(digits.value);
  return first.is('-') ? -value : value;
}

std::string described(const Token& token) {
  switch (token.kind) {
  case Token::Kind::End:
    return "the file's end";
  case Token::Kind::Number:
    return number(token.value);
  case Token::Kind::Word:
    return "'" + token.word + "'";
  case Token::Kind::Text:
    return "\"" + token.word + "\"";
  default:
    return std::string("'") + token.symbol + "'";
  }
}

} // namespace foam::evolver
