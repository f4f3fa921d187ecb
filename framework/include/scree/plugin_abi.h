/* The only binary contract between scree and its plug-ins: C types, no exceptions, no allocation.
 *
 * Rules that hold for every struct: `struct_size` is set by whoever fills the struct, so that a newer host
 * can still read an older plug-in's; pointers are never NULL unless marked (optional); strings are UTF-8,
 * static, and owned by the plug-in; all quantities are in SI units; vectors have 3 components, in 2D the
 * third is 0. Functions that can fail return 0 on success, else nonzero with one line of text in `message`.
 * No function is called from two threads on the same storage, except `evaluate` and `apply`, which only read
 * it. Plug-in authors write the C++ adapters of contact_law.hpp, boundary.hpp, probe.hpp, body_term.hpp
 * instead. */
#ifndef SCREE_PLUGIN_ABI_H
#define SCREE_PLUGIN_ABI_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define SCREE_ABI_VERSION 4u
#define SCREE_QUERY_SYMBOL "scree_plugin_query"
#define SCREE_LANES 8u        /* batches are padded to a multiple of this, columns aligned to 64 bytes */
#define SCREE_MAX_HISTORY 16u /* history columns a law may keep per contact */
#define SCREE_MAX_INSTANCE_SIZE 1024u /* bytes of storage a configured plug-in may ask for */
#define SCREE_MAX_NAME 64u            /* bytes of a column name or unit, final zero included */

/* ---- parameters ------------------------------------------------------------------------------------- */

typedef enum scree_type {
  SCREE_NUMBER = 0,  /* one double */
  SCREE_INTEGER = 1, /* one double with an integral value */
  SCREE_BOOLEAN = 2, /* 0 or 1 */
  SCREE_CHOICE = 3,  /* index into `choices` */
  SCREE_VECTOR = 4,  /* `dimension` doubles, padded with zeros to 3 */
  SCREE_LIST = 5,    /* any number of doubles */
  SCREE_PROGRAM = 6  /* a function of time: see program.hpp */
} scree_type;

enum {
  SCREE_REQUIRED = 1u << 0,         /* must be given unless the parameter named by `excludes` is */
  SCREE_OPTIONAL = 1u << 1,         /* may be absent: its value then has count 0 */
  SCREE_MINIMUM_EXCLUDED = 1u << 2, /* range is (minimum, ...) */
  SCREE_MAXIMUM_EXCLUDED = 1u << 3  /* range is (..., maximum) */
};

typedef struct scree_parameter {
  uint32_t struct_size;
  uint32_t type; /* scree_type */
  uint32_t flags;
  const char* key;      /* snake_case */
  const char* unit;     /* "" when it has none */
  const char* doc;      /* one line */
  const char* choices;  /* (optional) "first|second|third" for SCREE_CHOICE */
  const char* excludes; /* (optional) key of the parameter that may be given in its place, never together */
  double default_value; /* used when neither required nor optional */
  double minimum, maximum; /* infinite where open */
} scree_parameter;

typedef struct scree_value {
  const double* data; /* valid until the plug-in is configured again or released */
  uint64_t count;     /* 0: an optional parameter that was not given */
} scree_value;

typedef struct scree_setup {
  uint32_t struct_size;
  uint32_t dimension;        /* 2 or 3 */
  const scree_value* values; /* one per declared parameter, in declared order */
  double lower[3],
      upper[3];  /* (m) bounding box of the bodies' surfaces at the start, shrunk to 0 without bodies */
  char* message; /* where to write what is wrong */
  size_t message_size;
} scree_setup;

/* ---- contact laws ----------------------------------------------------------------------------------- */

/* Columns a law may read. A vector takes 3 consecutive columns, of which 2D fills the first 2;
 * a spin takes 3, of which 2D fills the first 1. */
typedef enum scree_contact_input {
  SCREE_NORMAL = 0,               /* unit vector from b to a */
  SCREE_OVERLAP = 3,              /* (m) > 0 while touching */
  SCREE_RELATIVE_VELOCITY = 4,    /* (m/s) of a's contact point relative to b's, at the end of the step */
  SCREE_TANGENTIAL_INCREMENT = 7, /* (m) displacement of a's contact point relative to b's during the part of
                                     the step in which they touch, perpendicular to the normal of mid-step */
  SCREE_RELATIVE_SPIN = 10,       /* (rad/s) spin of a minus spin of b, at the end of the step */
  SCREE_ONSET_WEIGHT = 13,        /* factor for forces that jump at first touch: see contact_law.hpp */
  SCREE_CONTACT_RADIUS = 14,      /* 3 columns: (m) a = √(R* δ) of a Hertzian contact, 0 apart; (1/m) 1/a,
                                     finite; (m^½) √a */
  SCREE_REDUCED_MASS = 17,        /* (kg) m* = m_a m_b/(m_a+m_b); for a wall m_a */
  SCREE_REDUCED_MASS_ROOT = 18,   /* (kg^½) √m* */
  SCREE_EFFECTIVE_RADIUS = 19,    /* (m) R* = R_a R_b/(R_a+R_b); for a wall R_a */
  SCREE_CONTACT_INPUT_COUNT = 20
} scree_contact_input;

