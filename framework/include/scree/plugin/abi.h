/* The binary interface between scree and its plug-ins: C types, no exceptions, no allocation.
 *
 * Host and plug-in are built with the same headers: the host refuses, by name, another SCREE_ABI_VERSION,
 * structs of another size, and compiler settings that change values. Rules for every struct: the side that
 * fills it sets its `struct_size`; pointers are never NULL unless marked (optional); strings are UTF-8,
 * static, and owned by the plug-in; all quantities are in SI units; vectors have 3 components, of which the
 * third is 0 in 2D. Functions that can fail return 0 on success, else nonzero with one line of text in `message`. No
 * function is called from two threads on the same storage, except `evaluate`, `apply` and `accumulate`, which only read it.
 * Plug-in authors use the C++ adapters contact_law.hpp, boundary.hpp, probe.hpp, body_force.hpp instead. */
#ifndef SCREE_PLUGIN_ABI_H
#define SCREE_PLUGIN_ABI_H

#include <stddef.h>
#include <stdint.h>

#include <scree/plugin/abi/body_force.h>
#include <scree/plugin/abi/boundary.h>
#include <scree/plugin/abi/column.h>
#include <scree/plugin/abi/contact_law.h>
#include <scree/plugin/abi/parameters.h>
#include <scree/plugin/abi/probe.h>
#include <scree/plugin/abi/surface.h>

#ifdef __cplusplus
extern "C" {
#endif

#define SCREE_ABI_VERSION 17u
#define SCREE_QUERY_SYMBOL "scree_plugin_query"

typedef enum scree_kind {
  SCREE_CONTACT_LAW = 1,
  SCREE_BOUNDARY = 2,
  SCREE_BODY_FORCE = 3,
  SCREE_PROBE = 4
} scree_kind;

/* Compiler settings of a plug-in's build with which results would depend on the processor. */
enum {
  SCREE_CONTRACTED = 1u << 0, /* a product and a sum become one rounding: -ffp-contract=fast or on */
  SCREE_FAST_MATH = 1u << 1   /* -ffast-math, or one of its parts that change values */
};

typedef struct scree_plugin {
  uint32_t struct_size;
  uint32_t abi_version; /* SCREE_ABI_VERSION of the build; checked before anything below is read */
  uint32_t kind;        /* scree_kind */
  uint32_t parameter_count;
  uint64_t features; /* bits of capabilities that the plug-in requires of the host; none are defined: 0 */
  uint32_t numerics; /* SCREE_CONTRACTED, SCREE_FAST_MATH; the host accepts 0 only */
  uint32_t parameter_size; /* sizeof(scree_parameter) */
  const char* name;        /* as in the scenario: plugin = "name" */
  const char* summary;     /* one line */
  const char* equation;    /* the equations in plain text, lines separated by \n */
  const char* source;      /* paper and equation numbers */
  const scree_parameter* parameters;
  const void* interface; /* scree_contact_law, scree_boundary, scree_body_force or scree_probe */
} scree_plugin;

/* Type of SCREE_QUERY_SYMBOL, the only symbol that a library exports. */
typedef const scree_plugin* (*scree_query_function)(void);

#ifdef __cplusplus
}
#endif
#endif
