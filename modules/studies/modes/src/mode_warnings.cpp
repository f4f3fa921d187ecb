#include "mode_warnings.hpp"

#include <fmt/format.h>

#include <scree/counted.hpp>

namespace scree::modes {

namespace {

std::string numbers_above(const Vibration& vibration, double residual_limit) {
  std::string numbers;
  for (const Mode& m : vibration.modes)
    if (m.kind == ModeKind::vibrating && m.residual > residual_limit)
      numbers += fmt::format("{}{}", numbers.empty() ? "" : ", ", m.number);
  return numbers;
}

}  // namespace

std::vector<std::string> mode_warnings(const Vibration& vibration, bool of_full_stiffness,
                                       double residual_limit) {
  std::vector<std::string> warnings;
  if (!of_full_stiffness)
    warnings.push_back(
        "unstable and floppy modes are those of the symmetric part of K, and with all of it some may be neither: its "
        "asymmetry, by sliding contacts, is large; let the packing come to rest with less sliding");
  if (vibration.unstable > 0)
    warnings.push_back(
        fmt::format("the packing is unstable: {} (modes.csv); let it come to rest, or hold what is loose",
                    counted(vibration.unstable, "mode grows", "modes grow")));
  if (vibration.floppy > 0)
    warnings.push_back(fmt::format(
        "K is singular at 0 Hz: {} floppy; see floppy.csv, or leave {} bodies out by --fewest-contacts",
        counted(vibration.floppy, "mode is", "modes are"), vibration.floppy == 1 ? "its" : "their"));
  if (const std::string numbers = numbers_above(vibration, residual_limit); !numbers.empty())
    warnings.push_back(fmt::format(
        "with the full, asymmetric K residuals are above {1:g}, those of: {0}; take these frequencies as approximate",
        numbers, residual_limit));
  if (!vibration.complete && !vibration.modes.empty())
    warnings.push_back(
        "the count of modes does not confirm that none is left out; ask for more with --modes");
  return warnings;
}

}  // namespace scree::modes
