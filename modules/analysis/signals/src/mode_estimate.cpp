#include "mode_estimate.hpp"

#include "averaged_columns.hpp"
#include "mode_background.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace scree::signals {

namespace {

using Complex = std::complex<double>;
using Eigen::Index;

constexpr Index least_spare = 5;                                   // values beyond the numbers of the fit
constexpr std::array background_widths = {0.25, 0.5, 1.0, 2.0};    // over the width of the pole
constexpr std::array noises = {1e-8, 1e-6, 1e-4, 1e-2, 1.0, 1e2};  // variances over the background's
// A priori, noise alone is as likely as all backgrounds together.
constexpr double no_background = 1e8, prior_of_noise = double(background_widths.size() * noises.size());
constexpr double negligible =
    8;  // by which the logarithm of the evidence is below that of the best background
constexpr double square_round_off = 1e-26;      // of sums of squares
constexpr int steps_of_grid = 4;                // on each side
constexpr double size_of_grid = 4;              // standard deviations on each side
constexpr double narrowest = 0.15, widest = 4;  // over the width at the start

// A frequency and a width of the pole, and the rest of the fit there.
struct Place {
  double frequency = 0, width = 0;
  Complex height = 0;          // of the pole, scaled
  double height_variance = 0;  // of each of its parts
  double square = 0;           // sum of squares of the residual
  double log_likelihood = 0;
};

// The fit beside one background. All else is linear, and all strengths are integrated out.
class OneBackground {
 public:
  OneBackground(const AveragedColumns& columns, const ModeBackground& background, double noise,
                const Eigen::MatrixXcd& others, double prior = 1)
      : columns_(columns), background_(background), noise_(noise), count_(columns.values().size()) {
    const Eigen::MatrixXcd white = background.whitened(others, noise);
    const Eigen::VectorXd norms = white.colwise().norm();
    const Eigen::HouseholderQR<Eigen::MatrixXcd> qr(white * norms.cwiseInverse().asDiagonal());
    basis_ = qr.householderQ() * Eigen::MatrixXcd::Identity(white.rows(), white.cols());
    log_volume_ = background.log_determinant(noise);
    log_restricted_ = -std::log(prior);
    for (Index k = 0; k < white.cols(); ++k)
      log_restricted_ += 2 * std::log(std::abs(qr.matrixQR()(k, k)) * norms[k]);
    values_ = rest_of(columns.values());
    least_square_ = square_round_off * background.whitened(columns.values(), noise).squaredNorm();
    spare_ = double(count_ - 1 - basis_.cols());
    independent_ = std::min(spare_, background.independent(noise));
  }

  Place at(double frequency, double width) const {
    const Eigen::VectorXcd pole = rest_of(columns_.pole(frequency, width));
    Place place{frequency, width, 0, 0, 0, 0};
    const double square = pole.squaredNorm();
    place.height = pole.dot(values_) / square;
    place.square = std::max((values_ - place.height * pole).squaredNorm(), least_square_);
    place.height_variance = 0.5 * place.square / spare_ / square;
    place.log_likelihood = -log_volume_ - log_restricted_ - std::log(square);
    if (least_ > 0)
      place.log_likelihood -=
          spare_ * std::log(least_) +
          (independent_ + 1) * std::log1p(spare_ / independent_ * std::max(0.0, place.square / least_ - 1));
    else
      place.log_likelihood -= spare_ * std::log(place.square);
    return place;
  }
  // Curvature of half the square, and the step to its minimum, in frequency and logarithm of the width.
  void expand(const Place& place, Eigen::Matrix2d& curvature, Eigen::Vector2d& step) const {
    Eigen::MatrixXcd columns(count_, 3);
    const double f = place.frequency, w = place.width;
    columns.col(0) = columns_.pole(f, w);
    columns.col(1) = columns_.pole(f, w, [&](double, Complex inverse) { return -2 * f * inverse; });
    columns.col(2) =
        columns_.pole(f, w, [&](double at, Complex inverse) { return Complex(0, -at * w) * inverse; });
    const Eigen::MatrixXcd rest = rest_of(columns);
    const Eigen::VectorXcd unit = rest.col(0).normalized();
    Eigen::MatrixXcd by = place.height * rest.rightCols(2);
    by -= unit * (unit.adjoint() * by).eval();
    curvature = (by.adjoint() * by).real();
    const Eigen::Vector2d slope = (by.adjoint() * (values_ - place.height * rest.col(0))).real();
    step = curvature.ldlt().solve(slope);
  }
  double spare() const { return spare_; }
  // Takes the strength of the background from the residual at a place, with as many degrees of freedom as
  // values are independent: from here on the likelihood falls as Student's distribution.
  void learn_strength(const Place& place) { least_ = place.square; }
  // Akaike's criterion, corrected, for strengths, shifts and four numbers of the background.
  double criterion(const Place& place) const {
    const double count = 2.0 * double(count_), parameters = 2.0 * double(basis_.cols()) + 4 + 4;
    const double room = count - parameters - 1;
    if (room < 1) return std::numeric_limits<double>::infinity();
    return 2 * log_volume_ + count * std::log(place.square / double(count_)) + 2 * parameters +
           2 * parameters * (parameters + 1) / room;
  }

