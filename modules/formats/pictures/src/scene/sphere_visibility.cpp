#include "sphere_visibility.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace scree::pictures {
namespace {

// Nearest sphere at the centre of each pixel.
class DepthImage {
 public:
  // cut: half-spaces in pixels, out of which nothing is drawn.
  DepthImage(int width, int height, std::vector<HalfSpace> cut, DepthMemory& memory)
      : width_(width), height_(height), cut_(std::move(cut)), depth_(memory.depth), owner_(memory.owner) {
    depth_.assign(std::size_t(width) * std::size_t(height), -std::numeric_limits<float>::infinity());
    owner_.assign(depth_.size(), -1);
  }

  // x, y: centre; z: depth towards the viewer; all in pixels.
  void draw(int sphere, double x, double y, double z, double radius) {
    const int bottom = std::max(0, int(std::ceil(y - radius - 0.5)));
    const int top = std::min(height_ - 1, int(std::floor(y + radius - 0.5)));
    for (int row = bottom; row <= top; ++row) {
      const double dy = row + 0.5 - y;
      const double half = std::sqrt(std::max(0.0, radius * radius - dy * dy));
      const int left = std::max(0, int(std::ceil(x - half - 0.5)));
      const int right = std::min(width_ - 1, int(std::floor(x + half - 0.5)));
      for (int column = left; column <= right; ++column) {
        const double dx = column + 0.5 - x;
        const double rise = std::sqrt(std::max(0.0, half * half - dx * dx));
        const float depth =
            float(cut_.empty() ? z + rise : front(column + 0.5, row + 0.5, z - rise, z + rise));
        const std::size_t pixel = std::size_t(row) * width_ + column;
        const bool nearer = depth > depth_[pixel];
        depth_[pixel] = nearer ? depth : depth_[pixel];
        owner_[pixel] = nearer ? sphere : owner_[pixel];
      }
    }
  }

  const std::vector<int>& owners() const { return owner_; }

 private:
  // The front end of what the cut leaves between two depths at a pixel; minus infinity if nothing.
  double front(double x, double y, double back, double front) const {
    for (const auto& [normal, offset] : cut_) {
      const double rest = offset - normal[0] * x - normal[1] * y;
      if (std::abs(normal[2]) < 1e-9) {
        if (rest > 0) return -std::numeric_limits<double>::infinity();
      } else {
        double& end = normal[2] > 0 ? back : front;
        end = normal[2] > 0 ? std::max(back, rest / normal[2]) : std::min(front, rest / normal[2]);
      }
    }
    return back < front ? front : -std::numeric_limits<double>::infinity();
  }

  int width_;
  int height_;
  std::vector<HalfSpace> cut_;
  std::vector<float>& depth_;
  std::vector<int>& owner_;
};

}  // namespace

std::vector<std::size_t> visible_spheres(const Frame& frame, const SceneCamera& camera, int width, int height,
                                         const std::vector<HalfSpace>& cut, DepthMemory& memory) {
  const double pixels_per_metre = height / (2 * camera.half_height);
  std::vector<HalfSpace> cut_in_pixels;
  for (const auto& [normal, offset] : cut)
    cut_in_pixels.push_back(
        {normal, pixels_per_metre * offset + normal[0] * width / 2.0 + normal[1] * height / 2.0});
  DepthImage image(width, height, std::move(cut_in_pixels), memory);
  for (std::size_t k = 0; k < frame.particle_count(); ++k) {
    const double* position = frame.position.data() + 3 * k;
    const Point offset = moved({position[0], position[1], position[2]}, -1, camera.center);
    image.draw(int(k), width / 2.0 + pixels_per_metre * dot(offset, camera.axes.right),
               height / 2.0 + pixels_per_metre * dot(offset, camera.axes.up),
               pixels_per_metre * dot(offset, camera.axes.toward), pixels_per_metre * frame.radius[k]);
  }
  std::vector<char> seen(frame.particle_count(), 0);
  for (int owner : image.owners())
    if (owner >= 0) seen[owner] = 1;
  std::vector<std::size_t> visible;
  for (std::size_t k = 0; k < seen.size(); ++k)
    if (seen[k]) visible.push_back(k);
  return visible;
}

}  // namespace scree::pictures
