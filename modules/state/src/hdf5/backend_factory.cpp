#include "backend.hpp"
#include "bodies_writer.hpp"
#include "file_reader.hpp"
#include "file_writer.hpp"
#include "h5md_place.hpp"
#include "state_path.hpp"

#include <optional>
#include <string_view>

#include <scree/error.hpp>

namespace scree::state_file {
namespace {

constexpr std::string_view own_group = "scree/";

// Path of the array at a place of the file, and whether it has a leading dimension for the time; none for what
// is there for other programs.
std::optional<std::string> path_of(const FileReader& reader, const std::string& link) {
  if (const auto path = path_at(link)) return path;
  if (!link.starts_with(own_group) || reader.is_group(link)) return std::nullopt;
  return link.substr(own_group.size());
}

class Hdf5Backend final : public StateBackend {
 public:
  Hdf5Backend() {
    // At the end of the program HDF5 would close again what it could not close, and crash. It is too late to say so
    // where other code has used HDF5 before.
    H5dont_atexit();
    checked(H5open(), "HDF5");
    checked(H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr), "HDF5");  // failures are reported by Error alone
  }

  void write(const std::filesystem::path& file, const State& state) override {
    FileWriter writer(file);
    write_h5md_group(writer);
    writer.group("scree");
    BodiesWriter bodies(writer, state);
    for (const auto& [path, array] : state.arrays())
      if (!bodies.write(path, array)) writer.array(std::string(own_group) + path, array, false);
    writer.close();
  }

  State read(const std::filesystem::path& file, double largest) override {
    FileReader reader(file, largest);
    State state;
    for (const std::string& link : reader.links()) {
      const auto path = path_of(reader, link);
      if (!path) continue;
      if (!is_state_path(*path)) throw Error("/" + link + " is not the name of an array of a state");
      const auto place = h5md_place(*path);
      const bool of_bodies = !link.starts_with(own_group);
      state.put(*path, reader.array(link, of_bodies && place->as_frame));
    }
    return state;
  }
};

}  // namespace
}  // namespace scree::state_file

// Returns null if the program was built against another version of the interface.
extern "C" __attribute__((visibility("default"))) scree::state_file::StateBackend* scree_create_state_backend(
    int version) {
  return version == scree::state_file::backend_version ? new scree::state_file::Hdf5Backend : nullptr;
}
