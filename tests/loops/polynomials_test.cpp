// SPDX-License-Identifier: MIT
// Joints that follow by polynomials: cams, knees with a rolling contact, springs behind levers. Gaps and
// their derivatives are MuJoCo's equality constraints of the same file; assemblies, motions and dynamics are
// those of the reference, which takes the polynomial as its text has it.
#include <fstream>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "assembly_laws.h"
#include "derive/inverse/lower.h"
#include "derive/loops/assembly_plan.h"
#include "description/reader.h"
#include "description/write.h"
#include "mujoco_model.h"
#include "standing_functions.h"
#include "verify/loops/certify_loops.h"
#include "verify/loops/mobility.h"

namespace qvgen::test::polynomials {
namespace {

using loops::Folder;
using loops::Language;
using testing::HasSubstr;

constexpr unsigned models_wanted = QVGEN_LOOP_RODS < 100 ? 1 : QVGEN_LOOP_RODS / 10;

std::string first_error(const description::ReadResult& result) {
  for (const auto& diagnostic : result.diagnostics)
    if (diagnostic.severity == description::Diagnostic::error) return description::to_string(diagnostic);
  return "";
}

model::Mechanism mechanism_of(const description::ReadResult& result) {
  if (!result.robot) throw std::runtime_error(first_error(result));
  return {*result.robot, result.tips, result.loops};
}

class Draw {
 public:
  explicit Draw(unsigned seed) : random_(seed) {}
  int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }
  /// A number between -most and most, of six decimals: readers take shorter ones for rounded parts of pi.
  std::string number(double most = 1) { return std::to_string(most * (below(2000001) - 1000000) / 1000000); }

 private:
  std::mt19937 random_;
};

/// A tree of hinges and slides with positions of reference, tied by polynomials of degree 1 to 4. Joints lead
/// that follow none; so no relation is made of others.
std::string random_mjcf(unsigned seed, bool degrees) {
  Draw draw(seed);
  const int joints = 3 + draw.below(4);
  std::string bodies, ends, ties;
  for (int i = 0; i < joints; ++i) {
    const bool slides = draw.below(3) == 0;
    const std::string reference = degrees && !slides ? draw.number(90) : draw.number();
    bodies += "<body name='b" + std::to_string(i) +
              "' pos='0.1 0 0.2'><inertial pos='0 0 0' mass='1' "
              "diaginertia='1 1 1'/><joint name='j" +
              std::to_string(i) + "' type='" + (slides ? "slide" : "hinge") + "' axis='0 " +
              (i % 2 == 0 ? "1 0" : "0 1") + "' ref='" + reference + "'/>";
    ends += "</body>";
  }
  const int leaders = 1 + draw.below(joints - 1);
  for (int i = leaders; i < joints; ++i) {
    ties += "<joint joint1='j" + std::to_string(i) + "' joint2='j" + std::to_string(draw.below(leaders)) +
            "' polycoef='" + draw.number();
    const int degree = i == leaders ? 4 : 1 + draw.below(4);
    for (int power = 1; power <= 4; ++power) ties += power <= degree ? " " + draw.number() : " 0";
    ties += "'/>";
  }
  return "<mujoco><compiler angle='" + std::string(degrees ? "degree" : "radian") +
         "'/><option jacobian='dense'/><worldbody>" + bodies + ends + "</worldbody><equality>" + ties +
         "</equality></mujoco>";
}

/// MuJoCo's residuals of its equality constraints, and their derivatives by joints in our order.
struct Residuals {
  Eigen::VectorXd gaps;
  Eigen::MatrixXd by_joints;
};

Residuals residuals(const std::string& text, const model::Robot& robot, const Eigen::VectorXd& q) {
  const loops::MujocoModel mujoco = loops::mujoco_model(text);
  const loops::MujocoData data(mj_makeData(mujoco.get()), &mj_deleteData);
  std::vector<int> places;
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    const int joint = mj_name2id(mujoco.get(), mjOBJ_JOINT, robot.joints[i].variable.c_str());
    data->qpos[mujoco->jnt_qposadr[joint]] = q[static_cast<Eigen::Index>(i)];
    places.push_back(mujoco->jnt_dofadr[joint]);
  }
  mj_forward(mujoco.get(), data.get());
  Residuals result{Eigen::Map<Eigen::VectorXd>(data->efc_pos, data->ne), Eigen::MatrixXd(data->ne, q.size())};
  for (Eigen::Index row = 0; row < data->ne; ++row)
    for (Eigen::Index i = 0; i < q.size(); ++i)
      result.by_joints(row, i) = data->efc_J[row * mujoco->nv + places[static_cast<std::size_t>(i)]];
  return result;
}