/* Columns a law writes. */
typedef enum scree_contact_output {
  SCREE_FORCE = 0,                 /* (N) on a, the opposite on b */
  SCREE_COUPLE = 3,                /* (N m) on a beyond the lever arm's, the opposite on b */
  SCREE_ELASTIC_NORMAL = 6,        /* (J) energy stored in the normal spring */
  SCREE_ELASTIC_TANGENTIAL = 7,    /* (J) energy stored in tangential and rolling springs */
  SCREE_DISSIPATED_NORMAL = 8,     /* (W) power lost to the normal dashpot */
  SCREE_DISSIPATED_TANGENTIAL = 9, /* (W) power lost to the tangential dashpot */
  SCREE_DISSIPATED_FRICTION = 10,  /* (J) lost to sliding and to springs let go during the step */
  SCREE_CONTACT_OUTPUT_COUNT = 11
} scree_contact_output;

typedef enum scree_arms {
  SCREE_ARM_CONTACT_POINT = 0, /* R − δ/2: the middle of the overlap */
  SCREE_ARM_RADIUS = 1         /* R */
} scree_arms;

typedef struct scree_contact_batch {
  uint32_t struct_size;
  uint32_t count; /* multiple of SCREE_LANES; padding lanes do not touch and hold finite numbers */
  double step;    /* (s); below 0 in a substep that goes back in time */
  const double* input[SCREE_CONTACT_INPUT_COUNT]; /* filled only for columns that the law reads */
  double* history[SCREE_MAX_HISTORY];             /* read and written in place; zero before the first touch */
  double* output[SCREE_CONTACT_OUTPUT_COUNT];     /* energy columns are NULL when no audit is kept */
} scree_contact_batch;

/* The same in single precision, for runs in mixed precision. */
typedef struct scree_contact_batch_single {
  uint32_t struct_size;
  uint32_t count;
  double step;
  const float* input[SCREE_CONTACT_INPUT_COUNT];
  float* history[SCREE_MAX_HISTORY];
  float* output[SCREE_CONTACT_OUTPUT_COUNT];
} scree_contact_batch_single;

typedef struct scree_contact_instance {
  uint32_t struct_size;
  uint32_t reads;         /* bit (1 << first column) of each input read */
  uint32_t writes_couple; /* nonzero if SCREE_COUPLE is written */
  uint32_t tangential;    /* nonzero if forces have tangential parts, so that bodies must carry spin */
  uint32_t arms;          /* scree_arms */
  uint32_t history_width; /* <= SCREE_MAX_HISTORY */
  int32_t sliding_column; /* history column that is above 0 while the contact slides, -1 without */
  const char* const* history_names; /* (optional) history_width names */
  void (*evaluate)(const void* storage, const scree_contact_batch* batch);
  /* (optional) NULL: the law cannot be used in a run of mixed precision */
  void (*evaluate_single)(const void* storage, const scree_contact_batch_single* batch);
} scree_contact_instance;

/* A pair of bodies for which closed forms are asked. */
typedef struct scree_encounter {
  double reduced_mass, effective_radius, speed; /* (kg), (m), (m/s) */
  double
      network; /* 1: the pair alone; more: how many times stiffer and more damped than the pair, in normal and
                  tangential contacts together, the network is that holds it. For critical_step alone. */
} scree_encounter;

typedef struct scree_closed_form {
  const char* name; /* for example contact_time, restitution, critical_step */
  const char* unit;
  const char* formula;
  double value;
} scree_closed_form;

typedef struct scree_contact_law {
  uint32_t struct_size;
  uint32_t storage_size; /* <= SCREE_MAX_INSTANCE_SIZE */
  int (*configure)(const scree_setup* setup, void* storage, scree_contact_instance* instance);
  /* Writes up to `capacity` forms and returns how many; the first is contact_time, the second restitution. */
  uint32_t (*closed_forms)(const void* storage, const scree_encounter* encounter, scree_closed_form* forms,
                           uint32_t capacity);
} scree_contact_law;

/* ---- boundaries ------------------------------------------------------------------------------------- */

typedef struct scree_plane {
  double point[3];        /* (m) */
  double normal[3];       /* unit, pointing into the material */
  double velocity[3];     /* (m/s) at the end of the step */
  double mid_velocity[3]; /* (m/s) displacement during the step / step */
} scree_plane;

typedef struct scree_load {
  double force[3]; /* (N) of all contacts on the plane */
} scree_load;

typedef struct scree_boundary_energy { /* running totals since the start of the run */
  double kinetic;                      /* (J) now, not a total */
  double work;                         /* (J) done on scene by loads and prescribed motion */
  double dissipated;                   /* (J) lost in the boundary's own viscosity */
} scree_boundary_energy;

