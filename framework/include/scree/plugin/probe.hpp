#pragma once

#include <cmath>
#include <cstdio>
#include <string>
#include <type_traits>

#include <scree/plugin/abi.h>
#include <scree/plugin/body_list.hpp>
#include <scree/plugin/declaration.hpp>
#include <scree/plugin/vec.hpp>

// How to write a probe: plugins/README.md; when each function is called: abi/probe.h. An author's struct has
//
//   static constexpr scree::About about;
//   void declare(scree::Declaration&);
//   void prepare(const scree::Setup&);                 optional: derived values, refusals
//   void describe(scree_probe_instance&) const;        columns, needs, width of the state
//   scree::ColumnName column(std::uint32_t) const;     name, unit and meaning of a column
//   std::uint64_t state_size(const scree_view&) const; optional: width of a state that depends on the scene
//   std::string start(const scree_view&, double* state) const;   optional: sets the state; returns the problem
//                                                      and a remedy, or "" (or const char*, null without one)
//   void observe(const scree_view&, double* state) const;        optional: updates the state at every step
//   void sample(const scree_view&, const double* state, double* row) const;   writes one row of values
//   void mark_bodies(const scree_view&, const double* state, std::uint8_t* marks) const;   optional: 1 for the
//                                                      bodies that observe and sample read, if these are few
//   void accumulate(const scree_view& part, std::uint32_t pass, double* totals) const;   optional: adds sums of a
//                                                      part, which sample finds for all parts in view.totals
//
// `describe` may set `observes` to 0 if the parameters make observation unnecessary, and sets `leaves_out` to
// 1 in a probe that asks counts() of each body, so that scenarios may choose the bodies.