TEST(Polynomials, AreMujocosEqualities) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> value(-2, 2);
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const std::string text = random_mjcf(seed, seed % 2 == 0);
    SCOPED_TRACE(text);
    const model::Mechanism mechanism = mechanism_of(description::read_text(text, "m.xml"));
    EXPECT_TRUE(mechanism.loops.closures.empty());
    const verify::LoopNumbers numbers(mechanism);
    for (int k = 0; k < 5; ++k) {
      const auto joints = static_cast<Eigen::Index>(mechanism.robot.joints.size());
      const Eigen::VectorXd q = Eigen::VectorXd::NullaryExpr(joints, [&] { return value(random); });
      const Residuals expected = residuals(text, mechanism.robot, q);
      const double scale = 1 + expected.by_joints.norm();
      EXPECT_LT((numbers.gaps(q) - expected.gaps).norm(), 1e-9 * scale);
      EXPECT_LT((numbers.jacobian(q) - expected.by_joints).norm(), 1e-9 * scale);
    }
    const verify::Mobility mobility = verify::mobility_of(mechanism);
    EXPECT_EQ(mobility.free, static_cast<int>(mechanism.loops.actuated.size()));
    EXPECT_TRUE(mobility.loose.empty());
  }
}

/// A polynomial of a joint that follows by one factor, and one factor of a joint that follows by a
/// polynomial: closed where MuJoCo's are.
TEST(Polynomials, FollowAlongChainsOfOneFactor) {
  const auto body = [](const std::string& name, const std::string& ref) {
    return "<body name='" + name + "'><inertial pos='0 0 0' mass='1' diaginertia='1 1 1'/><joint name='" +
           name + "' axis='0 1 0' ref='" + ref + "'/></body>";
  };
  const std::string text = "<mujoco><compiler angle='radian'/><option jacobian='dense'/><worldbody>" +
                           body("a", "0.3") + body("b", "-0.2") + body("c", "0.4") + body("d", "0.1") +
                           "</worldbody><equality><joint joint1='b' joint2='a' polycoef='0.2 -1.5 0 0 "
                           "0'/><joint joint1='c' joint2='b' "
                           "polycoef='0.1 0.3 -0.4 0.2 0'/><joint joint1='d' joint2='c' polycoef='-0.3 2 0 0 "
                           "0'/></equality></mujoco>";
  const model::Mechanism mechanism = mechanism_of(description::read_text(text, "m.xml"));
  const verify::LoopNumbers numbers(mechanism);
  for (unsigned seed = 1; seed <= 10; ++seed) {
    const auto q = numbers.assembled(seed);
    ASSERT_TRUE(q.has_value());
    EXPECT_LT(residuals(text, mechanism.robot, *q).gaps.norm(), 1e-10 * (1 + q->norm()));
  }
}

const std::string moving = "mass = 0.7\ncentre_of_mass = [0.1, 0.05, -0.02]\ninertia = [0.02, 0.03, 0.04]\n";

std::string joint(const std::string& type, const std::string& axis, const std::string& name,
                  const std::string& more) {
  return "[[joint]]\ntype = \"" + type + "\"\naxis = \"" + axis + "\"\nvariable = \"" + name + "\"\n" + more +
         moving;
}
std::string follows(const std::string& relation) { return "follows = \"" + relation + "\"\n"; }

