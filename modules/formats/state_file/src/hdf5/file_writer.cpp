#include "file_writer.hpp"

#include "../unit_text.hpp"
#include "element_type.hpp"
#include "seal.hpp"
#include "text.hpp"

#include <algorithm>
#include <fcntl.h>
#include <unistd.h>

namespace scree::state_file {
namespace {

Handle without_times(hid_t kind) {
  Handle properties(H5Pcreate(kind), H5Pclose, "properties");
  checked(H5Pset_obj_track_times(properties, false), "properties");
  return properties;
}

// Links lie in the header of their group, where HDF5 finds them one by one, and not in a heap with an index.
Handle group_properties() {
  constexpr unsigned most_links = 65535;
  Handle properties = without_times(H5P_GROUP_CREATE);
  checked(H5Pset_link_phase_change(properties, most_links, 0), "properties");
  return properties;
}

Handle access_properties() {
  Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "access");
  // The format of HDF5 1.8 and later: shorter than the first one, and with its own checksums.
  checked(H5Pset_libver_bounds(access, H5F_LIBVER_V18, H5F_LIBVER_V18), "version of the format");
  // No other process knows the file yet, and some network file systems have no locks.
  checked(H5Pset_file_locking(access, false, true), "locks");
  return access;
}

Handle create_file(const std::filesystem::path& file, std::size_t user_block) {
  const Handle creation = without_times(H5P_FILE_CREATE), access = access_properties();
  checked(H5Pset_userblock(creation, user_block), "room for the seal");
  return {H5Fcreate(file.c_str(), H5F_ACC_TRUNC, creation, access), H5Fclose, "new file"};
}

// The last part of a path; the rest goes to `folder`.
std::string split(const std::string& name, std::string& folder) {
  const std::size_t slash = name.rfind('/');
  folder = slash == name.npos ? "" : name.substr(0, slash);
  return slash == name.npos ? name : name.substr(slash + 1);
}

void write_lengths(hid_t dataset, const std::vector<std::string>& lines) {
  if (std::none_of(lines.begin(), lines.end(), [](const auto& line) { return line.ends_with('\0'); })) return;
  std::vector<std::uint64_t> lengths;
  for (const std::string& line : lines) lengths.push_back(line.size());
  const Handle space = dataspace({lengths.size()}, false);
  const Handle attribute(
      H5Acreate2(dataset, lengths_attribute, file_type<std::uint64_t>(), space, H5P_DEFAULT, H5P_DEFAULT),
      H5Aclose, lengths_attribute);
  checked(H5Awrite(attribute, memory_type<std::uint64_t>(), lengths.data()), lengths_attribute);
}

}  // namespace

Handle dataspace(const std::vector<std::size_t>& shape, bool as_frame) {
  std::vector<hsize_t> extents(shape.begin(), shape.end());
  if (as_frame) extents.insert(extents.begin(), 1);
  if (extents.empty()) return {H5Screate(H5S_SCALAR), H5Sclose, "shape"};
  return {H5Screate_simple(int(extents.size()), extents.data(), nullptr), H5Sclose, "shape"};
}

FileWriter::FileWriter(const std::filesystem::path& file, std::size_t user_block)
    : FileWriter(create_file(file, user_block)) {}

FileWriter FileWriter::existing(const std::filesystem::path& file) {
  const Handle access = access_properties();
  return FileWriter({H5Fopen(file.c_str(), H5F_ACC_RDWR, access), H5Fclose, "is not a whole HDF5 file"});
}

FileWriter::FileWriter(Handle file)
    : file_(std::move(file)),
      group_properties_(group_properties()),
      dataset_properties_(without_times(H5P_DATASET_CREATE)) {}

FileWriter::~FileWriter() {
  if (complete_) return;
  // HDF5 does not free a file whose end it cannot write: the rest goes to /dev/null.
  void* descriptor = nullptr;
  const int nowhere = ::open("/dev/null", O_RDWR | O_CLOEXEC);
  if (H5Fget_vfd_handle(file_, H5P_DEFAULT, &descriptor) >= 0 && nowhere >= 0)
    ::dup2(nowhere, *static_cast<int*>(descriptor));
  ::close(nowhere);
}

void FileWriter::close() {
  checked(H5Fflush(file_, H5F_SCOPE_LOCAL), "end of the file");
  complete_ = true;
  file_.close("end of the file");
}

Handle FileWriter::group(const std::string& name) {
  if (name.empty()) return {H5Gopen2(file_, "/", H5P_DEFAULT), H5Gclose, "root"};
  std::string folder;
  const std::string own = split(name, folder);
  const Handle parent = group(folder);
  if (checked(H5Lexists(parent, own.c_str(), H5P_DEFAULT), name) > 0)
    return {H5Gopen2(parent, own.c_str(), H5P_DEFAULT), H5Gclose, name};
  return {H5Gcreate2(parent, own.c_str(), H5P_DEFAULT, group_properties_, H5P_DEFAULT), H5Gclose, name};
}