 private:
  Eigen::MatrixXcd rest_of(const Eigen::MatrixXcd& columns) const {
    Eigen::MatrixXcd white = background_.whitened(columns, noise_);
    white -= basis_ * (basis_.adjoint() * white).eval();
    return white;
  }

  const AveragedColumns& columns_;
  const ModeBackground& background_;
  double noise_;
  Index count_;
  Eigen::MatrixXcd basis_;
  Eigen::VectorXcd values_;
  double log_volume_ = 0, log_restricted_ = 0, least_square_ = 0, spare_ = 0;
  double independent_ = 0, least_ = 0;
};

// The most likely place with one background, and the evidence for this background.
struct LikeliestPlace {
  OneBackground background;
  Place place{};
  Eigen::Matrix2d spread{};  // in frequency and logarithm of the width; its square is the covariance
  double log_evidence = 0;
};

bool climb(LikeliestPlace& peak, const Pole& start) {
  constexpr int most_steps = 30;
  constexpr double at_rest = 1e-4;  // standard deviations
  Place& place = peak.place = peak.background.at(start.frequency, start.width);
  Eigen::Matrix2d curvature;
  Eigen::Vector2d step;
  for (int k = 0; k < most_steps; ++k) {
    peak.background.expand(place, curvature, step);
    const double variance = place.square / peak.background.spare();
    if (step.dot(curvature * step) < at_rest * at_rest * variance) break;
    bool better = false;
    for (double share = 1; share > 1e-3 && !better; share /= 2) {
      const double frequency = place.frequency + share * step[0];
      const double width = place.width * std::exp(std::clamp(share * step[1], -1.0, 1.0));
      if (!(width > narrowest * start.width && width < widest * start.width) ||
          std::abs(frequency - start.frequency) > start.width)
        continue;
      const Place next = peak.background.at(frequency, width);
      better = next.square < place.square;
      if (better) place = next;
    }
    if (!better) break;
  }
  peak.background.expand(place, curvature, step);
  const Eigen::Matrix2d covariance = 0.5 * place.square / peak.background.spare() * curvature.inverse();
  const Eigen::LLT<Eigen::Matrix2d> factor(covariance);
  if (factor.info() != Eigen::Success || !covariance.allFinite()) return false;
  peak.spread = factor.matrixL();
  peak.background.learn_strength(place);
  peak.log_evidence = place.log_likelihood + std::log(peak.spread(0, 0) * peak.spread(1, 1));
  return std::isfinite(peak.log_evidence);
}

// Weighted means and variances of the numbers of a mode over places, summed relative to a first place.
class Moments {
 public:
  Moments(const Place& about, double log_weight) : about_(numbers(about)), log_weight_(log_weight) {}

