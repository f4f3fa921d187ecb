#include "plugins/plugin_call.hpp"

#include <string_view>

#include <fmt/format.h>

#include <scree/closed_forms.hpp>

namespace scree {

namespace {

constexpr std::uint32_t capacity = 32;

bool is_time(std::string_view name) {
  return name == "contact_time" || name == "critical_step" || name == "rayleigh_time";
}

}  // namespace

std::vector<scree_closed_form> closed_forms(const ConfiguredLaw& law, const scree_encounter& encounter) {
  std::vector<scree_closed_form> forms(capacity);
  const char* name = law.parameters().plugin().name;
  const std::uint32_t count = plugin_call(name, "closed_forms", [&] {
    return law.interface().closed_forms(law.storage(), &encounter, forms.data(), capacity);
  });
  if (count > capacity)
    throw Error(fmt::format("plug-in {}: states {} closed forms where there is room for {}; heed `capacity`",
                            name, count, capacity));
  forms.resize(count);
  for (const scree_closed_form& form : forms) {
    if (!form.name || !form.unit || !form.formula)
      throw Error(fmt::format("plug-in {}: a closed form has no name, unit or formula; set all three", name));
    if (is_time(form.name) && !(form.value > 0))
      throw Error(fmt::format(
          "plug-in {}: {} = {:g} s is not above 0, for a reduced mass of {:g} kg, an effective radius of "
          "{:g} m and a speed of {:g} m/s; check its parameters, or its closed forms",
          name, form.name, form.value, encounter.reduced_mass, encounter.effective_radius, encounter.speed));
  }
  return forms;
}

}  // namespace scree
