// SPDX-License-Identifier: MIT
// Centre of mass and its Jacobian of a robot whose base floats, in C, by its momentum matrix as in
// qvgen/centroidal.h: a turn about x moves the centre along m (0, -z, y), one about y along m (z, 0, -x).
#include "emit/c/parts.h"
#include "model/coordinates.h"

namespace qvgen::emit::c {
namespace {

Function head(const model::Robot& robot, const std::string& name, std::vector<std::string> doc,
              const Parameter& result) {
  doc.emplace_back("`base`: its orientation w x y z and its position in the world, m. NaN without mass.");
  Function function{name,
                    std::move(doc),
                    {{"const double ", "base", "[7]"},
                     joint_array(robot, "q"),
                     geometry(robot),
                     {"const " + robot.name + "_inertia* ", "inertia"},
                     result}};
  function.statements = {"double momentum[6][" + std::to_string(model::coordinate_count(robot)) + "];",
                         robot.name + "_momentum_matrix(base, q, g, inertia, momentum);",
                         "const double w = base[0], x = base[1], y = base[2], z = base[3];",
                         "const double turn[3][3] = {",
                         "    {1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},",
                         "    {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},",
                         "    {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}};"};
  return function;
}

Function centre_of_mass(const model::Robot& robot) {
  Function function =
      head(robot, "centre_of_mass", {"Centre of mass of all links in the world, m."}, result_array(3));
  append(function.statements,
         {"const double centre[3] = {-momentum[2][4] / momentum[0][0], momentum[2][3] / momentum[0][0],",
          "                          -momentum[1][3] / momentum[0][0]};", "for (int i = 0; i < 3; ++i)",
          "  result[i] = base[4 + i] + turn[i][0] * centre[0] + turn[i][1] * centre[1] + turn[i][2] * "
          "centre[2];"});
  return function;
}

Function centre_of_mass_jacobian(const model::Robot& robot) {
  const std::size_t size = model::coordinate_count(robot);
  Function function =
      head(robot, "centre_of_mass_jacobian",
           {"Derivatives of the centre of mass by velocities: the base's linear and angular one in "
            "its own frame,",
            "then the joints' rates."},
           result_matrix(3, size));
  append(function.statements,
         {"for (int k = 0; k < " + std::to_string(size) + "; ++k)", "  for (int i = 0; i < 3; ++i)",
          "    result[i][k] = (turn[i][0] * momentum[0][k] + turn[i][1] * momentum[1][k] +",
          "                    turn[i][2] * momentum[2][k]) / momentum[0][0];"});
  return function;
}

}  // namespace

Part centroidal(const model::Robot& robot) {
  return written(robot, {centre_of_mass(robot), centre_of_mass_jacobian(robot)});
}

}  // namespace qvgen::emit::c
