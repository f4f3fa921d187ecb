#include "averaged_columns.hpp"

namespace scree::signals {

namespace {

using Complex = std::complex<double>;
using Eigen::Index;

constexpr Index most_values = 64;

}  // namespace

AveragedColumns::AveragedColumns(const ResponseSpectrum& response) : response_(response) {
  const auto count = Index(response.values.size());
  group_ = (count + most_values - 1) / most_values;
  values_ = averaged([&](std::size_t k) { return response.values[k]; });
  scale_ = values_.cwiseAbs().maxCoeff();
  if (scale_ > 0) values_ /= scale_;
  frequencies_ = averaged([&](std::size_t k) { return Complex(response.frequencies[k]); }).real();
  for (const double f : response.frequencies) factors_.push_back(response.factor(f));
}

Eigen::VectorXcd AveragedColumns::factors(double at) const {
  const double size = std::abs(response_.factor(at));
  return averaged([&](std::size_t k) { return factors_[k] / size; });
}

Eigen::VectorXcd AveragedColumns::pole(double frequency, double width) const {
  return pole(frequency, width, [](double, Complex) { return 1.0; });
}

Eigen::MatrixXcd AveragedColumns::others(double at, const std::vector<Pole>& poles) const {
  const double middle = 0.5 * (response_.frequencies.front() + response_.frequencies.back());
  const double half = 0.5 * (response_.frequencies.back() - response_.frequencies.front());
  const double size = std::abs(response_.factor(at));
  Eigen::MatrixXcd all(values_.size(), Index(2 + 2 * poles.size()));
  for (const int power : {0, 1})
    all.col(power) = averaged([&](std::size_t k) {
      const double f = response_.frequencies[k];
      return factors_[k] / size * (power == 0 ? 1 : (f - middle) / half);
    });
  for (std::size_t p = 0; p < poles.size(); ++p) {
    const double f0 = poles[p].frequency, w = poles[p].width;
    all.col(Index(2 * p) + 2) = pole(f0, w);
    all.col(Index(2 * p) + 3) = pole(f0, w, [&](double, Complex inverse) { return f0 * w * inverse; });
  }
  return all;
}

}  // namespace scree::signals
