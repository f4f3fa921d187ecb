#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <limits>
#include <optional>
#include <type_traits>

#include <scree/plugin/abi.h>
#include <scree/plugin/input_column.hpp>
#include <scree/plugin/numerics.hpp>
#include <scree/plugin/program.hpp>

namespace scree {

// Accepted range of a number; bounds are included unless stated otherwise.
struct Range {
  double minimum = -std::numeric_limits<double>::infinity();
  double maximum = std::numeric_limits<double>::infinity();
  bool minimum_excluded = false;
  bool maximum_excluded = false;
};

inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr Range any_number{};
inline constexpr Range positive{.minimum = 0, .minimum_excluded = true};
inline constexpr Range non_negative{.minimum = 0};
inline constexpr Range coefficient{.minimum = 0, .maximum = 1};
inline constexpr Range positive_coefficient{.minimum = 0, .maximum = 1, .minimum_excluded = true};

// The parameters of a plug-in, declared once: the same calls describe them to the host and, during
// configuration, write the values into the author's members. A member's initial value is its default.
//   void declare(scree::Declaration& d) {
//     d.number("normal_stiffness", normal_stiffness, "N/m", scree::positive, "spring k").required();
//   }
class Declaration {
 public:
  static constexpr std::uint32_t capacity = 64;  // the host refuses more

  // Options of the parameter that was declared last.
  class Entry {
   public:
    explicit Entry(scree_parameter& parameter) : parameter_(parameter) {}
    // The parameter must be given.
    Entry& required() { return flag(SCREE_REQUIRED); }
    // The parameter may be absent; the member then keeps its initial value.
    Entry& optional() { return flag(SCREE_OPTIONAL); }
    // The parameter describes the start, and stages may not set it.
    Entry& at_start_only() { return flag(SCREE_AT_START_ONLY); }
    // Exactly one of this parameter and `key` must be given.
    Entry& or_else(const char* key) {
      parameter_.excludes = key;
      return flag(SCREE_OPTIONAL);
    }

   private:
    Entry& flag(std::uint32_t bit) {
      parameter_.flags |= bit;
      return *this;
    }
    scree_parameter& parameter_;
  };

  Declaration() = default;
  explicit Declaration(const scree_setup& setup) : values_(setup.values), inputs_(setup.inputs) {}

  Entry number(const char* key, double& member, const char* unit, const Range& range, const char* doc) {
    assign(member);
    return add(SCREE_NUMBER, key, unit, doc, member, range);
  }
  Entry integer(const char* key, int& member, const char* unit, const Range& range, const char* doc) {
    double value = member;
    assign(value);
    member = int(value);
    return add(SCREE_INTEGER, key, unit, doc, value, range);
  }
  Entry boolean(const char* key, bool& member, const char* doc) {
    double value = member ? 1 : 0;
    assign(value);
    member = value != 0;
    return add(SCREE_BOOLEAN, key, "", doc, value, {.minimum = 0, .maximum = 1});
  }
  // `choices` is "first|second|third"; the member holds the index.
  Entry choice(const char* key, int& member, const char* choices, const char* doc) {
    double value = member;
    assign(value);
    member = int(value);
    const Entry entry = add(SCREE_CHOICE, key, "", doc, value, any_number);
    last().choices = choices;
    return entry;
  }
  Entry vector(const char* key, std::array<double, 3>& member, const char* unit, const char* doc) {
    if (const scree_value* value = next())
      for (int k = 0; k < 3; ++k) member[k] = value->data[k];
    return add(SCREE_VECTOR, key, unit, doc, 0, any_number);
  }
  // Optional: the member stays empty if the vector is not given.
  Entry vector(const char* key, std::optional<std::array<double, 3>>& member, const char* unit,
               const char* doc) {
    if (const scree_value* value = next()) member = {value->data[0], value->data[1], value->data[2]};
    return add(SCREE_VECTOR, key, unit, doc, 0, any_number).optional();
  }
  // The member becomes a view of the host's numbers, valid as long as the configuration.
  Entry list(const char* key, scree_value& member, const char* unit, const Range& range, const char* doc) {
    if (const scree_value* value = next()) member = *value;
    return add(SCREE_LIST, key, unit, doc, 0, range);
  }
  Entry program(const char* key, Program& member, const char* unit, const Range& range, const char* doc) {
    if (const scree_value* value = next()) member = Program(*value);
    return add(SCREE_PROGRAM, key, unit, doc, 0, range);
  }
  // A file with triangles; the member becomes a view of their numbers, see SCREE_MESH_FILE.
  Entry mesh(const char* key, scree_value& member, const char* doc) {
    if (const scree_value* value = next()) member = *value;
    return add(SCREE_MESH_FILE, key, "", doc, 0, any_number);
  }
  // A column of another probe; of probes only.
  Entry input(const char* key, InputColumn& member, const char* doc) {
    if (const scree_value* value = next()) {
      const std::uint32_t number = std::uint32_t(value->data[0]);
      member = {inputs_[number].name, inputs_[number].unit, number};
    }
    return add(SCREE_INPUT, key, "", doc, 0, any_number);
  }

