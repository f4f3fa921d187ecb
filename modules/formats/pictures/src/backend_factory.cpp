#include "files/frame_check.hpp"
#include "files/frame_transfer.hpp"
#include "files/mesh_file.hpp"
#include "files/png_file.hpp"
#include "files/pvd_index.hpp"
#include "files/vtp.hpp"
#include "scene/scene_picture.hpp"

#include <scree/files/text_file.hpp>
#include <scree/pictures/backend.hpp>
#include <scree/pictures/frame_files.hpp>

namespace scree::pictures {
namespace {

void add_to_series(const std::filesystem::path& directory, const char* kind, const Frame& frame,
                   const std::string& content) {
  PvdIndex index(directory / frame_index(kind));
  const std::string file_name = frame_file(kind, frame.step);
  files::write_in_folder(directory / file_name, content);
  index.put(file_name, frame.time);
  index.save();
}

class VtkBackend final : public SnapshotBackend {
 public:
  void write_frame(const Frame& frame, const std::filesystem::path& directory) override {
    check_columns(frame);
    add_to_series(directory, frame_kinds[0], frame, contacts_vtp(frame));
    if (!frame.surfaces.empty()) add_to_series(directory, surface_kind, frame, surfaces_vtp(frame));
    add_to_series(directory, frame_kinds[1], frame, particles_vtp(frame));
  }

  Frame read_frame(const std::filesystem::path& particles_file) override {
    return read_vtp_apart(particles_file);
  }

  void render(const Frame& frame, const RenderOptions& options,
              const std::filesystem::path& png_file) override {
    write_png(scene_picture(context_, frame, options), png_file);
  }

  void render_arrows(const Frame& frame, const ArrowField& arrows, const RenderOptions& options,
                     const std::filesystem::path& png_file) override {
    write_png(arrow_picture(context_, frame, arrows, options), png_file);
  }

  std::vector<double> read_mesh(const std::filesystem::path& file) override { return read_mesh_file(file); }

  Picture read_png(const std::filesystem::path& png_file) override { return pictures::read_png(png_file); }

 private:
  OffscreenContext context_;
};

}  // namespace
}  // namespace scree::pictures

// Returns null if the program was built against another version of the interface.
extern "C" __attribute__((visibility("default"))) scree::pictures::SnapshotBackend*
scree_create_snapshot_backend(int version) {
  return version == scree::pictures::backend_version ? new scree::pictures::VtkBackend : nullptr;
}
