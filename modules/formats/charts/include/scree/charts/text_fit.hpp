#pragma once

#include <functional>
#include <string>

namespace scree::charts {

// Width of one line of text at a font size, both in the same unit.
using TextWidth = std::function<double(const std::string& line, double size)>;

struct FittedText {
  std::string line;
  double size;
};

// Text that can be drawn: blanks for control characters, question marks for bytes that are not UTF-8.
std::string drawable_text(const std::string& text);

// The line, or the beginning of one that no picture is wide enough for, so that measuring it takes little
// time.
std::string shown_part(const std::string& line);

// A line for a space of length `room`: reduced to not less than two thirds of its size, then cut with an
// ellipsis.
FittedText fit_text(const std::string& line, double size, double room, const TextWidth& width);

}  // namespace scree::charts
