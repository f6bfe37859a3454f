// SPDX-License-Identifier: MIT
#include "folder.h"
#include "xml.h"

// Models in several files: <include>, <attach>, fragments; and what is written out within one: <frame>,
// <replicate>. tests/interop/parts_test.cpp compares random ones with MuJoCo.
namespace qvgen::description {
namespace {

std::string model(const std::string& content) { return "<mujoco model=\"arm\">\n" + content + "</mujoco>\n"; }
std::string world(const std::string& content) { return model("<worldbody>\n" + content + "</worldbody>\n"); }
std::string part(const std::string& content) { return "<mujocoinclude>\n" + content + "</mujocoinclude>\n"; }
const std::string hand = "<body name=\"hand\" pos=\"0 0 2\"><joint name=\"j\"/></body>\n";

TEST(MjcfFiles, IncludesStandInPlace) {
  Folder files;
  files.write("a.xml", model("<include file=\"parts/settings.xml\"/><worldbody><body pos=\"1 0 0\">\n"
                             "<include file=\"parts/hand.xml\"/></body></worldbody>"));
  files.write("parts/settings.xml", part("<compiler angle=\"radian\"/><include file=\"classes.xml\"/>"));
  files.write("parts/classes.xml",
              part("<default><joint range=\"-1 2\"/></default>"));  // beside the one that includes
  files.write("parts/hand.xml", part(hand));
  const model::Robot arm = files.robot("a.xml");
  ASSERT_EQ(arm.joints.size(), 1U);
  EXPECT_EQ(texts(arm.joints[0].before), "1, 0, 2");
  EXPECT_EQ(to_string(arm.joints[0].limits->upper), "2");
}

TEST(MjcfFiles, TheFolderOfTheModelComesFirst) {
  Folder files;
  files.write("a.xml", world("<include file=\"parts/b.xml\"/>"));
  files.write("parts/b.xml", part("<include file=\"c.xml\"/>"));
  files.write("parts/c.xml", part("<body name=\"wrong\"><joint/></body>"));
  files.write("c.xml", part(hand));
  EXPECT_EQ(files.robot("a.xml").title, "arm, world to hand");
}

TEST(MjcfFiles, MistakesStandInTheIncludedFile) {
  Folder files;
  files.write("a.xml", world("<include file=\"b.xml\"/>"));
  files.write("b.xml",
              part("<body name=\"b\"\n quat=\"0.9239 0.3827 0 0\"><joint axis=\"0 0 x\"/></body>\n"));
  EXPECT_EQ(files.report("a.xml"),
            "@b.xml:3:8: note: quat=\"0.9239 0.3827 0 0\" is read as 45 deg about x, entries change by up to "
            "1.1e-05; --snap off keeps it\n"
            "@b.xml:3:44: error: 'x' is no number; write a decimal number such as 0.1 or 1e-3\n");
  files.write("b.xml", "<a>\n<b></a>");
  EXPECT_EQ(files.report("a.xml"),
            "@a.xml:3:16: note: the mistake in @b.xml counts because of this line\n"
            "@b.xml:2:6: error: XML syntax: mismatched tag; every element is closed, attributes stand in "
            "quotes, & and "
            "< are written &amp; and &lt;\n");
}

TEST(MjcfFiles, WhatCannotBeIncluded) {
  Folder files;
  files.write("a.xml", world("<include/>\n<include file=\"sub/b.xml\"/>\n<include file=\"a.xml\"/>\n"
                             "<include file=\"sub\"/>\n<include file=\"sub/b.xml\"><a/></include>\n"
                             "<include file=\"./sub/../sub/b.xml\"/>"));
  files.write("sub/b.xml", part("<include file=\"none.xml\"/>"));
  EXPECT_EQ(
      files.report("a.xml"),
      "@a.xml:3:1: error: <include> without 'file'; add file=\"...\"\n"
      "@a.xml:5:16: error: 'a.xml' is included again, first at @a.xml:1:1; MuJoCo takes a file once: include "
      "it "
      "in one place, or attach it as a model\n"
      "@a.xml:6:16: error: cannot read @sub: it is a directory; name a readable file\n"
      "@a.xml:7:1: error: <include> has content; put it behind it, or into the file\n"
      "@a.xml:8:16: error: './sub/../sub/b.xml' is included again, first at @a.xml:4:16; MuJoCo takes a file "
      "once: include it in one place, or attach it as a model\n"
      "@sub/b.xml:2:16: error: the included file 'none.xml' is not there: no @none.xml, nor @sub/none.xml; "
      "names "
      "start in the folder of the model, or of the file that includes\n");
}

TEST(MjcfFiles, CirclesEnd) {
  Folder files;
  files.write("a.xml", world("<include file=\"b.xml\"/>"));
  files.write("b.xml", part("<include file=\"c.xml\"/>"));
  files.write("c.xml", part("<include file=\"b.xml\"/>"));
  EXPECT_EQ(files.report("a.xml"),
            "@c.xml:2:16: error: 'b.xml' is included again, first at @a.xml:3:16; MuJoCo takes a file once: "
            "include it "
            "in one place, or attach it as a model\n");
  files.write("m.xml", model("<asset><model file=\"n.xml\"/></asset>"));
  files.write("n.xml", model("<asset><model file=\"m.xml\"/></asset>"));
  EXPECT_EQ(files.report("m.xml"),
            "@n.xml:2:21: error: 'm.xml' holds itself, through its models; attach a file that does not lead "
            "back to "
            "this one\n");
  const std::string self =
      files.write("s.xml", world("<body name=\"b\"><joint/><attach body=\"b\" prefix=\"x\"/></body>"))
          .report("s.xml");
  EXPECT_NE(self.find("nested more than 500 deep; a body does not attach one that holds it"),
            std::string::npos)
      << self;
}

TEST(MjcfFiles, ManyFilesAndElementsAreRefused) {
  Folder files;
  std::string includes, wide;
  for (int i = 0; i < 250; ++i) {
    const std::string name = "part" + std::to_string(i) + ".xml";
    includes += "<include file=\"" + name + "\"/>";
    files.write(name, part("<a/>"));
  }
  EXPECT_NE(files.write("a.xml", model(includes)).report("a.xml").find("error: more than 200 files"),
            std::string::npos);
  for (int i = 0; i < 60'000; ++i) wide += "<a/>";
  files.write("b.xml", part(wide)).write("c.xml", part(wide));
  files.write("d.xml", model("<include file=\"b.xml\"/><include file=\"c.xml\"/>"));
  EXPECT_NE(files.report("d.xml").find("more than 100000 elements"), std::string::npos);
}

TEST(MjcfFiles, FramesAreAppliedToWhatTheyHold) {
  const model::Robot arm = read(world(
      "<frame pos=\"1 0 0\" euler=\"0 0 90\"><body name=\"b\" pos=\"2 0 0\">\n"
      "<frame pos=\"0 3 0\" euler=\"90 0 0\"><frame pos=\"0 0 1\"><joint axis=\"0 1 0\"/></frame></frame>\n"
      "<frame euler=\"0 90 0\"><site name=\"tool\" pos=\"0 0 5\"/></frame></body></frame>"));
  ASSERT_EQ(arm.joints.size(), 1U);
  EXPECT_EQ(texts(arm.joints[0].before), "0, 0, 1 by 1/2*pi; 1, 0, 0 by 1/2*pi; -1, 2, 0");
  EXPECT_EQ(texts(arm.joints[0].axis), "0, 1, 0");
  EXPECT_TRUE(arm.joints[0].after.turns.empty());  // link frames are not turned behind their joint
  EXPECT_EQ(texts(arm.tool), "1, 0, 0 by -1/2*pi; 0, 1, 0 by 1/2*pi; 5, 0, 0");
}

TEST(MjcfFiles, ClassesOfFramesHoldInThem) {
  const model::Robot arm =
      read(model("<default><default class=\"a\"><joint armature=\"1\"/></default><default class=\"b\"><joint "
                 "armature=\"2\"/></default>"
                 "</default><worldbody><body childclass=\"a\"><frame childclass=\"b\"><joint/></frame><joint "
                 "name=\"k\"/></body>"
                 "</worldbody>"));
  ASSERT_EQ(arm.joints.size(), 2U);
  EXPECT_EQ(to_string(arm.joints[0].drive.rotor_inertia), "2");
  EXPECT_EQ(to_string(arm.joints[1].drive.rotor_inertia), "1");
}

TEST(MjcfFiles, CopiesHaveNumbers) {
  ReadOptions options;
  options.tip = "tip-1-03";
  const model::Robot arm = read(world("<replicate count=\"12\" offset=\"1 0 0\" euler=\"0 0 90\" "
                                      "sep=\"-\"><body name=\"b\"><joint name=\"j\"/>\n"
                                      "<replicate count=\"2\" offset=\"0 0 1\" sep=\"-\"><body "
                                      "name=\"tip\"/></replicate></body></replicate>"),
                                options);
  ASSERT_EQ(arm.joints.size(), 1U);
  EXPECT_EQ(arm.joints[0].variable, "j_03");
  // Three steps of one along x, each turned by 90 degrees more.
  EXPECT_EQ(texts(arm.joints[0].before), "0, 0, 1 by 3/2*pi; 0, 1, 0");
  EXPECT_EQ(texts(arm.tool), "0, 0, 1");
}

TEST(MjcfFiles, CountlessCopiesAreRefused) {
  const auto with = [](const std::string& count) {
    return report(world("<body><joint/><replicate count=\"" + count + "\"><site/></replicate></body>"));
  };
  const std::string hint = "; write a whole number of copies, at most 1000\n";
  EXPECT_EQ(with("1000000000"), "3:33: error: a count of 1000000000" + hint);
  EXPECT_EQ(with("2.5"), "3:33: error: a count of 2.5" + hint);
  EXPECT_EQ(with("-1"), "3:33: error: a count of -1" + hint);
  EXPECT_EQ(with("0"), "");
  const std::string thousand = "<replicate count=\"1000\">";
  EXPECT_NE(report(world("<body><joint/>" + thousand + thousand + thousand +
                         "<site/></replicate></replicate></replicate></body>"))
                .find("with all copies more than 100000 elements; copy less"),
            std::string::npos);
}

TEST(MjcfFiles, DeepFramesAreRefused) {
  std::string open, close;
  for (int i = 0; i < 33; ++i) {
    open += "<frame pos=\"1 0 0\">";
    close += "</frame>";
  }
  EXPECT_EQ(report(world(open + "<body><joint/></body>" + close)),
            "3:609: error: frames nested more than 32 deep; put them together\n");
}

TEST(MjcfFiles, PartsOfOtherModelsAreAttached) {
  Folder files;
  files.write(
      "arm.xml",
      model("<compiler angle=\"radian\"/><asset><model name=\"gripper\" file=\"g/gripper.xml\"/></asset>\n"
            "<worldbody><body><joint range=\"0 1.5\"/><frame pos=\"0 0 1\">\n"
            "<attach model=\"gripper\" body=\"hand\" prefix=\"left_\"/></frame></body></worldbody>"));
  files.write(
      "g/gripper.xml",
      model("<include file=\"classes.xml\"/><worldbody><frame pos=\"7 7 7\">\n"
            "<body name=\"base\"><body name=\"hand\" pos=\"1 0 0\" euler=\"0 0 90\"><joint name=\"wrist\" "
            "range=\"0 90\"/><site name=\"tcp\" pos=\"0 0 3\"/></body></body></frame></worldbody>"));
  files.write("g/classes.xml", part("<default><joint damping=\"4\"/></default>"));
  ReadOptions options;
  options.tip = "left_tcp";
  const model::Robot arm = files.robot("arm.xml", options);
  ASSERT_EQ(arm.joints.size(), 2U);
  EXPECT_EQ(arm.joints[1].variable, "left_wrist");
  EXPECT_EQ(texts(arm.joints[1].before), "0, 0, 1 by 1/2*pi; 1, 0, 1");  // in degrees, as its own file says
  EXPECT_EQ(to_string(arm.joints[1].limits->upper), "1/2*pi");
  EXPECT_EQ(to_string(arm.joints[1].drive.viscous_friction), "4");
  EXPECT_EQ(to_string(arm.joints[0].drive.viscous_friction), "0");
}

TEST(MjcfFiles, FramesAndWholeModelsAreAttached) {
  Folder files;
  files.write("b.xml", world("<frame name=\"f\" pos=\"0 1 0\"><body name=\"b\"><joint/></body></frame>"));
  const std::string assets =
      "<asset><model name=\"m\" file=\"b.xml\"/></asset><worldbody><frame pos=\"1 0 0\">\n";
  const std::string end = "</frame></worldbody>";
  files.write("a.xml", model(assets + "<attach model=\"m\" frame=\"f\" prefix=\"x_\"/>" + end));
  EXPECT_EQ(texts(files.robot("a.xml").joints.at(0).before), "1, 1, 0");
  files.write("a.xml", model(assets + "<attach model=\"m\" prefix=\"x_\"/>" + end));
  EXPECT_EQ(texts(files.robot("a.xml").joints.at(0).before), "1, 1, 0");
  files.write(
      "a.xml",
      model(assets + "<attach model=\"n\" prefix=\"x_\"/><attach model=\"m\" body=\"c\"/><attach/>" + end));
  EXPECT_EQ(
      files.report("a.xml"),
      "@a.xml:3:1: error: there is no model 'n' to attach; add <model name=\"n\" file=\"...\"/> to <asset>\n"
      "@a.xml:3:56: error: there is no body 'c' to attach; name one that the model has\n"
      "@a.xml:3:60: error: nothing to attach; name a body of a model: model=\"...\" body=\"...\"\n");
}

TEST(MjcfFiles, FragmentsNameTheModelsThatIncludeThem) {
  Folder files;
  files.write("assets/hand.xml", part(hand));
  files.write("assets/more.xml", part("<include file=\"hand.xml\"/>"));
  files.write("arm.xml", world("<include file=\"assets/more.xml\"/>"));
  files.write("other.xml", world(hand));
  EXPECT_EQ(files.report("assets/hand.xml"),
            "@assets/hand.xml:1:1: error: <mujocoinclude> is a part of a model, for an <include>; give a "
            "model that "
            "includes it: @arm.xml\n");
}

TEST(MjcfFiles, ModelsWithoutBodiesNameTheModelsThatIncludeThem) {
  const std::string shared = "<mujoco><equality><weld body1=\"a\" body2=\"b\"/></equality></mujoco>";
  Folder files;
  files.write("shared.xml", shared);
  files.write("arm.xml", world("<include file=\"shared.xml\"/>"));
  EXPECT_EQ(files.report("shared.xml"),
            "@shared.xml:1:1: error: a <mujoco> without <worldbody> is a part of a model, for an <include>; "
            "give a model that includes it: @arm.xml\n");
  files.write("a/b/alone.xml", shared);
  EXPECT_EQ(files.report("a/b/alone.xml").find("is a part of a model"), std::string::npos);
}

TEST(MjcfFiles, FragmentsMayBeIncludedFromAFolderBeside) {
  Folder files;
  files.write("parts/hand.xml", part(hand));
  files.write("scenes/a.xml", world("<include file=\"../parts/hand.xml\"/>"));
  EXPECT_NE(files.report("parts/hand.xml").find("give a model that includes it: @scenes/a.xml\n"),
            std::string::npos);
}

TEST(MjcfFiles, FragmentsThatAreTreesAreRead) {
  Folder files;
  files.write("a/b/hand.xml", part(hand));
  EXPECT_EQ(
      files.report("a/b/hand.xml"),
      "@a/b/hand.xml:1:1: note: <mujocoinclude> is read as a model of its own: no file near by includes "
      "it; without "
      "<compiler> its angles are in degrees\n");
  EXPECT_EQ(texts(files.robot("a/b/hand.xml").joints.at(0).before), "0, 0, 2");
  files.write("a/b/finger.xml", part("<joint name=\"j\"/>" + hand));
  EXPECT_EQ(files.robot("a/b/finger.xml").joints.size(), 2U);
  files.write("a/b/whole.xml", part("<worldbody>" + hand + "</worldbody>"));
  EXPECT_EQ(files.robot("a/b/whole.xml").joints.size(), 1U);
  files.write("a/b/assets.xml", part("<asset/>"));
  EXPECT_EQ(files.report("a/b/assets.xml"),
            "@a/b/assets.xml:1:1: error: <mujocoinclude> is a part of a model, for an <include>; give the "
            "model that "
            "includes it\n");
}

}  // namespace
}  // namespace qvgen::description
