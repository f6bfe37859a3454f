// SPDX-License-Identifier: MIT
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "description/reader.h"

namespace qvgen::description {
namespace {

std::vector<std::string> texts_of_robots() {
  std::vector<std::string> texts;
  for (const auto& entry : std::filesystem::directory_iterator(QVGEN_SOURCE_DIR "/generator/robots")) {
    if (entry.path().extension() != ".toml") continue;
    std::ifstream file(entry.path());
    std::ostringstream text;
    text << file.rdbuf();
    texts.push_back(text.str());
  }
  std::sort(texts.begin(), texts.end());
  return texts;
}

/// A slip of the keyboard or of the mouse: something deleted, doubled, or put in.
void damage(std::string& text) {
  const std::size_t at = *rc::gen::inRange<std::size_t>(0, text.size());
  const std::size_t length = std::min<std::size_t>(*rc::gen::inRange<std::size_t>(1, 12), text.size() - at);
  switch (*rc::gen::inRange(0, 3)) {
    case 0:
      text.erase(at, length);
      break;
    case 1:
      text.insert(at, text.substr(at, length));
      break;
    default:
      text.insert(at, *rc::gen::element<std::string>("0", "-", "\"", "[", "]", "x", "theta1", " ", "\n", "(",
                                                     "1/0", "1e300", "nan", "=", "é", "{", "'", "^9", "<",
                                                     "/>", "&lt;", "<joint/>", " pos=\"0 0\"", "1e9"));
  }
}

/// Read or refused, with a place and a reason.
void expect_answer(const std::string& text, const std::string& file) {
  const ReadResult result = read_text(text, file);
  const long lines = std::count(text.begin(), text.end(), '\n') + 1;
  RC_ASSERT(result.robot || !result.diagnostics.empty());
  for (const Diagnostic& diagnostic : result.diagnostics) {
    RC_ASSERT(diagnostic.line >= 1 && diagnostic.line <= lines + 1);
    RC_ASSERT(diagnostic.column >= 1);
    RC_ASSERT(!diagnostic.message.empty());
    RC_ASSERT(!diagnostic.hint.empty());
  }
}

TEST(Fuzz, DamagedFilesAreReadOrRefusedWithAPlace) {
  const auto texts = texts_of_robots();
  EXPECT_TRUE(rc::check([&] {
    std::string text = *rc::gen::elementOf(texts);
    const int count = *rc::gen::inRange(1, 4);
    for (int i = 0; i < count; ++i) damage(text);
    expect_answer(text, "r.toml");
  }));
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

TEST(Fuzz, DamagedXmlIsReadOrRefusedWithAPlace) {
  EXPECT_TRUE(rc::check([&] {
    std::string text = *rc::gen::element<std::string>(urdf, mjcf);
    const int count = *rc::gen::inRange(1, 4);
    for (int i = 0; i < count; ++i) damage(text);
    expect_answer(text, "r.xml");
  }));
}

}  // namespace
}  // namespace qvgen::description
