/* SPDX-License-Identifier: MIT */
/* Stand-in for LinuxCNC's rtapi.h, of which a kinematics module uses nothing. */
