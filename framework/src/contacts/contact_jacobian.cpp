#include <algorithm>

#include <fmt/format.h>

#include <scree/contact_jacobian.hpp>
#include <scree/error.hpp>
#include <scree/plugin/great_circle.hpp>

namespace scree {

namespace {

// The derivatives of the inputs of a batch along one direction, as columns.
class InputTangent {
 public:
  InputTangent(const scree_contact_batch& batch, int dimension, std::uint32_t reads)
      : batch_(batch), dimension_(dimension), reads_(reads), columns_(SCREE_CONTACT_INPUT_COUNT) {}

  // Component k of a motion changes by 1.
  void move(PairMotion motion, int k, std::span<const PairVariation> variations) {
    switch (motion) {
      case PairMotion::centres:
        move_surfaces(k), move_centres(k, variations);
        break;
      case PairMotion::surfaces:
        move_surfaces(k);
        break;
      case PairMotion::rotation_a:
        rotate(SCREE_ORIENTATION_A, k);
        break;
      case PairMotion::rotation_b:
        rotate(SCREE_ORIENTATION_B, k);
        break;
      case PairMotion::velocity:
        change(SCREE_RELATIVE_VELOCITY, k);
        break;
      case PairMotion::spin:
        change(SCREE_RELATIVE_SPIN, k);
        break;
    }
  }

  const double* column(std::uint32_t k) const { return columns_[k].empty() ? nullptr : columns_[k].data(); }

 private:
  // Component k of the part of a unit vector across the normal.
  double across(int axis, int k, std::uint32_t i) const {
    return (k == axis ? 1 : 0) - input(SCREE_NORMAL + axis, i) * input(SCREE_NORMAL + k, i);
  }

  void move_surfaces(int axis) {
    if (!reads(SCREE_TANGENTIAL_INCREMENT)) return;
    for (std::uint32_t i = 0; i < batch_.count; ++i)
      for (int k = 0; k < dimension_; ++k) set(SCREE_TANGENTIAL_INCREMENT + k, i, across(axis, k, i));
  }

  void move_centres(int axis, std::span<const PairVariation> variations) {
    for (std::uint32_t i = 0; i < batch_.count; ++i) {
      const double along = input(SCREE_NORMAL + axis, i);
      set(SCREE_OVERLAP, i, -along);
      const PairVariation& change = variations[i];
      for (int k = 0; k < dimension_; ++k) set(SCREE_NORMAL + k, i, change.normal[std::size_t(k)][axis]);
      if (reads(SCREE_SEPARATION)) set(SCREE_SEPARATION + axis, i, 1);
      if (batch_.input[SCREE_NORMAL_CHANGE])
        for (int k = 0; k < 6; ++k)
          set(SCREE_NORMAL_CHANGE + k, i, change.normal_change[std::size_t(k)][axis]);
      if (reads(SCREE_EFFECTIVE_RADIUS)) set(SCREE_EFFECTIVE_RADIUS, i, change.effective_radius[axis]);
      if (reads(SCREE_CONTACT_RADIUS)) set_contact_radius(i, -along, change.effective_radius[axis]);
    }
  }

  // A body turns about an axis: about z in 2D.
  void rotate(scree_contact_input orientation, int axis) {
    if (!reads(orientation)) return;
    for (std::uint32_t i = 0; i < batch_.count; ++i) {
      if (dimension_ == 2) {
        set(orientation, i, 1);
        continue;
      }
      Vec3 unit = {};
      unit[axis] = 1;
      Vec<4> quaternion;
      for (int k = 0; k < 4; ++k) quaternion[k] = input(orientation + k, i);
      const Vec<4> change = quaternion_change(quaternion, unit);
      for (int k = 0; k < 4; ++k) set(orientation + k, i, change[k]);
    }
  }

  // Component k of a vector input changes by 1.
  void change(scree_contact_input vector, int k) {
    if (!reads(vector)) return;
    for (std::uint32_t i = 0; i < batch_.count; ++i) set(vector + k, i, 1);
  }

  bool reads(scree_contact_input input) const { return reads_ & (1u << input); }
  double input(int column, std::uint32_t i) const {
    return batch_.input[column] ? batch_.input[column][i] : 0;
  }
  void set(int column, std::uint32_t i, double value) {
    columns_[std::size_t(column)].resize(batch_.count, 0.0);
    columns_[std::size_t(column)][i] = value;
  }
  // a = √(R* δ), with R* = a²/δ; 1/a; √a.
  void set_contact_radius(std::uint32_t i, double overlap_change, double effective_radius_change) {
    const double overlap = input(SCREE_OVERLAP, i), radius = input(SCREE_CONTACT_RADIUS, i);
    const double relative =
        overlap > 0 ? 0.5 * (overlap_change / overlap + effective_radius_change * overlap / (radius * radius))
                    : 0;
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

int motion_components(PairMotion motion, int dimension) {
  return is_turning(motion) && dimension == 2 ? 1 : dimension;
}

ContactJacobian::ContactJacobian(const ConfiguredLaw& law, int dimension)
    : law_(law), dimension_(dimension), spins_(dimension == 2 ? 1 : 3) {
  if (!law.instance().differentiate)
    throw Error(fmt::format("contact law '{}' has no derivatives; build it with SCREE_CONTACT_LAW_PLUGIN",
                            law.parameters().plugin().name));
}

int ContactJacobian::first(PairMotion motion) const {
  int columns = 0;
  for (int m = 0; m < int(motion); ++m) columns += motion_components(PairMotion(m), dimension_);
  return columns;
}

void ContactJacobian::evaluate(const scree_contact_batch& batch, std::span<const PairVariation> variations,
                               std::vector<double>& jacobian) const {
  jacobian.assign(batch.count * std::size_t(rows() * columns()), 0.0);
  std::vector<double> outputs(batch.count * SCREE_ELASTIC_NORMAL);
  for (int m = 0; m < pair_motions; ++m)
    for (int k = 0; k < motion_components(PairMotion(m), dimension_); ++k) {
      InputTangent input(batch, dimension_, law_.instance().reads);
      input.move(PairMotion(m), k, variations);
      scree_contact_tangent tangent = {};
      tangent.struct_size = sizeof(tangent);
      for (std::uint32_t c = 0; c < SCREE_CONTACT_INPUT_COUNT; ++c) tangent.input[c] = input.column(c);
      for (std::uint32_t c = 0; c < SCREE_ELASTIC_NORMAL; ++c)
        tangent.output[c] = outputs.data() + c * batch.count;
      std::fill(outputs.begin(), outputs.end(), 0.0);
      law_.instance().differentiate(law_.storage(), &batch, &tangent);
      const int column = first(PairMotion(m)) + k;
      for (std::uint32_t i = 0; i < batch.count; ++i) {
        double* const of_pair = jacobian.data() + i * std::size_t(rows() * columns());
        for (int row = 0; row < rows(); ++row) {
          const int output = row < dimension_ ? SCREE_FORCE + row : SCREE_COUPLE + row - dimension_;
          of_pair[row * columns() + column] = tangent.output[output][i];
        }
      }
    }
}

}  // namespace scree