  const scree_parameter* table() const { return table_.data(); }
  std::uint32_t count() const { return count_; }

 private:
  // The value of the parameter being declared; null if it was not given or if values are not being assigned.
  const scree_value* next() const {
    return values_ && values_[count_].count > 0 ? &values_[count_] : nullptr;
  }
  scree_parameter& last() { return table_[(count_ < capacity ? count_ : capacity) - 1]; }
  void assign(double& member) const {
    if (const scree_value* value = next()) member = value->data[0];
  }
  Entry add(scree_type type, const char* key, const char* unit, const char* doc, double initial,
            const Range& range) {
    ++count_;
    scree_parameter& p = last();
    p = {.struct_size = sizeof(scree_parameter),
         .type = std::uint32_t(type),
         .flags = (range.minimum_excluded ? std::uint32_t(SCREE_MINIMUM_EXCLUDED) : 0) |
                  (range.maximum_excluded ? std::uint32_t(SCREE_MAXIMUM_EXCLUDED) : 0),
         .key = key,
         .unit = unit,
         .doc = doc,
         .choices = nullptr,
         .excludes = nullptr,
         .default_value = initial,
         .minimum = range.minimum,
         .maximum = range.maximum};
    return Entry(p);
  }

  const scree_value* values_ = nullptr;
  const scree_input* inputs_ = nullptr;
  std::array<scree_parameter, capacity> table_ = {};
  std::uint32_t count_ = 0;
};

// What an author's `prepare` can read besides the parameters: dimension and bounding box of the bodies (m).
// `refuse` makes the configuration fail.
class Setup {
 public:
  explicit Setup(const scree_setup& setup) : setup_(setup) {}
  int dimension() const { return int(setup_.dimension); }
  double lower(int axis) const { return setup_.lower[axis]; }
  double upper(int axis) const { return setup_.upper[axis]; }
  // message: the problem and a remedy, in one line.
  void refuse(const char* message) const {
    std::snprintf(setup_.message, setup_.message_size, "%s", message);
    refused_ = true;
  }
  bool refused() const { return refused_; }

 private:
  const scree_setup& setup_;
  mutable bool refused_ = false;
};

// Constructs an author's struct in the host's storage, assigns its parameters and calls its `prepare`.
// Returns 0 on success, 1 if `prepare` refused or threw an exception, which becomes the message.
template <class Author>
int configure_author(const scree_setup* setup, void* storage) try {
  static_assert(sizeof(Author) <= SCREE_MAX_INSTANCE_SIZE, "keep large data in the host's state");
  static_assert(std::is_trivially_copyable_v<Author> && std::is_trivially_destructible_v<Author>);
  Author* author = ::new (storage) Author{};
  Declaration declaration(*setup);
  author->declare(declaration);
  if constexpr (requires(const Setup& s) { author->prepare(s); }) {
    const Setup view(*setup);
    author->prepare(view);
    return view.refused() ? 1 : 0;
  }
  return 0;
} catch (const std::exception& exception) {
  Setup(*setup).refuse(exception.what());
  return 1;
}

// Documentation of a plug-in, shown by `scree describe`; each line of `equation` is one equation.
struct About {
  const char* name;
  const char* summary;
  const char* equation;
  const char* source;
};

// The manifest of a plug-in: its kind, documentation, declared parameters and function table.
template <class Author, class Interface>
const scree_plugin* manifest_of(scree_kind kind, const Interface& interface) {
  static const Declaration declaration = [] {
    Declaration d;
    Author author{};
    author.declare(d);
    return d;
  }();
  static const scree_plugin plugin = {.struct_size = sizeof(scree_plugin),
                                      .abi_version = SCREE_ABI_VERSION,
                                      .kind = std::uint32_t(kind),
                                      .parameter_count = declaration.count(),
                                      .features = 0,
                                      .numerics = detail::numeric_settings(),
                                      .parameter_size = sizeof(scree_parameter),
                                      .name = Author::about.name,
                                      .summary = Author::about.summary,
                                      .equation = Author::about.equation,
                                      .source = Author::about.source,
                                      .parameters = declaration.table(),
                                      .interface = &interface};
  return &plugin;
}

#define SCREE_EXPORT_PLUGIN(manifest)                                                              \
  extern "C" __attribute__((visibility("default"))) const scree_plugin* scree_plugin_query(void) { \
    return manifest;                                                                               \
  }

}  // namespace scree
