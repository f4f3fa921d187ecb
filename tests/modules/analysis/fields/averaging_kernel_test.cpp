#include "numbers.hpp"

#include <cmath>
#include <numbers>
#include <random>

#include <catch2/catch.hpp>

#include <scree/fields/averaging_kernel.hpp>

using namespace scree;
using fields::AlongLine;
using fields::AveragingKernel;

namespace {

// Midpoint rule: an error of 1/n² times the second derivative, near 2e-9 of the largest value.
AlongLine along_by_midpoints(const AveragingKernel& kernel, const Vec3& offset, const Vec3& line) {
  constexpr int n = 20000;
  AlongLine sum = {0, 0};
  for (int k = 0; k < n; ++k) {
    const Vec3 r = offset - ((k + 0.5) / n) * line;
    sum.weight += kernel(dot(r, r)) / n;
  }
  const Vec3 end = offset - line;
  sum.drop = kernel(dot(offset, offset)) - kernel(dot(end, end));
  return sum;
}

}  // namespace

TEST_CASE("the kernel has an integral of 1 in two and three dimensions", "[fields]") {
  const double w = 0.7;
  const int n = 4000;
  for (const int k : {0, 1, 2, 3}) {
    const int dimension = 2 + k / 2;
    const AveragingKernel kernel(dimension, w, fields::KernelShape(k % 2));
    double integral = 0;
    for (int ring = 0; ring < n; ++ring) {
      const double r = (ring + 0.5) * w / n;
      integral +=
          kernel(r * r) * (dimension == 2 ? 2 * std::numbers::pi * r : 4 * std::numbers::pi * r * r) * w / n;
    }
    CHECK(integral == Approx(1).epsilon(1e-6));  // 1/n² of the midpoint rule
    CHECK(kernel(w * w) == 0);
    CHECK(kernel(2 * w * w) == 0);
  }
}

TEST_CASE("the kernel is integrated along lines that end inside, outside, or miss it", "[fields]") {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> part(-1, 1);
  const auto any = [&](double size) {
    return Vec3{{size * part(random), size * part(random), size * part(random)}};
  };
  for (const int kind : {0, 1, 2, 3}) {
    const int dimension = 2 + kind / 2;
    const AveragingKernel kernel(dimension, 1.3, fields::KernelShape(kind % 2));
    const double top = kernel(0);
    int clipped = 0;
    for (int k = 0; k < 400; ++k) {
      Vec3 offset = any(1.5), line = any(k % 2 ? 0.8 : 3);
      if (dimension == 2) offset[2] = line[2] = 0;
      const AlongLine along = kernel.along(offset, line), slow = along_by_midpoints(kernel, offset, line);
      CHECK(along.weight == Approx(slow.weight).margin(2e-8 * top));
      // Round-off of four terms of degree 5 whose sum may be small.
      CHECK(along.drop == Approx(slow.drop).margin(50 * test::epsilon * top));
      clipped += slow.drop == 0 && slow.weight > 0;
    }
    CHECK(clipped > 5);
  }
}

TEST_CASE("a line without a length has the kernel of its point", "[fields]") {
  for (const auto shape : {fields::KernelShape::triweight, fields::KernelShape::lucy}) {
    const AveragingKernel kernel(3, 1, shape);
    const Vec3 offset = {{0.1, 0.2, 0.3}};
    CHECK(kernel.along(offset, {}).weight == Approx(kernel(dot(offset, offset))).epsilon(10 * test::epsilon));
    CHECK(kernel.along(offset, {}).drop == 0);
    CHECK(kernel.along({{2, 0, 0}}, {}).weight == 0);
  }
}
