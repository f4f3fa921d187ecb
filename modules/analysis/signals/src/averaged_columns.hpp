#pragma once

#include "mode_fit.hpp"

#include <algorithm>
#include <complex>
#include <vector>

#include <Eigen/Dense>

namespace scree::signals {

// The values of a response, over the largest, and the columns of a linear fit to them. More than 64
// frequencies are averaged in groups.
class AveragedColumns {
 public:
  explicit AveragedColumns(const ResponseSpectrum& response);

  double scale() const { return scale_; }  // largest size of a value
  const Eigen::VectorXcd& values() const { return values_; }
  const Eigen::VectorXd& frequencies() const { return frequencies_; }  // (Hz)

  // ResponseSpectrum::factor, over its size at a frequency (Hz).
  Eigen::VectorXcd factors(double at) const;

  // A pole of height 1.
  Eigen::VectorXcd pole(double frequency, double width) const;
  // The same times factor(f, 1 / (frequency^2 - f^2 + i f width)).
  template <class Factor>
  Eigen::VectorXcd pole(double frequency, double width, const Factor& factor) const {
    const double scale = frequency * width / std::abs(response_.factor(frequency));
    return averaged([&](std::size_t k) {
      const double f = response_.frequencies[k];
      const std::complex<double> inverse =
          1.0 / std::complex<double>((frequency - f) * (frequency + f), f * width);
      return scale * factors_[k] * inverse * factor(f, inverse);
    });
  }

  // A straight line over frequency, and each of the other poles with its derivative in complex frequency.
  Eigen::MatrixXcd others(double at, const std::vector<Pole>& poles) const;

 private:
  template <class Value>
  Eigen::VectorXcd averaged(const Value& value) const {
    const auto count = Eigen::Index(response_.values.size());
    Eigen::VectorXcd means((count + group_ - 1) / group_);
    for (Eigen::Index g = 0; g < means.size(); ++g) {
      const Eigen::Index end = std::min(count, (g + 1) * group_);
      std::complex<double> sum = 0;
      for (Eigen::Index k = g * group_; k < end; ++k) sum += value(std::size_t(k));
      means[g] = sum / double(end - g * group_);
    }
    return means;
  }

  const ResponseSpectrum& response_;
  std::vector<std::complex<double>> factors_;
  Eigen::Index group_ = 1;  // frequencies
  double scale_ = 0;
  Eigen::VectorXcd values_;
  Eigen::VectorXd frequencies_;
};

}  // namespace scree::signals
