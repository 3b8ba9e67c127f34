// SPDX-License-Identifier: GPL-3.0-or-later
#include "evolver/expression.h"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string_view>
#include <utility>
#include <vector>

#include "base/number.h"

namespace foam::evolver {
namespace {

/// Parentheses, signs and powers in each other.
constexpr int kDeepest = 200;

using OfOneNumber = double (*)(double);
using OfTwo = double (*)(double, double);

/// With the first two derivatives of those that lines and circles are written with.
struct OfOne {
  OfOneNumber value;
  OfOneNumber first = [](double) { return std::numeric_limits<double>::quiet_NaN(); };
  OfOneNumber second = first;
};

constexpr std::array<std::pair<std::string_view, OfOne>, 20> kOfOne = {{
    {"abs", {[](double x) { return std::abs(x); }}},
    {"acos", {[](double x) { return std::acos(x); }}},
    {"acosh", {[](double x) { return std::acosh(x); }}},
    {"asin", {[](double x) { return std::asin(x); }}},
    {"asinh", {[](double x) { return std::asinh(x); }}},
    {"atan", {[](double x) { return std::atan(x); }}},
    {"atanh", {[](double x) { return std::atanh(x); }}},
    {"ceil", {[](double x) { return std::ceil(x); }}},
    {"ceiling", {[](double x) { return std::ceil(x); }}},
    {"cos",
     {[](double x) { return std::cos(x); }, [](double x) { return -std::sin(x); },
      [](double x) { return -std::cos(x); }}},
    {"cosh", {[](double x) { return std::cosh(x); }}},
    {"exp", {[](double x) { return std::exp(x); }}},
    {"floor", {[](double x) { return std::floor(x); }}},
    {"log", {[](double x) { return std::log(x); }}},
    {"sin",
     {[](double x) { return std::sin(x); }, [](double x) { return std::cos(x); },
      [](double x) { return -std::sin(x); }}},
    {"sinh", {[](double x) { return std::sinh(x); }}},
    {"sqr",
     {[](double x) { return x * x; }, [](double x) { return 2 * x; }, [](double) { return 2.0; }}},
    {"sqrt",
     {[](double x) { return std::sqrt(x); }, [](double x) { return 0.5 / std::sqrt(x); },
      [](double x) { return -0.25 / (x * std::sqrt(x)); }}},
    {"tan", {[](double x) { return std::tan(x); }}},
    {"tanh", {[](double x) { return std::tanh(x); }}},
}};

constexpr std::array<std::pair<std::string_view, OfTwo>, 3> kOfTwo = {{
    {"atan2", [](double y, double x) { return std::atan2(y, x); }},
    {"maximum", [](double x, double y) { return std::fmax(x, y); }},
    {"minimum", [](double x, double y) { return std::fmin(x, y); }},
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

double modulo(double a, double b) {
  return a - b * std::floor(a / b);
}
double whole_modulo(double a, double b) {
  return modulo(std::floor(a), std::floor(b));
}
double whole_quotient(double a, double b) {
  return std::trunc(a / b);
}

double number_of(double value) {
  return value;
}
double number_of(const Jet& value) {
  return value.value;
}

double apply(const OfOne& function, double x) {
  return function.value(x);
}
Jet apply(const OfOne& function, const Jet& x) {
  return composed(x, function.value(x.value), function.first(x.value), function.second(x.value));
}

double apply(OfTwo function, double x, double y) {
  return function(x, y);
}
/// Of constants, as lines and circles have them.
Jet apply(OfTwo function, const Jet& x, const Jet& y) {
  return x.is_constant() && y.is_constant() ? Jet{function(x.value, y.value)} : Jet::unknown();
}

double power(double base, double exponent) {
  return std::pow(base, exponent);
}
Jet power(const Jet& base, const Jet& exponent) {
  if (!exponent.is_constant()) {
    return Jet::unknown();
  }
  const double n = exponent.value;
  const auto term = [&](double factor, double less) {
    return factor == 0 ? 0 : factor * std::pow(base.value, n - less);
  };
  return composed(base, term(1, 0), term(n, 1), term(n * (n - 1), 2));
}

/// By descent, an operator of lower precedence first. \tparam Value a number, or a Jet
template <class Value> class Expression {
public:
  Expression(Tokens& tokens, const Parameters& parameters, const Variables<Value>& variables)
      : tokens_(tokens), parameters_(parameters), variables_(variables) {}

  Value conditional() {
    const Deeper deeper(*this);
    const Value condition = either();
    if (!tokens_.peek().is('?')) {
      return condition;
    }
    tokens_.take();
    const Value if_true = conditional();
    take(':');
    const Value if_false = conditional();
    return number_of(condition) != 0 ? if_true : if_false;
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

  static Value truth(bool holds) { return Value{holds ? 1.0 : 0.0}; }

  Value either() {
    Value value = both();
    while (take_both('|', '|') || take_word("or")) {
      const Value other = both();
      value = truth(number_of(value) != 0 || number_of(other) != 0);
    }
    return value;
  }
  Value both() {
    Value value = comparison();
    while (take_both('&', '&') || take_word("and")) {
      const Value other = comparison();
      value = truth(number_of(value) != 0 && number_of(other) != 0);
    }
    return value;
  }
  Value comparison() {
    const Value value = equation();
    const double left = number_of(value);
    const auto right = [&] { return number_of(equation()); };
    if (take_both('=', '=')) {
      return truth(left == right());
    }
    if (take_both('!', '=')) {
      return truth(left != right());
    }
    if (take_both('<', '=')) {
      return truth(left <= right());
    }
    if (take_both('>', '=')) {
      return truth(left >= right());
    }
    if (take_if('<')) {
      return truth(left < right());
    }
    if (take_if('>')) {
      return truth(left > right());
    }
    return value;
  }
  /// The equals sign is a minus that binds less.
  Value equation() {
    Value value = sum();
    while (tokens_.peek().is('=') && !next_are('=', '=')) {
      tokens_.take();
      value = value - sum();
    }
    return value;
  }
  Value sum() {
    Value value = product();
    while (true) {
      const Token& next = tokens_.peek();
      const bool begins_another =
          parentheses_ == 0 && next.space_before && !next.space_after && variables_.empty();
      if (next.is('+')) {
        tokens_.take();
        value = value + product();
      } else if (next.is('-') && !begins_another) {
        tokens_.take();
        value = value - product();
      } else {
        return value;
      }
    }
  }
  Value product() {
    Value value = signed_power();
    while (true) {
      if (tokens_.peek().is('*') && !next_are('*', '*')) {
        tokens_.take();
        value = value * signed_power();
      } else if (take_if('/')) {
        value = value / signed_power();
      } else if (take_if('%') || take_word("mod")) {
        value = apply(modulo, value, signed_power());
      } else if (take_word("idiv")) {
        value = apply(whole_quotient, value, signed_power());
      } else if (take_word("imod")) {
        value = apply(whole_modulo, value, signed_power());
      } else {
        return value;
      }
    }
  }
  Value signed_power() {
    const Deeper deeper(*this);
    if (take_if('-')) {
      return -signed_power();
    }
    if (take_if('+')) {
      return signed_power();
    }
    if (take_if('!') || take_word("not")) {
      return truth(number_of(signed_power()) == 0);
    }
    const Value base = operand();
    return take_both('*', '*') || take_if('^') ? power(base, signed_power()) : base;
  }
  Value in_parentheses() {
    ++parentheses_;
    const Value value = conditional();
    --parentheses_;
    return value;
  }
  Value operand() {
    const Token token = tokens_.take();
    if (token.kind == Token::Kind::Number) {
      return Value{token.value};
    }
    if (token.is('(')) {
      const Value value = in_parentheses();
      take(')');
      return value;
    }
    if (token.kind == Token::Kind::Word) {
      if (const OfOne* function = find(kOfOne, token.word)) {
        take('(');
        const Value argument = in_parentheses();
        take(')');
        return apply(*function, argument);
      }
      const OfTwo* const function = find(kOfTwo, token.word);
      if (function != nullptr || token.word == "pow") {
        take('(');
        const Value first = in_parentheses();
        take(',');
        const Value second = in_parentheses();
        take(')');
        return function != nullptr ? apply(*function, first, second) : power(first, second);
      }
      if (const auto found = variables_.find(token.word); found != variables_.end()) {
        return found->second;
      }
      if (const auto found = parameters_.find(token.word); found != parameters_.end()) {
        return Value{found->second};
      }
      if (const double* constant = find(kConstants, token.word)) {
        return Value{*constant};
      }
    }
    fail_at(token.line, "expected a number or a PARAMETER, not " + described(token));
  }

  Tokens& tokens_;
  const Parameters& parameters_;
  const Variables<Value>& variables_;
  int depth_ = 0;
  int parentheses_ = 0;
};

} // namespace

double take_expression(Tokens& tokens, const Parameters& parameters) {
  return Expression<double>(tokens, parameters, {}).conditional();
}

Jet jet_of(const std::vector<Token>& expression, const Parameters& parameters,
           const Variables<Jet>& variables) {
  Tokens tokens(expression);
  const Jet value = Expression<Jet>(tokens, parameters, variables).conditional();
  while (tokens.peek().kind == Token::Kind::Separator) {
    tokens.take();
  }
  if (const Token& next = tokens.peek(); next.kind != Token::Kind::End) {
    fail_at(next.line, "unexpected " + described(next) + " after an expression");
  }
  return value;
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
