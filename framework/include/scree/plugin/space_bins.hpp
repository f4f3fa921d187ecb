#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <optional>
#include <string>

#include <scree/plugin/averaging_frame.hpp>
#include <scree/plugin/probe.hpp>
#include <scree/plugin/walls.hpp>

namespace scree {

// The part of space in which a probe averages, and its bins: keys of the probe.
//
//   scree::SpaceBins bins;
//   in declare    bins.declare(d);
//   in prepare    bins.check(setup);
//   in start      return bins.problem(view);
//   in describe   instance.total_count = bins.totals() + ...; instance.passes = bins.passes() + ...;
//   in accumulate if (bins.finds_followed(part, pass, totals)) return;
//                 const scree::AveragingFrame frame = bins.frame(part);   further totals from bins.totals() on
//   in sample     const scree::AveragingFrame frame = bins.frame(view);
struct SpaceBins {
  int region = AveragingFrame::enclosed, along = 0, axis = 2, bins = 1;
  std::optional<std::array<double, 3>> lower, upper, centre;
  double radius = std::numeric_limits<double>::quiet_NaN(), length = radius, radius_low = radius,
         radius_high = radius, follow = 0;

  void declare(Declaration& d) {
    declare_region(d);
    d.integer("bins", bins, "", Range{.minimum = 1, .maximum = 1000},
              "of equal width, of which each has columns with its number");
    d.choice("along", along, "x|y|z|radius", "direction of the bins; radius: shells of a sphere or cylinder");
  }
  // For a probe with one bin.
  void declare_region(Declaration& d) {
    d.choice("region", region, "enclosed|box|sphere|cylinder|cone",
             "where bodies and contacts count; enclosed: between planes, or a period");
    d.vector("lower", lower, "m", "lower corner of region = \"box\"");
    d.vector("upper", upper, "m", "upper corner of region = \"box\"");
    d.vector("centre", centre, "m",
             "of region = \"sphere\", \"cylinder\" or \"cone\"; with follow, from that body on");
    d.number("radius", radius, "m", positive, "of region = \"sphere\" or \"cylinder\"").optional();
    d.number("radius_low", radius_low, "m", non_negative,
             "of region = \"cone\" at its lower end along its axis")
        .optional();
    d.number("radius_high", radius_high, "m", non_negative, "of region = \"cone\" at its upper end")
        .optional();
    d.number("length", length, "m", positive, "of region = \"cylinder\" or \"cone\" along its axis")
        .optional();
    d.choice("axis", axis, "x|y|z", "of region = \"cylinder\" or \"cone\"");
    d.number("follow", follow, "", body_ids, "id of a body with which the region moves").optional();
  }

  void check(const Setup& setup) const {
    check_that_keys_count(setup);
    if (region == AveragingFrame::box && !(lower && upper))
      return setup.refuse("region = \"box\" lacks lower or upper; add both corners");
    if (round() && !is_cone() && (!centre || std::isnan(radius)))
      return setup.refuse("the region lacks centre or radius; add both");
    if (is_cone() && radius_low + radius_high == 0)
      return setup.refuse("both radii of the cone are 0; give one above 0");
    if (is_cone() && !(centre && radius_low + radius_high > 0))
      return setup.refuse("the cone lacks centre, radius_low or radius_high; add all");
    if (has_axis() && setup.dimension() == 2)
      return setup.refuse("a 2D scene has no cylinders; choose region = \"sphere\", which is a circle there");
    if (has_axis() && std::isnan(length))
      return setup.refuse(is_cone() ? "region = \"cone\" lacks length; add it"
                                    : "region = \"cylinder\" lacks length; add it");
    if (along == AveragingFrame::radial && (!round() || is_cone()))
      return setup.refuse("shells along = \"radius\" need region = \"sphere\" or \"cylinder\"; choose one");
    if (is_cone() && bins > 1 && along != axis)
      return setup.refuse("bins of a cone lie along its axis; set along to it");
    if (along == 2 && setup.dimension() == 2) return setup.refuse("a 2D scene has no z axis; choose x or y");
    if (region == AveragingFrame::cylinder && bins > 1 && along != AveragingFrame::radial && along != axis)
      return setup.refuse("bins of a cylinder lie along its axis or its radius; choose one of them");
    if (follow > 0 && region == AveragingFrame::enclosed)
      return setup.refuse("a region that follows a body is a box, sphere, cylinder or cone; choose one");
    for (int k = 0; region == AveragingFrame::box && k < setup.dimension(); ++k)
      if (!((*lower)[std::size_t(k)] < (*upper)[std::size_t(k)]))
        return setup.refuse(
            "upper is not above lower along each axis; exchange them, or give a larger upper");
  }

