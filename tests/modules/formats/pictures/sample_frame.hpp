#pragma once

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <unistd.h>

#include <scree/error.hpp>
#include <scree/pictures/load_backend.hpp>

namespace scree::pictures {

// One backend for all tests, as in a run of the program.
inline SnapshotBackend& backend() {
  static const std::shared_ptr<SnapshotBackend> shared = load_backend();
  return *shared;
}

// An empty directory, removed after the test.
class ScratchDirectory {
 public:
  ScratchDirectory() {
    std::string name = (std::filesystem::temp_directory_path() / "scree-snapshot-XXXXXX").string();
    path_ = mkdtemp(name.data());
  }
  ~ScratchDirectory() {
    std::filesystem::permissions(path_, std::filesystem::perms::owner_all);
    std::filesystem::remove_all(path_);
  }
  ScratchDirectory(const ScratchDirectory&) = delete;
  ScratchDirectory& operator=(const ScratchDirectory&) = delete;

  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

inline std::string read_text(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

// Message of the scree::Error that an action throws; empty if it throws none.
template <class Action>
std::string error_of(Action action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

// Of the particles of the sample.
inline constexpr const char* particles_file = "particles_0123456789.vtp";

// Values without short decimal form, so that lost bits are detected.
inline Frame sample_frame() {
  Frame frame;
  frame.time = 0.1 + 0.2;
  frame.step = 123456789;
  frame.title = "drum \"A\" <b> & µ = 0.3";
  const int n = 7;
  for (int i = 0; i < n; ++i) {
    frame.id.push_back((std::int64_t{1} << 60) + i);
    frame.radius.push_back(0.005 / std::sqrt(i + 2.0));
    frame.material.push_back(i % 3);
    frame.coordination.push_back(n - i);
    for (int k = 0; k < 3; ++k) {
      frame.position.push_back(std::sin(1.0 + 3 * i + k));
      frame.velocity.push_back(1e-200 * std::cos(3.0 * i + k));
      frame.spin.push_back(1e200 * std::tan(3.0 * i + k));
      frame.force.push_back(k == 0 ? -0.0 : std::exp(-i * k));
      frame.displacement.push_back(std::sin(7.0 * i - k));
    }
    frame.group.push_back(i % 3 - 1);
  }
  frame.groups = {"floor", "a \"lid\""};
  for (int c = 0; c < 4; ++c) {
    for (int k = 0; k < 3; ++k) {
      frame.contact_from.push_back(frame.position[3 * c + k]);
      frame.contact_to.push_back(frame.position[3 * c + 3 + k]);
    }
    frame.contact_normal_force.push_back(std::sqrt(c + 3.0));
    frame.contact_tangential_force.push_back(std::cbrt(c + 3.0));
    frame.contact_overlap.push_back(1e-6 / (c + 3));
    frame.contact_sliding.push_back(c % 2 == 1);
    frame.contact_a.push_back(frame.id[c]);
    frame.contact_b.push_back(c < 3 ? frame.id[c + 1] : -1);
    frame.contact_wall.push_back(c < 3 ? -1 : 1);
    for (int k = 0; k < 3; ++k) {
      frame.contact_normal.push_back(std::cos(2.0 * c + k));
      frame.contact_force.push_back(std::exp(-c * k - 1.0));
      frame.contact_point.push_back(std::sin(5.0 * c + k));
    }
  }
  frame.walls = {{"floor", {0, 0, -1}, {0, 0, 1}}, {"slope", {-1, 0, 0}, {0.6, 0, 0.8}}};
  frame.lower = {-1, -1, -1};
  frame.upper = {1, 1.1, 1};
  return frame;
}

}  // namespace scree::pictures
