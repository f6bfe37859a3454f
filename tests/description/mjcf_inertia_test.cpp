// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "mjcf_body.h"
#include "model/evaluate.h"
#include "xml.h"

// Inertia of bodies from geoms, and the settings about it. tests/interop/geoms_test.cpp compares random
// models with MuJoCo; here are named cases. mjcf_meshes_test.cpp has those of meshes.
namespace qvgen::description {
namespace {

/// "mass; centre; xx, yy, zz, xy, yz, xz"
std::string texts(const model::Inertia& inertia) {
  std::string text = to_string(inertia.mass) + "; " + description::texts(inertia.centre_of_mass) + ";";
  for (std::size_t i = 0; i < 6; ++i) text += (i == 0 ? " " : ", ") + to_string(inertia.inertia.at(i));
  return text;
}

std::string inertia(const std::string& geoms, const std::string& head = "") {
  return texts(read(body(geoms, head)).joints.at(0).inertia);
}

TEST(MjcfInertia, SolidsOfKnownMassAreExact) {
  EXPECT_EQ(inertia("<geom size=\"0.5\" mass=\"2\"/>"), "2; 0, 0, 0; 1/5, 1/5, 1/5, 0, 0, 0");
  EXPECT_EQ(inertia("<geom type=\"box\" size=\"1 2 3\" mass=\"3\" pos=\"1 0 0\"/>"),
            "3; 1, 0, 0; 13, 10, 5, 0, 0, 0");
  EXPECT_EQ(inertia("<geom type=\"box\" size=\"0.5 0.5 1\"/>"),
            "2000; 0, 0, 0; 2500/3, 2500/3, 1000/3, 0, 0, 0");
  EXPECT_EQ(inertia("<geom type=\"ellipsoid\" size=\"1 2 3\" mass=\"5\"/>"),
            "5; 0, 0, 0; 13, 10, 5, 0, 0, 0");
  EXPECT_EQ(inertia("<geom type=\"cylinder\" size=\"1 3\" mass=\"4\"/>"), "4; 0, 0, 0; 13, 13, 2, 0, 0, 0");
  EXPECT_EQ(inertia("<geom type=\"capsule\" size=\"3 2\" mass=\"2\"/>"),
            "2; 0, 0, 0; 941/60, 941/60, 81/10, 0, 0, 0");
  EXPECT_EQ(inertia("<geom type=\"box\" size=\"1 1 1\" mass=\"9\" shellinertia=\"true\"/>"),
            "9; 0, 0, 0; 10, 10, 10, 0, 0, 0");
}

TEST(MjcfInertia, SeveralGeomsAreOneBody) {
  EXPECT_EQ(inertia("<geom size=\"1\" mass=\"1\" pos=\"1 0 0\"/><geom size=\"1\" mass=\"1\" pos=\"-1 0 2\"/>"
                    "<geom size=\"1\" mass=\"0\"/><geom size=\"1\" density=\"0\"/><geom type=\"plane\" "
                    "size=\"1 1 1\"/>"),
            "2; 0, 0, 1; 14/5, 24/5, 14/5, 0, 0, 2");
}

TEST(MjcfInertia, BetweenTwoPoints) {
  EXPECT_EQ(inertia("<geom type=\"cylinder\" size=\"1\" fromto=\"0 0 0 6 0 0\" mass=\"4\"/>").substr(0, 10),
            "4; 3, 0, 0");
  const model::Robot arm =
      read(body("<geom type=\"cylinder\" size=\"1\" fromto=\"0 0 0 6 0 0\" mass=\"4\"/>"));
  const auto& moments = arm.joints.at(0).inertia.inertia;
  EXPECT_NEAR(model::to_double(model::evaluate(moments[0])), 2, 1e-15);
  EXPECT_NEAR(model::to_double(model::evaluate(moments[1])), 13, 1e-14);
}

TEST(MjcfInertia, WhereItComesFrom) {
  const std::string both =
      "<inertial pos=\"0 0 0\" mass=\"1\" diaginertia=\"1 1 1\"/>"
      "<geom size=\"1\" mass=\"5\"/><geom size=\"1\" mass=\"7\" group=\"3\"/>";
  const auto with = [&](const std::string& text) {
    return inertia(both, "<compiler " + text + "/>").substr(0, 2);
  };
  EXPECT_EQ(with(""), "1;");
  EXPECT_EQ(with("inertiafromgeom=\"auto\""), "1;");
  EXPECT_EQ(with("inertiafromgeom=\"false\""), "1;");
  EXPECT_EQ(with("inertiafromgeom=\"true\""), "12");
  EXPECT_EQ(with("inertiafromgeom=\"true\" inertiagrouprange=\"1 5\""), "7;");
  EXPECT_EQ(with("inertiafromgeom=\"true\" inertiagrouprange=\"4 5\""), "1;");
  EXPECT_EQ(inertia("<geom size=\"1\" mass=\"5\"/>", "<compiler inertiafromgeom=\"false\"/>").substr(0, 2),
            "0;");
}

TEST(MjcfInertia, Bounds) {
  const std::string flat = "<inertial pos=\"0 0 0\" mass=\"1\" diaginertia=\"0.5 1 3\"/>";
  const auto with = [&](const std::string& text) { return inertia(flat, "<compiler " + text + "/>"); };
  EXPECT_EQ(with("boundmass=\"2\" boundinertia=\"2\""), "2; 0, 0, 0; 2, 2, 3, 0, 0, 0");
  EXPECT_EQ(with("balanceinertia=\"true\""), "1; 0, 0, 0; 3/2, 3/2, 3/2, 0, 0, 0");
  EXPECT_EQ(with("settotalmass=\"4\" balanceinertia=\"true\""), "4; 0, 0, 0; 6, 6, 6, 0, 0, 0");
  EXPECT_EQ(with("balanceinertia=\"true\" boundinertia=\"2\""), "1; 0, 0, 0; 2, 2, 3, 0, 0, 0");
}

TEST(MjcfInertia, TheTotalMassIsThatOfAllBodies) {
  const model::Robot arm = read(
      "<mujoco><compiler settotalmass=\"3\"/><worldbody><body><geom size=\"1\" mass=\"4\"/></body>"
      "<body><joint/><geom size=\"1\" mass=\"2\"/></body></worldbody></mujoco>");
  EXPECT_EQ(to_string(arm.joints.at(0).inertia.mass), "1");
}

TEST(MjcfInertia, MistakesOfGeoms) {
  EXPECT_EQ(report(body("\n<geom type=\"box\" size=\"1 2\"/>")),
            "3:24: error: the size of a geom of type box has fewer than 3 positive numbers; write as many\n");
  EXPECT_EQ(
      report(body("\n<geom fromto=\"0 0 0 1 0 0\" size=\"1\"/>")),
      "3:15: error: 'fromto' of a geom of type sphere, or of length zero; give two points, and the type "
      "capsule, cylinder, box or ellipsoid\n");
  EXPECT_EQ(
      report(body("\n<geom type=\"capsule\" fromto=\"1 0 0 1 0 0\" size=\"1\"/>")),
      "3:30: error: 'fromto' of a geom of type capsule, or of length zero; give two points, and the type "
      "capsule, cylinder, box or ellipsoid\n");
  EXPECT_EQ(
      report(body("\n<geom type=\"mesh\" mesh=\"m\"/><geom/>")),
      "2:1: warning: the body 'b' is read without inertia: that of a geom is not known; give it an "
      "<inertial>\n"
      "3:25: warning: the mesh 'm' has no volume here: there is no <mesh> of that name in <asset>; give the "
      "body an <inertial>\n"
      "3:29: warning: a geom without 'size'; give the body an <inertial>\n");
}

}  // namespace
}  // namespace qvgen::description
