/* Interface of contact laws. Part of abi.h, which plug-ins include. */
#ifndef SCREE_ABI_CONTACT_LAW_H
#define SCREE_ABI_CONTACT_LAW_H

#include <stddef.h>
#include <stdint.h>

#include <scree/plugin/abi/parameters.h>

#ifdef __cplusplus
extern "C" {
#endif

#define SCREE_LANES 8u        /* batches are padded to a multiple of this; columns are aligned to 64 bytes */
#define SCREE_MAX_HISTORY 16u /* most history columns of a law */

/* Columns that a law may read. A vector takes 3 consecutive columns, of which 2D fills the first 2; a spin
 * takes 3, of which 2D fills the first. */
typedef enum scree_contact_input {
  SCREE_NORMAL = 0,               /* unit vector from b to a */
  SCREE_OVERLAP = 3,              /* (m) > 0 while touching */
  SCREE_RELATIVE_VELOCITY = 4,    /* (m/s) of a's contact point relative to b's, at the end of the step */
  SCREE_TANGENTIAL_INCREMENT = 7, /* (m) displacement of a's contact point relative to b's during the part of
                                     the step in which they touch, perpendicular to the mid-step normal */
  SCREE_RELATIVE_SPIN = 10,       /* (rad/s) spin of a minus spin of b, at the end of the step */
  SCREE_ONSET_WEIGHT = 13,        /* factor for forces with an onset_power or a parting_power below 1 */
  SCREE_CONTACT_RADIUS = 14,      /* 3 columns of a Hertzian contact: a = √(R* δ) (m), 0 while open;
                                     1/a (1/m), always finite; √a (m^½) */
  SCREE_REDUCED_MASS = 17,        /* (kg) m* = m_a m_b/(m_a+m_b); for a wall m_a */
  SCREE_REDUCED_MASS_ROOT = 18,   /* (kg^½) √m* */
  SCREE_EFFECTIVE_RADIUS = 19,    /* (m) R* = R_a R_b/(R_a+R_b); for a wall R_a */
  SCREE_ORIENTATION_A = 20, /* 2D: 1 column, the angle (rad) of a since the start; 3D: 4 columns, the unit
                                     quaternion w, x, y, z of its rotation since the start */
  SCREE_ORIENTATION_B = 24, /* of b; of the frame of a surface; of a plane 0, or 1, 0, 0, 0 */
  SCREE_SEPARATION = 28,    /* (m) x_a − x_b of the nearest images. Of a wall: of a and of the plane's point
                                     or the origin of the surface's frame, while a crosses periodic faces
                                     without a jump */
  SCREE_RADII = 31,         /* 2 columns (m): R_a, R_b; of a wall 0 */
  SCREE_NORMAL_CHANGE = 33, /* 6 columns (1/m), xx, yy, zz, xy, xz, yz: derivative of the normal of a
                                     surface with the place of a, symmetric. Given to laws that follow
                                     surfaces, for batches of a surface alone */
  SCREE_CONTACT_INPUT_COUNT = 39
} scree_contact_input;

/* Columns that a law writes. */
typedef enum scree_contact_output {
  SCREE_FORCE = 0,                       /* (N) on a, the opposite on b */
  SCREE_COUPLE = 3,                      /* (N m) on a in addition to arm × force, the opposite on b */
  SCREE_ELASTIC_NORMAL = 6,              /* (J) energy stored in the normal spring */
  SCREE_ELASTIC_TANGENTIAL = 7,          /* (J) energy stored in tangential and rolling springs */
  SCREE_DISSIPATION_RATE_NORMAL = 8,     /* (W) dissipated by the normal dashpot */
  SCREE_DISSIPATION_RATE_TANGENTIAL = 9, /* (W) dissipated by the tangential dashpot */
  SCREE_DISSIPATION_RATE_ROLLING = 10,   /* (W) dissipated by rolling resistance */
  SCREE_DISSIPATED_FRICTION = 11,        /* (J) dissipated by slip during the step */
  SCREE_DISSIPATED_RELEASE = 12, /* (J) released by springs during the step: where a stiffness changes, or
                                      where a pair opens with stretched springs. Dissipated columns are >= 0;
                                      negative values are summed separately, as energy that the law creates */
  SCREE_CONTACT_OUTPUT_COUNT = 13
} scree_contact_output;

/* Lever arm of contact forces, from the centre of a body. */
typedef enum scree_arms {
  SCREE_ARM_CONTACT_POINT = 0, /* R − δ/2: the middle of the overlap */
  SCREE_ARM_RADIUS = 1         /* R */
} scree_arms;

typedef struct scree_contact_batch {
  uint32_t struct_size;
  uint32_t count; /* multiple of SCREE_LANES; padding lanes do not touch and hold finite numbers */
  double step;    /* (s); negative in a substep backwards in time */
  double kick;    /* (s) time for which the forces act on the bodies; 0: they are evaluated without motion */
  const double* input[SCREE_CONTACT_INPUT_COUNT]; /* filled only for columns that the law reads */
  double* history[SCREE_MAX_HISTORY];             /* updated in place; 0 before the first touch */
  double* output[SCREE_CONTACT_OUTPUT_COUNT];     /* energy columns are NULL without an audit */
} scree_contact_batch;

/* A direction in the space of a batch's inputs, and the derivative of the outputs along it. */
typedef struct scree_contact_tangent {
  uint32_t struct_size;
  const double* input[SCREE_CONTACT_INPUT_COUNT]; /* (optional) derivative of each input; NULL: 0 */
  double* output[SCREE_ELASTIC_NORMAL];           /* derivatives of force and, if written, couple */
} scree_contact_tangent;

typedef struct scree_contact_instance {
  uint32_t struct_size;
  uint32_t reads;         /* bit (1 << first column) of each input read */
  uint32_t writes_couple; /* nonzero if SCREE_COUPLE is written */
  uint32_t tangential;    /* nonzero if forces have tangential parts, so that bodies must carry spin */
  uint32_t arms;          /* scree_arms */
  /* Nonzero if a law that reads orientations or separations knows surfaces, by SCREE_NORMAL_CHANGE; without,
   * the host refuses it in scenes with surfaces. */
  uint32_t follows_surfaces;
  uint32_t history_width; /* <= SCREE_MAX_HISTORY */
  int32_t sliding_column; /* history column that is above 0 while the contact slides; -1: none */
  /* Powers of time with which forces multiplied by SCREE_ONSET_WEIGHT begin at first touch and end at
   * parting: 0 (a jump), 1/4, 1/2, 3/4; 1 or more: no weights. */
  double onset_power, parting_power;
  const char* const* history_names; /* (optional) history_width names */
  void (*evaluate)(const void* storage, const scree_contact_batch* batch);
  void (*reserved)(void); /* never called; keeps the places of the other members */
  /* (optional) Exact derivative of force and couple in the touching pairs of a batch, on the branch (sticking,
   * sliding, ...) that `evaluate` would take, with the history before the step. Writes only `tangent`: neither
   * history nor outputs of the batch. */
  void (*differentiate)(const void* storage, const scree_contact_batch* batch,
                        const scree_contact_tangent* tangent);
} scree_contact_instance;

/* A pair of bodies for which closed forms are evaluated. */
typedef struct scree_encounter {
  double reduced_mass, effective_radius, speed; /* (kg), (m), (m/s) */
  /* Used by critical_step only. 1: isolated pair; above 1: factor by which the surrounding contact network is
   * stiffer and more damped than the pair, normal and tangential contacts together. */
  double network;
} scree_encounter;

typedef struct scree_closed_form {
  const char* name; /* such as contact_time, restitution, critical_step */
  const char* unit;
  const char* formula;
  double value;
} scree_closed_form;

typedef struct scree_contact_law {
  uint32_t struct_size;
  uint32_t storage_size; /* <= SCREE_MAX_INSTANCE_SIZE */
  uint32_t dimensions;   /* bit (1 << D) of each dimension D in which the law exists */
  int (*configure)(const scree_setup* setup, void* storage, scree_contact_instance* instance);
  /* Writes up to `capacity` forms and returns their number; the first is contact_time, the second
   * restitution. */
  uint32_t (*closed_forms)(const void* storage, const scree_encounter* encounter, scree_closed_form* forms,
                           uint32_t capacity);
} scree_contact_law;

#ifdef __cplusplus
}
#endif
#endif
