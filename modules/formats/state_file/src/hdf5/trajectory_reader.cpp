#include "trajectory_reader.hpp"

#include "../unit_text.hpp"
#include "element_type.hpp"
#include "file_writer.hpp"
#include "text.hpp"

#include <fmt/format.h>

namespace scree::state_file {
namespace {

Handle open_file(const std::filesystem::path& file) {
  const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "access");
  checked(H5Pset_file_locking(access, false, true), "locks");
  return {H5Fopen(file.c_str(), H5F_ACC_RDONLY, access), H5Fclose, "is not a whole HDF5 file"};
}

herr_t keep_name(hid_t, const char* name, const H5L_info_t*, void* names) {
  static_cast<std::vector<std::string>*>(names)->emplace_back(name);
  return 0;
}

std::vector<hsize_t> extents_of(hid_t space, const std::string& name) {
  std::vector<hsize_t> extents(std::size_t(checked(H5Sget_simple_extent_ndims(space), name)));
  checked(H5Sget_simple_extent_dims(space, extents.data(), nullptr), name);
  return extents;
}

// Fixed elements have texts of fixed length, as states.
std::string unit_of(hid_t dataset, const std::string& name) {
  if (checked(H5Aexists(dataset, label_attribute), name) > 0) return "";
  std::string unit = read_variable_attribute(dataset, unit_attribute);
  if (unit.empty()) unit = read_attribute(dataset, unit_attribute);
  return unit.empty() ? "" : state_unit(unit);
}

// Reads the selected values if they are of this type.
template <class T>
bool read(hid_t dataset, hid_t type, hid_t memory, hid_t space, std::size_t count, StateArray& array) {
  if (H5Tequal(type, file_type<T>()) <= 0) return false;
  std::vector<T> values(count);
  checked(H5Dread(dataset, memory_type<T>(), memory, space, H5P_DEFAULT, values.data()), "values");
  array.values = std::move(values);
  return true;
}

}  // namespace

TrajectoryReader::TrajectoryReader(const std::filesystem::path& file)
    : file_(open_file(file)),
      all_(H5Gopen2(file_, "particles/all", H5P_DEFAULT), H5Gclose, "/particles/all") {}

std::vector<std::string> TrajectoryReader::elements(H5I_type_t type) const {
  std::vector<std::string> names, found;
  hsize_t next = 0;
  checked(H5Literate(all_, H5_INDEX_NAME, H5_ITER_INC, &next, keep_name, &names), "list of elements");
  for (const std::string& name : names) {
    const Handle object(H5Oopen(all_, name.c_str(), H5P_DEFAULT), H5Oclose, name);
    if (H5Iget_type(object) == type && name != "box") found.push_back(name);
  }
  return found;
}

bool TrajectoryReader::has(const std::string& name) const {
  return checked(H5Lexists(all_, name.c_str(), H5P_DEFAULT), name) > 0;
}

std::vector<std::string> TrajectoryReader::boundary() const {
  const Handle attribute(H5Aopen_by_name(all_, "box", "boundary", H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
                         "boundary");
  const Handle type(H5Aget_type(attribute), H5Tclose, "boundary"),
      space(H5Aget_space(attribute), H5Sclose, "boundary");
  const std::size_t width = H5Tget_size(type);
  const std::size_t count = std::size_t(checked(H5Sget_simple_extent_npoints(space), "boundary"));
  if (H5Tis_variable_str(type) != 0 || H5Tget_class(type) != H5T_STRING)
    throw Error("the boundary is no text");
  std::string text(width * count, '\0');
  checked(H5Aread(attribute, type, text.data()), "boundary");
  std::vector<std::string> all;
  for (std::size_t k = 0; k < count; ++k) all.emplace_back(text.substr(k * width, width).c_str());
  return all;
}

void TrajectoryReader::check(const std::string& name, std::uint64_t frames) const {
  const Handle dataset(H5Dopen2(all_, name.c_str(), H5P_DEFAULT), H5Dclose, name);
  const Handle space(H5Dget_space(dataset), H5Sclose, name);
  const std::vector<hsize_t> extents = extents_of(space, name);
  if (extents.empty() || extents[0] < frames)
    throw Error(fmt::format("{} has fewer than {} frames", name, frames));
}

StateArray TrajectoryReader::array(const std::string& name, std::optional<std::uint64_t> frame) const {
  const Handle dataset(H5Dopen2(all_, name.c_str(), H5P_DEFAULT), H5Dclose, name);
  const Handle type(H5Dget_type(dataset), H5Tclose, name), space(H5Dget_space(dataset), H5Sclose, name);
  std::vector<hsize_t> extents = extents_of(space, name), offset(extents.size(), 0);
  if (frame) {
    check(name, *frame + 1);
    offset[0] = *frame, extents[0] = 1;
    checked(H5Sselect_hyperslab(space, H5S_SELECT_SET, offset.data(), nullptr, extents.data(), nullptr),
            name);
  }
  const std::size_t count = std::size_t(checked(H5Sget_select_npoints(space), name));
  const Handle memory = dataspace({count}, false);
  StateArray array;
  array.shape.assign(extents.begin() + (frame ? 1 : 0), extents.end());
  array.unit = unit_of(dataset, name);
  const bool known = read<double>(dataset, type, memory, space, count, array) ||
                     read<std::int64_t>(dataset, type, memory, space, count, array) ||
                     read<std::uint64_t>(dataset, type, memory, space, count, array) ||
                     read<std::int32_t>(dataset, type, memory, space, count, array) ||
                     read<std::uint32_t>(dataset, type, memory, space, count, array);
  if (!known) throw Error(fmt::format("{} has a type that no trajectory has", name));
  return array;
}

}  // namespace scree::state_file
