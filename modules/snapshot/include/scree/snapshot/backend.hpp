#pragma once

#include <filesystem>

#include <scree/snapshot/chart_spec.hpp>
#include <scree/snapshot/frame.hpp>
#include <scree/snapshot/picture.hpp>
#include <scree/snapshot/render_options.hpp>

namespace scree::snapshot {

// Raised when this interface or a struct it takes changes; loader and library must agree.
inline constexpr int backend_version = 1;

// Files and pictures of frames. One object serves one thread at a time. Missing directories are created; a
// file appears under its name only when it is complete. Every function throws scree::Error with path and
// cure.
class SnapshotBackend {
 public:
  virtual ~SnapshotBackend() = default;

  // Writes particles_<step>.vtp and contacts_<step>.vtp (ten digits) and adds them to particles.pvd and
  // contacts.pvd. A series that the directory already holds is continued; the same step is replaced.
  virtual void write_frame(const Frame& frame, const std::filesystem::path& directory) = 0;

  // The frame of a particles file and, where it lies beside it, of its contacts file; time from particles.pvd
  // where the file itself has none.
  virtual Frame read_frame(const std::filesystem::path& particles_file) = 0;

  // Draws the frame into a PNG file. Orthographic: the scene's box fits the panel left of the colour bar.
  virtual void render(const Frame& frame, const RenderOptions& options,
                      const std::filesystem::path& png_file) = 0;

  // Draws a diagram into a PNG file.
  virtual void chart(const ChartSpec& spec, const std::filesystem::path& png_file) = 0;

  // The pixels of a PNG file, without its transparency.
  virtual Picture read_png(const std::filesystem::path& png_file) = 0;
};

}  // namespace scree::snapshot
