#include "error_line.hpp"
#include "signals.hpp"

#include <array>
#include <cmath>
#include <random>

#include <Eigen/Dense>
#include <catch2/catch.hpp>

#include <scree/error.hpp>
#include <scree/signals/lock_in.hpp>

using namespace scree;
using namespace scree::signals;
using scree::test::equal_times;
using scree::test::error_line;
using scree::test::random_times;
using scree::test::sine;
using scree::test::turned_by;

namespace {

constexpr double driven_frequency = 37.7;
constexpr std::array amplitudes = {2e-6, 3e-7, 5e-8}, phases = {2.5, -1.2, -3.1};

// A drift a million times the third harmonic, and three harmonics.
std::vector<double> driven(const std::vector<double>& times) {
  std::vector<double> x;
  for (const double t : times) {
    double value = 0.01 + 0.02 * t - 0.03 * t * t + 0.01 * t * t * t;
    for (int h = 1; h <= 3; ++h) value += sine(amplitudes[h - 1], h * driven_frequency, phases[h - 1], t);
    x.push_back(value);
  }
  return x;
}

// Round-off of a value of the record is 1e-18; the fit takes 2e4 samples and hence adds less than that to the
// lines.
void check_lines(const LockInResult& result) {
  REQUIRE(result.harmonics == 3);
  for (int h = 0; h < 3; ++h) {
    const SpectralLine& line = result.lines[h];
    CHECK(line.frequency == (h + 1) * driven_frequency);
    CHECK(std::abs(line.amplitude - amplitudes[h]) < 1e-15);
    CHECK(std::abs(turned_by(line.phase, phases[h])) < 1e-15 / amplitudes[h]);
  }
}

LockInOptions options_of(int drift_degree) {
  LockInOptions options;
  options.frequency = driven_frequency;
  options.drift_degree = drift_degree;
  return options;
}

}  // namespace

TEST_CASE("a lock-in finds three harmonics beside a cubic drift, at equal and at unequal times",
          "[lock_in]") {
  for (const auto& times : {equal_times(20000, 1e-4), random_times(20000, 1e-4, 3)})
    check_lines(lock_in(times, driven(times), options_of(3)));
}

TEST_CASE("phases refer to the origin, also for a record that starts late", "[lock_in]") {
  const auto times = equal_times(20000, 1e-4, 5.0123);
  check_lines(lock_in(times, driven(times), options_of(3)));
  LockInOptions later = options_of(3);
  later.origin = 5.0123;
  const SpectralLine line = lock_in(times, driven(times), later).lines[0];
  CHECK(std::abs(turned_by(line.phase, phases[0] + 2 * std::numbers::pi * driven_frequency * 5.0123)) < 1e-9);
  CHECK(line.phase <= std::numbers::pi);
  CHECK(line.phase > -std::numbers::pi);
}

TEST_CASE("a drift that is no polynomial changes the amplitude by no more than the stated bound",
          "[lock_in]") {
  const auto times = equal_times(4001, 1e-3);  // 4 s, 20 periods
  std::vector<double> x;
  for (const double t : times) x.push_back(std::exp(-t) + sine(0.01, 5, 1, t));
  const auto error = [&](int degree) {
    LockInOptions options;
    options.frequency = 5, options.drift_degree = degree;
    return std::abs(lock_in(times, x, options).lines[0].amplitude - 0.01);
  };
  // Degree 0: r = exp(-t) - 1/2 has max|r| = 1/2 and V = 1. Degree 2, by Chebyshev: max|r| <= T^3 / (2^5 3!).
  CHECK(error(0) < 2 / (std::numbers::pi * 20));
  CHECK(error(0) > 1e-3);
  const double rest = 64.0 / 192;
  CHECK(error(2) < (2 * rest + 6 * rest) / (std::numbers::pi * 20));
  CHECK(error(3) < 0.1 * error(0));
}

TEST_CASE("a million samples one by one give what a fit of all of them at once gives", "[lock_in]") {
  constexpr std::size_t samples = 1000000;
  const auto times = random_times(samples, 1e-5, 17);
  std::mt19937_64 random(1);
  std::normal_distribution<double> noise(0, 0.3);
  std::vector<double> x;
  for (const double t : times) x.push_back(5 + t + sine(1, driven_frequency, 0.3, t) + noise(random));
  const LockInResult streamed = lock_in(times, x, options_of(1));
  using Vector = Eigen::Matrix<long double, 8, 1>;
  Eigen::Matrix<long double, 8, 8> gram = Eigen::Matrix<long double, 8, 8>::Zero();
  Vector right = Vector::Zero(), column;
  for (std::size_t k = 0; k < samples; ++k) {
    const long double angle = 2 * std::numbers::pi_v<long double> * (long double)(driven_frequency)*times[k];
    column << 1, times[k] / 5 - 1, std::sin(angle), std::cos(angle), std::sin(2 * angle), std::cos(2 * angle),
        std::sin(3 * angle), std::cos(3 * angle);
    gram += column * column.transpose();
    right += column * (long double)(x[k]);
  }
  const Vector fit = gram.ldlt().solve(right);
  // Sums of 1e6 terms of size 1: round-off 1e6 * 1e-16 in the worst case, 1e-13 in the mean.
  for (int h = 0; h < 3; ++h) {
    const double a = double(fit[2 + 2 * h]), b = double(fit[3 + 2 * h]);
    CHECK(std::abs(streamed.lines[h].amplitude - std::hypot(a, b)) < 1e-11);
    CHECK(std::abs(turned_by(streamed.lines[h].phase, std::atan2(b, a))) < 1e-11 / std::hypot(a, b));
  }
  CHECK(streamed.residual_rms == Approx(0.3).epsilon(0.005));
}

