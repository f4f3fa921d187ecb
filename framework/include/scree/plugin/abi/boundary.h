/* Interface of boundaries. Part of abi.h, which plug-ins include. */
#ifndef SCREE_ABI_BOUNDARY_H
#define SCREE_ABI_BOUNDARY_H

#include <stddef.h>
#include <stdint.h>

#include <scree/plugin/abi/parameters.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct scree_plane { /* a wall */
  double point[3];           /* (m) */
  double normal[3];          /* unit, pointing to the bodies */
  double velocity[3];        /* (m/s) at the end of the step */
  double mid_velocity[3];    /* (m/s) displacement in the step / step */
} scree_plane;

typedef struct scree_load {
  double force[3]; /* (N) of all contacts on the plane */
} scree_load;

typedef struct scree_boundary_energy { /* totals since the start of the run, except `kinetic` */
  double kinetic;                      /* (J) present value */
  double work;                         /* (J) done on the scene by loads and prescribed motion */
  double dissipated;                   /* (J) by the boundary's own viscosity */
} scree_boundary_energy;

typedef struct scree_boundary_step {
  uint32_t struct_size;
  uint32_t dimension;
  double time;             /* (s) at the start of the step, counted from the last change of parameters */
  double step;             /* (s) */
  const scree_load* loads; /* plane_count; at the start (begin_step) or the end (finish_step) of the step */
  scree_plane* planes;     /* plane_count */
  double* state;           /* state_width doubles, which the host stores and hashes */
  scree_boundary_energy* energy;
} scree_boundary_step;

typedef struct scree_boundary_instance {
  uint32_t struct_size;
  uint32_t plane_count;
  uint32_t state_width;
  uint32_t periodic[3];           /* nonzero: the axis is periodic between lower and upper */
  double lower[3], upper[3];      /* (m) */
  const char* const* plane_names; /* (optional) plane_count names */
  const double* plane_masses; /* (optional) plane_count masses (kg), in the plug-in's storage; 0 for planes
                                 that forces do not move */
  double damping_rate; /* (1/s) at which the boundary's own viscosity slows its lightest plane; 0 without */
  uint32_t still;      /* nonzero: no plane moves, and steps call neither `begin_step` nor `finish_step`;
                          `finish_step` is called with step 0 before and after a change of parameters */
} scree_boundary_instance;

typedef struct scree_boundary {
  uint32_t struct_size;
  uint32_t storage_size;
  int (*configure)(const scree_setup* setup, void* storage, scree_boundary_instance* instance);
  /* Called once: sets state and planes at the start. */
  void (*start)(const void* storage, const scree_boundary_step* step);
  /* First half of a step: moves the planes from t to t + step. */
  void (*begin_step)(const void* storage, const scree_boundary_step* step);
  /* Second half: sets the velocities at t + step and adds to the energies. */
  void (*finish_step)(const void* storage, const scree_boundary_step* step);
} scree_boundary;

#ifdef __cplusplus
}
#endif
#endif
