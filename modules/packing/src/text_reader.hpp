#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace scree::packing {

// Part of a line. column: of its first byte, counted from 1.
struct Token {
  std::string_view text;
  std::size_t column = 1;
};

// The token for a message: quoted, shortened, and with non-printable bytes escaped.
std::string quote_token(std::string_view text);

// Reads a text line by line and converts tokens to numbers. The text must outlive the reader. Every failure
// throws Error "name:line:column: message; cure".
class TextReader {
 public:
  struct Position {
    std::size_t offset = 0;       // of the first byte of a line
    std::size_t line_number = 0;  // of the previous line
  };

  // Throws Error if the text is compressed or contains NUL bytes.
  TextReader(std::string_view text, std::string name);

  // Goes to the next line; false at the end of the text.
  bool next();
  // Goes to the next line that has words; false at the end of the text.
  bool next_words();
  // Start of the current line: after seek(position()), next() reads this line again.
  Position position() const { return {line_start_, line_number_ - 1}; }
  void seek(Position position);

  std::size_t line_number() const { return line_number_; }
  // Bytes of the whole text, an upper bound of any number of lines in it.
  std::size_t size() const { return text_.size(); }
  // Current line without its line break.
  std::string_view line() const { return line_; }
  // Words of the current line, separated by blanks, up to a '#'. Valid until the next call.
  const std::vector<Token>& words();
  // Cells of the current line, separated by commas, trimmed, without surrounding double quotes. Valid until
  // the next call.
  const std::vector<Token>& cells();
  // Bytes [begin, end) of the current line without surrounding blanks.
  Token trimmed(std::size_t begin, std::size_t end) const;

  // Throws unless the token is a finite number. what: name of the quantity for messages.
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
