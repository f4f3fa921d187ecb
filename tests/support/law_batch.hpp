#pragma once

#include "scenes.hpp"

#include <string>
#include <vector>

#include <scree/contact_columns.hpp>
#include <scree/contact_jacobian.hpp>

// One contact passed to a law directly, without the kernel.

namespace scree::test {

class LawBatch {
 public:
  LawBatch(const std::string& plugin, const Values& values, int dimension = 3,
           ContactColumns::Partner partner = ContactColumns::Partner::body_or_plane)
      : dimension_(dimension),
        law_(parameters(plugin, SCREE_CONTACT_LAW, values), dimension, nowhere_, nowhere_),
        contact_(1, partner) {}

  double& input(scree_contact_input column, int k = 0) { return contact_.input(column, k); }
  void set(scree_contact_input column, const Vec3& v) { contact_.set(column, v); }
  double& history(std::size_t k) { return contact_.history(k); }
  double history(std::size_t k) const { return contact_.history(k); }
  // A column of the history by name; setting one that the law does not have does nothing.
  bool has_history(const std::string& name) const { return index_of(name) < law_.instance().history_width; }
  double history(const std::string& name) const { return history(index_of(name)); }
  void set_history(const std::string& name, double value) {
    if (has_history(name)) history(index_of(name)) = value;
  }
  double output(scree_contact_output column, int k = 0) const { return contact_.output(column, k); }
  Vec3 force() const { return contact_.output_vector(SCREE_FORCE); }
  const scree_contact_instance& instance() const { return law_.instance(); }
  // kick: time for which the force acts (s); 0: without motion.
  void evaluate(double step, double kick = 0) { contact_.evaluate(law_, step, kick); }

  // Of force and couple, rows as in ContactJacobian, with component k of a motion.
  class Derivatives {
   public:
    Derivatives(const ConfiguredLaw& law, int dimension) : jacobian_(law, dimension) {}
    double operator()(int row, PairMotion motion, int k) const {
      return values_[std::size_t(row * jacobian_.columns() + jacobian_.first(motion) + k)];
    }

   private:
    friend class LawBatch;
    ContactJacobian jacobian_;
    std::vector<double> values_;
  };
  // inverse_distance: (1/m) of the centres; 0: at a plane.
  Derivatives derivatives(double inverse_distance, double step) {
    Vec3 normal;
    for (int k = 0; k < 3; ++k) normal[k] = contact_.input(SCREE_NORMAL, k);
    const std::vector<PairVariation> variations(SCREE_LANES, {across(inverse_distance, normal), {}, {}});
    Derivatives all(law_, dimension_);
    all.jacobian_.evaluate(contact_.batch(step), variations, all.values_);
    return all;
  }

 private:
  std::uint32_t index_of(const std::string& name) const {
    const scree_contact_instance& law = law_.instance();
    std::uint32_t k = 0;
    while (k < law.history_width && law.history_names[k] != name) ++k;
    return k;
  }

  static constexpr double nowhere_[3] = {0, 0, 0};
  int dimension_;
  ConfiguredLaw law_;
  ContactColumns contact_;
};

}  // namespace scree::test
