/* Probes. Part of plugin_abi.h, which plug-ins include. */
#ifndef SCREE_ABI_PROBE_H
#define SCREE_ABI_PROBE_H

#include <stddef.h>
#include <stdint.h>

#include <scree/plugin/abi/boundary.h>
#include <scree/plugin/abi/column.h>
#include <scree/plugin/abi/parameters.h>

#ifdef __cplusplus
extern "C" {
#endif

#define SCREE_MAX_NAME 64u /* bytes of a column name or unit, final zero included */

typedef struct scree_energy {
  double kinetic_translation, kinetic_rotation, kinetic_boundary;
  double elastic_normal, elastic_tangential, potential;
  double dissipated_normal, dissipated_tangential, dissipated_rolling; /* dashpots, rolling resistance */
  double dissipated_friction, dissipated_release;                      /* slip, springs let go */
  double dissipated_translation, dissipated_rotation, dissipated_boundary;
  double created;  /* by contact laws that have no potential and do not only dissipate */
  double work;     /* done by boundaries since the start */
  double residual; /* stored now − stored at the start + dissipated − created − work */
} scree_energy;

enum { SCREE_NEEDS_CONTACTS = 1u << 0 };

typedef struct scree_view {
  uint32_t struct_size;
  uint32_t dimension;
  double time;
  uint64_t step;
  uint64_t body_count;
  scree_column position[3], velocity[3], spin[3], force[3], torque[3];
  scree_column radius, mass;
  const int64_t* id;
  uint64_t contact_count;       /* contacts that touch; 0 unless SCREE_NEEDS_CONTACTS */
  const uint32_t* contact_a;    /* index of a body */
  const uint32_t* contact_b;    /* index of a body or, from body_count on, of a plane */
  const double* contact_normal; /* (contact_count, 3) */
  const double* contact_overlap;
  const double* contact_force; /* (contact_count, 3) on a */
  const uint8_t* contact_sliding;
  uint32_t plane_count;
  const scree_plane* planes;
  const scree_load* loads;
  const char* const* plane_names; /* "<boundary>.<plane>" */
  const scree_energy* energy;
} scree_view;

typedef struct scree_probe_instance {
  uint32_t struct_size;
  uint32_t needs;
  uint32_t column_count;
  uint32_t state_width; /* doubles kept by the host, for reference lengths and the like */
} scree_probe_instance;

typedef struct scree_probe {
  uint32_t struct_size;
  uint32_t storage_size;
  int (*configure)(const scree_setup* setup, void* storage, scree_probe_instance* instance);
  void (*column)(const void* storage, uint32_t column, char name[SCREE_MAX_NAME], char unit[SCREE_MAX_NAME]);
  /* Once, before the first sample: checks that the scene has what the probe looks at, sets the state. */
  int (*start)(const void* storage, const scree_view* view, double* state, char* message,
               size_t message_size);
  void (*sample)(const void* storage, const scree_view* view, const double* state, double* row);
} scree_probe;

#ifdef __cplusplus
}
#endif
#endif
