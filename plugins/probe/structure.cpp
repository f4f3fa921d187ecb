// Order of a packing: pair correlation g(r), and coordination without rattlers.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include <scree/plugin/space_bins.hpp>

namespace {

using scree::Vec3;

// A part of space in which pairs are counted, and the places of the bodies there.
struct Window {
  int dimension;
  Vec3 lower, upper, period;  // (m) infinite bounds and the period along periodic axes, else period 0
  std::vector<Vec3> places;

  // Volume within r of a place, in the window.
  double volume_within(const Vec3& place, double r) const {
    bool whole = true;
    for (int k = 0; k < dimension; ++k) whole = whole && place[k] - r >= lower[k] && place[k] + r <= upper[k];
    if (whole) return scree::volume_of_sphere(dimension, r);
    return dimension == 2 ? scree::disc_in_rectangle(place, r, lower, upper)
                          : scree::sphere_in_box(place, r, lower, upper);
  }

  // Calls visit(distance) for each pair of places nearer than `reach`; sorts the places.
  template <class Visit>
  void each_pair(double reach, const Visit& visit) {
    std::sort(places.begin(), places.end(), [](const Vec3& a, const Vec3& b) { return a[0] < b[0]; });
    const auto compare = [&](const Vec3& a, const Vec3& b) {
      Vec3 apart = a - b;
      for (int k = 0; k < dimension; ++k)
        if (period[k] > 0) apart[k] -= period[k] * std::round(apart[k] / period[k]);
      if (const double distance = norm(apart); distance < reach) visit(distance);
    };
    for (std::size_t i = 0; i < places.size(); ++i) {
      for (std::size_t k = i + 1; k < places.size() && places[k][0] - places[i][0] < reach; ++k)
        compare(places[i], places[k]);
      // Across the face of a period.
      for (std::size_t k = 0; k < i && places[k][0] + period[0] - places[i][0] < reach; ++k)
        if (places[i][0] - places[k][0] >= reach) compare(places[i], places[k]);
    }
  }
};

struct StructureProbe {
  scree::SpaceBins region;
  double rattler_below = 2, largest = 0;
  int classes = 100, dimension = 3;

  static constexpr scree::About about = {
      "structure", "pair correlation g(r), and coordination without rattlers, repeated until none is left",
      "g_<k> = Σ_i n_i/(ρ Σ_i V_i)   n_i: centres in class k: (k − 1) w ≤ r < k w of body i, w = largest/classes;\n"
      "V_i: volume of this shell in the region, exact; ρ: centres in the region over its volume. No centre is within a\n"
      "radius of a wall: region = \"box\" away from walls gives g(r) of the interior\n"
      "rattler: a body that is not fixed with fewer than rattler_below contacts, those with rattlers not counted;\n"
      "region (enclosed or box) limits g(r) alone: rattlers and coordination are of the whole scene",
      "—"};

  void declare(scree::Declaration& d) {
    region.declare_region(d);
    d.number("rattler_below", rattler_below, "", scree::positive,
             "a body with fewer contacts than this is a rattler, and its contacts do not count");
    d.number("largest", largest, "m", scree::positive,
             "r at the end of the last class, at most half of a period; without it there is no g(r)")
        .optional();
    d.integer("classes", classes, "", scree::Range{.minimum = 1, .maximum = 1000}, "of g(r)");
  }
  void prepare(const scree::Setup& setup) {
    region.check(setup);
    dimension = setup.dimension();
    if (region.region != scree::AveragingFrame::enclosed && region.region != scree::AveragingFrame::box)
      return setup.refuse("g(r) has a window with flat sides; choose region = \"enclosed\" or \"box\"");
    if (region.region == scree::AveragingFrame::box && !(largest > 0))
      setup.refuse("region = \"box\" is the window of g(r), which lacks largest; add it, or remove region");
  }
  void describe(scree_probe_instance& instance) const {
    instance.needs = SCREE_NEEDS_CONTACTS;
    instance.column_count = std::uint32_t(std::size(names)) + (largest > 0 ? std::uint32_t(classes) : 0);
    instance.leaves_out = 1;
  }
  scree::ColumnName column(std::uint32_t c) const {
    if (c < std::size(names)) return {names[c], "", meanings[c]};
    return {"g_" + std::to_string(c - std::size(names) + 1), "", "pair correlation"};
  }
  std::string start(const scree_view& view, double*) const {
    const bool whole = region.region == scree::AveragingFrame::enclosed;
    for (int k = 0; whole && k < dimension; ++k)
      if (view.period[k] > 0 && largest > 0.5 * view.period[k] * (1 + 1e-12))
        return std::string("largest is more than half of the period along ") + "xyz"[k] +
               "; give a smaller one";
    return largest > 0 || !whole ? region.problem(view) : "";
  }

