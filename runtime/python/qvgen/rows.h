/* SPDX-License-Identifier: MIT */
/* One call of a robot's function for many rows of arguments, as Python hands it over by ctypes.

   The loops over rows are printed for each robot, in C99 (_c_rows.py) or in C++ for what C has not
   (_cxx_rows.py, _loop_rows.py). All of them take a pointer to this struct, so that a library needs neither
   Python's headers nor a template library. */
#ifndef QVGEN_ROWS_H
#define QVGEN_ROWS_H

#include <stddef.h>

#ifdef __cplusplus
#define QVGEN_ROWS extern "C" __attribute__((visibility("default")))
#else
#define QVGEN_ROWS __attribute__((visibility("default")))
#endif

typedef struct qvgen_call {
  ptrdiff_t count;      /* rows */
  const void* rows[5];  /* arguments, C-contiguous */
  ptrdiff_t steps[5];   /* numbers from a row to the next; 0 where one serves all */
  const void* geometry; /* constants in the order of the robot's struct */
  const void* inertia;
  const void* lower; /* limits, one row; NULL: none, or the description's where there must be some */
  const void* upper;
  double numbers[3];  /* gravity; tolerance; or threshold, damping and scale */
  int flags[2];       /* is there a seed; do the targets follow each other, or a choice of the function */
  ptrdiff_t capacity; /* rows of solutions for which there is room */
  void* results[6];
} qvgen_call;

#endif
