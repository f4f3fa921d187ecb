#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include <catch2/catch.hpp>

#include <scree/plugin/averaging_frame.hpp>

using namespace scree;

namespace {

AveragingFrame box_frame(int dimension, int bins, int along, const Vec3& period = {}) {
  AveragingFrame f;
  f.dimension = dimension;
  f.region = AveragingFrame::box;
  f.bins = bins;
  f.along = along;
  f.lower = {1, 2, 3};
  f.upper = {2, 4, 6};
  f.period = period;
  return f.with_edges();
}
AveragingFrame round_frame(AveragingFrame::Region region, int bins, int along) {
  AveragingFrame f;
  f.region = region;
  f.bins = bins;
  f.along = along;
  f.axis = 1;
  f.centre = {1, 2, 3};
  f.radius = 2;
  f.length = 3;
  return f.with_edges();
}

// Along y, with radii at its ends.
AveragingFrame cone_frame(double low, double high, int bins) {
  AveragingFrame f = round_frame(AveragingFrame::cone, bins, 1);
  f.radius_low = low, f.radius_high = high;
  f.radius = std::max(low, high);
  return f.with_edges();
}

std::vector<double> shares(const AveragingFrame& frame, const Vec3& start, const Vec3& step) {
  std::vector<double> all(std::size_t(frame.bins), 0);
  frame.split_line(start, step, [&](int bin, double share) { all[std::size_t(bin)] += share; });
  return all;
}

// The same by the bins of many points of the line and of its periodic images.
std::vector<double> counted_shares(const AveragingFrame& frame, const Vec3& start, const Vec3& step) {
  constexpr int points = 4000;
  std::vector<double> all(std::size_t(frame.bins), 0);
  for (int n = 0; n < points; ++n)
    if (const int bin = frame.bin_of(start + (n + 0.5) / points * step); bin >= 0)
      all[std::size_t(bin)] += 1.0 / points;
  return all;
}

}  // namespace

TEST_CASE("a line is divided among the bins that it crosses", "[bins]") {
  const AveragingFrame frame =
      GENERATE(box_frame(3, 1, 0), box_frame(3, 7, 2), box_frame(2, 5, 0), box_frame(3, 4, 1, {0, 2, 0}),
               box_frame(3, 4, 1, {1, 2, 3}), box_frame(3, 3, 0, {2.5, 0, 0}),
               round_frame(AveragingFrame::sphere, 1, 0),
               round_frame(AveragingFrame::sphere, 6, AveragingFrame::radial),
               round_frame(AveragingFrame::sphere, 6, 2), round_frame(AveragingFrame::cylinder, 1, 0),
               round_frame(AveragingFrame::cylinder, 5, AveragingFrame::radial),
               round_frame(AveragingFrame::cylinder, 5, 1), cone_frame(0, 2, 1), cone_frame(2, 0.3, 4),
               cone_frame(0.1, 3, 5));
  std::mt19937_64 generator(7);
  std::uniform_real_distribution<double> place(-1, 7), move(-1.5, 1.5);
  for (int n = 0; n < 200; ++n) {
    const Vec3 start = {place(generator), place(generator), place(generator)};
    const Vec3 step = {move(generator), n % 5 ? move(generator) : 0, n % 3 ? move(generator) : 0};
    const std::vector<double> exact = shares(frame, start, step),
                              counted = counted_shares(frame, start, step);
    // A point more or less at each of the two ends of the part of a bin, for each of up to three images.
    for (std::size_t k = 0; k < exact.size(); ++k) CHECK(std::abs(exact[k] - counted[k]) < 6.1 / 4000);
  }
}

TEST_CASE("in a box as long as its periods the whole of a line counts", "[bins]") {
  const AveragingFrame frame = box_frame(3, 4, 1, {1, 2, 3});
  double sum = 0;
  for (const double share : shares(frame, {1.9, 3.9, 5.9}, {0.3, 0.5, 0.4})) sum += share;
  CHECK(sum == Approx(1).epsilon(1e-14));
}

TEST_CASE("bins of an enclosed scene hold all lines, the outer ones also what reaches into walls", "[bins]") {
  AveragingFrame f;
  f.bins = 4;
  f.along = 2;
  f.upper = {1, 1, 8};
  f.enclosed_length = {1, 1, 8};
  f = f.with_edges();
  const std::vector<double> all = shares(f, {0.5, 0.5, -0.5}, {0, 0, 9});
  CHECK(all[0] == Approx(2.5 / 9));
  CHECK(all[1] == Approx(2.0 / 9));
  CHECK(all[3] == Approx(2.5 / 9));
  CHECK(f.volume(1) == Approx(2));
  CHECK(f.bin_of({0, 0, -1}) == 0);
  CHECK(f.bin_of({9, 9, 9}) == 3);
}

