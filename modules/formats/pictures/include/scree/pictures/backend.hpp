#pragma once

#include <filesystem>
#include <vector>

#include <scree/pictures/arrow_field.hpp>
#include <scree/pictures/frame.hpp>
#include <scree/pictures/picture.hpp>
#include <scree/pictures/render_options.hpp>

namespace scree::pictures {

// Incremented when this interface or a struct in it changes; loader and library must have the same version.
inline constexpr int backend_version = 8;

// Reads and writes frames, reads meshes and draws pictures. Not thread-safe. The directory of a file is
// created, but none above; a file gets its final name only when it is complete. Every function throws
// scree::Error with path and cure.
class SnapshotBackend {
 public:
  virtual ~SnapshotBackend() = default;

  // Writes particles_<step>.vtp, contacts_<step>.vtp and, if there are any, surfaces_<step>.vtp (ten
  // digits) and adds them to particles.pvd, contacts.pvd and surfaces.pvd. An existing series in the
  // directory is continued; a frame of the same step is replaced.
  virtual void write_frame(const Frame& frame, const std::filesystem::path& directory) = 0;

  // Reads a frame from a particles file and, if they exist, the contacts and surfaces files in the same
  // directory. The time
  // is taken from particles.pvd if the file has none.
  virtual Frame read_frame(const std::filesystem::path& particles_file) = 0;

  // Draws the frame to a PNG file. Orthographic: the box of the scene fits the panel left of the colour bar.
  virtual void render(const Frame& frame, const RenderOptions& options,
                      const std::filesystem::path& png_file) = 0;

  // The same with an arrow at each body, coloured by its length, and bodies drawn small and
  // pale.
  virtual void render_arrows(const Frame& frame, const ArrowField& arrows, const RenderOptions& options,
                             const std::filesystem::path& png_file) = 0;

  // The triangles of an STL, OBJ, PLY or VTP file as a parameter of the type SCREE_MESH_FILE; polygons are
  // divided. VTK reads all but VTP with single precision.
  virtual std::vector<double> read_mesh(const std::filesystem::path& file) = 0;

  // Pixels of a PNG file; transparency is dropped.
  virtual Picture read_png(const std::filesystem::path& png_file) = 0;
};

}  // namespace scree::pictures
