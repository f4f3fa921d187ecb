#include "backend.hpp"
#include "bodies_writer.hpp"
#include "file_reader.hpp"
#include "file_writer.hpp"
#include "h5md_place.hpp"
#include "seal.hpp"
#include "state_path.hpp"
#include "trajectory_file.hpp"

#include <optional>
#include <string_view>

#include <scree/error.hpp>

namespace scree::state_file {
namespace {

constexpr std::string_view own_group = "scree/";

// Path of the array that a dataset holds; none for datasets that are written for other programs.
std::optional<std::string> path_of(const std::string& dataset) {
  if (const auto path = path_at(dataset)) return path;
  if (!dataset.starts_with(own_group)) return std::nullopt;
  return dataset.substr(own_group.size());
}

// Failures are reported by Error alone. HDF5 keeps this setting for each thread.
void print_no_failures() { checked(H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr), "messages"); }

class Hdf5Backend final : public StateBackend {
 public:
  Hdf5Backend() {
    // At the end of the program HDF5 would close again what it could not close, and crash. The call has no
    // effect if other code has used HDF5 before.
    H5dont_atexit();
    if (H5open() < 0)
      throw Error("libscree_state_hdf5.so", "HDF5 cannot be started",
                  "give the program more memory (ulimit -v)");
  }

  void write(const std::filesystem::path& file, const State& state) override {
    print_no_failures();
    FileWriter writer(file, Seal::size);
    write_h5md_group(writer);
    writer.group("scree");
    BodiesWriter bodies(writer, state);
    for (const auto& [path, array] : state.arrays())
      if (!bodies.write(path, array)) writer.array(std::string(own_group) + path, array, false);
    writer.close();
  }

  std::vector<PlacedArray> places(const std::filesystem::path& file) override {
    print_no_failures();
    FileReader reader(file);
    std::vector<PlacedArray> arrays;
    for (const std::string& dataset : reader.datasets()) {
      const auto path = path_of(dataset);
      if (!path) continue;
      if (!is_state_path(*path)) throw Error("/" + dataset + " is not the name of an array of a state");
      const auto place = h5md_place(*path);
      const bool of_bodies = !dataset.starts_with(own_group);
      arrays.push_back(reader.array(dataset, of_bodies && place->as_frame));
      arrays.back().path = *path;
    }
    return arrays;
  }

  void append_frame(const std::filesystem::path& file, const TrajectoryFrame& frame,
                    std::uint64_t frames) override {
    print_no_failures();
    append_to_trajectory(file, frame, frames);
  }
  void check_frames(const std::filesystem::path& file, std::uint64_t frames) override {
    print_no_failures();
    check_trajectory(file, frames);
  }
  TrajectoryFrame frame(const std::filesystem::path& file, std::uint64_t number) override {
    print_no_failures();
    return frame_of_trajectory(file, number);
  }
};

}  // namespace
}  // namespace scree::state_file

// Returns null if the program was built against another version of the interface.
extern "C" __attribute__((visibility("default"))) scree::state_file::StateBackend* scree_create_state_backend(
    int version) {
  return version == scree::state_file::backend_version ? new scree::state_file::Hdf5Backend : nullptr;
}
