// SPDX-License-Identifier: MIT
#include "canonical/structure.h"

#include <algorithm>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "description/reader.h"

namespace {

using namespace qvgen;
using namespace qvgen::canonical;

model::Robot committed(const std::string& name) {
  return *description::read_file(std::string(QVGEN_SOURCE_DIR "/generator/robots/") + name + ".toml").robot;
}

const std::vector<std::string> codes{"ss", "sc", "sn", "cs", "cc", "cr", "ns", "nn",
                                     "nr", "rc", "rn", "rr", "rs", "sr", "cn", "nc"};

/// Every arm of three joints along coordinate axes.
std::vector<Structure> all_structures() {
  std::vector<Structure> list;
  const char* axes[] = {"+x", "+y", "+z"};
  for (int types = 0; types < 8; ++types)
    for (int a = 0; a < 27; ++a) {
      std::string text = "name = \"arm\"\ntitle = \"three joints\"\n";
      const int axis[] = {a % 3, a / 3 % 3, a / 9};
      for (int i = 0; i < 3; ++i)
        text += "[[joint]]\nvariable = \"q" + std::to_string(i) + "\"\naxis = \"" + axes[axis[i]] +
                "\"\ntype = \"" + ((types >> i) % 2 != 0 ? "revolute" : "prismatic") + "\"\n";
      list.push_back(*structure_of(*description::read_text(text, "arm.toml").robot));
    }
  return list;
}

/// Three turns about axes at one angle or another to each other.
Structure of_axes(const std::vector<std::string>& axes) {
  std::string text = "name = \"arm\"\ntitle = \"three joints\"\n";
  for (std::size_t i = 0; i < axes.size(); ++i)
    text += "[[joint]]\nvariable = \"q" + std::to_string(i) + "\"\naxis = " + axes[i] +
            "\ntype = \"revolute\"\norigin = [0.1, 0.2, 0.3]\n";
  return *structure_of(*description::read_text(text, "arm.toml").robot);
}

/// Frames along the normals of such axes turn by angles that are no multiple of a right one.
TEST(Structure, ObliqueAxesHaveNamedAngles) {
  using enum Relation;
  const std::string a = "[0, \"3/5\", \"4/5\"]", across = "[0, \"-4/5\", \"3/5\"]",
                    b = "[\"4/5\", 0, \"3/5\"]";
  EXPECT_EQ(of_axes({a, b, b}).relations, (std::array{oblique, parallel}));
  EXPECT_EQ(of_axes({b, a, across}).relations, (std::array{oblique, perpendicular}));
  EXPECT_EQ(of_axes({a, across, b}).relations, (std::array{perpendicular, oblique}));
}

TEST(Structure, CodesOfTheSixteenArms) {
  for (const std::string& name : codes) {
    std::string code = *code_of(*structure_of(committed(name)));
    for (char& letter : code) letter = static_cast<char>(letter + ('a' - 'A'));
    EXPECT_EQ(code, name);
  }
}

/// Thesis, chapter 2: of the codes CN, NC, RS and SR are not useful and distinct, the other twelve are.
TEST(Structure, TwelveAreUsefulAndDistinct) {
  std::set<std::string> kept;
  for (const Structure& structure : all_structures()) {
    const auto same = alike(structure);
    for (const Structure& each : same) EXPECT_EQ(is_useful(each), is_useful(structure));
    if (is_useful(structure))
      kept.insert(code_of(representative(structure)).value_or("none " + types_of(structure)));
  }
  EXPECT_EQ(kept,
            (std::set<std::string>{"SS", "SC", "SN", "CS", "CC", "CR", "NS", "NN", "NR", "RC", "RN", "RR"}));
  const std::map<std::string, std::string> others{{"cn", "CR"}, {"nc", "RC"}, {"rs", "CC"}, {"sr", "CC"}};
  for (const std::string& name : codes) {
    const Structure structure = *structure_of(committed(name));
    EXPECT_TRUE(is_useful(structure)) << name;
    const auto place = others.find(name);
    EXPECT_EQ(representative(structure) == structure, place == others.end()) << name;
    if (place != others.end()) {
      EXPECT_EQ(code_of(representative(structure)), place->second) << name;
    }
  }
}

TEST(Structure, Workspaces) {
  const std::map<std::string, Workspace> expected{
      {"ss", Workspace::prismatic},   {"sc", Workspace::cylindrical}, {"cs", Workspace::cylindrical},
      {"cc", Workspace::cylindrical}, {"rs", Workspace::cylindrical}, {"sr", Workspace::cylindrical}};
  for (const std::string& name : codes) {
    const auto place = expected.find(name);
    EXPECT_EQ(workspace_of(*structure_of(committed(name))),
              place == expected.end() ? Workspace::spherical : place->second)
        << name;
  }
  EXPECT_EQ(code_of(*structure_of(committed("puma560"))), "NR");
  EXPECT_EQ(code_of(*structure_of(committed("stanford"))), "NS");
  EXPECT_FALSE(structure_of(committed("general_6r"))) << "its twists are symbols";
}

/// Planar arms, slides in one plane: they move no point in all three directions.
TEST(Structure, UselessOnes) {
  for (const Structure& structure : all_structures())
    if (!is_useful(structure)) {
      EXPECT_EQ(workspace_of(structure), Workspace::none);
    }
  using enum Relation;
  EXPECT_FALSE(is_useful({{true, true, true}, {parallel, parallel}, oblique}));
  EXPECT_FALSE(is_useful({{true, true, false}, {parallel, perpendicular}, oblique}));
  EXPECT_FALSE(is_useful({{true, false, true}, {perpendicular, perpendicular}, parallel}));
  EXPECT_TRUE(is_useful({{true, false, true}, {perpendicular, perpendicular}, perpendicular}));
}

}  // namespace
