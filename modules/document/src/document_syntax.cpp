#include "document_syntax.hpp"

#include "document_message.hpp"

#include <fmt/format.h>

#include <scree/files/text.hpp>

namespace scree::document {
namespace {

constexpr std::size_t longest_complaint = 200;

struct Cure {
  std::string_view sign;  // found in the complaint
  std::string_view cure;
};

// The first that fits is given, so the special stands before the general.
constexpr Cure cures[] = {
    {"redefine existing table", "merge the two tables, or write [[name]] for each entry of a list"},
    {"redefine existing", "keep one of the two"},
    {"determine value type", "give a number, true, false, an [array] or a \"string\" in quotes"},
    {"parsing boolean", "write true or false, or put the word in quotes"},
    {"end-of-file", "close the bracket, brace or quote that is open there"},
    {"utf-8", "save the file as UTF-8 text"},
    {"leading zeroes", "write the number without leading zeros"},
    {"not representable", "give a number that fits 64 bits"},
    {"could not be interpreted", "give a number of magnitude below 1.8e308"},
    {"underscores", "put underscores between digits only"},
    {"digit, saw '.'", "put a digit on both sides of the decimal point, such as 0.5"},
    {"digit, saw '\\", "put a digit behind the decimal point or exponent, such as 1.0"},
    {"digit", "write a plain number such as 2.5e-3, without a unit (all units are SI)"},
    {"comment or whitespace, saw ','", "use a decimal point, one value for each key, and [ ] for several"},
    {"comment or whitespace", "put each key = value on a line of its own"},
    {"expected '='", "write key = value"},
    {"expected value", "give the value behind the = on the same line"},
    {"inline table", "write an inline table on one line, { a = 1, b = 2 }"},
    {"table header", "write [name] or [[name]] on a line of its own"},
    {"control characters", "close the quote on the same line, or use \"\"\" for several lines"},
    {"escape sequence", "write \\\\ for a backslash, or use 'single quotes'"},
    {"nested value depth", "flatten the arrays"},
    {"keys, tables", "write key = value, [table], [[entry of a list]] or # comment"},
};

}  // namespace

std::string syntax_complaint(std::string_view description) {
  constexpr std::string_view opening = "Error while parsing ";
  std::string_view cure = "correct the line by the rules of TOML (toml.io)";
  for (const Cure& candidate : cures) {
    if (description.find(candidate.sign) == std::string_view::npos) continue;
    cure = candidate.cure;
    break;
  }
  if (description.starts_with(opening)) description.remove_prefix(opening.size());
  return fmt::format("not valid TOML: {}; {}", files::one_line(description, longest_complaint), cure);
}

}  // namespace scree::document
