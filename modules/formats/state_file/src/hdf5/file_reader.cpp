#include "file_reader.hpp"

#include "../unit_text.hpp"
#include "element_type.hpp"
#include "file_writer.hpp"
#include "text.hpp"

#include <utility>

#include <fmt/format.h>

#include <scree/state.hpp>

namespace scree::state_file {
namespace {

constexpr int deepest = 10;  // groups within each other; states have six

[[noreturn]] void refuse(const std::string& name, std::string_view problem) {
  throw Error(fmt::format("/{} {}", name, problem));
}

Handle open_file(const std::filesystem::path& file) {
  const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "access");
  checked(H5Pset_file_locking(access, false, true), "locks");
  return {H5Fopen(file.c_str(), H5F_ACC_RDONLY, access), H5Fclose, "is not an HDF5 file"};
}

std::vector<std::uint64_t> shape_of(hid_t dataset, const std::string& name, bool as_frame) {
  const Handle space(H5Dget_space(dataset), H5Sclose, name);
  if (H5Sget_simple_extent_type(space) == H5S_NULL) refuse(name, "has no shape");
  std::vector<hsize_t> extents(std::size_t(checked(H5Sget_simple_extent_ndims(space), name)));
  checked(H5Sget_simple_extent_dims(space, extents.data(), nullptr), name);
  if (as_frame && (extents.empty() || extents[0] != 1)) refuse(name, "is not the state at one time");
  return {extents.begin() + std::ptrdiff_t(as_frame), extents.end()};
}

// Throws Error unless all of an array lies in the file in one piece.
void check_layout(hid_t dataset, const PlacedArray& array, const std::string& name) {
  const Handle properties(H5Dget_create_plist(dataset), H5Pclose, name);
  if (H5Pget_layout(properties) != H5D_CONTIGUOUS || H5Pget_external_count(properties) != 0)
    refuse(name, "does not lie in the file in one piece");
  std::uint64_t bytes = array.width;
  bool fits = true;
  for (const std::uint64_t extent : array.shape)
    fits = fits && !__builtin_mul_overflow(bytes, extent, &bytes);
  if (!fits || bytes != H5Dget_storage_size(dataset)) refuse(name, "claims more values than it has");
}

std::vector<std::uint64_t> lengths_of(hid_t dataset, const std::string& name) {
  std::vector<std::uint64_t> lengths;
  if (checked(H5Aexists(dataset, lengths_attribute), name) == 0) return lengths;
  const Handle attribute(H5Aopen(dataset, lengths_attribute, H5P_DEFAULT), H5Aclose, name);
  const Handle space(H5Aget_space(attribute), H5Sclose, name), type(H5Aget_type(attribute), H5Tclose, name),
      texts(H5Dget_space(dataset), H5Sclose, name);
  const hssize_t count = H5Sget_simple_extent_npoints(texts);
  if (count < 0 || H5Sget_simple_extent_npoints(space) != count ||
      H5Tequal(type, file_type<std::uint64_t>()) <= 0)
    refuse(name, "has no lengths for its texts");
  lengths.resize(std::size_t(count));
  checked(H5Aread(attribute, memory_type<std::uint64_t>(), lengths.data()), name);
  return lengths;
}

template <class T>
bool is_of(hid_t type) {
  if constexpr (std::is_same_v<T, std::string>)
    return H5Tget_class(type) == H5T_STRING && H5Tis_variable_str(type) == 0 &&
           H5Tget_strpad(type) == H5T_STR_NULLPAD;
  else
    return H5Tequal(type, file_type<T>()) > 0;
}

using Values = decltype(StateArray::values);

// Index of a type among the kinds of values of a state; the number of kinds if it is none of them.
template <std::size_t k = 0>
std::size_t kind_of(hid_t type) {
  if constexpr (k < std::variant_size_v<Values>) {
    return is_of<typename std::variant_alternative_t<k, Values>::value_type>(type) ? k : kind_of<k + 1>(type);
  } else {
    return k;
  }
}

std::string unit_of(hid_t dataset, const std::string& name) {
  std::string unit = read_attribute(dataset, unit_attribute);
  if (!unit.empty()) unit = state_unit(unit);
  if (unit.empty()) unit = read_attribute(dataset, unit_attribute_of_format_1);
  if (unit.empty()) refuse(name, "has no unit");
  return checked(H5Aexists(dataset, label_attribute), name) > 0 ? "" : unit;
}

// Whether arrays of a state lie at or below a place; what other programs add elsewhere is left alone.
bool has_arrays(const std::string& name) {
  return name == "particles" || name == "particles/bodies" || name.starts_with("particles/bodies/") ||
         name == "scree" || name.starts_with("scree/");
}

herr_t keep_link(hid_t, const char* name, const H5L_info_t* info, void* links) {
  static_cast<std::vector<std::pair<std::string, H5L_info_t>>*>(links)->emplace_back(name, *info);
  return 0;
}

}  // namespace

FileReader::FileReader(const std::filesystem::path& file) : file_(open_file(file)) {}

std::vector<std::string> FileReader::datasets() {
  visit(file_, "", 0);
  return std::move(found_);
}

// In the order of the file, since HDF5 1.10 makes a table to sort names that it frees unfilled when it fails.
// Not with the recursion of HDF5, which has no limit.
void FileReader::visit(hid_t group, const std::string& name, int depth) {
  std::vector<std::pair<std::string, H5L_info_t>> links;
  hsize_t next = 0;
  checked(H5Literate(group, H5_INDEX_NAME, H5_ITER_NATIVE, &next, keep_link, &links),
          "list of what is in it");
  for (const auto& [link, info] : links) visit_link(group, name + link, info, depth);
}

void FileReader::visit_link(hid_t group, const std::string& name, const H5L_info_t& link, int depth) {
  if (!has_arrays(name)) return;
  if (link.type != H5L_TYPE_HARD) refuse(name, "is a link out of its place");
  const Handle object(H5Oopen(group, name.substr(name.rfind('/') + 1).c_str(), H5P_DEFAULT), H5Oclose, name);
  const H5I_type_t type = H5Iget_type(object);
  if (type == H5I_DATASET) return found_.push_back(name);
  if (type != H5I_GROUP) refuse(name, "is neither a group nor a dataset");
  if (depth == deepest) refuse(name, "lies in too many groups");
  if (!groups_.insert(link.u.address).second) refuse(name, "is a second name of a group");
  visit(object, name + '/', depth + 1);
}

PlacedArray FileReader::array(const std::string& name, bool as_frame) const {
  const Handle dataset(H5Dopen2(file_, name.c_str(), H5P_DEFAULT), H5Dclose, name);
  const Handle type(H5Dget_type(dataset), H5Tclose, name);
  PlacedArray array;
  array.dataset = name;
  array.as_frame = as_frame;
  array.kind = kind_of(type);
  if (array.kind == std::variant_size_v<Values>) refuse(name, "has a type that no state has");
  array.shape = shape_of(dataset, name, as_frame);
  array.width = H5Tget_size(type);
  check_layout(dataset, array, name);
  array.unit = unit_of(dataset, name);
  array.lengths = lengths_of(dataset, name);
  const haddr_t offset = H5Dget_offset(dataset);  // none of an array without values
  array.offset = offset == HADDR_UNDEF ? 0 : offset;
  return array;
}

}  // namespace scree::state_file
