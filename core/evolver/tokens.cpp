// SPDX-License-Identifier: GPL-3.0-or-later
#include "evolver/tokens.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "base/error.h"

namespace foam::evolver {
namespace {

/// Files that include each other, or macros that name each other; Evolver allows 10 of the former.
constexpr std::size_t kDeepest = 10;
/// Macros and files in all: two that name each other twice would go on for ever.
constexpr int kMostExpansions = 100'000;
/// As Evolver's own limit.
constexpr std::size_t kLongestMacro = 500;

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}
char lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

} // namespace

void fail_at(int line, const std::string& what) {
  throw FoamError("line " + std::to_string(line) + ": " + what);
}

Tokens::Tokens(std::string text, std::function<std::string(const std::string&)> include)
    : include_(std::move(include)) {
  push({std::move(text)});
}

Tokens::Tokens(const std::vector<Token>& taken)
    : sources_(1), ahead_(taken.begin(), taken.end()),
      line_(taken.empty() ? 1 : taken.back().line) {}

const Token& Tokens::peek(std::size_t ahead) {
  while (ahead >= ahead_.size()) {
    ahead_.push_back(scan());
  }
  return ahead_[ahead];
}

Token Tokens::take() {
  peek();
  Token token = std::move(ahead_.front());
  ahead_.pop_front();
  return token;
}

void Tokens::push(Source source) {
  if (sources_.size() > kDeepest || ++expansions_ > kMostExpansions) {
    fail_at(line_, "#include or #define are nested too deeply");
  }
  sources_.push_back(std::move(source));
}

/// Whether a line goes on in the next one.
bool Tokens::splice_at(std::size_t offset) const {
  return at(offset) == '\\' && (at(offset + 1) == '\n' || at(offset + 1) == '\r');
}

bool Tokens::space_at(std::size_t offset) const {
  const char c = at(offset);
  if (c == '\0' && sources_.back().at + offset >= sources_.back().text.size()) {
    return sources_.back().file || sources_.back().space_follows;
  }
  return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f' || c == '\v' ||
         splice_at(offset);
}

/// Goes past a character, which may end a line: LF, CR or both.
void Tokens::pass() {
  const char c = at();
  Source& source = sources_.back();
  ++source.at;
  const bool ends_line = c == '\n' || (c == '\r' && at() != '\n');
  if (ends_line) {
    line_begins_ = source.file;
    line_ += sources_.size() == 1 ? 1 : 0;
  }
  space_ = true;
}

void Tokens::skip_comment(std::string_view end) {
  while (at() != '\0' || sources_.back().at < sources_.back().text.size()) {
    if (sources_.back().text.compare(sources_.back().at, end.size(), end) == 0) {
      sources_.back().at += end.size();
      break;
    }
    pass();
  }
  space_ = true;
}

/// \returns whether there was any
bool Tokens::skip_space() {
  if (splice_at(0)) {
    const bool begins = line_begins_;
    ++sources_.back().at;
    while (at() == '\r' && at(1) == '\n') {
      ++sources_.back().at;
    }
    pass();
    line_begins_ = begins;
  } else if (at() != '\0' && space_at(0)) {
    pass();
  } else if (at() == '/' && at(1) == '*') {
    skip_comment("*/");
  } else if (at() == '/' && at(1) == '/') {
    while (at() != '\0' && at() != '\n' && at() != '\r') {
      ++sources_.back().at;
    }
    space_ = true;
  } else {
    return false;
  }
  return true;
}

std::string Tokens::rest_of_line() {
  std::string rest;
  while (at() != '\0' && at() != '\n' && at() != '\r') {
    if (splice_at(0) || (at() == '/' && at(1) == '*')) {
      const bool begins = line_begins_;
      skip_space();
      line_begins_ = begins;
      rest += ' ';
    } else if (at() == '/' && at(1) == '/') {
      skip_space();
    } else {
      rest += at();
      ++sources_.back().at;
    }
  }
  return rest;
}

/// #define or #include, at a line's start.
void Tokens::obey_directive() {
  const int line = line_;
  const std::string text = rest_of_line();
  const auto begin_of_name = [&](std::size_t from) { return text.find_first_not_of(" \t", from); };
  const auto end_of_name = [&](std::size_t from) {
    return std::min(text.find_first_of(" \t", from), text.size());
  };
  const std::size_t begin = begin_of_name(1);
  const std::size_t end = begin == std::string::npos ? begin : end_of_name(begin);
  const std::string directive =
      begin == std::string::npos ? std::string() : text.substr(begin, end - begin);
  if (directive == "define") {
    const std::size_t name = begin_of_name(end);
    if (name == std::string::npos || !is_letter(text[name])) {
      fail_at(line, "#define names nothing");
    }
    const std::size_t name_end = end_of_name(name);
    std::string meaning = text.substr(name_end);
    if (meaning.size() > kLongestMacro) {
      fail_at(line, "#define has more than " + std::to_string(kLongestMacro) + " characters");
    }
    macros_[text.substr(name, name_end - name)] = std::move(meaning);
  } else if (directive == "include") {
    const std::size_t open = text.find('"');
    const std::size_t close = open == std::string::npos ? open : text.find('"', open + 1);
    if (close == std::string::npos) {
      fail_at(line, "#include names no file in quotes");
    }
    push({include_(text.substr(open + 1, close - open - 1))});
    line_begins_ = true;
  } else {
    fail_at(line, "#" + directive + " is neither #define nor #include");
  }
}