/// A polynomial of a joint: its own powers, or those of a difference.
std::string polynomial(const std::string& leader, const std::string& size, Draw& draw) {
  const std::string base = draw.below(2) == 0 ? leader : "(" + leader + " - 20 deg)";
  std::string text = size + " " + leader + " + 0.0" + std::to_string(10 + draw.below(90));
  for (int power = 2; power <= 4; ++power)
    if (power == 2 || draw.below(2) == 0)
      text += " + (" + draw.number(0.2) + ")*" + base + "^" + std::to_string(power);
  return text;
}

const std::string on_base = "parent = \"base\"\n";

/// A finger whose second joint and whose pusher follow the first one: no loop.
std::string finger(Draw& draw) {
  return joint("revolute", "+y", "bend", "link = [0.3, 0, 0.1]\nviscous_friction = 0.1\n") +
         joint("revolute", "+z", "curl", follows(polynomial("bend", "2/3", draw)) + "link = [0.2, 0, 0]\n") +
         joint("prismatic", "+x", "push", on_base + follows(polynomial("bend", "0.1", draw))) +
         "[[tip]]\nname = \"end\"\njoint = \"curl\"\n";
}

/// A slider-crank whose crank follows a motor.
std::string cam(Draw& draw) {
  return joint("revolute", "+z", "cam", follows(polynomial("motor", "1/2", draw)) + "link = [0.2, 0, 0]\n") +
         joint("revolute", "+z", "rod", "link = [0.1, 0, 0]\n") +
         joint("prismatic", "+x", "slider", on_base + "origin = [0.1, 0.05, 0]\n") +
         "[[motor]]\nvariable = \"motor\"\nrotor_inertia = 0.02\n[[tip]]\nname = \"end\"\njoint = \"rod\"\n"
         "[[loop]]\ntype = \"pin\"\nbetween = [\"rod\", \"slider\"]\nat = [[0.6, 0, 0], [0, 0, 0]]\n";
}

/// A four-bar whose rocker leads a flap.
std::string flap(Draw& draw) {
  return joint("revolute", "+z", "motor", "link = [0.1, 0, 0]\n") + joint("revolute", "+z", "rod", "") +
         joint("revolute", "+z", "rocker", on_base + "origin = [0.3, 0, 0]\n") +
         joint("revolute", "+y", "flap", on_base + follows(polynomial("rocker", "-3/2", draw))) +
         "[[tip]]\nname = \"end\"\njoint = \"flap\"\n[[loop]]\ntype = \"pin\"\nbetween = [\"rod\", "
         "\"rocker\"]\nat = [[0.35, 0, 0], [0.25, 0, 0]]\n";
}

/// A slider-crank whose slide leads another one, which a rod ties to a lever.
std::string two_slides(Draw& draw) {
  return joint("revolute", "+z", "motor", "link = [0.2, 0, 0]\n") + joint("revolute", "+z", "rod", "") +
         joint("prismatic", "+x", "slide", on_base) +
         joint("prismatic", "+y", "other",
               on_base + follows("0.5 slide + " + draw.number(0.3) + "*(slide - 1/2)^2 + 0.1 slide")) +
         joint("revolute", "+z", "lever", on_base + "origin = [0.5, 0.3, 0]\n") +
         "[[tip]]\nname = \"end\"\njoint = \"lever\"\n[[loop]]\ntype = \"pin\"\nbetween = [\"rod\", "
         "\"slide\"]\nat = [[0.6, 0, 0], [0, 0, 0]]\n[[loop]]\ntype = \"rod\"\nbetween = [\"other\", "
         "\"lever\"]\nat = [[0, 0, 0], [0.4, 0, 0]]\nlength = 0.5\n";
}

using Family = std::string (*)(Draw&);

/// Newton's assemblies, with joints that follow where the others have them.
std::vector<Eigen::VectorXd> assemblies(const reference::LoopMechanism& of, const Eigen::VectorXd& a) {
  auto found = reference::assemblies(of, loops::with_values(of, of.driven, a), of.driven, 60, 1);
  for (Eigen::VectorXd& q : found) q = reference::followed(of, q);
  return found;
}