  // The problem and a remedy if the scene does not have the region, or "".
  std::string problem(const scree_view& view) const {
    if (follow > 0 && followed(view) == view.body_count)
      return "the scene has no body with the id of follow; give an id of the scene";
    const int dimension = int(view.dimension);
    for (int k = 0; k < dimension; ++k) {
      const char name = "xyz"[k];
      if (region == AveragingFrame::enclosed && std::isnan(view.length[k]))
        return std::string("the scene is not enclosed along ") + name +
               (view.surface_count == 0
                    ? "; give region = \"box\" with lower and upper"
                    : " by planes, and this region does not end at cylinders, meshes and other "
                      "surfaces; give region = \"cylinder\", \"cone\", \"sphere\" or \"box\"");
      if (region == AveragingFrame::enclosed && bins > 1 && along == k && view.period[k] > 0)
        return std::string("bins along the periodic axis ") + name +
               " have no first one; give region = \"box\" with lower and upper";
      if (region != AveragingFrame::enclosed && view.period[k] > 0 &&
          extent(k) > view.period[k] * (1 + 1e-12))
        return std::string("the region is longer than the period along ") + name + "; give a smaller one";
    }
    const AveragingFrame now = frame_about({}, view);  // volumes are the same anywhere
    for (int bin = 0; bin < bins; ++bin)
      if (const double volume = now.volume(bin); !(volume > 0 && std::isfinite(volume)))
        return std::string("the volume of the region or of a bin is ") + (volume == 0 ? "0" : "infinite") +
               " in the numbers of a computer; give a " + (volume == 0 ? "larger" : "smaller") + " region";
    return "";
  }

  // What a probe with totals needs to follow a body: its position comes first in them, in a pass before
  // others.
  std::uint32_t totals() const { return follow > 0 ? 3 : 0; }
  std::uint32_t passes() const { return follow > 0 ? 1 : 0; }
  bool finds_followed(const scree_view& part, std::uint32_t pass, double* totals) const {
    if (pass >= passes()) return false;
    for (std::uint64_t i = part.part_begin; i < part.part_end; ++i)
      if (double(part.id[i]) == follow)
        for (int k = 0; k < 3; ++k) totals[k] += vector_of(part.position, i)[k];
    return true;
  }

  AveragingFrame frame(const scree_view& view) const { return frame_about(place_of_followed(view), view); }

  // Name of a column of a bin, counted from 0: without a number if there is one bin.
  std::string numbered(const char* name, std::uint32_t bin) const {
    return bins == 1 ? name : std::string(name) + "_" + std::to_string(bin + 1);
  }

 private:
  // from: place of the followed body (m), or 0.
  AveragingFrame frame_about(const Vec3& from, const scree_view& view) const {
    AveragingFrame f;
    f.dimension = int(view.dimension);
    f.region = AveragingFrame::Region(region);
    f.along = along;
    f.axis = axis;
    f.bins = bins;
    for (int k = 0; k < 3; ++k) set_axis(view, from, k, f);
    if (centre) f.centre = from + Vec3{{(*centre)[0], (*centre)[1], (*centre)[2]}};
    f.radius = is_cone() ? std::max(radius_low, radius_high) : radius;
    f.radius_low = radius_low;
    f.radius_high = radius_high;
    f.length = length;
    return f.with_edges();
  }
  bool is_cone() const { return region == AveragingFrame::cone; }
  bool has_axis() const { return region == AveragingFrame::cylinder || is_cone(); }
  bool round() const { return region == AveragingFrame::sphere || has_axis(); }
  // Keys of another region would change nothing.
  void check_that_keys_count(const Setup& setup) const {
    if (region != AveragingFrame::box && (lower || upper))
      return setup.refuse("lower and upper belong to region = \"box\"; set it, or remove them");
    if ((!round() && centre) || ((!round() || is_cone()) && !std::isnan(radius)))
      return setup.refuse(
          "centre and radius belong to region = \"sphere\" or \"cylinder\"; set it, or remove them");
    if (!is_cone() && !(std::isnan(radius_low) && std::isnan(radius_high)))
      return setup.refuse("radius_low and radius_high belong to region = \"cone\"; set it, or remove them");
    if (!has_axis() && (!std::isnan(length) || axis != 2))
      return setup.refuse(
          "length and axis belong to region = \"cylinder\" or \"cone\"; set it, or remove them");
  }
  // (m) 0 if the region follows none.
  Vec3 place_of_followed(const scree_view& view) const {
    if (!(follow > 0)) return {};
    if (view.totals) return {{view.totals[0], view.totals[1], view.totals[2]}};
    const std::uint64_t leader = followed(view);
    return leader < view.body_count ? vector_of(view.position, leader) : Vec3{};
  }
  std::uint64_t followed(const scree_view& view) const {
    for (std::uint64_t i = 0; i < view.body_count; ++i)
      if (double(view.id[i]) == follow) return i;
    return view.body_count;
  }
  double extent(int k) const {
    if (region == AveragingFrame::box) return (*upper)[std::size_t(k)] - (*lower)[std::size_t(k)];
    return has_axis() && k == axis ? length : 2 * (is_cone() ? std::max(radius_low, radius_high) : radius);
  }
  void set_axis(const scree_view& view, const Vec3& from, int k, AveragingFrame& f) const {
    f.period[k] = view.period[k];
    if (region == AveragingFrame::box && lower && upper) {
      f.lower[k] = from[k] + (*lower)[std::size_t(k)];
      f.upper[k] = from[k] + (*upper)[std::size_t(k)];
      return;
    }
    // Between the walls, as they are now.
    f.lower[k] = wall_height({view.planes, view.plane_count}, k, 1, view.plane_absent);
    f.upper[k] = wall_height({view.planes, view.plane_count}, k, -1, view.plane_absent);
    f.enclosed_length[k] = view.length[k];
  }
};

}  // namespace scree
