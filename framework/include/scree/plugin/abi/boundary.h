/* Interface of boundaries. Part of abi.h, which plug-ins include. */
#ifndef SCREE_ABI_BOUNDARY_H
#define SCREE_ABI_BOUNDARY_H

#include <stddef.h>
#include <stdint.h>

#include <scree/plugin/abi/parameters.h>
#include <scree/plugin/abi/surface.h>

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

/* Output of a call; the host sets all three to 0 before each. */
typedef struct scree_boundary_energy {
  double kinetic;    /* (J) present value, set by `start`, `change` and `finish_step`; ignored otherwise */
  double work;       /* (J) done on the scene in this call by pressing forces and prescribed motion */
  double dissipated; /* (J) in this call, by the boundary's own viscosity */
} scree_boundary_energy;

/* What a boundary can see of the scene besides its own planes. In `begin_step` the planes of boundaries that
 * precede this one in the scene are already at the end of the step, and in `finish_step` their velocities;
 * in `start` the planes of boundaries that follow are not listed yet. */
typedef struct scree_boundary_scene {
  uint32_t struct_size;
  uint32_t plane_count; /* of all boundaries, in the order of the scene */
  const scree_plane* planes;
  const scree_load* loads;        /* of the last force evaluation; 0 in `start` */
  const char* const* plane_names; /* "<boundary>.<plane>" */
  double lower[3], upper[3]; /* (m) bounding box of the bodies at the start of the run; 0 without bodies */
  uint32_t periodic[3];      /* nonzero: the axis is periodic between the limits below */
  double domain_lower[3], domain_upper[3]; /* (m) */
} scree_boundary_scene;

/* What contacts would exert on a plane at the end of the step, if it were displaced in the step. */
typedef struct scree_displaced_loads {
  uint32_t struct_size;
  void* host; /* first argument of `load` */
  /* Load of a plane of the boundary after a displacement (m) at constant velocity since the start of the step,
   * from where the bodies are at its end: what the next force evaluation will find, up to round-off, if
   * `begin_step` then sets velocity and mid_velocity to displacement / step. Keeps nothing. */
  void (*load)(void* host, uint32_t plane, const double* displacement, scree_load* load);
} scree_displaced_loads;

typedef struct scree_boundary_step {
  uint32_t struct_size;
  uint32_t dimension;
  double time; /* (s) at the start of the step; starts again from 0 when a stage sets parameters */
  double step; /* (s) 0 in `start` and `change`; negative in the third substep of fourth_order; a half step
                  at the start of position_verlet and before a stage */
  uint32_t plane_count, state_width;
  const scree_load* loads; /* plane_count; at the start (begin_step) or the end (finish_step) of the step */
  scree_plane* planes;     /* plane_count */
  double* state;           /* state_width doubles, which the host stores and hashes */
  scree_boundary_energy* energy;
  const scree_boundary_scene* scene;
  const scree_displaced_loads*
      displaced_loads; /* (optional) only in `begin_step`, if the instance has a displacement_speed */
  uint32_t surface_count;
  scree_frame* frames;                 /* surface_count; at first at the origin, not turned and at rest */
  const scree_frame_load* frame_loads; /* surface_count; as loads */
} scree_boundary_step;

typedef struct scree_boundary_instance {
  uint32_t struct_size;
  uint32_t plane_count; /* the same in all stages */
  uint32_t state_width; /* may change with the parameters: see `change` */
  uint32_t periodic[3]; /* nonzero: the axis is periodic between lower and upper; the same in all stages */
  double lower[3], upper[3];      /* (m) finite */
  const char* const* plane_names; /* (optional) plane_count names, none of which is NULL */
  const double* plane_masses; /* (optional) plane_count masses (kg), in the plug-in's storage; 0 for planes
                                 that forces do not move */
  double damping_rate; /* (1/s) at which the boundary's own viscosity slows its lightest wall; 0 without */
  double
      displacement_speed; /* (m/s) above 0: `begin_step` asks for loads after displacements of at most this speed * |step| */
  uint32_t still; /* nonzero: no plane moves, and `begin_step` and `finish_step` are not called */
  const uint32_t*
      plane_absent; /* (optional) plane_count, in the plug-in's storage; nonzero: the plane keeps its place
                                   and exerts no force, as if it were not there */
  uint32_t surface_count;           /* the same in all stages, and so are the shapes */
  const scree_surface* surfaces;    /* (optional) surface_count, in the plug-in's storage */
  const char* const* surface_names; /* (optional) surface_count names, none of which is NULL */
  double surface_mass;      /* (kg) that the lightest contact with a surface feels; 0 if forces move none */
  uint32_t surfaces_absent; /* nonzero: the surfaces keep their places and exert no forces */
} scree_boundary_instance;

