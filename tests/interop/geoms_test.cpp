// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "compare.h"
#include "random.h"

// Inertia that follows from geoms, and what <compiler> does with it: MuJoCo's own reading is the measure.
namespace arms {
namespace {

struct Settings {
  bool degrees = false, balanced = false, from_geoms_alone = false;
  bool together = false;  ///< a body has several geoms, else one, and bodies fixed to it
  double angle() const { return degrees ? 180 : 3; }
};

std::string positive(Random& random, int count) {
  std::ostringstream text;
  for (int i = 0; i < count; ++i) text << (i == 0 ? "" : " ") << 0.3 + 0.2 * random.real();
  return text.str();
}

/// `counts`: the group is one that counts in every model here.
std::string geom(Random& random, const Settings& settings, bool counts) {
  static const std::string types[] = {"sphere", "capsule", "cylinder", "ellipsoid", "box"};
  const int type = random.below(5);
  const bool between = type != 0 && random.below(3) == 0;
  std::string text = "<geom" + attribute("type", types[type]);
  text += attribute("size", positive(random, type == 0 || between ? 1 : type < 3 ? 2 : 3));
  text += between ? attribute("fromto", random.reals(6))
                  : attribute("pos", random.reals(3)) + orientation(random, settings.angle());
  if (random.below(3) == 0) text += attribute("mass", positive(random, 1));
  if (random.below(3) == 0) text += attribute("density", random.below(2) == 0 ? "7" : "0.5");
  if (random.below(4) == 0) text += attribute("class", "light");
  return text + attribute("group", std::to_string(counts ? 3 : random.below(6))) + "/>\n";
}

std::string inertial(Random& random, const Settings& settings) {
  const std::string moments = settings.balanced ? "0.1 0.2 0.9" : "0.3 0.25 0.2";
  return "<inertial" + attribute("pos", random.reals(3)) + orientation(random, settings.angle()) +
         attribute("mass", positive(random, 1)) + attribute("diaginertia", moments) + "/>\n";
}

std::string compiler(Random& random, const Settings& settings) {
  std::string text = "<compiler" + attribute("angle", settings.degrees ? "degree" : "radian");
  if (settings.from_geoms_alone) text += attribute("inertiafromgeom", "true");
  if (settings.balanced) text += attribute("balanceinertia", "true");
  if (random.below(2) == 0) text += attribute("inertiagrouprange", random.below(2) == 0 ? "1 3" : "3 5");
  if (random.below(3) == 0) text += attribute("boundmass", "0.4");
  if (random.below(3) == 0) text += attribute("boundinertia", "0.15");
  if (random.below(3) == 0) text += attribute("settotalmass", "12.5");
  return text + "/>";
}

std::string random_model(Random& random, bool together) {
  Settings settings;
  settings.together = together;
  settings.degrees = random.below(2) == 0;
  settings.balanced = random.below(3) == 0;
  settings.from_geoms_alone = random.below(3) == 0;
  std::string text = "<mujoco model=\"r\">" + compiler(random, settings) +
                     "<default><geom density=\"3\" contype=\"0\" conaffinity=\"0\"/><default "
                     "class=\"light\"><geom density=\"0.25\" "
                     "group=\"2\"/></default></default>\n<worldbody><geom type=\"plane\" size=\"1 1 1\"/>\n";
  const int bodies = 2 + random.below(3);
  for (int i = 0; i <= bodies; ++i) {
    text += "<body name=\"" + (i == bodies ? "tool0" : "b" + std::to_string(i)) + "\"" +
            attribute("pos", random.reals(3)) + orientation(random, settings.angle()) +
            (random.below(4) == 0 ? " childclass=\"light\"" : "") + ">";
    if (i < bodies) text += "<joint" + attribute("axis", random.reals(3)) + "/>";
    if (random.below(3) == 0) text += inertial(random, settings);
    text += geom(random, settings, true);
    for (int more = random.below(3); more > 0; --more)
      text += settings.together ? geom(random, settings, false)
                                : "<body" + attribute("pos", random.reals(3)) + ">" +
                                      geom(random, settings, false) + "</body>";
  }
  for (int i = 0; i <= bodies; ++i) text += "</body>";
  return text + "</worldbody></mujoco>";
}

void compare_models(bool together, double tolerance) {
  for (unsigned seed = 0; seed < 100; ++seed) {
    Random random(seed);
    const std::string text = random_model(random, together);
    SCOPED_TRACE(text);
    const auto off = qvgen::description::SnapOptions::off;
    compare(chain_of(read(text, "r.xml", off)), *mujoco(text), random.engine, tolerance, !together);
    if (testing::Test::HasFailure()) return;
  }
}

TEST(Geoms, AgreeWithMuJoCo) { compare_models(false, 1e-12); }

// The principal axes of geoms together are an iteration of MuJoCo 2.2's that ends early; models like these
// agree with MuJoCo 4.0 to 2e-12. What is wrong here would be wrong by more than this.
TEST(Geoms, SeveralTogetherAgreeWithMuJoCo) { compare_models(true, 1e-6); }

}  // namespace
}  // namespace arms
