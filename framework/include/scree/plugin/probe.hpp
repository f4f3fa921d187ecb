#pragma once

#include <cstdio>
#include <string>

#include <scree/plugin/abi.h>
#include <scree/plugin/declaration.hpp>
#include <scree/plugin/vec.hpp>

// How to write a probe: plugins/README.md. An author's struct has
//
//   static constexpr scree::About about;
//   void declare(scree::Declaration&);
//   void prepare(const scree::Setup&);                         optional: derived values, refusals
//   void describe(scree_probe_instance&) const;                columns, state, whether contacts are needed
//   scree::ColumnName column(std::uint32_t) const;             name and unit of a column
//   const char* start(const scree_view&, double* state) const; null, or the problem and a remedy
//   void sample(const scree_view&, const double* state, double* row) const;   writes one row of values

namespace scree {

// Name and unit of a column of a probe.
struct ColumnName {
  std::string name;  // snake_case
  std::string unit;  // "" if dimensionless
};

// Index of the body with an id; body_count if there is none. Takes a linear search.
inline std::uint64_t index_of_body(const scree_view& view, double id) {
  std::uint64_t i = 0;
  while (i < view.body_count && double(view.id[i]) != id) ++i;
  return i;
}

// A vector of body i; components that the scene does not carry are 0.
inline Vec3 vector_of(const scree_column (&columns)[3], std::uint64_t i) {
  Vec3 v = {};
  for (int k = 0; k < 3; ++k)
    if (columns[k]) v[k] = columns[k][i];
  return v;
}

namespace detail {

template <class Author>
int configure_probe(const scree_setup* setup, void* storage, scree_probe_instance* instance) {
  if (const int failed = configure_author<Author>(setup, storage)) return failed;
  *instance = {};
  instance->struct_size = sizeof(*instance);
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
int start_probe(const void* storage, const scree_view* view, double* state, char* message,
                size_t message_size) {
  const char* problem = static_cast<const Author*>(storage)->start(*view, state);
  if (problem) std::snprintf(message, message_size, "%s", problem);
  return problem ? 1 : 0;
}
template <class Author>
void sample_probe(const void* storage, const scree_view* view, const double* state, double* row) {
  static_cast<const Author*>(storage)->sample(*view, state, row);
}

}  // namespace detail

#define SCREE_PROBE_PLUGIN(Author)                                                     \
  static const scree_probe scree_interface = {sizeof(scree_probe),                     \
                                              sizeof(Author),                          \
                                              &scree::detail::configure_probe<Author>, \
                                              &scree::detail::column_of_probe<Author>, \
                                              &scree::detail::start_probe<Author>,     \
                                              &scree::detail::sample_probe<Author>};   \
  SCREE_EXPORT_PLUGIN((scree::manifest_of<Author>(SCREE_PROBE, scree_interface)))

}  // namespace scree
