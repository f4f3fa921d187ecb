#pragma once

#include "scenes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <scree/contact_jacobian.hpp>

// One contact passed to a law directly, without the kernel.

namespace scree::test {

class LawBatch {
 public:
  LawBatch(const std::string& plugin, const Values& values, int dimension = 3)
      : dimension_(dimension),
        law_(parameters(plugin, SCREE_CONTACT_LAW, values), dimension, nowhere_, nowhere_) {
    for (auto& column : input_) column.fill(0.0);
    for (auto& column : history) column.fill(0.0);
    input_[SCREE_NORMAL].fill(1.0);
    input_[SCREE_ONSET_WEIGHT].fill(1.0);
    input_[SCREE_REDUCED_MASS].fill(1.0);
    input_[SCREE_EFFECTIVE_RADIUS].fill(1.0);
  }

  // A scalar input, or component k of a vector input.
  double& input(scree_contact_input column, int k = 0) { return input_[column + k][0]; }
  void set(scree_contact_input column, const Vec3& v) {
    for (int k = 0; k < 3; ++k) input(column, k) = v[k];
  }
  double output(scree_contact_output column, int k = 0) const { return output_[column + k][0]; }
  Vec3 force() const { return {{output(SCREE_FORCE, 0), output(SCREE_FORCE, 1), output(SCREE_FORCE, 2)}}; }
  const scree_contact_instance& instance() const { return law_.instance(); }

  void evaluate(double step) {
    const scree_contact_batch contacts = batch(step);
    law_.instance().evaluate(law_.storage(), &contacts);
  }

  // Row and column as in ContactJacobian.
  double derivative(int row, int column, double inverse_distance, double step) {
    const scree_contact_batch contacts = batch(step);
    const std::vector<double> inverse_distances(SCREE_LANES, inverse_distance);
    const ContactJacobian jacobian(law_, dimension_);
    std::vector<double> values;
    jacobian.evaluate(contacts, inverse_distances.data(), values);
    return values[std::size_t(row * jacobian.columns() + column)];
  }

  using Lanes = std::array<double, SCREE_LANES>;
  alignas(64) std::array<Lanes, SCREE_MAX_HISTORY> history;

 private:
  void derive_inputs() {
    input(SCREE_REDUCED_MASS_ROOT) = std::sqrt(input(SCREE_REDUCED_MASS));
    const double radius = std::sqrt(input(SCREE_EFFECTIVE_RADIUS) * std::max(input(SCREE_OVERLAP), 0.0));
    input(SCREE_CONTACT_RADIUS, 0) = radius;
    input(SCREE_CONTACT_RADIUS, 1) = radius > 0 ? 1 / radius : 0;
    input(SCREE_CONTACT_RADIUS, 2) = std::sqrt(radius);
  }

  scree_contact_batch batch(double step) {
    derive_inputs();
    scree_contact_batch contacts = {};
    contacts.struct_size = sizeof(contacts);
    contacts.count = SCREE_LANES;
    contacts.step = step;
    for (std::size_t k = 0; k < input_.size(); ++k) contacts.input[k] = input_[k].data();
    for (std::size_t k = 0; k < history.size(); ++k) contacts.history[k] = history[k].data();
    for (std::size_t k = 0; k < output_.size(); ++k) contacts.output[k] = output_[k].data();
    return contacts;
  }

  static constexpr double nowhere_[3] = {0, 0, 0};
  int dimension_;
  ConfiguredLaw law_;
  alignas(64) std::array<Lanes, SCREE_CONTACT_INPUT_COUNT> input_;
  alignas(64) std::array<Lanes, SCREE_CONTACT_OUTPUT_COUNT> output_;
};

}  // namespace scree::test
