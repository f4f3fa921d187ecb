/* Interface of probes. Part of abi.h, which plug-ins include. */
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

typedef struct scree_energy { /* the energy balance (J); dissipated, created and work since the start */
  double kinetic_translation, kinetic_rotation, kinetic_boundary;
  double elastic_normal, elastic_tangential, potential;
  double dissipated_normal, dissipated_tangential, dissipated_rolling; /* dashpots, rolling resistance */
  double dissipated_friction, dissipated_release;                      /* slip, released springs */
  double dissipated_translation, dissipated_rotation, dissipated_boundary;
  double created;  /* by contact laws that are neither conservative nor purely dissipative */
  double work;     /* done by boundaries */
  double residual; /* stored now − stored at the start + dissipated − created − work */
} scree_energy;

enum { SCREE_NEEDS_CONTACTS = 1u << 0 };

typedef struct scree_view {
  uint32_t struct_size;
  uint32_t dimension;
  double time;   /* (s) */
  uint64_t step; /* number of steps taken */
  uint64_t body_count;
  scree_column position[3], velocity[3], spin[3], force[3], torque[3];
  scree_column radius, mass;
  const int64_t* id;
  uint64_t contact_count;       /* touching pairs; 0 unless SCREE_NEEDS_CONTACTS */
  const uint32_t* contact_a;    /* index of a body */
  const uint32_t* contact_b;    /* index of a body or, from body_count on, of a plane */
  const double* contact_normal; /* (contact_count, 3) unit, from b to a */
  const double* contact_overlap;
  const double* contact_force;    /* (contact_count, 3) on a (N) */
  const uint8_t* contact_sliding; /* 1 while the contact slides */
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
  uint32_t state_width; /* doubles that the host stores, such as reference lengths */
} scree_probe_instance;

typedef struct scree_probe {
  uint32_t struct_size;
  uint32_t storage_size;
  int (*configure)(const scree_setup* setup, void* storage, scree_probe_instance* instance);
  void (*column)(const void* storage, uint32_t column, char name[SCREE_MAX_NAME], char unit[SCREE_MAX_NAME]);
  /* Called before the first sample: checks that the scene has what the probe reads, and sets the state. */
  int (*start)(const void* storage, const scree_view* view, double* state, char* message,
               size_t message_size);
  /* Writes one row of column_count values. */
  void (*sample)(const void* storage, const scree_view* view, const double* state, double* row);
} scree_probe;

#ifdef __cplusplus
}
#endif
#endif
