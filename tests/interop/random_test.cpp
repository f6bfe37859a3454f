// SPDX-License-Identifier: MIT
#include "random.h"

#include <sstream>

#include <gtest/gtest.h>

#include "compare.h"

// Chains that nobody builds, in every way of writing a frame that the formats have: the libraries' own
// readers are the measure.
namespace arms {
namespace {

using qvgen::description::SnapOptions;

std::string urdf_inertial(Random& random) {
  std::ostringstream text;
  const double mass = 2 + random.real();
  text << "<inertial><origin" << attribute("xyz", random.reals(3)) << attribute("rpy", random.reals(3, 3))
       << "/><mass value=\"" << mass
       << "\"/><inertia ixx=\"0.3\" iyy=\"0.25\" izz=\"0.2\" ixy=\"0.01\" ixz=\"-0.02\" "
       << "iyz=\"0.03\"/></inertial>";
  return text.str();
}

std::string random_urdf(Random& random) {
  std::string text = "<robot name=\"r\">\n<link name=\"base_link\"/>";
  const int count = 3 + random.below(6);
  std::string parent = "base_link";
  for (int i = 0; i <= count; ++i) {
    const std::string link = i == count ? "tool0" : "l" + std::to_string(i);
    // The first link but one is fixed, so is the tool.
    const bool fixed = i == 1 || i == count;
    const std::string type = fixed ? "fixed" : random.below(3) == 0 ? "prismatic" : "revolute";
    text += "<link name=\"" + link + "\">" + urdf_inertial(random) + "</link>\n<joint name=\"j" +
            std::to_string(i) + "\" type=\"" + type + "\"><parent link=\"" + parent + "\"/><child link=\"" +
            link + "\"/><origin" + attribute("xyz", random.reals(3)) + attribute("rpy", random.reals(3, 3)) +
            "/><axis" + attribute("xyz", random.reals(3)) +
            "/><limit lower=\"-3\" upper=\"3\" effort=\"1\" velocity=\"1\"/></joint>\n";
    parent = link;
  }
  return text + "</robot>";
}

std::string mjcf_joint(Random& random, const std::string& name, double angle) {
  std::string text = "<joint" + attribute("name", name);
  const bool slide = random.below(3) == 0;
  if (slide) text += " type=\"slide\"";
  if (random.below(2) == 0) text += attribute("axis", random.reals(3));
  if (random.below(2) == 0) text += attribute("pos", random.reals(3));
  if (random.below(2) == 0) text += attribute("ref", random.reals(1, slide ? 1 : angle));
  if (random.below(3) == 0) text += " class=\"stiff\"";
  if (random.below(3) == 0) text += " damping=\"0.25\"";
  return text + "/>";
}

std::string random_mjcf(Random& random) {
  const std::string sequence = [&] {
    static const std::string all[] = {"xyz", "zyx", "XYZ", "ZYX", "zxz", "ZYZ", "yXz"};
    return all[random.below(7)];
  }();
  const bool degrees = random.below(2) == 0;
  const double angle = degrees ? 180 : 3;
  std::string text =
      "<mujoco model=\"r\"><compiler eulerseq=\"" + sequence + "\"" + (degrees ? "" : " angle=\"radian\"") +
      "/><default><joint armature=\"0.125\"/><default class=\"stiff\"><joint damping=\"2\" axis=\"1 2 2\"/>"
      "<default class=\"other\"><joint axis=\"0 1 0\"/></default></default></default>\n<worldbody>\n";
  const int bodies = 2 + random.below(3);
  for (int i = 0; i <= bodies; ++i) {
    text += "<body name=\"" + (i == bodies ? "tool0" : "b" + std::to_string(i)) + "\"" +
            attribute("pos", random.reals(3)) + orientation(random, angle) +
            (random.below(3) == 0 ? " childclass=\"other\"" : "") + ">";
    for (int j = i == bodies ? 0 : 1 + random.below(2); j > 0; --j)
      text += mjcf_joint(random, "j" + std::to_string(i) + std::to_string(j), angle);
    text += "<inertial" + attribute("pos", random.reals(3)) + orientation(random, angle) +
            " mass=\"2\" diaginertia=\"0.3 0.25 0.2\"/>\n";
  }
  for (int i = 0; i <= bodies; ++i) text += "</body>";
  return text + "</worldbody></mujoco>";
}

TEST(Arms, RandomUrdfAgreesWithKdl) {
  for (unsigned seed = 0; seed < 50; ++seed) {
    Random random(seed);
    const std::string text = random_urdf(random);
    SCOPED_TRACE(text);
    compare(chain_of(read(text, "r.urdf", SnapOptions::off)), *kdl(text), random.engine);
    if (HasFailure()) return;
  }
}

TEST(Arms, RandomMjcfAgreesWithMuJoCo) {
  for (unsigned seed = 0; seed < 100; ++seed) {
    Random random(seed);
    const std::string text = random_mjcf(random);
    SCOPED_TRACE(text);
    compare(chain_of(read(text, "r.xml", SnapOptions::off)), *mujoco(text), random.engine);
    if (HasFailure()) return;
  }
}

}  // namespace
}  // namespace arms
