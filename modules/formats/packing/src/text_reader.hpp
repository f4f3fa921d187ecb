#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include <scree/files/text_line.hpp>

namespace scree::packing {

using files::quote_token;
using files::Token;

// Reads a text line by line. The text must outlive the reader. Every failure throws Error "name:line:column: message; cure".
class TextReader : public files::TextLine {
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
  Position position() const { return {line_start_, line_number() - 1}; }
  void seek(Position position);

  // Bytes of the whole text, an upper bound of any number of lines in it.
  std::size_t size() const { return text_.size(); }

 private:
  std::string_view text_;
  std::size_t line_start_ = 0;
  std::size_t next_start_ = 0;
};

}  // namespace scree::packing
