/* Parameters of plug-ins and their configuration. Part of abi.h, which plug-ins include. */
#ifndef SCREE_ABI_PARAMETERS_H
#define SCREE_ABI_PARAMETERS_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define SCREE_MAX_INSTANCE_SIZE 8192u /* most bytes of storage of an instance */

typedef enum scree_type {
  SCREE_NUMBER = 0,  /* one double */
  SCREE_INTEGER = 1, /* one double with an integral value */
  SCREE_BOOLEAN = 2, /* 0 or 1 */
  SCREE_CHOICE = 3,  /* index into `choices` */
  SCREE_VECTOR = 4,  /* `dimension` doubles, padded with zeros to 3 */
  SCREE_LIST = 5,    /* any number of doubles */
  SCREE_PROGRAM = 6, /* a function of time: see program.hpp */
  SCREE_INPUT = 7,   /* of probes: its number in scree_setup.inputs; see input_column.hpp */
  SCREE_MESH_FILE =
      8 /* the name of a file with triangles, which the host reads: the number of points, their coordinates,
                         and the numbers of the three points of each triangle, counted from 0 */
} scree_type;

enum {
  SCREE_REQUIRED = 1u << 0,         /* must be given unless the parameter named by `excludes` is */
  SCREE_OPTIONAL = 1u << 1,         /* may be absent: its value then has count 0 */
  SCREE_MINIMUM_EXCLUDED = 1u << 2, /* range is (minimum, ...) */
  SCREE_MAXIMUM_EXCLUDED = 1u << 3, /* range is (..., maximum) */
  SCREE_AT_START_ONLY = 1u << 4     /* holds for the whole run: stages may not set it */
};

typedef struct scree_parameter {
  uint32_t struct_size;
  uint32_t type; /* scree_type */
  uint32_t flags;
  const char* key;         /* snake_case */
  const char* unit;        /* "" if dimensionless */
  const char* doc;         /* one line */
  const char* choices;     /* (optional) "first|second|third" for SCREE_CHOICE */
  const char* excludes;    /* (optional) key of the alternative parameter; both together are an error */
  double default_value;    /* of parameters that are neither required nor optional */
  double minimum, maximum; /* infinite: no limit */
} scree_parameter;

typedef struct scree_value {
  const double* data; /* valid until the plug-in is configured again or released */
  uint64_t count;     /* 0: an optional parameter that was not given */
} scree_value;

typedef struct
    scree_input {   /* a column of another probe; the strings are valid as the data of a scree_value */
  const char* name; /* "<probe>.<column>" */
  const char* unit; /* "" if dimensionless */
} scree_input;

typedef struct scree_setup {
  uint32_t struct_size;
  uint32_t dimension;        /* 2 or 3 */
  const scree_value* values; /* one per declared parameter, in declared order */
  double lower[3], upper[3]; /* (m) bounding box of the bodies' surfaces at the start; 0 without bodies */
  uint32_t input_count;
  const scree_input* inputs; /* input_count */
  char* message;             /* output: reason of a failure */
  size_t message_size;
} scree_setup;

#ifdef __cplusplus
}
#endif
#endif