TEST_CASE("volumes of bins add up to the region", "[bins]") {
  const auto sum = [](const AveragingFrame& f) {
    double volume = 0;
    for (int bin = 0; bin < f.bins; ++bin) volume += f.volume(bin);
    return volume;
  };
  CHECK(sum(box_frame(3, 7, 2)) == Approx(6));
  CHECK(sum(box_frame(2, 7, 1)) == Approx(2));
  CHECK(sum(round_frame(AveragingFrame::sphere, 6, AveragingFrame::radial)) ==
        Approx(32 * std::numbers::pi / 3));
  CHECK(sum(round_frame(AveragingFrame::sphere, 6, 0)) == Approx(32 * std::numbers::pi / 3));
  CHECK(sum(round_frame(AveragingFrame::cylinder, 5, AveragingFrame::radial)) ==
        Approx(12 * std::numbers::pi));
  CHECK(sum(round_frame(AveragingFrame::cylinder, 5, 1)) == Approx(12 * std::numbers::pi));
  for (const int bins : {1, 5}) CHECK(sum(cone_frame(2, 0.5, bins)) == Approx(5.25 * std::numbers::pi));
  CHECK(cone_frame(0, 2, 2).volume(0) == Approx(std::numbers::pi / 2));
  CHECK(round_frame(AveragingFrame::sphere, 2, AveragingFrame::radial).volume(0) ==
        Approx(4 * std::numbers::pi / 3));
}

TEST_CASE("a sphere is divided among bins of a box and shells, across periodic faces too", "[bins]") {
  const auto sum = [](const AveragingFrame& f, const Vec3& x, double size) {
    double volume = 0;
    f.split_sphere(x, size, [&](int, double part) { volume += part; });
    return volume;
  };
  const double whole = 4.0 / 3 * std::numbers::pi * 0.027;
  CHECK(sum(box_frame(3, 5, 2), {1.5, 3, 4.4}, 0.3) == Approx(whole));
  CHECK(sum(box_frame(3, 5, 2), {1, 2, 4.4}, 0.3) == Approx(whole / 4));
  CHECK(sum(box_frame(3, 5, 2, {1, 2, 3}), {1, 2, 5.9}, 0.3) == Approx(whole));
  CHECK(sum(box_frame(3, 5, 2, {0, 2, 0}), {1, 2, 4.4}, 0.3) == Approx(whole / 2));
  CHECK(sum(box_frame(2, 5, 0), {2, 3, 0}, 0.3) == Approx(std::numbers::pi * 0.045));
  CHECK(sum(round_frame(AveragingFrame::sphere, 6, AveragingFrame::radial), {1.2, 2, 3.5}, 0.3) ==
        Approx(whole));
  CHECK(sum(round_frame(AveragingFrame::sphere, 6, AveragingFrame::radial), {3, 2, 3}, 0.3) ==
        Approx(common_volume(3, 2, 0.3, 2)));
  // Half of it in the lower end of the cylinder along y, and cut by its side, also in slices and shells.
  for (const int along : {1, int(AveragingFrame::radial)}) {
    CHECK(sum(round_frame(AveragingFrame::cylinder, 6, along), {1.2, 0.5, 3.5}, 0.3) == Approx(whole / 2));
    CHECK(sum(round_frame(AveragingFrame::cylinder, 6, along), {3, 2, 3}, 0.3) ==
          Approx(sphere_in_round(0.3, {3, true, 2, 2, 0}, -1, 1)));
  }
  CHECK(sum(round_frame(AveragingFrame::sphere, 6, 0), {3, 2, 3}, 0.3) ==
        Approx(common_volume(3, 2, 0.3, 2)));
  // In a cone along y from 0.5 m to 3.5 m, of radii 2 m and 0.5 m: inside, in its lower end, cut by its side.
  for (const int bins : {1, 6}) {
    CHECK(sum(cone_frame(2, 0.5, bins), {1.2, 2, 3.5}, 0.3) == Approx(whole));
    CHECK(sum(cone_frame(2, 0.5, bins), {1.2, 0.5, 3.5}, 0.3) == Approx(whole / 2));
    CHECK(sum(cone_frame(2, 0.5, bins), {2.2, 2.1, 3}, 0.3) ==
          Approx(sphere_in_round(0.3, {3, true, 1.2, 1.2, 0, -0.5}, -1, 1)));
  }
}
