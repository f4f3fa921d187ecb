#pragma once

#include "passage.hpp"

#include <functional>
#include <optional>
#include <string_view>

namespace scree::plugin_checks {

// A configured law in one dimension, and what the checks of its batches share.
struct LawUnderCheck {
  const ConfiguredLaw& law;
  int dimension;
  Passage passage;

  static constexpr int variants = 12;

  int spins() const { return dimension == 2 ? 1 : 3; }
  bool has_couple() const { return law.instance().writes_couple; }
  // Takes a number of contacts, each in a frame and a variant, through the passage; `visit` is called after
  // each step. Variants are numbered from `first`.
  void follow(ContactColumns& contacts, const Frame& frame, int first,
              const std::function<void(int step)>& visit) const;
};

// A closed form of the law for the checked pair, if it states one. Throws Error as closed_forms() does.
std::optional<double> closed_form(const ConfiguredLaw& law, const CheckedPair& pair, int dimension,
                                  std::string_view name);
// The law's own contact time (s); 0 if it states none or an infinite one.
double contact_time_of(const ConfiguredLaw& law, const CheckedPair& pair, int dimension);

// One family of checks each; names are the same in both dimensions.
Checks check_symmetries(const LawUnderCheck& law);
Checks check_direction(const LawUnderCheck& law);
Checks check_parting(const LawUnderCheck& law);
Checks check_batches(const LawUnderCheck& law);
Checks check_derivatives(const LawUnderCheck& law);
Checks check_impacts(const Parameters& law, const CheckedPair& pair, int dimension);
Checks check_limits(const Parameters& law, const CheckedPair& pair, int dimension);
Checks check_levels(const Parameters& law, const std::filesystem::path& library, const CheckedPair& pair,
                    int dimension);
Checks check_machine_code(const std::filesystem::path& library);

// A check that passes if a measured value is at most a bound.
Check bounded(const std::string& name, double measured, double bound);

}  // namespace scree::plugin_checks
