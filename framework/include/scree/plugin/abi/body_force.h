/* Interface of body forces. Part of abi.h, which plug-ins include. */
#ifndef SCREE_ABI_BODY_FORCE_H
#define SCREE_ABI_BODY_FORCE_H

#include <stddef.h>
#include <stdint.h>

#include <scree/plugin/abi/column.h>
#include <scree/plugin/abi/parameters.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A range of the scene's bodies; several batches may be evaluated at the same time. */
typedef struct scree_body_batch {
  uint32_t struct_size;
  uint32_t dimension;
  uint32_t count;
  scree_column position[3], velocity[3];
  scree_column spin[3];                  /* in 2D only [2] */
  scree_column radius;                   /* same stride as all columns above */
  scree_column mass, inertia;            /* stride 1 */
  scree_load_column force[3], torque[3]; /* the same stride for all; the plug-in adds to them */
  uint32_t audit;                        /* nonzero: the energies below are required */
  double potential;                      /* (J) output, added to */
  double dissipation_rate_translation;   /* (W) output, added to */
  double dissipation_rate_rotation;      /* (W) output, added to */
  const int32_t* image[3]; /* (optional) periods each body has crossed; NULL: axis not periodic */
  double period[3];        /* (m) */
  double time;             /* (s) of the forces; starts again from 0 when a stage sets parameters */
  double
      time_before; /* (s) of the evaluation before, or `time` if there was none since parameters were set */
  double
      work; /* (J) output, added to: since time_before, beyond potential and drag, such as the change of the
                              potential with time alone */
} scree_body_batch;

typedef struct scree_body_force {
  uint32_t struct_size;
  uint32_t storage_size;
  int (*configure)(const scree_setup* setup, void* storage);
  void (*apply)(const void* storage, scree_body_batch* batch);
  /* (optional) Largest rate (1/s) at which the force ever damps a body of this mass, inertia and radius. */
  double (*damping_rate)(const void* storage, double mass, double inertia, double radius);
} scree_body_force;

#ifdef __cplusplus
}
#endif
#endif
