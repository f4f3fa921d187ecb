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

#define SCREE_MAX_NAME 64u                     /* bytes of a column name or unit, final zero included */
#define SCREE_MAX_MEANING 256u                 /* bytes of the meaning of a column, final zero included */
#define SCREE_MAX_ID INT64_C(1000000000000000) /* largest id of a body, exact as a double */

typedef struct scree_energy { /* the energy balance (J); dissipated, created and work since the start */
  double kinetic_translation, kinetic_rotation, kinetic_boundary;
  double elastic_normal, elastic_tangential, potential;
  double dissipated_normal, dissipated_tangential, dissipated_rolling; /* dashpots, rolling resistance */
  double dissipated_friction, dissipated_release;                      /* slip, released springs */
  double dissipated_translation, dissipated_rotation, dissipated_boundary;
  double created;  /* by contact laws that are neither conservative nor purely dissipative */
  double work;     /* done by boundaries and groups */
  double residual; /* stored now − stored at the start + dissipated − created − work */
} scree_energy;

/* What a view costs time to provide, and contains only if the probe needs it. */
enum {
  SCREE_NEEDS_CONTACTS = 1u << 0,
  SCREE_NEEDS_ENERGY = 1u << 1,
  SCREE_NEEDS_ORIENTATIONS = 1u << 2, /* the scene then carries and integrates them */
  SCREE_NEEDS_NO_BODIES = 1u << 3,    /* arrays of bodies may be NULL: those from position to material, image,
                                     fixed and held; spares a copy of bodies that lie in another order in memory */
  SCREE_NEEDS_CONTACT_COUNTS = 1u << 4 /* `accumulate` reads view->contacts_of_body */
};

/* The scene at the end of a step, or at the start; with position_verlet, forces, loads and contacts are values of
 * half a step earlier. All pointers are valid during the call only. Body i is the same body, except in `accumulate`, and
 * plane w the same plane, in all views of a run. Arrays may be NULL if their count is 0. */
typedef struct scree_view {
  uint32_t struct_size;
  uint32_t dimension;
  double time;        /* (s) */
  double step_length; /* (s) */
  uint64_t step;      /* number of steps taken */
  uint64_t body_count;
  /* Components that the scene does not carry have data NULL: z in 2D, except of spin and torque, of which 2D
   * has only z; all of spin, torque and inertia in a scene without rotation. */
  scree_column position[3], velocity[3], spin[3], force[3], torque[3];
  scree_column radius, mass, inertia; /* (m), (kg), (kg m²) */
  scree_column orientation[4]; /* since the start; 2D: [0] the angle (rad), 3D: unit quaternion w, x, y, z;
                                         data NULL in a scene in which nothing needs orientations */
  const int64_t* id;           /* body_count; in scenarios from 1 to SCREE_MAX_ID */
  const uint32_t* material;    /* body_count indices into material_names */
  uint32_t material_count;
  const char* const* material_names; /* material_count */
  const int32_t* image[3];        /* (optional) body_count: net number of periods that each body has crossed;
                                        position + image * period is its path without jumps; NULL if no axis is
                                        periodic */
  double period[3];               /* (m) length of a periodic axis, 0 along others */
  double length[3];               /* (m) along each axis between the walls that enclose the bodies, or the
                                        period; NaN along an axis that is not enclosed */
  double length_at_start[3];      /* (m) the same at t = 0; the strain is length / length_at_start − 1 */
  uint64_t contact_count;         /* touching pairs; 0 unless SCREE_NEEDS_CONTACTS */
  const uint32_t* contact_a;      /* index of a body */
  const uint32_t* contact_b;      /* index of a body or, from body_count on, of a plane, then of a surface */
  const double* contact_normal;   /* (contact_count, 3) unit, from b to a */
  const double* contact_overlap;  /* contact_count (m) */
  const double* contact_force;    /* (contact_count, 3) on a (N) */
  const uint8_t* contact_sliding; /* contact_count: 1 while the contact slides */
  uint32_t plane_count;
  const scree_plane* planes;      /* plane_count */
  const scree_load* loads;        /* plane_count */
  const char* const* plane_names; /* plane_count: "<boundary>.<plane>" */
  const uint8_t* plane_absent; /* plane_count: 1 for planes that exert no force, as if they were not there */
  const scree_energy* energy;  /* all NaN unless SCREE_NEEDS_ENERGY, or without the balance */
  double end_time;             /* (s) when the run ends; NaN where that is not known */
  uint32_t input_count;        /* of the probe that is called, in observe and sample; else 0 */
  const double* inputs;        /* input_count: values of scree_setup.inputs at this time */
  const uint8_t* fixed; /* (optional) body_count: 1 for bodies that no force moves; NULL if there are none */
  const uint8_t*
      held; /* (optional) body_count: 1 << k for each component that no force moves, translations along x, y,
                           z, then rotations, of bodies that are not fixed; NULL if there are none */
  const uint8_t*
      left_out; /* (optional) body_count: 1 for bodies that the probe is not to count; NULL if it counts all */
  /* In `accumulate` alone: the bodies [part_begin, part_end) count, and all contacts of the view, of which each is in one
   * part. Body i is the body at place i in memory. Bodies of the part are as they are now; of other bodies of its contacts
   * position, velocity, spin, radius, mass, inertia, id, material, fixed, held and left_out are, and nothing else. */
  uint64_t part_begin, part_end;
  const uint32_t*
      contacts_of_body; /* body_count: number of contacts, walls included, of each body of the part; or NULL */
  const double*
      totals; /* total_count of the probe that is called: in `sample` of all parts, in `accumulate` of the
                           passes before; NULL if it has none */
  uint32_t surface_count;    /* of boundaries; a contact_b from body_count + plane_count on is one of them */
  const scree_frame* frames; /* surface_count */
  const scree_frame_load* frame_loads; /* surface_count */
  const char* const* surface_names;    /* surface_count: "<boundary>.<surface>" */
} scree_view;

