// SPDX-License-Identifier: MIT
// Descriptions with slips in them are refused with a place and a reason, or generated.
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>

#include <gtest/gtest.h>

#include "answer.h"
#include "mutation.h"
#include "random_description.h"

namespace qvgen::test {
namespace {

/// QVGEN_FUZZ texts, 1000 without it.
int count() {
  const char* wanted = std::getenv("QVGEN_FUZZ");
  return wanted == nullptr ? 1000 : std::atoi(wanted);
}

constexpr const char* urdf = R"(<?xml version="1.0"?>
<robot name="arm"><link name="base"/>
<link name="l1"><inertial><origin xyz="0 0 0.1" rpy="0 0 0.3"/><mass value="2"/>
<inertia ixx="0.1" ixy="0" ixz="0" iyy="0.2" iyz="0" izz="0.25"/></inertial></link>
<link name="l2"/><link name="tool0"/>
<joint name="j1" type="revolute"><parent link="base"/><child link="l1"/><origin xyz="0 0 1" rpy="0 1.5708 0"/>
<axis xyz="0 0.7071 0.7071"/><limit lower="-3" upper="3"/><dynamics damping="0.5" friction="1"/></joint>
<joint name="j2" type="prismatic"><parent link="l1"/><child link="l2"/><limit lower="0" upper="1"/></joint>
<joint name="f" type="fixed"><parent link="l2"/><child link="tool0"/></joint></robot>)";

constexpr const char* mjcf = R"(<mujoco model="arm"><compiler angle="radian" eulerseq="zyx"/>
<default><joint damping="2"/><default class="slow"><joint armature="3" axis="0 1 0"/></default></default>
<worldbody><body name="base" pos="0 0 1" quat="1 0 0 1"><joint name="j0" range="-1 2" pos="0 1 0" ref="0.5"/>
<inertial pos="0 0 0.5" mass="2" diaginertia="0.1 0.2 0.25"/>
<body name="l1" euler="0.1 0 1.5708" childclass="slow"><joint type="slide"/><joint axis="1 1 0"/>
<inertial pos="0 0 0" mass="1" fullinertia="1 1 1 0 0 0"/><site name="tool" xyaxes="1 0 0 0 1 1"/></body></body>
</worldbody></mujoco>)";

std::vector<std::string> corpus() {
  std::vector<std::string> texts(20, urdf);  // as often as a share of all texts
  texts.insert(texts.end(), 20, mjcf);
  for (const auto& entry : std::filesystem::directory_iterator(QVGEN_SOURCE_DIR "/generator/robots")) {
    if (entry.path().extension() != ".toml") continue;
    std::ifstream file(entry.path());
    texts.push_back({std::istreambuf_iterator<char>(file), {}});
  }
  std::sort(texts.begin(), texts.end());
  for (std::uint32_t seed = 0; seed < 100; ++seed) texts.push_back(random_description(seed));
  return texts;
}

TEST(Fuzz, SlipsAreRefusedWithAPlaceOrGenerated) {
  const std::vector<std::string> texts = corpus();
  std::map<Answer, int> answers;
  for (int i = 0; i < count(); ++i) {
    std::mt19937 random(static_cast<std::uint32_t>(i));
    const std::string text = mutated(texts, random);
    try {
      ++answers[answer(text, 2)];
    } catch (const std::exception& error) {
      ADD_FAILURE() << "text " << i << ": " << error.what() << "\n" << text;
    }
  }
  for (const Answer each : {Answer::refused, Answer::read, Answer::generated})
    EXPECT_GT(answers[each], count() / 100) << "answer " << static_cast<int>(each);
}

}  // namespace
}  // namespace qvgen::test
