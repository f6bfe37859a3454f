/* SPDX-License-Identifier: MIT */
/* Stand-in for LinuxCNC's hal.h; pins are numbers that the test can set. */
#ifndef STAND_IN_HAL_H
#define STAND_IN_HAL_H

typedef volatile double hal_float_t;
typedef enum { HAL_IN = 16, HAL_OUT = 32 } hal_pin_dir_t;
extern int hal_init(const char* name);
extern int hal_exit(int component);
extern int hal_ready(int component);
extern void* hal_malloc(long int size);
extern int hal_pin_float_newf(hal_pin_dir_t direction, hal_float_t** pin, int component, const char* format,
                              ...);

#endif
