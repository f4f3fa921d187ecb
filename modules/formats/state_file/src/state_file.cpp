#include "backend.hpp"
#include "opened_file.hpp"
#include "seal.hpp"
#include "state_path.hpp"

#include <stdexcept>

#include <fmt/format.h>

#include <scree/counted.hpp>
#include <scree/error.hpp>
#include <scree/files/part_file.hpp>
#include <scree/state_file/state_file.hpp>

namespace scree::state_file {
namespace {

// Checks what an HDF5 file relies on, before anything is written.
void check(const State& state) {
  for (const auto& [path, array] : state.arrays()) {
    if (!is_state_path(path)) throw std::invalid_argument(fmt::format("'{}' is not a path of a state", path));
    for (std::size_t end = path.find('/'); end != path.npos; end = path.find('/', end + 1))
      if (state.has(path.substr(0, end)))
        throw std::invalid_argument(fmt::format("the state has '{}' and '{}'", path, path.substr(0, end)));
    std::size_t size = 1;
    for (const std::size_t extent : array.shape) size *= extent;
    if (size != array.size())
      throw std::invalid_argument(
          fmt::format("'{}' has {} in a shape of {}", path, counted(array.size(), "value"), size));
  }
}

}  // namespace

void write_state(const std::filesystem::path& path, const State& state) {
  check(state);
  StateBackend& backend = load_backend(path);
  files::PartFile file(path);
  try {
    backend.write(name_of(file.descriptor()), state);
  } catch (const Error& error) {
    throw Error(path.string(), fmt::format("cannot be written ({})", error.what()),
                "check the space on the disk and the limit on the size of files", ExitStatus::failure);
  }
  write_seal(file.descriptor(), path);
  file.commit();
}

State read_state(const std::filesystem::path& path) { return OpenedFile(path).state(); }

}  // namespace scree::state_file