Handle FileWriter::dataset(hid_t group, const std::string& name, hid_t type, hid_t space,
                           const StateArray& array) {
  Handle made(H5Dcreate2(group, name.c_str(), type, space, H5P_DEFAULT, dataset_properties_, H5P_DEFAULT),
              H5Dclose, name);
  write_attribute(made, unit_attribute, array.unit.empty() ? "1" : h5md_unit(array.unit));
  if (array.unit.empty()) write_attribute(made, label_attribute, "a name, number or flag, not a quantity");
  return made;
}

template <class T>
void FileWriter::write(hid_t group, const std::string& name, const std::vector<T>& numbers, hid_t space,
                       const StateArray& array) {
  const Handle made = dataset(group, name, file_type<T>(), space, array);
  if (!numbers.empty())
    checked(H5Dwrite(made, memory_type<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.data()), name);
}

template <>
void FileWriter::write(hid_t group, const std::string& name, const std::vector<std::string>& lines,
                       hid_t space, const StateArray& array) {
  const PaddedText text(lines);
  const Handle type = text_type(text.width), made = dataset(group, name, type, space, array);
  write_lengths(made, lines);
  if (!lines.empty()) checked(H5Dwrite(made, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.bytes.data()), name);
}

void FileWriter::array(const std::string& name, const StateArray& array, bool as_frame) {
  std::string folder;
  const std::string own = split(name, folder);
  const Handle parent = group(folder), space = dataspace(array.shape, as_frame);
  std::visit([&](const auto& numbers) { write(parent, own, numbers, space, array); }, array.values);
}

Handle FileWriter::growing(const std::string& name, hid_t type, const StateArray& array,
                           const std::string& label) {
  constexpr hsize_t numbers_of_a_piece = 64;  // of datasets with one number a frame
  std::string folder;
  const std::string own = split(name, folder);
  const Handle parent = group(folder);
  std::vector<hsize_t> now(array.shape.begin(), array.shape.end()), most, piece;
  now.insert(now.begin(), 0);
  most = piece = now;
  most[0] = H5S_UNLIMITED;
  piece[0] = array.shape.empty() ? numbers_of_a_piece : 1;
  const Handle space(H5Screate_simple(int(now.size()), now.data(), most.data()), H5Sclose, name);
  const Handle properties(H5Pcopy(dataset_properties_), H5Pclose, name);
  checked(H5Pset_chunk(properties, int(piece.size()), piece.data()), name);
  Handle made(H5Dcreate2(parent, own.c_str(), type, space, H5P_DEFAULT, properties, H5P_DEFAULT), H5Dclose,
              name);
  if (!label.empty())
    write_variable_attribute(made, label_attribute, label);
  else
    write_variable_attribute(made, unit_attribute, array.unit.empty() ? "1" : h5md_unit(array.unit));
  return made;
}

void FileWriter::append(const std::string& name, const StateArray& array, std::uint64_t frame,
                        const std::string& label) {
  std::visit(
      [&]<class T>(const std::vector<T>& numbers) {
        if constexpr (!std::is_same_v<T, std::string>) {
          const Handle grown = frame == 0
                                   ? growing(name, file_type<T>(), array, label)
                                   : Handle(H5Dopen2(file_, name.c_str(), H5P_DEFAULT), H5Dclose, name);
          std::vector<hsize_t> extents(array.shape.begin(), array.shape.end());
          extents.insert(extents.begin(), frame + 1);
          checked(H5Dset_extent(grown, extents.data()), name);
          const Handle space(H5Dget_space(grown), H5Sclose, name),
              memory = dataspace({numbers.size()}, false);
          std::vector<hsize_t> offset(extents.size(), 0);
          offset[0] = frame, extents[0] = 1;
          checked(H5Sselect_hyperslab(space, H5S_SELECT_SET, offset.data(), nullptr, extents.data(), nullptr),
                  name);
          checked(H5Dwrite(grown, memory_type<T>(), memory, space, H5P_DEFAULT, numbers.data()), name);
        }
      },
      array.values);
}

void FileWriter::link(const std::string& existing, const std::string& name) {
  std::string folder;
  const std::string own = split(name, folder);
  const Handle parent = group(folder);
  checked(H5Lcreate_hard(file_, existing.c_str(), parent, own.c_str(), H5P_DEFAULT, H5P_DEFAULT), name);
}

}  // namespace scree::state_file
