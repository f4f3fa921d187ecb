#pragma once

#include <cstddef>

#include <scree/column.hpp>
#include <scree/plugin/vec.hpp>
#include <scree/plugin_host.hpp>

namespace scree {

// Contacts without bodies: the inputs, histories and outputs of a law, set and read by hand. For checks of
// plug-ins and tools; a simulation has its own columns.
class ContactColumns {
 public:
  enum class Partner { body_or_plane, surface };
  // count: contacts. Inputs are 0, but the normal is along x, and reduced mass (kg), effective radius (m) and
  // onset weight are 1. Surfaces alone have SCREE_NORMAL_CHANGE.
  explicit ContactColumns(std::size_t count, Partner partner = Partner::body_or_plane);

  std::size_t size() const { return size_; }
  // A scalar input, or component k of a vector input. Roots of the reduced mass and contact radii are derived
  // by `batch`.
  double& input(scree_contact_input column, int k = 0, std::size_t i = 0) {
    return input_[std::size_t(column + k) * padded_ + i];
  }
  void set(scree_contact_input column, const Vec3& v, std::size_t i = 0) {
    for (int k = 0; k < 3; ++k) input(column, k, i) = v[k];
  }
  double& history(std::size_t k, std::size_t i = 0) { return history_[k * padded_ + i]; }
  double history(std::size_t k, std::size_t i = 0) const { return history_[k * padded_ + i]; }
  double output(scree_contact_output column, int k = 0, std::size_t i = 0) const {
    return output_[std::size_t(column + k) * padded_ + i];
  }
  Vec3 output_vector(scree_contact_output column, std::size_t i = 0) const {
    return {{output(column, 0, i), output(column, 1, i), output(column, 2, i)}};
  }

  // The columns as the argument of a law, all outputs included; valid as long as this object. kick: time for
  // which the forces act (s), 0: without motion.
  scree_contact_batch batch(double step, double kick = 0);
  void evaluate(const ConfiguredLaw& law, double step, double kick = 0) {
    const scree_contact_batch contacts = batch(step, kick);
    law.instance().evaluate(law.storage(), &contacts);
  }

 private:
  void derive_inputs();

  std::size_t size_, padded_;
  Partner partner_;
  Column<double> input_, history_, output_;
};

}  // namespace scree
