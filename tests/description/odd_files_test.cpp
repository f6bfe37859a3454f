// SPDX-License-Identifier: MIT
#include "description/write.h"
#include "model/evaluate.h"
#include "xml.h"

// Files that break a rule which other readers do not mind, and units of tables: what is read, and what is
// said.
namespace qvgen::description {
namespace {

const std::string body =
    "<robot name=\"r\"><link name=\"a\"/><link name=\"b\"/>\n"
    "<joint name=\"j\" type=\"continuous\"><parent link=\"a\"/><child link=\"b\"/><origin xyz=\"0 0 0.25\"/>"
    "</joint></robot>";
const std::string declaration = "<?xml version=\"1.0\" encoding=\"utf-8\"?>";

std::string utf16(const std::string& ascii, bool big) {
  std::string text = big ? "\xFE\xFF" : "\xFF\xFE";
  for (const char c : ascii) text += big ? std::string{'\0', c} : std::string{c, '\0'};
  return text;
}

TEST(OddFiles, DeclarationsThatAreNotFirst) {
  EXPECT_EQ(report(declaration + "\n" + body), "");
  const std::string warning =
      "warning: the XML declaration is not the beginning of the file: it is left out; put it first\n";
  EXPECT_EQ(report("\n" + declaration + body), "2:1: " + warning);
  EXPECT_EQ(report("<!-- by\n hand -->\n  " + declaration + "\n" + body), "3:3: " + warning);
  EXPECT_EQ(report("<!-- open " + declaration + body).substr(0, 30), "1:1: error: XML syntax: unclos");
}

TEST(OddFiles, ByteOrderMarks) {
  const std::string mark = "\xEF\xBB\xBF";
  EXPECT_EQ(report(mark + body), "");
  EXPECT_EQ(report(mark + declaration + "\n" + body), "");
  EXPECT_EQ(report(mark + "\n" + declaration + body).substr(0, 14), "2:1: warning: ");
  for (const bool big : {true, false}) {
    EXPECT_EQ(report(utf16(body, big)),
              "1:1: note: the file is in UTF-16 and read so; UTF-8 is more usual\n");
    EXPECT_TRUE(read_text(utf16("<?xml version=\"1.0\" encoding=\"UTF-16\"?>" + body, big), "r.urdf").robot);
    EXPECT_TRUE(read_text(utf16(body, big), "no_extension").robot);
    // Any cut of such a file is answered.
    for (std::size_t size = 2; size < 40; ++size) read_text(utf16(body, big).substr(0, size), "r.urdf");
  }
}

TEST(OddFiles, MacrosWithoutTheirNamespace) {
  std::string text = body;
  text.insert(text.find("<link"), "<xacro:property name=\"h\" value=\"1\"/>");
  EXPECT_EQ(report(text),
            "1:17: warning: <xacro:property> is left out, as by other readers; macros need "
            "xmlns:xacro=\"http://ros.org/wiki/xacro\" in <robot>\n");
  text.insert(text.find(" name"), " xmlns:xacro=\"http://ros.org/wiki/xacro\"");
  EXPECT_NE(report(text).find("pip install xacro"), std::string::npos);
}

std::string with(const std::string& in_joint, const std::string& in_link = "") {
  return "<robot name=\"r\"><link name=\"a\"/><link name=\"b\">" + in_link +
         "</link>\n<joint name=\"j\" type=\"revolute\"><parent link=\"a\"/><child link=\"b\"/>" + in_joint +
         "</joint></robot>";
}

TEST(OddFiles, MirroredEntriesOfTheTensor) {
  const std::string limit = "<limit lower=\"-1\" upper=\"1\"/>";
  const auto inertial = [](const std::string& entries) {
    return "<inertial><mass value=\"1\"/><inertia ixx=\"1\" iyy=\"1\" izz=\"1\" " + entries + "/></inertial>";
  };
  const model::Robot robot = read(with(limit, inertial("iyx=\"0.1\" izx=\"0.2\" izy=\"0.3\"")));
  ASSERT_EQ(robot.joints.size(), 1U);
  const auto& tensor = robot.joints[0].inertia.inertia;  // xy, yz, xz behind the moments
  EXPECT_EQ(to_string(tensor[3]) + " " + to_string(tensor[4]) + " " + to_string(tensor[5]), "1/10 3/10 1/5");
  EXPECT_EQ(report(with(limit, inertial("ixy=\"0.1\" iyx=\"0.1\""))), "");
  EXPECT_EQ(report(with(limit, inertial("ixy=\"0.1\" iyx=\"-0.1\""))),
            "1:123: warning: ixy and iyx differ: 0.1 is read; the tensor is symmetric\n");
}

TEST(OddFiles, LimitsOfVelocityAndEffort) {
  const auto limit = [](const std::string& more) {
    return with("<limit lower=\"-1\" upper=\"1\" " + more + "/>");
  };
  const model::Robot robot = read(limit("velocity=\"3.15\" effort=\"28\""));
  ASSERT_EQ(robot.joints.size(), 1U);
  EXPECT_EQ(to_string(robot.joints[0].greatest_velocity.value()), "63/20");
  EXPECT_EQ(to_string(robot.joints[0].greatest_effort.value()), "28");
  EXPECT_FALSE(read(limit("velocity=\"0\" effort=\"0\"")).joints[0].greatest_velocity);
  EXPECT_EQ(report(limit("velocity=\"fast\"")),
            "2:106: warning: the velocity 'fast' is left out; write a positive number\n");
  const std::string toml = write_text(robot);
  EXPECT_NE(toml.find("velocity_limit = 3.15\neffort_limit = 28\n"), std::string::npos) << toml;
  const ReadResult again = read_text(toml, "r.toml");
  ASSERT_TRUE(again.robot);
  EXPECT_EQ(write_text(*again.robot), toml);
  std::string wrong = toml;
  wrong.replace(wrong.find("3.15"), 4, "-1");
  EXPECT_EQ(read_text(wrong, "r.toml").diagnostics.at(0).message, "'velocity_limit' is not above 0");
}

TEST(OddFiles, Commas) {
  const auto origin = [](const std::string& xyz) {
    return with("<origin xyz=\"" + xyz + "\"/><limit lower=\"-1\" upper=\"1\"/>");
  };
  const auto place = [&](const std::string& xyz) {
    const ReadResult result = read_text(origin(xyz), "r.urdf");
    return result.robot ? texts(result.robot->joints[0].before) : result.diagnostics.at(0).message;
  };
  EXPECT_EQ(place("1,234.5 0 -1,234,567"), "2469/2, 0, -1234567");
  EXPECT_EQ(place("+1,234.5e-2 12,345,678 -1,000."), "2469/200, 12345678, -1000");
  EXPECT_EQ(place("0.5, 0.25, 1"), "1/2, 1/4, 1");
  EXPECT_EQ(report(origin("0, 0 0")), "2:81: warning: '0,' is read as 0; write it without ','\n");
  // Thousands or a decimal point: nobody can tell.
  EXPECT_EQ(place("1,571 0 0"), "'1,571' is no number");
  EXPECT_EQ(place("0,1 0 0"), "'0,1' is no number");
  EXPECT_EQ(place(", 0 0"), "',' is no number");
  for (const std::string word :
       {"0,123.5", "1234,567.5", "1,23,456", "1,234,56", "1,234.5e", "1,234.5,6", "1,234e2"})
    EXPECT_EQ(place(word + " 0 0"), "'" + word + "' is no number");
}

TEST(OddFiles, JointsOfOtherFormatsBesideTheChain) {
  std::string text = with("<limit lower=\"-1\" upper=\"1\"/>");
  text.insert(text.find("</robot>"),
              "<link name=\"c\"/><joint name=\"k\" type=\"gearbox\"><parent link=\"a\"/><child link=\"c\"/>"
              "</joint>");
  EXPECT_TRUE(read_text(text, "r.urdf", {.tip = "b"}).robot);
  EXPECT_EQ(read_text(text, "r.urdf", {.tip = "c"}).diagnostics.at(0).message, "the joint 'k' is gearbox");
}

std::string table(const std::string& head, const std::string& numbers) {
  return "name = \"a\"\ntitle = \"a\"\n" + head + "convention = \"standard\"\n[defaults]\nl1 = 0.4\n" +
         numbers;
}

std::string value_text(const model::Expression& e) {
  return std::to_string(model::to_double(model::evaluate(e)));
}

std::string frame_text(const model::Displacement& frame) {
  std::string text;
  for (const model::Turn& turn : frame.turns)
    text += texts(turn.axis) + " by " + value_text(turn.angle) + "; ";
  return text + texts(frame.translation);
}

/// Frames, limits and centres of mass as text; angles by their values, since -90 deg has two spellings.
std::string all_of(const model::Robot& robot) {
  std::string text = frame_text(robot.tool) + "\n";
  for (const model::Joint& joint : robot.joints) {
    text += frame_text(joint.before) + " | " + texts(joint.axis) + " | " + frame_text(joint.after) + " | " +
            texts(joint.inertia.centre_of_mass);
    if (joint.limits)
      text += " | " + value_text(joint.limits->lower) + " to " + value_text(joint.limits->upper);
    text += "\n";
  }
  return text;
}

TEST(Units, TablesInMillimetresAndDegrees) {
  const std::string in_mm =
      "[[dh]]\nvariable = \"t1\"\ntheta = \"t1 - 90\"\nd = 90\na = \"l1 + 75\"\nalpha = -90\nlimits = [-170, "
      "170]\n"
      "[[dh]]\nvariable = \"t2\"\ntheta = \"t2\"\na = 270\nalpha = \"pi/2 rad\"\n"
      "[[dh]]\nvariable = \"d3\"\nd = \"d3 + 12.5\"\nlimits = [0, 300]\ncentre_of_mass = [0, 0, -20]\nmass = "
      "1\n"
      "inertia = [1, 1, 1]\n";
  const std::string in_si =
      "[[dh]]\nvariable = \"t1\"\ntheta = \"t1 - 90 deg\"\nd = 0.09\na = \"l1 + 0.075\"\nalpha = \"-90 "
      "deg\"\n"
      "limits = [\"-170 deg\", \"170 deg\"]\n"
      "[[dh]]\nvariable = \"t2\"\ntheta = \"t2\"\na = 0.27\nalpha = \"pi/2 rad\"\n"
      "[[dh]]\nvariable = \"d3\"\nd = \"d3 + 0.0125\"\nlimits = [0, 0.3]\ncentre_of_mass = [0, 0, "
      "-0.02]\nmass = 1\n"
      "inertia = [1, 1, 1]\n";
  const ReadResult mm = read_text(table("unit = \"mm\"\nangle_unit = \"deg\"\n", in_mm), "r.toml");
  const ReadResult si = read_text(table("", in_si), "r.toml");
  ASSERT_TRUE(mm.robot) << (mm.diagnostics.empty() ? "" : to_string(mm.diagnostics[0]));
  ASSERT_TRUE(si.robot) << (si.diagnostics.empty() ? "" : to_string(si.diagnostics[0]));
  EXPECT_TRUE(mm.diagnostics.empty());
  EXPECT_EQ(all_of(*mm.robot), all_of(*si.robot));
}

TEST(Units, JointsAndFrames) {
  const auto robot = [](const std::string& head, const std::string& length, const std::string& angle) {
    const ReadResult result = read_text(
        "name = \"a\"\ntitle = \"a\"\n" + head + "[tool]\ntranslation = [0, 0, " + length + "]\nrpy = [0, " +
            angle + ", 0]\n[[joint]]\ntype = \"revolute\"\naxis = \"+z\"\nvariable = \"t\"\n" + "origin = [" +
            length + ", 0, 0]\nturns = [{ axis = \"+x\", angle = " + angle + " }]\n",
        "r.toml");
    for (const auto& diagnostic : result.diagnostics) ADD_FAILURE() << to_string(diagnostic);
    return result.robot ? write_text(*result.robot) : "";
  };
  EXPECT_EQ(robot("unit = \"cm\"\nangle_unit = \"deg\"\n", "12", "30"), robot("", "0.12", "\"30 deg\""));
  EXPECT_EQ(robot("unit = \"in\"\n", "10", "0.5"), robot("", "0.254", "0.5"));
  EXPECT_EQ(robot("unit = \"m\"\nangle_unit = \"rad\"\n", "2", "0.5"), robot("", "2", "0.5"));
  std::string said;
  for (const auto& diagnostic : read_text("unit = \"feet\"\nangle_unit = \"gon\"\n", "r.toml").diagnostics)
    said += to_string(diagnostic) + "\n";
  EXPECT_NE(said.find("r.toml:1:8: error: unknown unit 'feet'; write m, cm, mm or in\n"), std::string::npos);
  EXPECT_NE(said.find("r.toml:2:14: error: unknown unit 'gon'; write rad or deg\n"), std::string::npos);
}

TEST(Units, RoundedAxesAreMadeUnitVectors) {
  const auto axis = [](const std::string& entries) {
    return read_text(
        "name = \"a\"\ntitle = \"a\"\n[[joint]]\ntype = \"revolute\"\nvariable = \"t\"\naxis = [" + entries +
            "]\n",
        "r.toml");
  };
  const ReadResult seven = axis("0.7071068, 0, 0.7071068");
  ASSERT_TRUE(seven.robot);
  EXPECT_EQ(texts(seven.robot->joints[0].axis), "sqrt(2)/2, 0, sqrt(2)/2");
  EXPECT_EQ(to_string(seven.diagnostics.at(0)),
            "r.toml:6:8: note: the axis has length 1.00000003 and is read as [sqrt(2)/2, 0, sqrt(2)/2]; "
            "write it so if "
            "other digits are meant");
  // Any direction, with seven digits: exactly of length 1.
  const ReadResult any = axis("0.2672612, 0.5345225, 0.8017837");
  ASSERT_TRUE(any.robot);
  cln::cl_R squared = 0;
  for (const auto& entry : any.robot->joints[0].axis) squared = squared + cln::square(model::evaluate(entry));
  EXPECT_TRUE(model::vanishes(squared - 1));
  EXPECT_FALSE(axis("0.7, 0, 0.7").robot);
}

}  // namespace
}  // namespace qvgen::description
