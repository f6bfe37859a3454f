// SPDX-License-Identifier: MIT
#pragma once

// Orientations in the notations of robot controllers and other programs, and rates of change in each of them:
// quaternions in either order, rotation matrices, rotation vectors and the 24 Euler conventions.
//
//     const qvgen::Quaternion<double> q = qvgen::from_euler_angles<double>({0.1, 0.2, 0.3}, qvgen::kuka_abc);
//     const auto wpr = qvgen::euler_angles(q, qvgen::fanuc_wpr);     // wpr.angles, wpr.gimbal_lock

#include <qvgen/orientation/analytical_jacobian.h>
#include <qvgen/orientation/decimals.h>
#include <qvgen/orientation/euler_angles.h>
#include <qvgen/orientation/euler_convention.h>
#include <qvgen/orientation/nearest_rotation.h>
#include <qvgen/orientation/order.h>
#include <qvgen/orientation/rates.h>
