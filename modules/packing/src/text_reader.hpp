#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace scree::packing {

// Piece of a line. column: of its first byte, from 1.
struct Token {
  std::string_view text;
  std::size_t column = 1;
};

// The token as it may stand in a message: quoted, shortened, and without bytes that would upset a terminal.
std::string quote_token(std::string_view text);

// Walks through the lines of a text that must outlive it, and turns tokens into numbers. Every failure is an
// Error "name:line:column: message; cure".
class TextReader {
 public:
  struct Position {
    std::size_t offset = 0;       // of the first byte of a line
    std::size_t line_number = 0;  // of the line before it
  };

  // Throws Error if the text holds NUL bytes, as no text file does.
  TextReader(std::string_view text, std::string name);

  // To the next line; false at the end of the text.
  bool next();
  // To the next line that has words; false at the end of the text.
  bool next_words();
  // Where the current line begins: after seek(position()), next() reads it again.
  Position position() const { return {line_start_, line_number_ - 1}; }
  void seek(Position position);

  std::size_t line_number() const { return line_number_; }
  // Bytes of the whole text: no announced count of lines can exceed it.
  std::size_t size() const { return text_.size(); }
  // Current line without its line end.
  std::string_view line() const { return line_; }
  // Words of the current line, separated by blanks, up to a '#'. Valid until the next call.
  const std::vector<Token>& words();
  // Cells of the current line, separated by commas, trimmed, without surrounding double quotes. Valid
  // likewise.
  const std::vector<Token>& cells();
  // Stretch of the current line without the blanks around it.
  Token trimmed(std::size_t begin, std::size_t end) const;

  // Finite number. what: what it stands for, used in messages.
  double number(const Token& token, std::string_view what) const;
  double positive_number(const Token& token, std::string_view what) const;
  std::int64_t integer(const Token& token, std::string_view what) const;
  std::int64_t positive_integer(const Token& token, std::string_view what) const;

  [[noreturn]] void fail(std::size_t column, std::string_view message, std::string_view cure) const;

 private:
  std::string_view text_;
  std::string name_;
  std::string_view line_;
  std::size_t line_start_ = 0;
  std::size_t next_start_ = 0;
  std::size_t line_number_ = 0;
  std::vector<Token> tokens_;
};

}  // namespace scree::packing
