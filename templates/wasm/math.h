// SPDX-License-Identifier: MIT
// <math.h> of generated C without a C library: instructions of WebAssembly, and sines and arctangents of the script.
#pragma once
#define HUGE_VAL __builtin_huge_val()
#define INFINITY __builtin_inff()
#define NAN __builtin_nanf("")
#define isnan(x) __builtin_isnan(x)
#define isinf(x) __builtin_isinf(x)
#define isfinite(x) __builtin_isfinite(x)
#define signbit(x) __builtin_signbit(x)
#define sqrt(x) __builtin_sqrt(x)
#define fabs(x) __builtin_fabs(x)
#define floor(x) __builtin_floor(x)
#define ceil(x) __builtin_ceil(x)
#define trunc(x) __builtin_trunc(x)
#define rint(x) __builtin_rint(x)
#define copysign(x, y) __builtin_copysign(x, y)
#define FROM_SCRIPT(text) __attribute__((import_module("math"), import_name(text)))
FROM_SCRIPT("sin") double sin(double x);
FROM_SCRIPT("cos") double cos(double x);
FROM_SCRIPT("tan") double tan(double x);
FROM_SCRIPT("atan") double atan(double x);
FROM_SCRIPT("atan2") double atan2(double y, double x);
FROM_SCRIPT("cbrt") double cbrt(double x);
FROM_SCRIPT("acos") double acos(double x);
FROM_SCRIPT("asin") double asin(double x);
static inline double fmax(double a, double b) { return a != a || b > a ? b : a; }
static inline double fmin(double a, double b) { return a != a || b < a ? b : a; }
static inline double round(double x) {
  const double whole = trunc(x);
  return fabs(x - whole) >= 0.5 ? whole + copysign(1.0, x) : whole;
}
