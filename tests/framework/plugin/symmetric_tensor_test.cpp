#include <cmath>
#include <random>

#include <catch2/catch.hpp>

#include <scree/plugin/symmetric_tensor.hpp>

using namespace scree;

namespace {

Vec3 times(const SymmetricTensor& t, const Vec3& v) {
  return {t.xx * v[0] + t.xy * v[1] + t.xz * v[2], t.xy * v[0] + t.yy * v[1] + t.yz * v[2],
          t.xz * v[0] + t.yz * v[1] + t.zz * v[2]};
}

}  // namespace

TEST_CASE("principal values and the major direction solve the eigenvalue problem", "[tensor]") {
  std::mt19937_64 generator(8);
  std::uniform_real_distribution<double> number(-1, 1);
  for (int n = 0; n < 200; ++n) {
    const int dimension = n % 2 ? 2 : 3;
    SymmetricTensor t{number(generator), number(generator), number(generator),
                      number(generator), number(generator), number(generator)};
    if (dimension == 2) t.zz = t.xz = t.yz = 0;
    const PrincipalValues p = principal_values(t, dimension);
    CHECK(norm(times(t, p.major) - p.values[0] * p.major) < 1e-14);
    CHECK(norm(p.major) == Approx(1).epsilon(1e-14));
    CHECK(p.values[0] >= p.values[1]);
    if (dimension == 3) CHECK(p.values[1] >= p.values[2]);
    // Invariants: trace and sum of squares.
    CHECK(p.values[0] + p.values[1] + p.values[2] == Approx(t.xx + t.yy + t.zz).margin(1e-14));
    CHECK(p.values[0] * p.values[0] + p.values[1] * p.values[1] + p.values[2] * p.values[2] ==
          Approx(t.xx * t.xx + t.yy * t.yy + t.zz * t.zz + 2 * (t.xy * t.xy + t.xz * t.xz + t.yz * t.yz)));
  }
}

TEST_CASE("the deviator of a triaxial state is the difference of its stresses", "[tensor]") {
  const SymmetricTensor triaxial{.xx = 1, .yy = 1, .zz = 4};
  const PrincipalValues p = principal_values(triaxial, 3);
  CHECK(deviator(p, 3) == Approx(3));
  CHECK(p.major == Vec3{0, 0, 1});
  CHECK(triaxial.mean(3) == Approx(2));
  const SymmetricTensor shear{.xy = 0.5};
  CHECK(deviator(principal_values(shear, 2), 2) == Approx(0.5));
  CHECK(principal_values(shear, 2).major[0] == Approx(std::sqrt(0.5)));
}
