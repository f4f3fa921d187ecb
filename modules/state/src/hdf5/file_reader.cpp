#include "file_reader.hpp"

#include "element_type.hpp"
#include "file_writer.hpp"
#include "text.hpp"

#include <fmt/format.h>

namespace scree::state_file {
namespace {

[[noreturn]] void refuse(const std::string& name, std::string_view problem) {
  throw Error(fmt::format("/{} {}", name, problem));
}

Handle open_file(const std::filesystem::path& file) {
  const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "access");
  checked(H5Pset_file_locking(access, false, true), "locks");
  return {H5Fopen(file.c_str(), H5F_ACC_RDONLY, access), H5Fclose, "is not an HDF5 file"};
}

std::vector<std::size_t> shape_of(hid_t dataset, const std::string& name, bool as_frame) {
  const Handle space(H5Dget_space(dataset), H5Sclose, name);
  if (H5Sget_simple_extent_type(space) == H5S_NULL) refuse(name, "has no shape");
  std::vector<hsize_t> extents(std::size_t(checked(H5Sget_simple_extent_ndims(space), name)));
  checked(H5Sget_simple_extent_dims(space, extents.data(), nullptr), name);
  if (as_frame && (extents.empty() || extents[0] != 1)) refuse(name, "is not the state at one time");
  return {extents.begin() + std::ptrdiff_t(as_frame), extents.end()};
}

// Bytes of an array, if it lies in the file in one piece and in full.
std::size_t bytes_of(hid_t dataset, hid_t type, const std::vector<std::size_t>& shape,
                     const std::string& name) {
  const Handle properties(H5Dget_create_plist(dataset), H5Pclose, name);
  if (H5Pget_layout(properties) != H5D_CONTIGUOUS || H5Pget_external_count(properties) != 0)
    refuse(name, "does not lie in the file in one piece");
  std::size_t bytes = H5Tget_size(type);
  bool fits = true;
  for (const std::size_t extent : shape) fits = fits && !__builtin_mul_overflow(bytes, extent, &bytes);
  if (!fits || bytes != H5Dget_storage_size(dataset)) refuse(name, "claims more values than it has");
  return bytes;
}

std::vector<std::uint64_t> lengths_of(hid_t dataset, std::size_t lines, std::size_t width,
                                      const std::string& name) {
  std::vector<std::uint64_t> lengths;
  if (checked(H5Aexists(dataset, lengths_attribute), name) == 0) return lengths;
  const Handle attribute(H5Aopen(dataset, lengths_attribute, H5P_DEFAULT), H5Aclose, name);
  const Handle space(H5Aget_space(attribute), H5Sclose, name), type(H5Aget_type(attribute), H5Tclose, name);
  if (H5Sget_simple_extent_npoints(space) != hssize_t(lines) ||
      H5Tequal(type, file_type<std::uint64_t>()) <= 0)
    refuse(name, "has no lengths for its texts");
  lengths.resize(lines);
  checked(H5Aread(attribute, memory_type<std::uint64_t>(), lengths.data()), name);
  for (const std::uint64_t length : lengths)
    if (length > width) refuse(name, "has texts longer than their room");
  return lengths;
}

herr_t keep_link(hid_t, const char* name, const H5L_info_t* info, void* links) {
  auto& kept = *static_cast<std::vector<std::string>*>(links);
  if (info->type != H5L_TYPE_HARD) kept.clear();
  kept.push_back(name);
  return info->type == H5L_TYPE_HARD ? 0 : 1;  // above 0 stops
}

template <class T>
bool is_of(hid_t type) {
  if constexpr (std::is_same_v<T, std::string>)
    return H5Tget_class(type) == H5T_STRING && H5Tis_variable_str(type) == 0 &&
           H5Tget_strpad(type) == H5T_STR_NULLPAD;
  else
    return H5Tequal(type, file_type<T>()) > 0;
}

// Makes the values of the kind that a dataset has; false if a state has no such kind.
template <std::size_t k = 0>
bool choose_kind(hid_t type, StateArray& array) {
  if constexpr (k == std::variant_size_v<decltype(array.values)>) {
    return false;
  } else {
    using Values = std::variant_alternative_t<k, decltype(array.values)>;
    if (!is_of<typename Values::value_type>(type)) return choose_kind<k + 1>(type, array);
    array.values.template emplace<k>();
    return true;
  }
}

}  // namespace

FileReader::FileReader(const std::filesystem::path& file, double largest)
    : file_(open_file(file)), memory_left_(largest) {
  hsize_t size = 0;
  checked(H5Fget_filesize(file_, &size), "size of the file");
  bytes_left_ = size;
}

std::vector<std::string> FileReader::links() const {
  std::vector<std::string> links;
  if (checked(H5Lvisit(file_, H5_INDEX_NAME, H5_ITER_INC, keep_link, &links), "list of what is in it") > 0)
    refuse(links.back(), "is a link out of its place");
  return links;
}

bool FileReader::is_group(const std::string& name) const {
  const Handle object(H5Oopen(file_, name.c_str(), H5P_DEFAULT), H5Oclose, name);
  const H5I_type_t type = H5Iget_type(object);
  if (type != H5I_GROUP && type != H5I_DATASET) refuse(name, "is neither a group nor a dataset");
  return type == H5I_GROUP;
}

template <class T>
void FileReader::read(hid_t dataset, const std::string& name, StateArray& array) {
  const std::size_t size =
      std::size_t(H5Sget_simple_extent_npoints(Handle(H5Dget_space(dataset), H5Sclose, name)));
  auto& values = std::get<std::vector<T>>(array.values);
  values.resize(size);
  if (size > 0)
    checked(H5Dread(dataset, memory_type<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), name);
}

template <>
void FileReader::read<std::string>(hid_t dataset, const std::string& name, StateArray& array) {
  const Handle type(H5Dget_type(dataset), H5Tclose, name), space(H5Dget_space(dataset), H5Sclose, name);
  const std::size_t lines = std::size_t(H5Sget_simple_extent_npoints(space)), width = H5Tget_size(type);
  std::vector<char> bytes(lines * width);
  if (lines > 0) checked(H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes.data()), name);
  const auto lengths = lengths_of(dataset, lines, width, name);
  auto& values = std::get<std::vector<std::string>>(array.values);
  for (std::size_t k = 0; k < lines; ++k) {
    values.emplace_back(bytes.data() + k * width, width);
    values[k].resize(lengths.empty() ? values[k].find_last_not_of('\0') + 1 : lengths[k]);
  }
}

StateArray FileReader::array(const std::string& name, bool as_frame) {
  const Handle dataset(H5Dopen2(file_, name.c_str(), H5P_DEFAULT), H5Dclose, name);
  const Handle type(H5Dget_type(dataset), H5Tclose, name);
  StateArray array;
  array.shape = shape_of(dataset, name, as_frame);
  if (!choose_kind(type, array)) refuse(name, "has a type that no state has");
  const std::size_t bytes = bytes_of(dataset, type, array.shape, name);
  if (bytes > bytes_left_) refuse(name, "claims more bytes than are in the file");
  bytes_left_ -= bytes;
  memory_left_ -= double(bytes);
  if (memory_left_ < 0) refuse(name, "does not fit into memory with the arrays before it");
  array.unit = read_attribute(dataset, unit_attribute);
  if (array.unit.empty()) refuse(name, "has no unit");
  if (checked(H5Aexists(dataset, label_attribute), name) > 0) array.unit.clear();
  std::visit(
      [&](auto& values) { read<typename std::decay_t<decltype(values)>::value_type>(dataset, name, array); },
      array.values);
  return array;
}

}  // namespace scree::state_file
