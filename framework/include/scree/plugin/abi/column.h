/* Columns of body properties. Part of abi.h, which plug-ins include. */
#ifndef SCREE_ABI_COLUMN_H
#define SCREE_ABI_COLUMN_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The value of body i is data[i * stride], in C++ column[i]; data is NULL if the scene does not carry it. */
typedef struct scree_column {
  const double* data;
  uint64_t stride;
#ifdef __cplusplus
  explicit operator bool() const { return data != nullptr; }
  const double& operator[](uint64_t i) const { return data[i * stride]; }
#endif
} scree_column;

typedef struct scree_load_column { /* writable: plug-ins add to it */
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
