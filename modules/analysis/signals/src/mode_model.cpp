#include "mode_model.hpp"

#include <cmath>

namespace scree::signals {

namespace {

using Complex = std::complex<double>;
constexpr Complex i(0, 1);

}  // namespace

ModeModel::ModeModel(const ResponseSpectrum& response, std::size_t poles, int degree)
    : response_(response),
      poles_(poles),
      degree_(degree),
      middle_(0.5 * (response.frequencies.front() + response.frequencies.back())),
      half_range_(0.5 * (response.frequencies.back() - response.frequencies.front())) {}

Eigen::Index ModeModel::residuals() const {
  return Eigen::Index(response_.values.size() * (response_.only_amplitudes ? 1 : 2));
}

void ModeModel::add_pole(const double* pole, double frequency, Complex& sum,
                         Eigen::Ref<Eigen::RowVectorXcd> derivative) const {
  const double f0 = pole[0], width = pole[1], q = (f0 - frequency) * (f0 + frequency), fw = frequency * width;
  if (response_.only_amplitudes) {
    const double inverse = 1 / (q * q + fw * fw), term = (pole[2] + pole[3] * q) * inverse;
    sum += term;
    derivative << (pole[3] - 2 * term * q) * 2 * f0 * inverse, -2 * term * inverse * fw * frequency, inverse,
        q * inverse;
    return;
  }
  const Complex inverse = 1.0 / Complex(q, fw), term = Complex(pole[2], pole[3]) * inverse;
  sum += term;
  derivative << -term * inverse * 2.0 * f0, -term * inverse * i * frequency, inverse, i * inverse;
}

Complex ModeModel::value(const Eigen::VectorXd& at, double frequency, Eigen::RowVectorXcd& derivative) const {
  Complex sum = 0;
  double power = 1;
  for (Eigen::Index p = of_poles(); p < parameters(); p += 2, power *= scaled(frequency)) {
    sum += Complex(at[p], at[p + 1]) * power;
    derivative.segment(p, 2) << power, i * power;
  }
  for (Eigen::Index p = 0; p < of_poles(); p += 4)
    add_pole(at.data() + p, frequency, sum, derivative.segment(p, 4));
  if (response_.derivative == 0) return sum;
  const Complex factor = response_.factor(frequency);
  const Complex all = response_.only_amplitudes ? std::norm(factor) : factor;
  derivative *= all;
  return all * sum;
}

Eigen::VectorXd ModeModel::start(const std::vector<Pole>& poles) const {
  Eigen::VectorXd at = Eigen::VectorXd::Zero(parameters());
  for (std::size_t p = 0; p < poles_; ++p)
    at.segment(Eigen::Index(4 * p), 2) << poles[p].frequency, poles[p].width;
  // H and |H|^2 are linear in all else.
  const auto count = Eigen::Index(response_.values.size());
  Eigen::MatrixXd columns(2 * count, parameters());
  Eigen::VectorXd values(2 * count);
  Eigen::RowVectorXcd derivative(parameters());
  for (Eigen::Index k = 0; k < count; ++k) {
    const Complex measured = response_.values[std::size_t(k)];
    value(at, response_.frequencies[std::size_t(k)], derivative);
    for (std::size_t p = 0; p < poles_; ++p) derivative.segment(Eigen::Index(4 * p), 2).setZero();
    const double weight = response_.only_amplitudes && std::abs(measured) > 0 ? 1 / std::abs(measured) : 1;
    const Complex target = response_.only_amplitudes ? Complex(std::norm(measured)) : measured;
    columns.row(2 * k) = weight * derivative.real(), columns.row(2 * k + 1) = weight * derivative.imag();
    values[2 * k] = weight * target.real(), values[2 * k + 1] = weight * target.imag();
  }
  Eigen::VectorXd norms = columns.colwise().norm();
  for (double& norm : norms)
    if (!(norm > 0)) norm = 1;
  const Eigen::MatrixXd unit = columns * norms.cwiseInverse().asDiagonal();
  const Eigen::VectorXd fit = unit.colPivHouseholderQr().solve(values).cwiseQuotient(norms);
  for (Eigen::Index k = 0; k < parameters(); ++k)
    if (k >= of_poles() || k % 4 >= 2) at[k] = fit[k];
  for (Eigen::Index k = of_poles(); response_.only_amplitudes && k < parameters(); k += 2) at[k + 1] = 0;
  return at;
}

Eigen::VectorXd ModeModel::evaluate(const Eigen::VectorXd& at, Eigen::MatrixXd* derivatives) const {
  Eigen::VectorXd rest(residuals());
  Eigen::RowVectorXcd derivative(parameters());
  if (derivatives) derivatives->resize(residuals(), parameters());
  for (std::size_t k = 0; k < response_.values.size(); ++k) {
    const Complex here = value(at, response_.frequencies[k], derivative);
    const auto first = Eigen::Index(response_.only_amplitudes ? k : 2 * k);
    if (response_.only_amplitudes) {
      const double size = std::sqrt(here.real());
      rest[first] = size - response_.values[k].real();
      if (derivatives) derivatives->row(first) = derivative.real() / (2 * size);
      continue;
    }
    const Complex difference = here - response_.values[k];
    rest[first] = difference.real(), rest[first + 1] = difference.imag();
    if (!derivatives) continue;
    derivatives->row(first) = derivative.real();
    derivatives->row(first + 1) = derivative.imag();
  }
  return rest;
}

}  // namespace scree::signals