typedef struct scree_boundary_step {
  uint32_t struct_size;
  uint32_t dimension;
  double time;             /* (s) at the start of the step, since the parameters in force were set */
  double step;             /* (s) */
  const scree_load* loads; /* plane_count; at `drift` those at the start, at `kick` at the end of the step */
  scree_plane* planes;     /* plane_count */
  double* state;           /* state_width doubles kept by the host: saved, restored and hashed by it */
  scree_boundary_energy* energy;
} scree_boundary_step;

typedef struct scree_boundary_instance {
  uint32_t struct_size;
  uint32_t plane_count;
  uint32_t state_width;
  uint32_t periodic[3];           /* nonzero: this axis is periodic between lower and upper */
  double lower[3], upper[3];      /* (m) */
  const char* const* plane_names; /* (optional) plane_count names */
  const double* plane_masses; /* (optional) plane_count masses (kg), 0 for planes that forces do not move; in
                                 the plug-in's storage */
  double damping_rate; /* (1/s) at which the boundary's own viscosity slows its lightest plane; 0 without */
} scree_boundary_instance;

typedef struct scree_boundary {
  uint32_t struct_size;
  uint32_t storage_size;
  int (*configure)(const scree_setup* setup, void* storage, scree_boundary_instance* instance);
  void (*start)(const void* storage,
                const scree_boundary_step* step); /* once: state and planes at the start */
  void (*drift)(const void* storage, const scree_boundary_step* step); /* planes from t to t + step */
  void (*kick)(const void* storage, const scree_boundary_step* step);  /* end-of-step velocities, energies */
} scree_boundary;

/* ---- numbers of bodies ------------------------------------------------------------------------------ */

/* That of body i is data[i * stride]; data is NULL for what the scene does not carry. C++ writes column[i].
 */
typedef struct scree_column {
  const double* data;
  uint64_t stride;
#ifdef __cplusplus
  explicit operator bool() const { return data != nullptr; }
  const double& operator[](uint64_t i) const { return data[i * stride]; }
#endif
} scree_column;

typedef struct scree_load_column { /* that may be added to */
  double* data;
  uint64_t stride;
#ifdef __cplusplus
  explicit operator bool() const { return data != nullptr; }
  double& operator[](uint64_t i) const { return data[i * stride]; }
#endif
} scree_load_column;

/* ---- body terms ------------------------------------------------------------------------------------- */

/* Some of the scene's bodies; several batches may be evaluated at the same time. */
typedef struct scree_body_batch {
  uint32_t struct_size;
  uint32_t dimension;
  uint32_t count;
  scree_column position[3], velocity[3];
  scree_column spin[3];                  /* 2D carries [2] alone */
  scree_column radius;                   /* of the same stride as all above */
  scree_column mass, inertia;            /* of stride 1 */
  scree_load_column force[3], torque[3]; /* of one stride */
  uint32_t audit;                        /* nonzero: energies are asked for */
  double potential;                      /* (J) out: added to */
  double dissipated_translation;         /* (W) out: added to */
  double dissipated_rotation;            /* (W) out: added to */
  const int32_t*
      image[3];     /* (optional) periods that each body has crossed along a periodic axis, NULL elsewhere */
  double period[3]; /* (m) */
} scree_body_batch;

typedef struct scree_body_term {
  uint32_t struct_size;
  uint32_t storage_size;
  int (*configure)(const scree_setup* setup, void* storage);
  void (*apply)(const void* storage, scree_body_batch* batch);
  /* (optional) Largest rate (1/s) at which the term slows a body of this mass, inertia and radius. */
  double (*damping_rate)(const void* storage, double mass, double inertia, double radius);
} scree_body_term;

/* ---- probes ----------------------------------------------------------------------------------------- */

typedef struct scree_energy {
  double kinetic_translation, kinetic_rotation, kinetic_boundary;
  double elastic_normal, elastic_tangential, potential;
  double dissipated_normal, dissipated_tangential, dissipated_friction;
  double dissipated_translation, dissipated_rotation, dissipated_boundary;
  double work;     /* done by boundaries since the start */
  double residual; /* stored now − stored at the start + dissipated − work */
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

/* ---- manifest --------------------------------------------------------------------------------------- */

typedef enum scree_kind {
  SCREE_CONTACT_LAW = 1,
  SCREE_BOUNDARY = 2,
  SCREE_BODY_TERM = 3,
  SCREE_PROBE = 4
} scree_kind;

typedef struct scree_plugin {
  uint32_t struct_size;
  uint32_t abi_version; /* SCREE_ABI_VERSION of the build; checked before anything below is read */
  uint32_t kind;        /* scree_kind */
  uint32_t parameter_count;
  uint64_t features;    /* bits of capabilities that the plug-in requires of the host; 0 today */
  const char* name;     /* as in the scenario: plugin = "name" */
  const char* summary;  /* one line */
  const char* equation; /* the equations in plain text, lines separated by \n */
  const char* source;   /* paper and equation numbers */
  const scree_parameter* parameters;
  const void* interface; /* scree_contact_law, scree_boundary, scree_body_term or scree_probe */
} scree_plugin;

/* The one symbol a library exports. */
typedef const scree_plugin* (*scree_query_function)(void);

#ifdef __cplusplus
}
#endif
#endif
