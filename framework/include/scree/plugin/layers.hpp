#pragma once

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

#include <scree/plugin/probe.hpp>

namespace scree {

// Mean motion of the bodies of a layer along the axis.
struct LayerMotion {
  double bodies = 0;        // number of bodies
  double start = 0;         // mean height when the probe started (m)
  double displacement = 0;  // of the mean height since then (m)
  double velocity = 0;      // (m/s)

  double position() const { return start + displacement; }
};

// Layers of bodies across an axis. Each body belongs to at most one of them, by its height when the probe
// starts, and stays in it; the state of the probe keeps which. Heights follow the paths of bodies without
// jumps at periodic faces.
//
//   scree::Layers layers{.count = 2};
//   in declare     layers.declare(d);
//   in prepare     layers.check(setup);
//   in state_size  return layers.state_size(view);
//   in start       return layers.start_around(view, centres, half_width, state);
//   in sample      layers.motion(view, state)[0].displacement
//   in mark_bodies layers.mark(view, state, marks);
struct Layers {
  // Of columns bodies, position, velocity and displacement.
  static constexpr const char* meanings[] = {"number of bodies", "mean height", "mean along the axis",
                                             "of the mean height since the start"};

  std::uint64_t count = 1;
  int axis = 1;

  void declare(Declaration& d) { d.choice("axis", axis, "x|y|z", "axis along which heights count"); }

  void check(const Setup& setup) const {
    if (axis >= setup.dimension()) setup.refuse("a 2D scene has no z axis; choose x or y");
  }

  // State: for each layer `header` numbers, then for each body the number of its layer, from 1, or 0.
  std::uint64_t state_size(const scree_view& view) const { return header * count + view.body_count; }

  // Height of body i above `from` (m); the height of its nearest image if the axis is periodic.
  double height(const scree_view& view, std::uint64_t i, double from) const {
    const double off = view.position[axis][i] - from, period = view.period[axis];
    return period > 0 ? off - period * std::round(off / period) : off;
  }

  // Puts body i into the layer layer_of(i), or into none if that is no index below `count`, and returns the
  // layers as they are now. centre_of(n): height near the bodies of layer n (m).
  template <class CentreOf, class LayerOf>
  std::vector<LayerMotion> gather(const scree_view& view, const CentreOf& centre_of, const LayerOf& layer_of,
                                  double* state) const {
    for (std::uint64_t n = 0; n < count; ++n) state[header * n + centre] = centre_of(n);
    for (std::uint64_t i = 0; i < view.body_count; ++i) {
      const std::uint64_t n = counts(view, i) ? layer_of(i) : count;
      if (n >= count) continue;
      state[header * count + i] = double(n + 1);
      state[header * n + above] += height(view, i, state[header * n + centre]);
    }
    const std::vector<LayerMotion> moved_from_centre = motion(view, state);
    for (std::uint64_t n = 0; n < count; ++n) {
      state[header * n + above] /= moved_from_centre[n].bodies;
      state[header * n + path] = moved_from_centre[n].displacement;
    }
    return motion(view, state);
  }

  // Layers of all bodies at most half_width (m) from each of `count` heights (m), which must lie further
  // apart. Returns the problem and a remedy if a layer has no body, or "".
  std::string start_around(const scree_view& view, const double* centres, double half_width,
                           double* state) const {
    const auto layer_of = [&](std::uint64_t i) {
      std::uint64_t n = 0;
      while (n < count && !(std::abs(height(view, i, centres[n])) <= half_width)) ++n;
      return n;
    };
    const auto layers = gather(
        view, [&](std::uint64_t n) { return centres[n]; }, layer_of, state);
    for (std::uint64_t n = 0; n < count; ++n)
      if (layers[n].bodies == 0) return without_bodies(view, centres[n], half_width);
    return "";
  }

  // Sets the marks of the bodies that are in a layer.
  void mark(const scree_view& view, const double* state, std::uint8_t* marks) const {
    for (std::uint64_t i = 0; i < view.body_count; ++i) marks[i] = state[header * count + i] >= 1;
  }

  // The layers as they are now.
  std::vector<LayerMotion> motion(const scree_view& view, const double* state) const {
    std::vector<LayerMotion> layers(count);
    for (std::uint64_t i = 0; i < view.body_count; ++i) {
      const double number = state[header * count + i];
      if (!(number >= 1 && number <= double(count))) continue;
      const auto n = std::size_t(number) - 1;
      layers[n].bodies += 1;
      layers[n].displacement += unwrapped_position(view, i)[axis] - state[header * n + centre];
      layers[n].velocity += view.velocity[axis][i];
    }
    for (std::uint64_t n = 0; n < count; ++n) {
      const double* const kept = state + header * n;
      layers[n].start = kept[centre] + kept[above];
      layers[n].displacement = layers[n].displacement / layers[n].bodies - kept[path];
      layers[n].velocity /= layers[n].bodies;
    }
    return layers;
  }

 private:
  // At the start: height near the bodies, so that sums over them keep their digits; mean height above it, of
  // the nearest images; mean path above it.
  enum : std::uint64_t { centre, above, path, header };

  std::string without_bodies(const scree_view& view, double at, double half_width) const {
    std::uint64_t nearest = view.body_count;
    const auto is_nearer = [&](std::uint64_t i) {
      return nearest == view.body_count ||
             std::abs(height(view, i, at)) < std::abs(height(view, nearest, at));
    };
    for (std::uint64_t i = 0; i < view.body_count; ++i)
      if (counts(view, i) && is_nearer(i)) nearest = i;
    if (nearest == view.body_count) return "there are no bodies to follow; add some";
    const double off = height(view, nearest, at);
    char problem[240];
    std::snprintf(problem, sizeof(problem),
                  "no body lies within half_width = %.6g m of %c = %.6g m; the nearest is body %lld at %c = "
                  "%.6g m: give a height near it, or a half_width above %.6g m",
                  half_width, "xyz"[axis], at, static_cast<long long>(view.id[nearest]), "xyz"[axis],
                  at + off, std::abs(off));
    return problem;
  }
};

}  // namespace scree
