/* SPDX-License-Identifier: MIT */
/* Stand-in for LinuxCNC's rtapi_app.h. */
#ifndef STAND_IN_RTAPI_APP_H
#define STAND_IN_RTAPI_APP_H
#define MODULE_LICENSE(text) extern int licensed
extern int rtapi_app_main(void);
extern void rtapi_app_exit(void);
#endif
