#include "backend.hpp"
#include "opened_file.hpp"

#include <fmt/format.h>

#include <scree/error.hpp>
#include <scree/files/part_file.hpp>
#include <scree/state_file/trajectory.hpp>

namespace scree::state_file {
namespace {

template <class Work>
void writing(const std::filesystem::path& path, const Work& work) {
  try {
    work();
  } catch (const Error& error) {
    throw Error(path.string(), fmt::format("cannot be written ({})", error.what()),
                "check the space on the disk and the limit on the size of files", ExitStatus::failure);
  }
}

template <class Work>
void reading(const std::filesystem::path& path, const Work& work) {
  try {
    work();
  } catch (const Error& error) {
    throw Error(path.string(), fmt::format("cannot be read ({})", error.what()),
                "put it back as the run wrote it, or begin the run anew with --overwrite");
  }
}

}  // namespace

void append_frame(const std::filesystem::path& path, const TrajectoryFrame& frame, std::uint64_t frames) {
  StateBackend& backend = load_backend(path);
  writing(path, [&] { backend.append_frame(path, frame, frames); });
}

void check_frames(const std::filesystem::path& path, std::uint64_t frames) {
  StateBackend& backend = load_backend(path);
  reading(path, [&] { backend.check_frames(path, frames); });
}

void cut_frames(const std::filesystem::path& path, std::uint64_t frames) {
  StateBackend& backend = load_backend(path);
  files::PartFile part(path);
  for (std::uint64_t k = 0; k < frames; ++k) {
    TrajectoryFrame frame;
    reading(path, [&] { frame = backend.frame(path, k); });
    writing(path, [&] { backend.append_frame(name_of(part.descriptor()), frame, k); });
  }
  part.commit();
}

}  // namespace scree::state_file