Token Tokens::scan_number() {
  Token token;
  token.kind = Token::Kind::Number;
  std::string& text = sources_.back().text;
  const std::size_t begin = sources_.back().at;
  const auto digits = [&](std::size_t from, auto&& allowed) {
    while (from < text.size() && allowed(text[from])) {
      ++from;
    }
    return from;
  };
  const auto whole_number = [&](std::size_t first, std::size_t last, int base) {
    std::uint64_t value = 0;
    std::from_chars(text.data() + first, text.data() + last, value, base);
    token.value = static_cast<double>(value);
    token.whole = true;
  };
  std::size_t end = digits(begin, is_digit);
  if (end == begin + 1 && text[begin] == '0' && end < text.size() && lower(text[end]) == 'x') {
    const std::size_t first = end + 1;
    end = digits(first, [](char c) { return is_digit(c) || (lower(c) >= 'a' && lower(c) <= 'f'); });
    whole_number(first, end, 16);
  } else if (end < text.size() && lower(text[end]) == 'b' &&
             std::all_of(text.begin() + static_cast<std::ptrdiff_t>(begin),
                         text.begin() + static_cast<std::ptrdiff_t>(end),
                         [](char c) { return c == '0' || c == '1'; })) {
    whole_number(begin, end, 2);
    ++end;
  } else {
    token.whole = true;
    if (end < text.size() && text[end] == '.') {
      token.whole = false;
      end = digits(end + 1, is_digit);
    }
    const std::size_t mantissa_end = end;
    if (end < text.size() && (lower(text[end]) == 'e' || lower(text[end]) == 'd')) {
      std::size_t exponent = end + 1;
      if (exponent < text.size() && (text[exponent] == '+' || text[exponent] == '-')) {
        ++exponent;
      }
      const std::size_t exponent_end = digits(exponent, is_digit);
      if (exponent_end > exponent) {
        token.whole = false;
        end = exponent_end;
      }
    }
    // Fortran's exponents have a d.
    const bool fortran = end > mantissa_end && lower(text[mantissa_end]) == 'd';
    const char written = fortran ? std::exchange(text[mantissa_end], 'e') : '\0';
    const auto result = std::from_chars(text.data() + begin, text.data() + end, token.value);
    if (fortran) {
      text[mantissa_end] = written;
    }
    if (result.ec == std::errc::result_out_of_range) {
      const bool tiny = end > mantissa_end && text[mantissa_end + 1] == '-';
      token.value = tiny ? 0 : HUGE_VAL;
    }
  }
  sources_.back().at = end;
  return token;
}

void Tokens::scan_text(Token& token) {
  token.kind = Token::Kind::Text;
  ++sources_.back().at;
  while (at() != '"') {
    if (sources_.back().at >= sources_.back().text.size()) {
      fail_at(token.line, "a text in quotes does not end");
    }
    token.word += at();
    pass();
  }
  ++sources_.back().at;
}

Token Tokens::scan_token() {
  Token token;
  token.line = line_;
  const char c = at();
  if (is_digit(c) || (c == '.' && is_digit(at(1)))) {
    token = scan_number();
    token.line = line_;
  } else if (is_letter(c)) {
    token.kind = Token::Kind::Word;
    while (is_letter(at()) || is_digit(at())) {
      token.word += at();
      ++sources_.back().at;
    }
  } else if (c == '"') {
    scan_text(token);
  } else {
    token.kind = c == ',' || c == ':' || c == ';' ? Token::Kind::Separator : Token::Kind::Symbol;
    token.symbol = c;
    ++sources_.back().at;
  }
  token.starts_line = line_begins_;
  token.space_before = space_;
  token.space_after = space_at(0);
  return token;
}

/// Goes on with what a name stands for, if it is one of #define.
bool Tokens::expand(const Token& name) {
  const auto macro = macros_.find(name.word);
  if (macro == macros_.end()) {
    return false;
  }
  push({macro->second, 0, false, name.space_after});
  line_begins_ = name.starts_line;
  space_ = name.space_before;
  return true;
}

Token Tokens::scan() {
  while (true) {
    if (sources_.back().at >= sources_.back().text.size()) {
      if (sources_.size() == 1) {
        Token end;
        end.line = line_;
        end.starts_line = true;
        return end;
      }
      const bool file = sources_.back().file;
      sources_.pop_back();
      line_begins_ = file || line_begins_;
      continue;
    }
    if (skip_space()) {
      continue;
    }
    if (at() == '#' && line_begins_ && sources_.back().file) {
      obey_directive();
      continue;
    }
    Token token = scan_token();
    if (token.kind == Token::Kind::Word && !macros_.empty() && expand(token)) {
      continue;
    }
    line_begins_ = false;
    space_ = token.kind == Token::Kind::Separator;
    if (token.kind == Token::Kind::Word) {
      std::ranges::transform(token.word, token.word.begin(), lower);
    }
    return token;
  }
}

} // namespace foam::evolver