void try_mechanism(const std::string& text, Language language, unsigned seed) {
  SCOPED_TRACE(text);
  const Folder folder;
  const std::filesystem::path file = folder.path / "m.toml";
  std::ofstream(file) << text;
  const model::Mechanism mechanism = mechanism_of(description::read_file(file.string()));
  EXPECT_EQ(verify::mobility_of(mechanism).free, 1);
  const auto plan = derive::loops::assembly_plan(mechanism, mechanism.loops.actuated);
  ASSERT_TRUE(plan.found) << testing::PrintToString(plan.reasons);
  EXPECT_EQ(verify::certify_loops(mechanism, plan, derive::inverse::lower(plan.plan), 10).inputs, 10);
  const reference::LoopMechanism of = reference::load_loops(file);
  const loops::Compiled compiled(file, "dynamics,assembly", language);
  const loops::StandingFunctions functions(compiled, "m", of);
  std::mt19937 random(seed);
  int moved = 0;
  for (int k = 0; k < 20; ++k) {
    const Eigen::VectorXd a = loops::random_values(of, of.driven, random);
    const loops::Set set = functions.assemble(a);
    loops::expect_closed(of, set);
    if (loops::is_apart(of, set)) {
      for (const Eigen::VectorXd& other : assemblies(of, a))
        EXPECT_TRUE(loops::has(of, set, other, 1e-6)) << other.transpose();
    }
    for (const loops::Row& row : set.rows) {
      if (functions.drive_measure(row.q) < 0.03) continue;
      loops::expect_motion_laws(functions, of, row.q, seed + static_cast<unsigned>(k));
      ++moved;
    }
  }
  EXPECT_GT(moved, 10);
}

void try_family(Family family, const std::string& driven, unsigned count = models_wanted,
                Language language = Language::c) {
  for (unsigned seed = 1; seed <= count; ++seed) {
    Draw draw(seed);
    try_mechanism("name = \"m\"\ntitle = \"m\"\n" + driven + family(draw), language, seed);
  }
}

TEST(Polynomials, LeadInTreesWithoutLoops) { try_family(finger, "actuated = [\"bend\"]\n"); }
TEST(Polynomials, LeadIntoLoops) { try_family(cam, "actuated = [\"motor\"]\n"); }
TEST(Polynomials, LeadOutOfLoops) { try_family(flap, "actuated = [\"motor\"]\n"); }
TEST(Polynomials, LeadFromSlideToSlide) { try_family(two_slides, "actuated = [\"motor\"]\n"); }
TEST(Polynomials, LeadSoInCxxToo) {
  if (models_wanted < 10) GTEST_SKIP() << "in long runs alone, since C++ takes a minute to compile";
  try_family(cam, "actuated = [\"motor\"]\n", 1, Language::cxx);
  try_family(flap, "actuated = [\"motor\"]\n", 1, Language::cxx);
}

/// Without closures there is nothing to choose.
TEST(Polynomials, LeadersDriveTreesWithoutLoops) {
  Draw draw(1);
  const auto mechanism =
      mechanism_of(description::read_text("name = \"m\"\ntitle = \"m\"\n" + finger(draw), "m.toml"));
  EXPECT_EQ(mechanism.loops.actuated, std::vector<std::size_t>{0});
  EXPECT_EQ(mechanism.loops.gears.size(), 2U);
}

TEST(Polynomials, AreWrittenAsTheyWereRead) {
  std::vector<std::string> texts;
  for (unsigned seed = 1; seed <= 4; ++seed) {
    Draw draw(seed);
    for (const Family family : {finger, cam, flap, two_slides})
      texts.push_back(description::write_text(
          mechanism_of(description::read_text("name = \"m\"\ntitle = \"m\"\n" + family(draw), "m.toml"))));
    texts.push_back(description::write_text(
        mechanism_of(description::read_text(random_mjcf(seed, seed % 2 == 0), "m.xml"))));
  }
  for (const std::string& text : texts) {
    const auto again = description::read_text(text, "m.toml");
    ASSERT_TRUE(again.robot.has_value()) << first_error(again) << text;
    EXPECT_EQ(description::write_text(mechanism_of(again)), text);
    EXPECT_THAT(text, HasSubstr("^"));
  }
}

