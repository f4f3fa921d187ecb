#pragma once

#include <optional>
#include <string>
#include <vector>

#include <scree/error.hpp>
#include <scree/plugin/abi.h>

namespace scree {

// The values of a plug-in's declared parameters, checked against the declaration.
class Parameters {
 public:
  explicit Parameters(const scree_plugin& plugin);

  const scree_plugin& plugin() const { return *plugin_; }
  // The declaration of a key, or null if there is none.
  const scree_parameter* find(const std::string& key) const;
  // What is wrong with numbers for a parameter, without a place, such as "= -1 is out of range; give a number
  // above 0"; nothing if they are valid.
  static std::optional<Error> problem(const scree_parameter& parameter, const std::vector<double>& data);
  // Sets a parameter. Throws Error for an unknown key or numbers that are out of range.
  void set(const std::string& key, std::vector<double> data);
  // Sets a parameter of the type SCREE_INPUT: "<probe>.<column>" and the unit of that column. Throws Error
  // for another parameter.
  void set_input(const std::string& key, const std::string& name, const std::string& unit);
  // Throws Error if a required parameter is missing or if two mutually exclusive ones are given.
  void check_complete() const;

  bool given(const std::string& key) const;
  // Whether a contact law or body force is left out of the scene, as a stage may ask.
  bool absent() const { return absent_; }
  void set_absent(bool absent) { absent_ = absent; }
  // One value per declared parameter, defaults filled in; valid until this object is changed or destroyed.
  std::vector<scree_value> values() const;
  // Columns of other probes, in the order in which they were set; valid as values() are.
  std::vector<scree_input> inputs() const;

 private:
  struct NamedInput {
    std::string name, unit;
  };
  std::size_t index_of(const std::string& key) const;

  const scree_plugin* plugin_;
  std::vector<std::vector<double>> data_;
  std::vector<bool> given_;
  std::vector<NamedInput> inputs_;
  bool absent_ = false;
};

// The words of a choice parameter: "first|second" split at '|'.
std::vector<std::string> choices_of(const scree_parameter& parameter);

// What a parameter accepts, for messages and help; for example "number above 0 (N/m)".
std::string describe_range(const scree_parameter& parameter);

}  // namespace scree
