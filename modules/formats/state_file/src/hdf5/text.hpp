#pragma once

#include "handle.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace scree::state_file {

// The type of UTF-8 text with a fixed number of bytes, padded with 0, which C and Fortran read directly.
Handle text_type(std::size_t bytes);

// Adds an attribute with one text.
void write_attribute(hid_t object, const char* name, std::string_view text);
// The same of variable length, which h5py gives as text and not as bytes.
void write_variable_attribute(hid_t object, const char* name, const std::string& text);
std::string read_variable_attribute(hid_t object, const char* name);
// Text of an attribute; empty if there is none, or none of the kind that write_attribute writes.
std::string read_attribute(hid_t object, const char* name);

// Lines of text padded to the longest; at least one byte each.
struct PaddedText {
  std::vector<char> bytes;
  std::size_t width = 1;

  explicit PaddedText(const std::vector<std::string>& lines);
};

}  // namespace scree::state_file