std::string mistake(const std::string& relation, const std::string& keys = "") {
  return first_error(description::read_text(
      "name = \"m\"\ntitle = \"m\"\n" + keys + joint("revolute", "+y", "a", "") +
          joint("revolute", "+y", "b", "") + joint("revolute", "+z", "c", follows(relation)),
      "m.toml"));
}

TEST(Polynomials, MistakesAreSaid) {
  EXPECT_THAT(mistake("a^2 + b"), HasSubstr("'follows' has powers and names several"));
  EXPECT_THAT(mistake("a^2 + (a - 1)^3"), HasSubstr("the powers in 'follows' are those of different sums"));
  EXPECT_THAT(mistake("a^9"), HasSubstr("'follows' has a power above 8"));
  EXPECT_THAT(mistake("(a + b)^2"), HasSubstr("'follows' is not a sum of multiples of joints and motors"));
  EXPECT_THAT(mistake("sqrt(2)*a^2"), HasSubstr("a factor of 'a' is not rational"));
  EXPECT_THAT(mistake("a^2", "angle_unit = \"deg\"\n"),
              HasSubstr("factors of powers are for radians and metres"));
}

TEST(Polynomials, MistakesOfMjcfAreSaid) {
  const auto said = [](const std::string& equality) {
    std::string bodies;
    for (const char* const name : {"a", "b", "c"})
      bodies += "<body><inertial pos='0 0 0' mass='1' diaginertia='1 1 1'/><joint name='" +
                std::string(name) + "' axis='0 1 0'/></body>";
    description::ReadOptions whole;
    whole.tips = {description::every_tip};
    return first_error(
        description::read_text("<mujoco><worldbody>" + bodies +
                                   "</worldbody><tendon><fixed name='t'><joint joint='a' coef='1'/></fixed>"
                                   "<fixed name='s'><joint joint='b' coef='1'/></fixed></tendon><equality>" +
                                   equality + "</equality></mujoco>",
                               "m.xml", whole));
  };
  EXPECT_THAT(said("<tendon tendon1='t' tendon2='s' polycoef='0 1 0.5 0 0'/>"),
              HasSubstr("the joint 'a' follows by a polynomial of degree 2; tendons tie sums"));
  EXPECT_THAT(said("<joint joint1='b' joint2='a' polycoef='0 1 0.5 0 0'/>"
                   "<joint joint1='c' joint2='b' polycoef='0 1 0.5 0 0'/>"),
              HasSubstr("the joint 'c' follows by polynomials of several joints"));
  EXPECT_EQ(said("<joint joint1='b' joint2='a' polycoef='0 1 0.5 0 0'/>"), "");
}

/// The first reason why there is no closed form.
std::string reason(const std::string& text) {
  const auto mechanism =
      mechanism_of(description::read_text("name = \"m\"\ntitle = \"m\"\n" + text, "m.toml"));
  const auto plan = derive::loops::assembly_plan(mechanism, mechanism.loops.actuated);
  EXPECT_FALSE(plan.found);
  return plan.reasons.empty() ? "" : plan.reasons.front();
}

TEST(Polynomials, AreNotSolvedForWhatLeads) {
  Draw draw(1);
  EXPECT_EQ(reason("actuated = [\"curl\"]\n" + finger(draw)),
            "the value of bend would be a root of the polynomial by which curl follows it; drive bend");
  // A rocker that loops hold leads a crank of another loop.
  const std::string text = "actuated = [\"motor\"]\n" + flap(draw) +
                           joint("revolute", "+y", "lever", on_base + "origin = [0.5, 0, 0]\n") +
                           "[[loop]]\ntype = \"rod\"\nbetween = [\"flap\", \"lever\"]\n"
                           "at = [[0.2, 0, 0], [0.1, 0, 0.1]]\nlength = 0.4\n";
  EXPECT_THAT(reason(text),
              testing::StartsWith(
                  "the value of flap is a polynomial of rocker, which the steps of a loop do not take"));
}

}  // namespace
}  // namespace qvgen::test::polynomials
