#include "contacts/shape_contacts.hpp"

#include "machine/instruction_levels.hpp"
#include "machine/lanes.hpp"
#include "surfaces/shape_points.hpp"

namespace scree {

namespace {

template <std::size_t most>
Vec3 lane(const double (&columns)[3][most], std::size_t k) {
  return {{columns[0][k], columns[1][k], columns[2][k]}};
}
template <std::size_t most>
void set_lane(double (&columns)[3][most], std::size_t k, const Vec3& v) {
  for (int c = 0; c < 3; ++c) columns[c][k] = v[c];
}

}  // namespace

// Private to this file, see SCREE_EVERY_LEVEL.
struct ShapeContacts::Loops {
  // Without structures of several vectors, which GCC would not keep in registers.
  template <class Nearest>
  static void find(const PlacedSurface& placed, const Nearest& nearest_to, ShapeContacts& c) {
    const PlacedSurface surface = placed;  // no store can change it
    const std::size_t padded = (c.count_ + SCREE_LANES - 1) / SCREE_LANES * SCREE_LANES;
#pragma GCC ivdep
    for (std::size_t k = 0; k < padded; ++k) {
      const NearestPoint nearest = nearest_to(surface.in_frame(lane(c.x_, k))),
                         middle = nearest_to(surface.mid_in_frame(lane(c.middle_, k)));
      const Vec3 point = surface.point_in_scene(nearest.point);
      set_lane(c.point_, k, point);
      set_lane(c.normal_, k, surface.to_scene()(nearest.normal));
      set_lane(c.mid_normal_, k, surface.mid_to_scene()(middle.normal));
      set_lane(c.velocity_, k, surface.velocity_at(point));
      set_lane(c.mid_velocity_, k, surface.mid_velocity_at(surface.mid_point_in_scene(middle.point)));
      c.effective_radius_[k] = effective_radius_at(nearest.curvature, 1 / c.radius_[k]);
    }
  }

  SCREE_EVERY_LEVEL_INLINED static void find_flat(const PlacedSurface& surface, ShapeContacts& c) {
    shape::with_nearest<2>(surface.surface(), [&](const auto& nearest) { find(surface, nearest, c); });
  }
  SCREE_EVERY_LEVEL_INLINED static void find_solid(const PlacedSurface& surface, ShapeContacts& c) {
    shape::with_nearest<3>(surface.surface(), [&](const auto& nearest) { find(surface, nearest, c); });
  }
};

void ShapeContacts::add(std::size_t pair, const Body& body) {
  const std::size_t k = count_++;
  pair_[k] = pair;
  beyond_[k] = body.beyond;
  set_lane(x_, k, body.x);
  set_lane(middle_, k, body.middle);
  radius_[k] = body.radius;
}

// Lanes without a body repeat the first one.
void ShapeContacts::find(const PlacedSurface& surface, int dimension) {
  for (std::size_t k = count_; k < most; ++k) {
    set_lane(x_, k, lane(x_, 0));
    set_lane(middle_, k, lane(middle_, 0));
    radius_[k] = radius_[0];
  }
  dimension == 2 ? Loops::find_flat(surface, *this) : Loops::find_solid(surface, *this);
}

SurfacePoint ShapeContacts::point(std::size_t k) const {
  return {lane(point_, k), lane(normal_, k), lane(mid_normal_, k), lane(velocity_, k),
          lane(mid_velocity_, k)};
}

}  // namespace scree
