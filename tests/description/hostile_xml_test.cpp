// SPDX-License-Identifier: MIT
#include <filesystem>
#include <fstream>

#include "xml.h"

// Files that were made to hurt, or are no descriptions: a message each. ctest's limit on the time of this
// program is what a hang would meet.
namespace qvgen::description {
namespace {

TEST(HostileXml, Syntax) {
  const std::string hint =
      "; every element is closed, attributes stand in quotes, & and < are written &amp; and &lt;\n";
  EXPECT_EQ(report("<robot>\n  <link name=a/>\n"),
            "2:14: error: XML syntax: not well-formed (invalid token)" + hint);
  EXPECT_EQ(report("<robot><link></robot>"), "1:16: error: XML syntax: mismatched tag" + hint);
  EXPECT_EQ(report(""), "1:1: error: the file is empty; a URDF begins with <robot>, an MJCF with <mujoco>\n");
  EXPECT_EQ(report("<robot name='é'>\n<a b='é'c=''/></robot>"),
            "2:9: error: XML syntax: not well-formed (invalid token)" + hint);
  EXPECT_EQ(report(std::string("\x7f"
                               "ELF\x02\x01\x01\0\0\0",
                               10)),
            "1:1: error: XML syntax: not well-formed (invalid token)" + hint);
  EXPECT_EQ(
      report("<html/>"),
      "1:1: error: <html> is no robot description; a URDF begins with <robot>, an MJCF with <mujoco>\n");
}

TEST(HostileXml, EntitiesAreRefused) {
  const std::string refused =
      "error: a document type declaration (<!DOCTYPE ...>); remove it: entities and other files are not "
      "read\n";
  EXPECT_EQ(report("<?xml version=\"1.0\"?>\n<!DOCTYPE r [<!ENTITY a \"aaaaaaaaaa\"><!ENTITY b "
                   "\"&a;&a;&a;&a;&a;\">]>\n"
                   "<robot name=\"&b;\"/>"),
            "2:13: " + refused);
  EXPECT_EQ(report("<!DOCTYPE r [<!ENTITY a SYSTEM \"file:///etc/passwd\">]><robot name=\"&a;\"/>"),
            "1:13: " + refused);
}

TEST(HostileXml, DeepAndWide) {
  std::string deep;
  for (int i = 0; i < 100'000; ++i) deep += "<a>";
  EXPECT_NE(report(deep).find("error: elements nested more than 500 deep"), std::string::npos);
  std::string wide = "<robot name=\"r\">";
  for (int i = 0; i < 900'000; ++i) wide += "<a/>";
  EXPECT_NE(report(wide).find("error: more than 100000 elements"), std::string::npos);
}

/// A robot of so many links in a row.
std::string row(int count, const std::string& type) {
  std::string text = "<robot name=\"r\"><link name=\"l0\"/>\n";
  for (int i = 1; i <= count; ++i) {
    const std::string number = std::to_string(i);
    text += "<link name=\"l" + number + "\"/><joint name=\"j" + number + "\" type=\"" + type +
            "\"><parent link=\"l" + std::to_string(i - 1) + "\"/><child link=\"l" + number +
            "\"/><origin rpy=\"0.1 0.2 0.3\"/></joint>\n";
  }
  return text + "</robot>";
}

TEST(HostileXml, ManyLinks) {
  EXPECT_EQ(report(row(17, "continuous")),
            "18:1: error: 17 joints from l0 to l17 move; a robot has at most 16 joints\n");
  EXPECT_EQ(
      report(row(15'000, "fixed")),
      "1:17: error: no joint between l0 and the tips moves; an arm has at least one revolute, continuous or "
      "prismatic joint\n");
  std::string text = row(15'000, "fixed");
  text.replace(text.find("fixed"), 5, "continuous");
  EXPECT_EQ(report(text), "15001:1: error: 15000 links from l0 to l15000; an arm has at most 1000\n");
  std::string missing = "<robot name=\"r\">";
  for (int i = 0; i < 20'000; ++i) missing += "<joint name=\"j" + std::to_string(i) + "\" type=\"fixed\"/>";
  const std::string all = report(missing + "</robot>");
  EXPECT_EQ(std::count(all.begin(), all.end(), '\n'), 20);
}

TEST(HostileXml, LargeFilesAreNotRead) {
  const auto path = std::filesystem::temp_directory_path() / "qvgen_large.urdf";
  std::ofstream(path) << std::string(max_file_size + 1, ' ');
  const ReadResult result = read_file(path);
  std::filesystem::remove(path);
  ASSERT_EQ(result.diagnostics.size(), 1U);
  EXPECT_EQ(result.diagnostics[0].message, "the file has more than 4 MB");
  EXPECT_EQ(read_file("/dev/zero").diagnostics.at(0).message, "the file has more than 4 MB");
}

}  // namespace
}  // namespace qvgen::description