enum scree_wall_freedom {
  SCREE_PRESCRIBED = 0, /* forces do not move the wall, and only the direction of its equation counts */
  SCREE_FREE = 1,       /* forces move it along the direction */
  SCREE_NO_EQUATION = 2 /* it moves in a way that the equations below do not have */
};

/* Equation of small motions of a plane or a surface about its present state, along one direction:
 *   m s" + γ s' + Σ_c k_c x_c = F,  x = s + d
 * x: displacement, d: its superposed part, F: change of the force of the contacts along the direction, and k_c
 * the negative derivative of the pressing force with the displacement of wall c along the direction of that
 * wall. A surface may also turn about an axis through a centre that moves with it:
 *   I φ" + γ' φ' = T
 * T: change of the torque of the contacts about the axis. */
typedef struct scree_linear_wall {
  uint32_t free;          /* scree_wall_freedom */
  double direction[3];    /* unit */
  double mass;            /* (kg) m >= 0 */
  double viscosity;       /* (kg/s) γ >= 0 */
  double pressing_force;  /* (N) in the direction, at the time of the step */
  double speed;           /* (m/s) d' at that time; for a wall that is not free, its own speed */
  uint32_t turns;         /* nonzero: torques turn it; only surfaces */
  double axis[3];         /* unit, of the turn */
  double centre[3];       /* (m) a point of the axis */
  double inertia;         /* (kg m²) I >= 0 */
  double spin_viscosity;  /* (N m s) γ' >= 0 */
  double pressing_torque; /* (N m) about the axis, at the time of the step */
} scree_linear_wall;

/* Output of `linear`; before the call planes are prescribed along their normals, surfaces along the axis z of
 * the scene, and all numbers are 0. */
typedef struct scree_linear_walls {
  uint32_t struct_size;
  uint32_t wall_count;      /* planes, then surfaces */
  scree_linear_wall* walls; /* wall_count */
  double* stiffness;        /* (wall_count, wall_count) (N/m) by rows; rows of walls that are not free
                               do not count */
} scree_linear_walls;

/* Calls: `start` when a scene is set up, also where it is only checked; then for each substep `begin_step`, an
 * evaluation of the forces, `finish_step`; between steps `change` when a stage sets parameters. Planes must be
 * finite after every call, and normals unit vectors after `start`; otherwise the host stops with an error
 * that names the plane. */
typedef struct scree_boundary {
  uint32_t struct_size;
  uint32_t storage_size;
  int (*configure)(const scree_setup* setup, void* storage, scree_boundary_instance* instance);
  /* Sets planes, state and kinetic energy at the start. No forces are known. Returns 0, or nonzero with the
   * problem and a remedy in `message`. */
  int (*start)(const void* storage, const scree_boundary_step* step, char* message, size_t message_size);
  /* First half of a step: moves the planes from t to t + step, sets mid_velocity, displacement / step, and
   * predicts velocity for t + step. `loads` are those at t, also directly after a stage has changed laws. */
  void (*begin_step)(const void* storage, const scree_boundary_step* step);
  /* Second half: sets the velocities at t + step, with the loads there. */
  void (*finish_step)(const void* storage, const scree_boundary_step* step);
  /* (optional) New parameters apply from now on; `before` is the storage with the old ones, `time_before` the
   * time (s) by their clock. Sets velocities and kinetic energy, a jump of which the host counts as work;
   * must not move the planes. Forces are evaluated afterwards. State beyond the old state_width is 0; state
   * beyond the new one is still there, and dropped after the call. Without this function velocities and
   * kinetic energy stay, or become 0 if the planes are still from now on. */
  void (*change)(const void* storage, const void* before, double time_before,
                 const scree_boundary_step* step);
  /* (optional) States how forces move the walls, for a linear response. `step` is as between two steps, with
   * copies of planes, frames and state; its energy is ignored. Without this function all planes are prescribed,
   * and surfaces too unless forces move them. */
  void (*linear)(const void* storage, const scree_boundary_step* step, const scree_linear_walls* walls);
  /* (optional) The host has displaced the walls and brought them to rest, with the loads there: the state
   * follows. displacements: (m) of plane_count planes, then of surface_count surfaces, which have not turned.
   * Sets the kinetic energy. Without this function the state stays as it was. */
  void (*rest)(const void* storage, const scree_boundary_step* step, const double (*displacements)[3]);
} scree_boundary;

#ifdef __cplusplus
}
#endif
#endif
