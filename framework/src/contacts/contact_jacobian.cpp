#include <algorithm>

#include <fmt/format.h>

#include <scree/contact_jacobian.hpp>
#include <scree/error.hpp>
#include <scree/plugin/vec.hpp>

namespace scree {

namespace {

// The derivatives of the inputs of a batch along one direction, as columns.
class InputTangent {
 public:
  InputTangent(const scree_contact_batch& batch, int dimension, std::uint32_t reads)
      : batch_(batch), dimension_(dimension), reads_(reads), columns_(SCREE_CONTACT_INPUT_COUNT) {}

  // The contact points move apart by the unit vector of an axis.
  void displace(int axis, const double* inverse_distance) {
    for (std::uint32_t i = 0; i < batch_.count; ++i) {
      const double along = input(SCREE_NORMAL + axis, i);
      set(SCREE_OVERLAP, i, -along);
      for (int k = 0; k < dimension_; ++k) {
        const double across = (k == axis ? 1 : 0) - along * input(SCREE_NORMAL + k, i);
        set(SCREE_NORMAL + k, i, across * inverse_distance[i]);
        if (reads(SCREE_TANGENTIAL_INCREMENT)) set(SCREE_TANGENTIAL_INCREMENT + k, i, across);
      }
      if (reads(SCREE_SEPARATION)) set(SCREE_SEPARATION + axis, i, 1);
      if (reads(SCREE_CONTACT_RADIUS)) set_contact_radius(i, -along);
    }
  }

  // a turns about an axis: about z in 2D.
  void rotate(int axis) {
    if (!reads(SCREE_ORIENTATION_A)) return;
    for (std::uint32_t i = 0; i < batch_.count; ++i) {
      if (dimension_ == 2) {
        set(SCREE_ORIENTATION_A, i, 1);
        continue;
      }
      // ½ e q, e: unit vector of the axis.
      Vec3 unit = {}, vector;
      unit[axis] = 0.5;
      for (int k = 0; k < 3; ++k) vector[k] = input(SCREE_ORIENTATION_A + 1 + k, i);
      const Vec3 turned = input(SCREE_ORIENTATION_A, i) * unit + cross(unit, vector);
      set(SCREE_ORIENTATION_A, i, -dot(unit, vector));
      for (int k = 0; k < 3; ++k) set(SCREE_ORIENTATION_A + 1 + k, i, turned[k]);
    }
  }

  // Component k of a vector input changes by 1.
  void change(scree_contact_input vector, int k) {
    if (!reads(vector)) return;
    for (std::uint32_t i = 0; i < batch_.count; ++i) set(vector + k, i, 1);
  }

  const double* column(std::uint32_t k) const { return columns_[k].empty() ? nullptr : columns_[k].data(); }

 private:
  bool reads(scree_contact_input input) const { return reads_ & (1u << input); }
  double input(int column, std::uint32_t i) const {
    return batch_.input[column] ? batch_.input[column][i] : 0;
  }
  void set(int column, std::uint32_t i, double value) {
    columns_[std::size_t(column)].resize(batch_.count, 0.0);
    columns_[std::size_t(column)][i] = value;
  }
  // a = √(R* δ), with R* = a²/δ; 1/a; √a.
  void set_contact_radius(std::uint32_t i, double overlap_change) {
    const double overlap = input(SCREE_OVERLAP, i), radius = input(SCREE_CONTACT_RADIUS, i);
    const double relative = overlap > 0 ? 0.5 * overlap_change / overlap : 0;
    set(SCREE_CONTACT_RADIUS, i, radius * relative);
    set(SCREE_CONTACT_RADIUS + 1, i, -input(SCREE_CONTACT_RADIUS + 1, i) * relative);
    set(SCREE_CONTACT_RADIUS + 2, i, 0.5 * input(SCREE_CONTACT_RADIUS + 2, i) * relative);
  }

  const scree_contact_batch& batch_;
  int dimension_;
  std::uint32_t reads_;
  std::vector<std::vector<double>> columns_;  // empty: 0
};

}  // namespace

ContactJacobian::ContactJacobian(const ConfiguredLaw& law, int dimension)
    : law_(law), dimension_(dimension), spins_(dimension == 2 ? 1 : 3) {
  if (!law.instance().differentiate)
    throw Error(fmt::format("contact law '{}' has no derivatives; build it with SCREE_CONTACT_LAW_PLUGIN",
                            law.parameters().plugin().name));
}

void ContactJacobian::evaluate(const scree_contact_batch& batch, const double* inverse_distance,
                               std::vector<double>& jacobian) const {
  jacobian.assign(batch.count * std::size_t(rows() * columns()), 0.0);
  std::vector<double> response(batch.count * SCREE_ELASTIC_NORMAL);
  for (int column = 0; column < columns(); ++column) {
    InputTangent input(batch, dimension_, law_.instance().reads);
    const int k = column % rows();
    if (column < dimension_)
      input.displace(k, inverse_distance);
    else if (column < rows())
      input.rotate(k - dimension_);
    else if (k < dimension_)
      input.change(SCREE_RELATIVE_VELOCITY, k);
    else
      input.change(SCREE_RELATIVE_SPIN, k - dimension_);

    scree_contact_tangent tangent = {};
    tangent.struct_size = sizeof(tangent);
    for (std::uint32_t c = 0; c < SCREE_CONTACT_INPUT_COUNT; ++c) tangent.input[c] = input.column(c);
    for (std::uint32_t c = 0; c < SCREE_ELASTIC_NORMAL; ++c)
      tangent.output[c] = response.data() + c * batch.count;
    std::fill(response.begin(), response.end(), 0.0);
    law_.instance().differentiate(law_.storage(), &batch, &tangent);
    for (std::uint32_t i = 0; i < batch.count; ++i)
      for (int row = 0; row < rows(); ++row) {
        const int output = row < dimension_ ? SCREE_FORCE + row : SCREE_COUPLE + row - dimension_;
        jacobian[std::size_t((int(i) * rows() + row) * columns() + column)] = tangent.output[output][i];
      }
  }
}

}  // namespace scree
