/* Contact laws. Part of plugin_abi.h, which plug-ins include. */
#ifndef SCREE_ABI_CONTACT_LAW_H
#define SCREE_ABI_CONTACT_LAW_H

#include <stddef.h>
#include <stdint.h>

#include <scree/plugin/abi/parameters.h>

#ifdef __cplusplus
extern "C" {
#endif

#define SCREE_LANES 8u        /* batches are padded to a multiple of this, columns aligned to 64 bytes */
#define SCREE_MAX_HISTORY 16u /* history columns a law may keep per contact */

/* Columns a law may read. A vector takes 3 consecutive columns, of which 2D fills the first 2;
 * a spin takes 3, of which 2D fills the first 1. */
typedef enum scree_contact_input {
  SCREE_NORMAL = 0,               /* unit vector from b to a */
  SCREE_OVERLAP = 3,              /* (m) > 0 while touching */
  SCREE_RELATIVE_VELOCITY = 4,    /* (m/s) of a's contact point relative to b's, at the end of the step */
  SCREE_TANGENTIAL_INCREMENT = 7, /* (m) displacement of a's contact point relative to b's during the part of
                                     the step in which they touch, perpendicular to the normal of mid-step */
  SCREE_RELATIVE_SPIN = 10,       /* (rad/s) spin of a minus spin of b, at the end of the step */
  SCREE_ONSET_WEIGHT = 13,        /* factor for forces that begin or end with onset_power or parting_power */
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
  SCREE_DISSIPATED_ROLLING = 10,   /* (W) power lost to rolling resistance */
  SCREE_DISSIPATED_FRICTION = 11,  /* (J) lost to slip during the step */
  SCREE_DISSIPATED_RELEASE = 12,   /* (J) let go by springs during the step: where a stiffness changes, or the
                                      pair opens with its springs stretched. Each dissipated column is >= 0;
                                      what   is below 0 is kept apart, as energy that the law has created */
  SCREE_CONTACT_OUTPUT_COUNT = 13
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
  /* Powers of time with which forces that are multiplied by SCREE_ONSET_WEIGHT begin at first touch and end
   * at parting: 0 for a jump, 1/4, 1/2, 3/4; 1 and more for no weights. */
  double onset_power, parting_power;
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

#ifdef __cplusplus
}
#endif
#endif
