#pragma once

#include <cstddef>
#include <cstdint>
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

// Throws Error if a file that begins so is compressed. name: of the file.
void refuse_compressed(std::string_view begin, std::string_view name);

inline constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";

// The current line of a text that something reads line by line, cut into tokens and these converted to numbers. Every failure
// throws Error "name:line:column: message; cure".
class TextLine {
 public:
  std::size_t line_number() const { return line_number_; }
  // Current line without its line break.
  std::string_view line() const { return line_; }
  // Words of the current line, separated by blanks, up to a '#'. Valid until the next call.
  const std::vector<Token>& words();
  // Cells of the current line, separated by commas, trimmed, without surrounding double quotes, within which commas do not separate and quotes are
  // doubled. Valid until the next call.
  const std::vector<Token>& cells();
  // Bytes [begin, end) of the current line without surrounding blanks.
  Token trimmed(std::size_t begin, std::size_t end) const;
  // Whether the line is blank or begins with '#'.
  bool is_comment() const;

  // Throws unless the token is a number, which may be infinite or NaN. what: name of the quantity for messages.
  double any_number(const Token& token, std::string_view what) const;
  // The same for a finite number.
  double number(const Token& token, std::string_view what) const;
  double positive_number(const Token& token, std::string_view what) const;
  std::int64_t integer(const Token& token, std::string_view what) const;
  std::int64_t positive_integer(const Token& token, std::string_view what) const;

  [[noreturn]] void fail(std::size_t column, std::string_view message, std::string_view cure) const;

 protected:
  explicit TextLine(std::string name) : name_(std::move(name)) {}
  const std::string& name() const { return name_; }
  // The next line, without its '\n', which must outlive its use.
  void set(std::string_view line);
  // After this the next line has the number + 1.
  void set_line_number(std::size_t number) { line_number_ = number; }

 private:
  std::size_t end_of_cell(std::size_t begin) const;

  std::string name_;
  std::string_view line_;
  std::size_t line_number_ = 0;
  std::vector<Token> tokens_;
};

}  // namespace scree::files