TEST_CASE("a lock-in goes on from its numbers to the same bits", "[lock_in]") {
  const auto times = equal_times(1000, 1e-3);
  const auto x = driven(times);
  LockInOptions options = options_of(2);
  options.duration = 1;
  std::vector<double> whole(LockIn::state_size(options)), first(whole);
  LockIn all(options, whole);
  for (std::size_t k = 0; k < times.size(); ++k) all.add(times[k], x[k]);
  for (std::size_t k = 0; k < 400; ++k) LockIn(options, first).add(times[k], x[k]);
  std::vector<double> second = first;
  LockIn rest(options, second);
  for (std::size_t k = 400; k < times.size(); ++k) rest.add(times[k], x[k]);
  CHECK(second == whole);
  CHECK(rest.result().lines[0].amplitude_error == all.result().lines[0].amplitude_error);
}

TEST_CASE("a lock-in refuses options out of range and samples that cannot answer", "[lock_in]") {
  LockInOptions options;
  CHECK(error_line([&] { LockIn::state_size(options); }) ==
        "lock-in: frequency 0; give a frequency above 0 in Hz");
  options.frequency = 10;
  CHECK(error_line([&] { LockIn::state_size(options); }).starts_with("lock-in: duration 0; "));
  options.duration = 1, options.harmonics = 4;
  CHECK(error_line([&] { LockIn::state_size(options); }) == "lock-in: harmonics 4; give 1 to 3");
  options.harmonics = 3, options.drift_degree = -1;
  CHECK(error_line([&] { LockIn::state_size(options); }) == "lock-in: drift degree -1; give 0 to 3");
  options.drift_degree = 1;
  std::vector<double> state(3);
  CHECK(error_line([&] { LockIn(options, state); }).starts_with("lock-in: a state of 3 numbers; give "));
  CHECK(error_line([&] { lock_in(equal_times(7, 0.01), equal_times(7, 1), options); }) ==
        "lock-in: 7 samples for 8 unknowns; give more samples");
  // Four samples per period do not tell the third harmonic from the first.
  CHECK(error_line([&] {
          lock_in(equal_times(80, 0.025), equal_times(80, 1), options);
        }).starts_with("lock-in: the 80 samples do not tell drift and 3 harmonics of 10 Hz apart; "));
  const auto nearly = equal_times(80, 0.025 * (1 + 1e-9));
  CHECK(error_line([&] { lock_in(nearly, nearly, options); }).find(" do not tell drift ") !=
        std::string::npos);
  options.harmonics = 1;
  const LockInResult result = lock_in(equal_times(80, 0.025), equal_times(80, 1), options);
  CHECK(result.lines[0].amplitude < 1e-12);
}

TEST_CASE("an offset takes no digits from the residual", "[lock_in]") {
  std::mt19937_64 random(7);
  std::normal_distribution<double> noise(0, 1e-3);
  const auto times = equal_times(20000, 1e-4);
  std::vector<double> x;
  for (const double t : times) x.push_back(1e6 + sine(1e-3, driven_frequency, 1, t) + noise(random));
  CHECK(lock_in(times, x, options_of(1)).residual_rms == Approx(1e-3).epsilon(0.02));
}

TEST_CASE("values that are too large for their squares are refused", "[lock_in]") {
  CHECK(error_line([&] {
          lock_in(equal_times(100, 1e-3), std::vector<double>(100, 0), options_of(1));
          auto x = std::vector<double>(100, 0);
          x[3] = 1e200;
          lock_in(equal_times(100, 1e-3), x, options_of(1));
        }) == "lock-in: a value is not finite or beyond 1e150; leave it out, or give another unit");
}

TEST_CASE("a drift that is no polynomial is left out by means over a period", "[lock_in]") {
  const auto times = equal_times(4001, 1e-3);  // 20 periods of 200 samples
  std::vector<double> x;
  for (const double t : times) x.push_back(std::exp(-t) + sine(0.01, 5, 1, t));
  LockInOptions options;
  options.frequency = 5, options.drift_degree = 0;
  const SpectralLine line = lock_in(times, x, options, Detrending::period_average).lines[0];
  // Of exp(-t) it leaves P^2/24 exp(-t), as 1.7e-3 of a drift, of which the fit leaves 2/(20 pi) at most.
  CHECK(std::abs(line.amplitude - 0.01) < 1.7e-3 * 2 / (std::numbers::pi * 20));
  CHECK(std::abs(lock_in(times, x, options).lines[0].amplitude - 0.01) > 1e-3);
}
