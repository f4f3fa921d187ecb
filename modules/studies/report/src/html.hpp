#pragma once

#include <string>
#include <string_view>
#include <vector>

// Parts of a page. Arguments called html are markup; all others are text, and are escaped.
namespace scree::report {

// Text for a page: markup is escaped, control characters are blanks, bytes that are not UTF-8 question marks.
std::string escaped(const std::string& text);
// The same with its line breaks, for <pre>; what is behind `longest` bytes is left out.
std::string escaped_lines(const std::string& text, std::size_t longest);

// <name class="kind">html</name>
std::string element(const char* name, const std::string& html, const char* kind = "");
std::string paragraph(const std::string& text);
std::string code(const std::string& text);

// A part of the page below a heading; empty without html.
std::string section(const std::string& title, const std::string& html);
// A part that a click opens, and that is open in print only if it was so before.
std::string folded(const std::string& title, const std::string& html);

struct Heading {
  std::string text;
  bool number = false;  // its column is aligned to the right
};

// Text with places for line breaks behind the dots and underscores of long names.
std::string breakable(const std::string& text);

// A table; it scrolls by itself on a screen that is too narrow. Columns without a cell are left out.
class Table {
 public:
  explicit Table(std::vector<Heading> headings) : headings_(std::move(headings)) {}
  // A row of html. Rows beyond `longest` are counted only.
  void add(std::vector<std::string> html);
  bool empty() const { return rows_.empty(); }
  // where: the file with all rows, for a table of which some are left out.
  std::string html(const std::string& where = "") const;

 private:
  static constexpr std::size_t longest = 400;
  bool is_shown(std::size_t column) const;

  std::vector<Heading> headings_;
  std::vector<std::vector<std::string>> rows_;
  std::size_t left_out_ = 0;
};

// Facts with their names, in pairs. A fact without html is left out.
class Facts {
 public:
  void add(const std::string& name, const std::string& html);
  std::string html() const;

 private:
  std::string rows_;
};

// Base64, as in data: addresses.
std::string base64(std::string_view bytes);
// A relative path as an address.
std::string address(const std::string& path);

}  // namespace scree::report