typedef struct scree_probe_instance {
  uint32_t struct_size;
  uint32_t needs; /* of start, observe and sample: SCREE_NEEDS_...; a scene without the balance of energy
                     (time.energy_audit = false) refuses a probe with SCREE_NEEDS_ENERGY */
  uint32_t column_count;
  uint32_t state_width; /* doubles of state, unless the probe has `state_size` */
  uint32_t observes;    /* nonzero: `observe` is called */
  uint32_t
      leaves_out; /* nonzero: it heeds view->left_out; the keys groups and leave_out are refused otherwise */
  double observe_every; /* (s) between observations if it is the probe that chooses it, else 0 */
  /* Of a probe with `accumulate`; else 0. */
  uint32_t total_count;   /* numbers in `totals` */
  uint32_t largest_count; /* of these, the last so many are largest values, the others are sums */
  uint32_t passes;        /* over all parts, at least 1 */
} scree_probe_instance;

/* The state is an array of doubles that the host stores between the calls, zero before `start`. Only `start`
 * and `observe` change it. A run calls `start` once, then at each time `observe` before `sample`. */
typedef struct scree_probe {
  uint32_t struct_size;
  uint32_t storage_size;
  /* Called when a scenario is read, and again for each run, each time with other storage. */
  int (*configure)(const scree_setup* setup, void* storage, scree_probe_instance* instance);
  /* Called for every column after each `configure`. Names are snake_case and differ from each other and from
   * "time"; neither they nor units contain commas, quotes or control characters. */
  void (*column)(const void* storage, uint32_t column, char name[SCREE_MAX_NAME], char unit[SCREE_MAX_NAME]);
  /* (optional) Number of doubles of state, in place of state_width; it may depend on the parameters and on the bodies.
   * Called before `start`, with its view, and when a run goes on from its state. */
  uint64_t (*state_size)(const void* storage, const scree_view* view);
  /* Called at t = 0, or at the start of the first stage in which the probe records, before anything is observed
   * or sampled: checks that the scene has what the probe reads, and sets the state. Also called when a scene
   * is checked, with a state that is then discarded, unless the probe records from a later stage only. */
  int (*start)(const void* storage, const scree_view* view, double* state, char* message,
               size_t message_size);
  /* (optional) Updates the state. Called if the instance has set `observes`: at the start of each stage in
   * which the probe records, and then at the end of every step or, with the key or the member `observe_every`, at the
   * steps nearest to the multiples of that time; never twice at one step, and independently of samples. What
   * view->inputs shows has been observed before, if that was due. */
  void (*observe)(const void* storage, const scree_view* view, double* state);
  /* Writes one row of column_count values. Called at the start of each stage in which the probe records, at the
   * steps nearest to the multiples of the key `every`, and at the end. */
  void (*sample)(const void* storage, const scree_view* view, const double* state, double* row);
  /* (optional) One line of what a column means, for documents. A library that was built without this member, as its
   * struct_size says, is used without it. */
  void (*meaning)(const void* storage, uint32_t column, char text[SCREE_MAX_MEANING]);
  /* (optional) Marks with 1, of body_count zeros, the bodies that `observe` and `sample` read. Of others they then see
   * radius, mass, inertia, id, material, fixed and held; all else may be as it was earlier. Spares copies of bodies that
   * lie in another order in memory or that other processes move. Called with a view of all bodies, after `start` and when
   * a run goes on. Not called for a probe with SCREE_NEEDS_CONTACTS. As `meaning`, a library may lack it. */
  void (*mark_bodies)(const void* storage, const scree_view* view, const double* state, uint8_t* marks);
  /* (optional) Adds what the bodies and contacts of a part of the scene give to the totals of the part, which are 0 before,
   * or −infinity where they are largest values; it never sets NaN there. Called in each pass for each part, by several
   * threads and processes at once; sums of all parts are exact and rounded once. `start` of such a probe sees of bodies
   * radius, mass, inertia, id, material, fixed and held alone, and no contacts; `sample` sees no bodies and no contacts, and
   * body_count is 0. It may have a state, which only `start` sets.
   * It observes nothing and reads no columns of other probes. As `meaning`, a library may lack it. */
  void (*accumulate)(const void* storage, const scree_view* part, uint32_t pass, double* totals);
} scree_probe;

#ifdef __cplusplus
}
#endif
#endif