  void sample(const scree_view& view, const double*, double* row) const {
    row = write_coordination(view, row);
    if (largest > 0) write_correlation(view, row);
  }

 private:
  // Contacts of each body that are left when rattlers are taken away, one after the other; −1 for rattlers
  // and for bodies that do not count.
  std::vector<int> load_bearing(const scree_view& view) const {
    const auto stays = [&](std::uint64_t i) { return view.fixed && view.fixed[i]; };
    std::vector<int> contacts(view.body_count, 0);
    std::vector<std::vector<std::uint64_t>> partners(view.body_count);
    for (std::uint64_t c = 0; c < view.contact_count; ++c) {
      const std::uint32_t a = view.contact_a[c], b = view.contact_b[c];
      ++contacts[a];
      if (b >= view.body_count) continue;
      ++contacts[b];
      partners[a].push_back(b);
      partners[b].push_back(a);
    }
    std::vector<std::uint64_t> rattlers;
    const auto check = [&](std::uint64_t i) {
      if (contacts[i] < 0 || stays(i) || contacts[i] >= rattler_below) return;
      contacts[i] = -1;
      rattlers.push_back(i);
    };
    for (std::uint64_t i = 0; i < view.body_count; ++i) check(i);
    for (std::size_t n = 0; n < rattlers.size(); ++n)
      for (const std::uint64_t partner : partners[rattlers[n]])
        if (contacts[partner] >= 0) {
          --contacts[partner];
          check(partner);
        }
    return contacts;
  }

  double* write_coordination(const scree_view& view, double* row) const {
    const std::vector<int> contacts = load_bearing(view);
    std::vector<int> all(view.body_count, 0);
    for (std::uint64_t c = 0; c < view.contact_count; ++c) {
      ++all[view.contact_a[c]];
      if (view.contact_b[c] < view.body_count) ++all[view.contact_b[c]];
    }
    double bodies = 0, ends = 0, rattlers = 0, bearing_ends = 0;
    for (std::uint64_t i = 0; i < view.body_count; ++i) {
      if (!scree::counts(view, i) || (view.fixed && view.fixed[i])) continue;
      bodies += 1;
      ends += all[i];
      contacts[i] < 0 ? rattlers += 1 : bearing_ends += contacts[i];
    }
    *row++ = bodies;
    *row++ = rattlers;
    *row++ = ends / bodies;
    *row++ = bearing_ends / (bodies - rattlers);
    return row;
  }

  Window window(const scree_view& view, const scree::AveragingFrame& frame) const {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    Window w{dimension, frame.lower, frame.upper, {}, {}};
    for (int k = 0; k < dimension; ++k) {
      if (frame.region != scree::AveragingFrame::enclosed || !(view.period[k] > 0)) continue;
      w.period[k] = view.period[k];
      w.lower[k] = -infinite;
      w.upper[k] = infinite;
    }
    for (std::uint64_t i = 0; i < view.body_count; ++i) {
      const Vec3 place = frame.nearest_image(scree::vector_of(view.position, i));
      if (scree::counts(view, i) && frame.bin_of(place) >= 0) w.places.push_back(place);
    }
    return w;
  }

  void write_correlation(const scree_view& view, double* row) const {
    const scree::AveragingFrame frame = region.frame(view);
    Window w = window(view, frame);
    const double width = largest / classes;
    std::vector<double> pairs(std::size_t(classes), 0), volume(pairs.size(), 0);
    w.each_pair(largest, [&](double r) {
      pairs[std::size_t(std::min(double(classes - 1), std::floor(r / width)))] += 2;
    });
    for (const Vec3& place : w.places) {
      double before = 0;
      for (int k = 0; k < classes; ++k) {
        const double now = w.volume_within(place, (k + 1) * width);
        volume[std::size_t(k)] += now - before;
        before = now;
      }
    }
    const double density = double(w.places.size()) / frame.volume(0);
    for (std::size_t k = 0; k < pairs.size(); ++k) row[k] = pairs[k] / (density * volume[k]);
  }

  static constexpr const char* names[] = {"bodies", "rattlers", "coordination_number",
                                          "coordination_without_rattlers"};
  static constexpr const char* meanings[] = {
      "number of bodies that are not fixed", "number of bodies that bear no load",
      "contacts per body that is not fixed",
      "contacts with bodies that bear load and walls, per body that bears load"};
};

}  // namespace

SCREE_PROBE_PLUGIN(StructureProbe)
