#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace scree::files {

// Part of a line. column: of its first byte, counted from 1.
struct Token {
  std::string_view text;
  std::size_t column = 1;
};

// The token for a message: quoted, shortened, and with non-printable bytes escaped.
std::string quote_token(std::string_view text);

inline constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";

// Reads a text line by line, cuts the lines into tokens and converts these to numbers. A byte order mark is
// skipped; compressed and binary text is refused. Every failure throws Error "name:line:column: problem;
// cure".
class TextReader {
 public:
  struct Position {
    std::size_t offset = 0;       // of the first byte of a line
    std::size_t line_number = 0;  // of the previous line
  };

  // Reads a text, which must outlive the reader.
  TextReader(std::string_view text, std::string name);
  // Reads a regular file, of which one line is in memory at a time.
  explicit TextReader(const std::filesystem::path& file);

  // Goes to the next line; false at the end of the text.
  bool next();
  // Goes to the next line that has words; false at the end of the text.
  bool next_words();
  // For a text in memory: start of the current line. After seek(position()), next() reads this line again.
  Position position() const { return {line_start_, line_number_ - 1}; }
  void seek(Position position);
  // Bytes of a text in memory, an upper bound of any number of lines in it.
  std::size_t size() const { return text_.size(); }

  const std::string& name() const { return name_; }
  std::size_t line_number() const { return line_number_; }
  // Current line without its line break.
  std::string_view line() const { return line_; }
  // Whether the current line ends with a line break; the last line of a file that was cut off does not.
  bool is_whole() const { return whole_; }
  // Words of the current line, separated by blanks, up to a '#'. Valid until the next call.
  const std::vector<Token>& words();
  // Cells of the current line, separated by commas and trimmed. A cell in double quotes, which are left out,
  // may have commas, and doubled quotes. Valid until the next call.
  const std::vector<Token>& cells();
  // Bytes [begin, end) of the current line without surrounding blanks.
  Token trimmed(std::size_t begin, std::size_t end) const;
  // Whether the line is blank or begins with '#'.
  bool is_comment() const;

  // Throws unless the token is a number, which may be infinite or NaN. what: name of the quantity for
  // messages.
  double any_number(const Token& token, std::string_view what) const;
  // The same for a finite number.
  double number(const Token& token, std::string_view what) const;
  double positive_number(const Token& token, std::string_view what) const;
  std::int64_t integer(const Token& token, std::string_view what) const;
  std::int64_t positive_integer(const Token& token, std::string_view what) const;

  [[noreturn]] void fail(std::size_t column, const std::string& problem, const std::string& cure) const;

 private:
  bool next_of_text();
  bool next_of_file();
  void set(std::string_view line);
  std::size_t end_of_cell(std::size_t begin) const;

  std::string name_;
  std::string_view text_;
  std::size_t line_start_ = 0, next_start_ = 0;  // in the text
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_{nullptr, nullptr};
  std::string line_of_file_;
  std::string_view line_;
  std::size_t line_number_ = 0;
  bool whole_ = false;
  std::vector<Token> tokens_;
};

}  // namespace scree::files
