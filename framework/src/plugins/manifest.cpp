#include "plugins/manifest.hpp"

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include <scree/parameters.hpp>
#include <scree/plugin/declaration.hpp>
#include <scree/plugin_host.hpp>

namespace scree {

namespace {

using Problem = std::optional<std::string>;

// More are an error in the manifest, or have no room in a Declaration.
constexpr std::uint32_t most_parameters = Declaration::capacity;

Problem missing(std::string_view what) { return fmt::format("its manifest has no {}; set it", what); }

Problem version_problem(const scree_plugin* plugin) {
  if (!plugin || plugin->struct_size < offsetof(scree_plugin, kind))
    return fmt::format("{} returned no manifest; rebuild it against this version", SCREE_QUERY_SYMBOL);
  if (plugin->abi_version != SCREE_ABI_VERSION)
    return fmt::format("plug-in interface version {}, this program has {}; rebuild it against this version",
                       plugin->abi_version, SCREE_ABI_VERSION);
  if (plugin->features != 0)
    return fmt::format("needs features {:#x} that this program lacks; use a newer scree", plugin->features);
  return {};
}

std::size_t interface_size(std::uint32_t kind) {
  switch (kind) {
    case SCREE_CONTACT_LAW:
      return sizeof(scree_contact_law);
    case SCREE_BOUNDARY:
      return sizeof(scree_boundary);
    case SCREE_BODY_FORCE:
      return sizeof(scree_body_force);
    case SCREE_PROBE:
      return sizeof(scree_probe);
  }
  return 0;
}

// Why a plug-in of the right version cannot be used all the same.
Problem build_problem(const scree_plugin& plugin) {
  if (plugin.struct_size != sizeof(scree_plugin) || plugin.parameter_size != sizeof(scree_parameter))
    return "was built with other headers of the same interface version; rebuild it against this version";
  if (plugin.numerics & SCREE_FAST_MATH)
    return "was compiled with -ffast-math or a part of it, which changes results; compile it without";
  if (plugin.numerics & SCREE_CONTRACTED)
    return "was compiled so that products and sums are fused, which changes results; add -ffp-contract=off";
  if (interface_size(plugin.kind) == 0)
    return fmt::format("contains a plug-in of an unknown kind {}; rebuild it against this version",
                       plugin.kind);
  if (!plugin.interface) return missing("interface");
  // Each interface begins with its struct_size. A member at the end of probes was added without a new
  // version.
  const auto size = *static_cast<const std::uint32_t*>(plugin.interface);
  const bool without_meaning = plugin.kind == SCREE_PROBE && size == offsetof(scree_probe, meaning);
  if (size != interface_size(plugin.kind) && !without_meaning)
    return fmt::format("has the interface of another version of a {}; rebuild it against this version",
                       kind_name(scree_kind(plugin.kind)));
  return {};
}

// A number that need not be given has a default, which is not checked when it is used.
Problem default_problem(const scree_parameter& p) {
  const bool number = p.type == SCREE_NUMBER || p.type == SCREE_INTEGER;
  if (!number || (p.flags & (SCREE_REQUIRED | SCREE_OPTIONAL))) return {};
  if (!Parameters::problem(p, {p.default_value})) return {};
  return fmt::format(
      "its parameter '{}' has the default {:g}, outside its range; give the member a value "
      "within it, or declare the parameter with .required() or .optional()",
      p.key, p.default_value);
}

// Keys that a scenario gives beside the parameters of a plug-in.
std::vector<std::string_view> keys_beside(std::uint32_t kind) {
  switch (kind) {
    case SCREE_CONTACT_LAW:
      return {"plugin", "name", "between", "control"};
    case SCREE_BOUNDARY:
      return {"plugin", "name", "material"};
    case SCREE_PROBE:
      return {"plugin", "name", "every", "observe_every", "stages", "groups", "leave_out"};
    default:
      return {"plugin", "name", "control"};
  }
}

Problem key_problem(const scree_plugin& plugin, std::string_view key) {
  const auto fits = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  };
  if (key.empty() || !std::all_of(key.begin(), key.end(), fits))
    return fmt::format("its parameter '{}' is not a key of a scenario; name it in snake_case", key);
  const std::vector<std::string_view> beside = keys_beside(plugin.kind);
  if (std::find(beside.begin(), beside.end(), key) == beside.end()) return {};
  return fmt::format("its parameter '{}' is a key that a scenario gives to every {}; rename it", key,
                     kind_name(scree_kind(plugin.kind)));
}

Problem parameter_problem(const scree_plugin& plugin, const scree_parameter& p) {
  if (!p.key) return missing("key of a parameter");
  if (const Problem problem = key_problem(plugin, p.key)) return problem;
  if (!p.unit || !p.doc) return missing(fmt::format("unit or doc of the parameter '{}'", p.key));
  if (p.type > SCREE_MESH_FILE)
    return fmt::format("its parameter '{}' has the unknown type {}; give one of scree_type", p.key, p.type);
  if (p.type == SCREE_INPUT && plugin.kind != SCREE_PROBE)
    return fmt::format("its parameter '{}' is a column of a probe, which only probes read; remove it", p.key);
  if (p.type == SCREE_MESH_FILE && (plugin.kind != SCREE_BOUNDARY || !(p.flags & SCREE_AT_START_ONLY)))
    return fmt::format(
        "its parameter '{}' is a mesh, which only boundaries have, from the start on; remove it, or "
        "set SCREE_AT_START_ONLY",
        p.key);
  if (p.type == SCREE_CHOICE && !p.choices)
    return missing(fmt::format("choices of the parameter '{}'", p.key));
  if (const Problem problem = default_problem(p)) return problem;
  const auto same_key = [&](const scree_parameter& other) {
    return other.key && std::string_view(other.key) == p.key;
  };
  if (std::count_if(plugin.parameters, plugin.parameters + plugin.parameter_count, same_key) > 1)
    return fmt::format("declares the parameter '{}' twice; rename one", p.key);
  if (!p.excludes) return {};
  for (std::uint32_t k = 0; k < plugin.parameter_count; ++k)
    if (plugin.parameters[k].key && std::string_view(plugin.parameters[k].key) == p.excludes) return {};
  return fmt::format("its parameter '{}' excludes '{}', which it does not have; give the key of another",
                     p.key, p.excludes);
}

Problem parameters_problem(const scree_plugin& plugin) {
  if (plugin.parameter_count > most_parameters)
    return fmt::format("declares {} parameters, more than the limit of {}; declare fewer",
                       plugin.parameter_count, most_parameters);
  if (plugin.parameter_count > 0 && !plugin.parameters) return missing("table of parameters");
  for (std::uint32_t k = 0; k < plugin.parameter_count; ++k)
    if (const Problem problem = parameter_problem(plugin, plugin.parameters[k])) return problem;
  return {};
}

bool has_functions(const scree_plugin& plugin) {
  switch (plugin.kind) {
    case SCREE_CONTACT_LAW: {
      const auto& law = *static_cast<const scree_contact_law*>(plugin.interface);
      return law.configure && law.closed_forms;
    }
    case SCREE_BOUNDARY: {
      const auto& boundary = *static_cast<const scree_boundary*>(plugin.interface);
      return boundary.configure && boundary.start && boundary.begin_step && boundary.finish_step;
    }
    case SCREE_BODY_FORCE: {
      const auto& force = *static_cast<const scree_body_force*>(plugin.interface);
      return force.configure && force.apply;
    }
    default: {
      const auto& probe = *static_cast<const scree_probe*>(plugin.interface);
      return probe.configure && probe.column && probe.start && probe.sample;
    }
  }
}

}  // namespace

std::optional<std::string> manifest_problem(const scree_plugin* plugin) {
  if (const Problem problem = version_problem(plugin)) return problem;
  if (const Problem problem = build_problem(*plugin)) return problem;
  if (!plugin->name) return missing("name");
  if (!plugin->summary || !plugin->equation || !plugin->source) return missing("summary, equation or source");
  if (!has_functions(*plugin)) return missing("function in its interface that is not optional");
  return parameters_problem(*plugin);
}

}  // namespace scree
