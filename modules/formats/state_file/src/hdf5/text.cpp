#include "text.hpp"

#include <algorithm>
#include <cstring>

namespace scree::state_file {

Handle text_type(std::size_t bytes) {
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose, "type of text");
  checked(H5Tset_size(type, std::max<std::size_t>(bytes, 1)), "size of text");
  checked(H5Tset_strpad(type, H5T_STR_NULLPAD), "padding of text");
  checked(H5Tset_cset(type, H5T_CSET_UTF8), "encoding of text");
  return type;
}

void write_attribute(hid_t object, const char* name, std::string_view text) {
  const Handle type = text_type(text.size());
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose, name);
  const Handle attribute(H5Acreate2(object, name, type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose, name);
  const std::string terminated(text);
  checked(H5Awrite(attribute, type, terminated.c_str()), name);
}

namespace {

Handle variable_text_type() {
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose, "type of text");
  checked(H5Tset_size(type, H5T_VARIABLE), "size of text");
  checked(H5Tset_cset(type, H5T_CSET_UTF8), "encoding of text");
  return type;
}

}  // namespace

void write_variable_attribute(hid_t object, const char* name, const std::string& text) {
  const Handle type = variable_text_type(), space(H5Screate(H5S_SCALAR), H5Sclose, name);
  const Handle attribute(H5Acreate2(object, name, type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose, name);
  const char* const characters = text.c_str();
  checked(H5Awrite(attribute, type, &characters), name);
}

std::string read_variable_attribute(hid_t object, const char* name) {
  if (checked(H5Aexists(object, name), name) == 0) return "";
  const Handle attribute(H5Aopen(object, name, H5P_DEFAULT), H5Aclose, name);
  const Handle own(H5Aget_type(attribute), H5Tclose, name), space(H5Aget_space(attribute), H5Sclose, name);
  if (H5Tis_variable_str(own) <= 0 || H5Sget_simple_extent_npoints(space) != 1) return "";
  const Handle type = variable_text_type();
  char* characters = nullptr;
  checked(H5Aread(attribute, type, &characters), name);
  const std::string text = characters ? characters : "";
  H5free_memory(characters);
  return text;
}

std::string read_attribute(hid_t object, const char* name) {
  constexpr std::size_t longest = 1000;  // of units
  if (checked(H5Aexists(object, name), name) == 0) return "";
  const Handle attribute(H5Aopen(object, name, H5P_DEFAULT), H5Aclose, name);
  const Handle type(H5Aget_type(attribute), H5Tclose, name), space(H5Aget_space(attribute), H5Sclose, name);
  const bool plain = H5Tget_class(type) == H5T_STRING && H5Tis_variable_str(type) == 0 &&
                     H5Tget_size(type) <= longest && H5Sget_simple_extent_npoints(space) == 1;
  if (!plain) return "";
  std::string text(H5Tget_size(type), '\0');
  checked(H5Aread(attribute, type, text.data()), name);
  text.resize(text.find_last_not_of('\0') + 1);
  return text;
}

PaddedText::PaddedText(const std::vector<std::string>& lines) {
  for (const std::string& line : lines) width = std::max(width, line.size());
  bytes.resize(width * lines.size());
  for (std::size_t k = 0; k < lines.size(); ++k)
    std::copy(lines[k].begin(), lines[k].end(), bytes.begin() + std::ptrdiff_t(k * width));
}

}  // namespace scree::state_file
