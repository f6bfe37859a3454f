// SPDX-License-Identifier: MIT
// <string.h> of generated C without a C library: instructions of WebAssembly.
#pragma once
#define memcpy(to, from, size) __builtin_memcpy(to, from, size)
#define memmove(to, from, size) __builtin_memmove(to, from, size)
#define memset(to, value, size) __builtin_memset(to, value, size)
