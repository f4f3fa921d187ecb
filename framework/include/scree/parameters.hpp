#pragma once

#include <optional>
#include <string>
#include <vector>

#include <scree/plugin/abi.h>

namespace scree {

// The values of a plug-in's declared parameters, checked against their declaration.
class Parameters {
 public:
  explicit Parameters(const scree_plugin& plugin);

  const scree_plugin& plugin() const { return *plugin_; }
  // The declaration of a key, or null.
  const scree_parameter* find(const std::string& key) const;
  // What is wrong with these numbers for a parameter, as "<problem>; <cure>", or nothing.
  static std::optional<std::string> problem(const scree_parameter& parameter,
                                            const std::vector<double>& data);
  // Throws Error for an unknown key or numbers out of range.
  void set(const std::string& key, std::vector<double> data);
  // Throws Error if a required parameter is missing or two that exclude each other are given.
  void check_complete() const;

  bool given(const std::string& key) const;
  // One value per declared parameter with defaults filled in; valid while this object lives unchanged.
  std::vector<scree_value> values() const;

 private:
  std::size_t index_of(const std::string& key) const;

  const scree_plugin* plugin_;
  std::vector<std::vector<double>> data_;
  std::vector<bool> given_;
};

// The words of a choice parameter, "first|second" split.
std::vector<std::string> choices_of(const scree_parameter& parameter);

// "number above 0 (N/m)": what a parameter accepts, for messages and help.
std::string describe_range(const scree_parameter& parameter);

}  // namespace scree
