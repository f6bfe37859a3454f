/* SPDX-License-Identifier: MIT */
/* Stand-ins for the headers of LinuxCNC: what a kinematics module uses of them, with the names and types of
 * version 2.9. */
#ifndef STAND_IN_KINEMATICS_H
#define STAND_IN_KINEMATICS_H

typedef struct {
  double x, y, z;
} PmCartesian;
typedef struct {
  PmCartesian tran;
  double a, b, c, u, v, w;
} EmcPose;
typedef unsigned long int KINEMATICS_FORWARD_FLAGS;
typedef unsigned long int KINEMATICS_INVERSE_FLAGS;
typedef enum {
  KINEMATICS_IDENTITY = 1,
  KINEMATICS_FORWARD_ONLY,
  KINEMATICS_INVERSE_ONLY,
  KINEMATICS_BOTH
} KINEMATICS_TYPE;

extern int kinematicsForward(const double* joint, EmcPose* world, const KINEMATICS_FORWARD_FLAGS* fflags,
                             KINEMATICS_INVERSE_FLAGS* iflags);
extern int kinematicsInverse(const EmcPose* world, double* joint, const KINEMATICS_INVERSE_FLAGS* iflags,
                             KINEMATICS_FORWARD_FLAGS* fflags);
extern KINEMATICS_TYPE kinematicsType(void);
extern int kinematicsSwitchable(void);
extern int kinematicsSwitch(int type);

#define EXPORT_SYMBOL(name) extern int exported_##name
#define KINS_NOT_SWITCHABLE                    \
  int kinematicsSwitchable(void) { return 0; } \
  int kinematicsSwitch(int type) {             \
    (void)type;                                \
    return 0;                                  \
  }                                            \
  EXPORT_SYMBOL(kinematicsSwitchable);         \
  EXPORT_SYMBOL(kinematicsSwitch);

#endif