  void add(const Place& place, double log_weight) {
    const double weight = std::exp(log_weight - log_weight_);
    const Eigen::Vector4d from = numbers(place) - about_;
    weight_ += weight, first_ += weight * from;
    second_ += weight * from.cwiseAbs2();
    second_[3] += weight * place.height_variance;
    height_ += weight * place.height;
  }
  FittedMode mode(double scale, const ResponseSpectrum& response) const {
    const Eigen::Vector4d change = first_ / weight_, mean = about_ + change;
    const Eigen::Vector4d error = (second_ / weight_ - change.cwiseAbs2()).cwiseMax(0.0).cwiseSqrt();
    FittedMode mode;
    mode.frequency = mean[0], mode.frequency_error = error[0];
    mode.width = mean[1], mode.width_error = error[1];
    mode.quality = mean[2], mode.quality_error = error[2];
    mode.amplitude = scale * mean[3], mode.amplitude_error = scale * error[3];
    mode.phase = std::arg(height_ * response.factor(mode.frequency));
    return mode;
  }

 private:
  static Eigen::Vector4d numbers(const Place& place) {
    return {place.frequency, place.width, place.frequency / place.width, std::abs(place.height)};
  }
  Eigen::Vector4d about_, first_ = Eigen::Vector4d::Zero(), second_ = Eigen::Vector4d::Zero();
  double log_weight_, weight_ = 0;
  Complex height_ = 0;
};

void add_grid(const LikeliestPlace& peak, const Pole& start, Moments& moments) {
  for (int i = -steps_of_grid; i <= steps_of_grid; ++i)
    for (int j = -steps_of_grid; j <= steps_of_grid; ++j) {
      const Eigen::Vector2d step =
          peak.spread * (size_of_grid / steps_of_grid * Eigen::Vector2d(double(i), double(j)));
      const double frequency = peak.place.frequency + step[0], width = peak.place.width * std::exp(step[1]);
      if (!(width > narrowest * start.width && width < widest * start.width) ||
          std::abs(frequency - start.frequency) > start.width)
        continue;
      const Place place = peak.background.at(frequency, width);
      moments.add(place, place.log_likelihood + std::log(peak.spread(0, 0) * peak.spread(1, 1)));
    }
}

}  // namespace

std::optional<ModeEstimate> estimate_mode(const ResponseSpectrum& response, const Pole& pole,
                                          const std::vector<Pole>& others) {
  const AveragedColumns columns(response);
  if (columns.values().size() < Index(3 + 2 * others.size()) + least_spare || !(columns.scale() > 0))
    return {};
  const Eigen::MatrixXcd beside = columns.others(pole.frequency, others);
  std::vector<ModeBackground> backgrounds;
  for (const double width : background_widths)
    backgrounds.emplace_back(columns.frequencies(), columns.factors(pole.frequency), width * pole.width);
  std::vector<LikeliestPlace> peaks;
  const auto add = [&](const ModeBackground& background, double noise, double prior) {
    LikeliestPlace peak{OneBackground(columns, background, noise, beside, prior)};
    if (climb(peak, pole)) peaks.push_back(std::move(peak));
  };
  add(backgrounds.front(), no_background, prior_of_noise);
  for (const ModeBackground& background : backgrounds)
    for (const double noise : noises) add(background, noise, 1);
  if (peaks.empty()) return {};
  const auto likelier = [](const LikeliestPlace& a, const LikeliestPlace& b) {
    return a.log_evidence < b.log_evidence;
  };
  const LikeliestPlace& best = *std::max_element(peaks.begin(), peaks.end(), likelier);
  ModeEstimate estimate;
  estimate.criterion = std::numeric_limits<double>::infinity();
  Moments moments(best.place, best.log_evidence);
  for (const LikeliestPlace& peak : peaks) {
    estimate.criterion = std::min(estimate.criterion, peak.background.criterion(peak.place));
    if (peak.log_evidence > best.log_evidence - negligible) add_grid(peak, pole, moments);
  }
  estimate.mode = moments.mode(columns.scale(), response);
  estimate.mode.together = 1 + others.size();
  estimate.mode.points = response.values.size();
  return estimate;
}

}  // namespace scree::signals
