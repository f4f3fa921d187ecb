#include "plugins/program_checks.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <scree/parameters.hpp>
#include <scree/plugin/program.hpp>

namespace scree {

namespace {

bool out_of_range(const scree_parameter& p, double x) {
  const bool low = (p.flags & SCREE_MINIMUM_EXCLUDED) ? !(x > p.minimum) : !(x >= p.minimum);
  const bool high = (p.flags & SCREE_MAXIMUM_EXCLUDED) ? !(x < p.maximum) : !(x <= p.maximum);
  return low || high;
}

std::string kind_of(const scree_parameter& p) {
  switch (scree_type(p.type)) {
    case SCREE_INTEGER:
      return "whole number";
    case SCREE_BOOLEAN:
      return "true or false";
    case SCREE_CHOICE:
      return fmt::format("one of {}", fmt::join(choices_of(p), ", "));
    case SCREE_VECTOR:
      return "vector";
    case SCREE_LIST:
      return "list of numbers";
    case SCREE_PROGRAM:
      return "number or program of time";
    case SCREE_INPUT:
      return "\"<probe>.<column>\" of another probe";
    case SCREE_MESH_FILE:
      return "file with triangles";
    case SCREE_NUMBER:
      break;
  }
  return "number";
}

// Whether the number of values or their kind does not match the type: plug-ins read them unchecked, and use a
// choice as an index.
bool has_wrong_shape(const scree_parameter& p, const std::vector<double>& data) {
  if (p.type == SCREE_LIST || p.type == SCREE_MESH_FILE) return false;
  if (data.size() != (p.type == SCREE_VECTOR ? 3 : 1)) return true;
  const bool whole = p.type == SCREE_INTEGER || p.type == SCREE_BOOLEAN || p.type == SCREE_CHOICE;
  if (whole && data[0] != std::floor(data[0])) return true;
  return p.type == SCREE_CHOICE && !(data[0] >= 0 && data[0] < double(choices_of(p).size()));
}

}  // namespace

std::vector<std::string> choices_of(const scree_parameter& parameter) {
  std::vector<std::string> words(1);
  for (const char* c = parameter.choices ? parameter.choices : ""; *c; ++c)
    *c == '|' ? words.emplace_back() : words.back() += *c, void();
  return words;
}

std::string describe_range(const scree_parameter& p) {
  std::string text = kind_of(p);
  const char* at_least = (p.flags & SCREE_MINIMUM_EXCLUDED) ? "above" : "from";
  const char* at_most = (p.flags & SCREE_MAXIMUM_EXCLUDED) ? "below" : "to";
  const bool ranged =
      p.type == SCREE_NUMBER || p.type == SCREE_INTEGER || p.type == SCREE_LIST || p.type == SCREE_PROGRAM;
  if (ranged && std::isfinite(p.minimum)) text += fmt::format(" {} {:g}", at_least, p.minimum);
  if (ranged && std::isfinite(p.maximum)) text += fmt::format(" {} {:g}", at_most, p.maximum);
  if (*p.unit) text += fmt::format(" ({})", p.unit);
  return text;
}

Parameters::Parameters(const scree_plugin& plugin)
    : plugin_(&plugin), data_(plugin.parameter_count), given_(plugin.parameter_count, false) {
  for (std::uint32_t k = 0; k < plugin.parameter_count; ++k) {
    const scree_parameter& p = plugin.parameters[k];
    if (p.flags & (SCREE_REQUIRED | SCREE_OPTIONAL)) continue;
    if (p.type == SCREE_NUMBER || p.type == SCREE_INTEGER || p.type == SCREE_BOOLEAN ||
        p.type == SCREE_CHOICE)
      data_[k] = {p.default_value};
  }
}

std::size_t Parameters::index_of(const std::string& key) const {
  for (std::uint32_t k = 0; k < plugin_->parameter_count; ++k)
    if (key == plugin_->parameters[k].key) return k;
  throw Error("", fmt::format("{} has no parameter '{}'", plugin_->name, key),
              fmt::format("see scree describe {}", plugin_->name));
}

const scree_parameter* Parameters::find(const std::string& key) const {
  for (std::uint32_t k = 0; k < plugin_->parameter_count; ++k)
    if (key == plugin_->parameters[k].key) return &plugin_->parameters[k];
  return nullptr;
}

std::optional<Error> Parameters::problem(const scree_parameter& p, const std::vector<double>& data) {
  const auto wrong = [&](const std::string& what) {
    return Error("", what, fmt::format("give a {}", describe_range(p)));
  };
  if (data.empty()) return wrong("is empty");
  if (p.type == SCREE_INPUT) return Error("", "is a number", fmt::format("give {}", describe_range(p)));
  if (p.type == SCREE_PROGRAM) {
    if (const auto invalid = program_problem(data)) return invalid;
    const auto [least, most] = Program({data.data(), data.size()}).extremes();
    for (const double x : {least, most})
      if (out_of_range(p, x)) return wrong(fmt::format("reaches {:g}, which is out of range", x));
    return {};
  }
  if (p.type == SCREE_MESH_FILE) return {};  // checked where it becomes a surface
  for (const double x : data)
    if (!std::isfinite(x) || (p.type != SCREE_CHOICE && out_of_range(p, x)))
      return wrong(fmt::format("= {:g} is out of range", x));
  if (has_wrong_shape(p, data)) return wrong(fmt::format("= {:g} has the wrong type", fmt::join(data, ", ")));
  return {};
}

void Parameters::set(const std::string& key, std::vector<double> data) {
  const std::size_t k = index_of(key);
  if (const auto wrong = problem(plugin_->parameters[k], data))
    throw Error("", fmt::format("{}.{} {}", plugin_->name, key, wrong->problem()), wrong->cure());
  data_[k] = std::move(data);
  given_[k] = true;
}

void Parameters::set_input(const std::string& key, const std::string& name, const std::string& unit) {
  const std::size_t k = index_of(key);
  if (plugin_->parameters[k].type != SCREE_INPUT)
    throw Error("", fmt::format("{}.{} is no column of a probe", plugin_->name, key),
                fmt::format("give a {}", describe_range(plugin_->parameters[k])));
  if (!given_[k]) data_[k] = {double(inputs_.size())}, inputs_.emplace_back();
  inputs_[std::size_t(data_[k][0])] = {name, unit};
  given_[k] = true;
}

bool Parameters::given(const std::string& key) const { return given_[index_of(key)]; }

void Parameters::check_complete() const {
  for (std::uint32_t k = 0; k < plugin_->parameter_count; ++k) {
    const scree_parameter& p = plugin_->parameters[k];
    if (p.excludes) {
      const bool other = given(p.excludes);
      if (given_[k] && other)
        throw Error(plugin_->name, fmt::format("'{}' and '{}' are both given", p.key, p.excludes),
                    "keep one of them");
      if (!given_[k] && !other)
        throw Error(plugin_->name, fmt::format("neither '{}' nor '{}' is given", p.key, p.excludes),
                    "add one of them");
    } else if ((p.flags & SCREE_REQUIRED) && !given_[k]) {
      throw Error(plugin_->name, fmt::format("'{}' is missing", p.key),
                  fmt::format("add {} = <{}>", p.key, describe_range(p)));
    }
  }
}

std::vector<scree_input> Parameters::inputs() const {
  std::vector<scree_input> inputs;
  for (const NamedInput& input : inputs_) inputs.push_back({input.name.c_str(), input.unit.c_str()});
  return inputs;
}

std::vector<scree_value> Parameters::values() const {
  std::vector<scree_value> values;
  for (const auto& data : data_) values.push_back({data.data(), data.size()});
  return values;
}

}  // namespace scree
