#include "plugins/plugin_call.hpp"

#include <algorithm>
#include <cmath>
#include <new>
#include <type_traits>

#include <fmt/format.h>

#include <scree/counted.hpp>
#include <scree/error.hpp>
#include <scree/plugin_host.hpp>

namespace scree {

namespace {

void check_instance(const char* name, const scree_contact_instance& i) {
  if (i.history_width > SCREE_MAX_HISTORY || !i.evaluate)
    throw Error(fmt::format("plug-in {}: keeps {} of at most {}, or has no evaluate function", name,
                            counted(i.history_width, "history column"), SCREE_MAX_HISTORY));
  constexpr std::uint32_t columns = 1u << SCREE_NORMAL | 1u << SCREE_OVERLAP | 1u << SCREE_RELATIVE_VELOCITY |
                                    1u << SCREE_TANGENTIAL_INCREMENT | 1u << SCREE_RELATIVE_SPIN |
                                    1u << SCREE_ONSET_WEIGHT | 1u << SCREE_CONTACT_RADIUS |
                                    1u << SCREE_REDUCED_MASS | 1u << SCREE_REDUCED_MASS_ROOT |
                                    1u << SCREE_EFFECTIVE_RADIUS | 1u << SCREE_ORIENTATION_A |
                                    1u << SCREE_ORIENTATION_B | 1u << SCREE_SEPARATION | 1u << SCREE_RADII;
  if ((i.reads & ~columns) != 0 || i.arms > SCREE_ARM_RADIUS ||
      i.sliding_column >= std::int32_t(i.history_width))
    throw Error(
        fmt::format("plug-in {}: reads {:#x}, arms {} or sliding_column {} name what there is not; "
                    "use the values of contact_law.h",
                    name, i.reads, i.arms, i.sliding_column));
  for (const double power : {i.onset_power, i.parting_power})
    if (!(power >= 0) || (power < 1 && std::fmod(4 * power, 1) != 0))
      throw Error(
          fmt::format("plug-in {}: onset or parting power {:g} is not supported; "
                      "use 0, 1/4, 1/2, 3/4, or 1 or more for forces without onset weights",
                      name, power));
}
template <class Instance>
void check_instance(const char*, const Instance&) {}

}  // namespace

template <class Interface, class Instance>
Configured<Interface, Instance>::Configured(const Parameters& parameters, int dimension,
                                            const double (&lower)[3], const double (&upper)[3])
    : parameters_(std::make_unique<Parameters>(parameters)),
      storage_(::operator new(SCREE_MAX_INSTANCE_SIZE, std::align_val_t(64))) {
  if constexpr (std::is_same_v<Interface, scree_contact_law>) check_dimension(*parameters_, dimension);
  parameters_->check_complete();
  const std::vector<scree_value> values = parameters_->values();
  const std::vector<scree_input> inputs = parameters_->inputs();
  char message[512] = "";
  scree_setup setup = {};
  setup.struct_size = sizeof(setup);
  setup.dimension = std::uint32_t(dimension);
  setup.values = values.data();
  setup.input_count = std::uint32_t(inputs.size());
  setup.inputs = inputs.data();
  for (int k = 0; k < 3; ++k) setup.lower[k] = lower[k], setup.upper[k] = upper[k];
  setup.message = message;
  setup.message_size = sizeof(message);

  const char* name = parameters_->plugin().name;
  if (interface().storage_size > SCREE_MAX_INSTANCE_SIZE)
    throw Error(fmt::format("plug-in {}: needs {} bytes of storage, more than the limit of {}", name,
                            interface().storage_size, SCREE_MAX_INSTANCE_SIZE));
  const int failed = plugin_call(name, "configure", [&] {
    if constexpr (std::is_same_v<Instance, NoInstance>)
      return interface().configure(&setup, storage_.get());
    else
      return interface().configure(&setup, storage_.get(), &instance_);
  });
  message[sizeof(message) - 1] = 0;
  if (failed) throw Error(fmt::format("{}: {}", name, *message ? message : "refused its parameters"));
  check_instance(name, instance_);
}

void check_dimension(const Parameters& law, int dimension) {
  const std::vector<int> dimensions = dimensions_of(law);
  if (std::find(dimensions.begin(), dimensions.end(), dimension) != dimensions.end()) return;
  throw Error(fmt::format("{}: a law of {}; set [scene] dimension = {}, or choose a law for {}D",
                          law.plugin().name, dimension == 2 ? "spheres" : "discs", dimension == 2 ? 3 : 2,
                          dimension));
}

bool keeps_spring(const scree_contact_instance& law, int dimension) {
  constexpr std::string_view names[] = {"spring_x", "spring_y", "spring_z"};
  if (!law.history_names || law.history_width < std::uint32_t(dimension)) return false;
  return std::equal(names, names + dimension, law.history_names);
}

std::vector<int> dimensions_of(const Parameters& law) {
  std::vector<int> dimensions;
  for (const int dimension : {2, 3})
    if (static_cast<const scree_contact_law*>(law.plugin().interface)->dimensions & (1u << dimension))
      dimensions.push_back(dimension);
  return dimensions;
}

template class Configured<scree_contact_law, scree_contact_instance>;
template class Configured<scree_boundary, scree_boundary_instance>;
template class Configured<scree_body_force, NoInstance>;
template class Configured<scree_probe, scree_probe_instance>;

}  // namespace scree
