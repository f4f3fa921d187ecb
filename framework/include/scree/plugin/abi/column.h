/* Numbers of bodies. Part of plugin_abi.h, which plug-ins include. */
#ifndef SCREE_ABI_COLUMN_H
#define SCREE_ABI_COLUMN_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

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

#ifdef __cplusplus
}
#endif
#endif