namespace scree {

// Name, unit and meaning of a column of a probe.
struct ColumnName {
  std::string name;  // snake_case
  std::string unit;  // "" if dimensionless
  std::string
      meaning{};  // one line for scree describe; columns that differ in a number, as x_1 and x_2, have the same
};

// A vector of body i; components that the scene does not carry are 0.
inline Vec3 vector_of(const scree_column (&columns)[3], std::uint64_t i) {
  Vec3 v = {};
  for (int k = 0; k < 3; ++k)
    if (columns[k]) v[k] = columns[k][i];
  return v;
}

// Position of body i (m) on its path without jumps at periodic faces.
inline Vec3 unwrapped_position(const scree_view& view, std::uint64_t i) {
  Vec3 x = vector_of(view.position, i);
  for (int k = 0; k < 3; ++k)
    if (view.image[k]) x[k] += view.image[k][i] * view.period[k];
  return x;
}

// Whether the scenario counts body i in this probe.
inline bool counts(const scree_view& view, std::uint64_t i) { return !view.left_out || !view.left_out[i]; }

// Whether it counts a body of contact c.
inline bool counts_contact(const scree_view& view, std::uint64_t c) {
  const std::uint32_t b = view.contact_b[c];
  return counts(view, view.contact_a[c]) || (b < view.body_count && counts(view, b));
}

// The problem and a remedy if there is no wall of this number, counted from 1; otherwise "".
inline std::string missing_wall(const scree_view& view, double number) {
  if (number >= 1 && number <= view.plane_count && number == std::floor(number)) return "";
  char problem[160];
  std::snprintf(problem, sizeof(problem),
                "wall %.16g does not exist; the scene has %u, numbered from 1 in the order of the "
                "[[boundary]] entries",
                number, view.plane_count);
  return problem;
}

// The same of surfaces.
inline std::string missing_surface(const scree_view& view, double number) {
  if (number >= 1 && number <= view.surface_count && number == std::floor(number)) return "";
  char problem[200];
  std::snprintf(
      problem, sizeof(problem),
      "surface %.16g does not exist; the scene has %u, numbered from 1 in the order of the [[boundary]] "
      "entries; planes and boxes do not count",
      number, view.surface_count);
  return problem;
}

namespace detail {

template <class Author>
concept StartingProbe = requires(const Author& author, const scree_view& view, double* state) {
  author.start(view, state);
};
template <class Author>
concept ObservingProbe = requires(const Author& author, const scree_view& view, double* state) {
  author.observe(view, state);
};
template <class Author>
concept SceneSizedProbe = requires(const Author& author, const scree_view& view) {
  author.state_size(view);
};

template <class Author>
concept MarkingProbe = requires(const Author& author, const scree_view& view, const double* state,
                                std::uint8_t* marks) {
  author.mark_bodies(view, state, marks);
};

template <class Author>
concept AccumulatingProbe = requires(const Author& author, const scree_view& part, double* totals) {
  author.accumulate(part, 0u, totals);
};

template <class Author>
int configure_probe(const scree_setup* setup, void* storage, scree_probe_instance* instance) {
  if (const int failed = configure_author<Author>(setup, storage)) return failed;
  *instance = {};
  instance->struct_size = sizeof(*instance);
  instance->observes = ObservingProbe<Author>;
  instance->passes = AccumulatingProbe<Author>;
  static_cast<const Author*>(storage)->describe(*instance);
  return 0;
}
template <class Author>
void column_of_probe(const void* storage, std::uint32_t column, char name[SCREE_MAX_NAME],
                     char unit[SCREE_MAX_NAME]) {
  const ColumnName c = static_cast<const Author*>(storage)->column(column);
  std::snprintf(name, SCREE_MAX_NAME, "%s", c.name.c_str());
  std::snprintf(unit, SCREE_MAX_NAME, "%s", c.unit.c_str());
}
template <class Author>
void meaning_of_probe(const void* storage, std::uint32_t column, char text[SCREE_MAX_MEANING]) {
  std::snprintf(text, SCREE_MAX_MEANING, "%s",
                static_cast<const Author*>(storage)->column(column).meaning.c_str());
}
template <class Author>
std::uint64_t state_size_of_probe(const void* storage, const scree_view* view) {
  return static_cast<const Author*>(storage)->state_size(*view);
}
template <class Author>
int start_probe(const void* storage, const scree_view* view, double* state, char* message,
                size_t message_size) {
  if constexpr (StartingProbe<Author>) {
    const auto problem = static_cast<const Author*>(storage)->start(*view, state);
    const char* text;
    if constexpr (std::is_convertible_v<decltype(problem), const char*>)
      text = problem ? problem : "";
    else
      text = problem.c_str();
    std::snprintf(message, message_size, "%s", text);
    return *text != 0;
  }
  return 0;
}
template <class Author>
void observe_probe(const void* storage, const scree_view* view, double* state) {
  static_cast<const Author*>(storage)->observe(*view, state);
}
template <class Author>
void sample_probe(const void* storage, const scree_view* view, const double* state, double* row) {
  static_cast<const Author*>(storage)->sample(*view, state, row);
}

template <class Author>
void mark_bodies_of_probe(const void* storage, const scree_view* view, const double* state,
                          std::uint8_t* marks) {
  static_cast<const Author*>(storage)->mark_bodies(*view, state, marks);
}

template <class Author>
void accumulate_probe(const void* storage, const scree_view* part, std::uint32_t pass, double* totals) {
  static_cast<const Author*>(storage)->accumulate(*part, pass, totals);
}

template <class Author>
constexpr scree_probe make_probe_interface() {
  scree_probe p = {};
  p.struct_size = sizeof(p);
  p.storage_size = sizeof(Author);
  p.configure = &configure_probe<Author>;
  p.column = &column_of_probe<Author>;
  if constexpr (SceneSizedProbe<Author>) p.state_size = &state_size_of_probe<Author>;
  p.start = &start_probe<Author>;
  if constexpr (ObservingProbe<Author>) p.observe = &observe_probe<Author>;
  p.sample = &sample_probe<Author>;
  p.meaning = &meaning_of_probe<Author>;
  if constexpr (MarkingProbe<Author>) p.mark_bodies = &mark_bodies_of_probe<Author>;
  if constexpr (AccumulatingProbe<Author>) p.accumulate = &accumulate_probe<Author>;
  return p;
}

}  // namespace detail

// Function table of a probe.
template <class Author>
inline constexpr scree_probe probe_interface = detail::make_probe_interface<Author>();

#define SCREE_PROBE_PLUGIN(Author) \
  SCREE_EXPORT_PLUGIN((scree::manifest_of<Author>(SCREE_PROBE, scree::probe_interface<Author>)))

}  // namespace scree
