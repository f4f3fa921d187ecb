#include "law_under_check.hpp"

#include <fmt/format.h>

#include <scree/error.hpp>

namespace scree::plugin_checks {

namespace {

void append(Checks& all, const Checks& more, int dimension) {
  for (Check check : more) {
    check.name += fmt::format(", {}D", dimension);
    all.push_back(check);
  }
}

}  // namespace

Checks check_law(const Parameters& law, const std::filesystem::path& library, const CheckedPair& pair) {
  Checks all;
  const std::vector<int> dimensions = dimensions_of(law);
  for (const int dimension : dimensions) {
    const ConfiguredLaw configured(law, dimension, no_bounds, no_bounds);
    try {
      contact_time_of(configured, pair, dimension);
    } catch (const Error& error) {
      return {{"closed forms are usable", Check::Verdict::failed, error.what()}};
    }
  }
  for (const int dimension : dimensions) {
    const ConfiguredLaw configured(law, dimension, no_bounds, no_bounds);
    const double time = contact_time_of(configured, pair, dimension);
    const LawUnderCheck checked{configured, dimension,
                                Passage(dimension, pair, time > 0 ? time : 1e-3 * pair.radius / pair.speed)};
    for (const Checks& some : {check_symmetries(checked), check_direction(checked), check_parting(checked),
                               check_batches(checked), check_levels(law, library, pair, dimension),
                               check_single_precision(checked), check_derivatives(checked),
                               check_limits(law, pair, dimension), check_impacts(law, pair, dimension)})
      append(all, some, dimension);
  }
  for (const Check& check : check_machine_code(library)) all.push_back(check);
  return all;
}

}  // namespace scree::plugin_checks
