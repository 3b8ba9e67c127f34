// SPDX-License-Identifier: GPL-3.0-or-later
//
// The lexical grammar of Surface Evolver's datafiles (Brakke, Surface Evolver Manual, "Datafile"):
// comments, splices, #define and #include; case matters in the names of #define alone.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace foam::evolver {

struct Token {
  enum class Kind : std::uint8_t {
    End,
    Number,
    Word,
    Text,      ///< quoted
    Separator, ///< a comma, colon or semicolon: white space, but in expressions
    Symbol
  };

  Kind kind = Kind::End;
  char symbol = 0;           ///< of a separator or a symbol
  bool whole = false;        ///< of a number: written as an integer
  bool starts_line = false;  ///< whether it is the first of its line
  bool space_before = false; ///< white space, or a line's start
  bool space_after = false;
  int line = 0;     ///< from 1, in the file that was opened: where that includes another, the line
                    ///< that does
  double value = 0; ///< of a number
  std::string word; ///< of a word, in lower case; of a text, as it is

  bool is(char c) const { return kind == Kind::Symbol && symbol == c; }
  bool is_word(std::string_view w) const { return kind == Kind::Word && word == w; }
  bool is_integer() const { return kind == Kind::Number && whole; }
};

/// A datafile's tokens, one after the other.
class Tokens {
public:
  /// \param include gives the content of a file that is included; it may throw.
  Tokens(std::string text, std::function<std::string(const std::string&)> include);
  /// Those that were taken before.
  explicit Tokens(const std::vector<Token>& taken);

  /// The next one, or one farther ahead.
  const Token& peek(std::size_t ahead = 0);
  /// Takes the next one.
  Token take();

private:
  /// A text that is being read: the file, one that it includes, or a macro.
  struct Source {
    std::string text;
    std::size_t at = 0;
    bool file = true;
    bool space_follows = false; ///< of a macro: whether white space follows its name
  };

  Token scan();
  bool skip_space();
  void skip_comment(std::string_view end);
  Token scan_token();
  Token scan_number();
  void scan_text(Token& token);
  bool expand(const Token& name);
  void obey_directive();
  std::string rest_of_line();
  void push(Source source);
  bool splice_at(std::size_t offset) const;
  bool space_at(std::size_t offset) const;
  void pass();

  char at(std::size_t offset = 0) const {
    const Source& source = sources_.back();
    return source.at + offset < source.text.size() ? source.text[source.at + offset] : '\0';
  }

  std::function<std::string(const std::string&)> include_;
  std::vector<Source> sources_;
  std::map<std::string, std::string, std::less<>> macros_; ///< by name, as it is written
  std::deque<Token> ahead_; ///< where looking farther leaves in place what has been looked at
  int line_ = 1;
  int expansions_ = 0;
  bool line_begins_ = true;
  bool space_ = true;
};

/// \throws FoamError with the line in front
[[noreturn]] void fail_at(int line, const std::string& what);

} // namespace foam::evolver
