// SPDX-License-Identifier: MIT
// Random mechanisms on rods under bases that float: tips, in C, and dynamics of the base and the motors, in C
// and C++, also where joints follow motors and other joints. The reference has three slides and three turns
// in place of the base, and multipliers that hold loops and gears together: it knows no floating base and no
// rates of loops. MuJoCo has a free joint in place of the base, and its own constraints.
#include <gtest/gtest.h>

#include "base_motion.h"
#include "compiled_loops.h"
#include "derive/loops/assembly_plan.h"
#include "description/reader.h"
#include "floating/six_joints.h"
#include "mujoco_loops.h"
#include "random_gears.h"
#include "random_rods.h"
#include "reference/dynamics.h"
#include "reference/linear_algebra.h"
#include "verify/loops/mobility.h"

namespace qvgen::test::loops {
namespace {

using Eigen::Vector3d;
using reference::product;
using trees::BaseMotion;
using trees::joined;

constexpr unsigned wanted = QVGEN_LOOP_RODS < 100 ? 1 : QVGEN_LOOP_RODS / 5;
constexpr double gravity = 9.81;  ///< m/s^2, as the reference has it

std::string replaced(std::string text, const std::string& old, const std::string& by) {
  for (std::size_t at = text.find(old); at != std::string::npos; at = text.find(old, at + by.size()))
    text.replace(at, old.size(), by);
  return text;
}

/// Descriptions of one mechanism: its base floats, six joints are in place of that, or the base stands.
struct Descriptions {
  std::string floating, with_joints, standing;
};

/// Gives every link a mass. Every other mechanism hangs on a link behind the base, beside an arm.
Descriptions on_floating_base(const std::string& rods, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-0.3, 0.3);
  const auto number = [&] { return std::to_string(unit(random)); };
  const auto heavy = [&](double mass) {
    const std::string centre = number() + ", " + number() + ", " + number();
    return "mass = " + std::to_string(mass) + "\ncentre_of_mass = [" + centre +
           "]\ninertia = [0.5, 0.6, 0.7, 0.1, -0.05, 0.02]\n";
  };
  std::string text = rods;
  const std::string joint = "[[joint]]\n";
  if (seed % 2 == 0) {
    text = replaced(text, "\"base\"", "\"torso\"");
    text = replaced(text, "actuated = [", "actuated = [\"arm\", \"torso\", ");
    text = replaced(text, "outputs = [", "outputs = [\"arm\", \"torso\", ");
    const auto turn = [&](const std::string& name, const std::string& axis) {
      return joint + "type = \"revolute\"\naxis = \"" + axis + "\"\nvariable = \"" + name +
             "\"\nparent = \"base\"\norigin = [0.1, 0.2, 0.3]\n";
    };
    text.insert(text.find(joint), turn("arm", "+x") + turn("torso", "-y"));
  }
  const std::size_t head = text.find(joint);
  std::string links;
  for (std::size_t at = head, next = 0; at != std::string::npos; at = next) {
    next = text.find(joint, at + 1);
    links += joint + heavy(1 + unit(random)) +
             text.substr(at + joint.size(), next == std::string::npos ? next : next - at - joint.size());
  }
  const std::string begin = text.substr(0, head), base = heavy(3);
  std::string six;
  for (const char* const each : {"x", "y", "z", "rz", "ry", "rx"}) {
    const std::string name = each;
    six += joint + "type = \"" + (name.size() == 1 ? "prismatic" : "revolute") + "\"\naxis = \"+" +
           name.back() + "\"\nvariable = \"base_" + name + "\"\n";
  }
  return {begin + "[floating_base]\n" + base + "\n" + links,
          begin + six + base + replaced(links, "\"base\"", "\"base_rx\""), begin + links};
}

reference::LoopMechanism reference_of(const std::string& text, const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / "reference.toml";
  std::ofstream(file) << text;
  return reference::load_loops(file);
}

/// A tip in the world: its pose, its velocity by those of the base and the motors, and its acceleration where
/// these have none.
struct TipInWorld {
  Eigen::Vector4d turn;  ///< w x y z
  Vector3d place;
  Eigen::Matrix<double, 6, Eigen::Dynamic, Eigen::RowMajor> jacobian;
  Eigen::Matrix<double, 6, 1> bias;
};

/// Generated functions of the mechanism m; vectors begin with the base's six.
class Functions {
 public:
  Functions(const Compiled& compiled, Eigen::Index dof, Eigen::Index driven)
      : compiled_(&compiled), dof_(dof), driven_(driven) {}

  [[nodiscard]] MatrixXd rates(const VectorXd& q) const {
    MatrixXd result(driven_, dof_);
    compiled_->get<void(const double*, const double*, double*)>("m_rates")(q.data(), nullptr, result.data());
    return result.transpose();
  }
  [[nodiscard]] double drive_measure(const VectorXd& q) const {
    return compiled_->get<double(const double*, const double*)>("m_drive_measure")(q.data(), nullptr);
  }
  [[nodiscard]] MatrixXd masses(const VectorXd& base, const VectorXd& q) const {
    MatrixXd result(6 + driven_, 6 + driven_);
    compiled_->get<void(const double*, const double*, const double*, const double*, double*)>(
        "m_driven_mass_matrix")(base.data(), q.data(), nullptr, nullptr, result.data());
    return result;
  }
  [[nodiscard]] VectorXd forces(const VectorXd& base, const VectorXd& q, const VectorXd& ad,
                                const VectorXd& add) const {
    return called("m_driven_inverse_dynamics", base, q, ad, add, 6 + driven_);
  }
  [[nodiscard]] VectorXd accelerations(const VectorXd& base, const VectorXd& q, const VectorXd& ad,
                                       const VectorXd& forces) const {
    return called("m_driven_forward_dynamics", base, q, ad, forces, 6 + driven_);
  }
  [[nodiscard]] VectorXd loop_forces(const VectorXd& base, const VectorXd& q, const VectorXd& ad,
                                     const VectorXd& add) const {
    return called("m_loop_forces", base, q, ad, add, dof_ - driven_);
  }
  /// Calls one of these three under gravity of any direction.
  [[nodiscard]] VectorXd falling(const std::string& name, const Vector3d& gravity, const VectorXd& base,
                                 const VectorXd& q, const VectorXd& ad, const VectorXd& more) const {
    using Function = void(const double*, const double*, const double*, const double*, const double*,
                          const double*, const double*, double*);
    VectorXd result(name == "loop_forces" ? dof_ - driven_ : 6 + driven_);
    compiled_->get<Function>("m_" + name + "_with_gravity_vector")(
        base.data(), q.data(), ad.data(), more.data(), nullptr, nullptr, gravity.data(), result.data());
    return result;
  }
  [[nodiscard]] VectorXd joint_accelerations(const VectorXd& q, const VectorXd& qd,
                                             const VectorXd& add) const {
    VectorXd result(dof_);
    compiled_->get<void(const double*, const double*, const double*, const double*, double*)>(
        "m_accelerations")(q.data(), qd.data(), add.data(), nullptr, result.data());
    return result;
  }
  [[nodiscard]] TipInWorld tip(const std::string& name, const VectorXd& base, const VectorXd& q,
                               const VectorXd& ad) const {
    TipInWorld found;
    found.jacobian.resize(6, 6 + driven_);
    compiled_->get<void(const double*, const double*, const double*, const double*, double*, double*, double*,
                        double*)>("m_driven_tip_motion_of_" + name)(base.data(), q.data(), ad.data(), nullptr,
                                                                    found.turn.data(), found.place.data(),
                                                                    found.jacobian.data(), found.bias.data());
    return found;
  }

 private:
  [[nodiscard]] VectorXd called(const std::string& name, const VectorXd& base, const VectorXd& q,
                                const VectorXd& ad, const VectorXd& more, Eigen::Index size) const {
    using Function = void(const double*, const double*, const double*, const double*, const double*,
                          const double*, double, double*);
    VectorXd result(size);
    compiled_->get<Function>(name)(base.data(), q.data(), ad.data(), more.data(), nullptr, nullptr, gravity,
                                   result.data());
    return result;
  }
  const Compiled* compiled_;
  Eigen::Index dof_, driven_;
};

/// The pose of the base as the functions take it.
VectorXd pose_of(const BaseMotion& base) {
  const Eigen::Quaterniond turn(base.rotation);
  VectorXd pose(7);
  pose << turn.w(), turn.x(), turn.y(), turn.z(), base.q.head<3>();
  return pose;
}

void expect_close(const MatrixXd& a, const MatrixXd& b, double tolerance) {
  EXPECT_LE(reference::largest(a - b), tolerance * (1 + reference::largest(b)));
}

/// Expects the tip where the reference has it; its velocity and its acceleration to be the reference's.
void expect_tip(const Functions& m, const reference::LoopMechanism& joints, const BaseMotion& base,
                const VectorXd& q, const VectorXd& ad) {
  const reference::NamedFrame& frame = joints.chain.frames.front();
  const MatrixXd rates = m.rates(q);
  const VectorXd none = VectorXd::Zero(ad.size()), at = joined(base.q, q), qd = joined(base.qd, rates * ad);
  const VectorXd qdd = joined(base.qdd, m.joint_accelerations(q, rates * ad, none));
  const TipInWorld found = m.tip(frame.name, pose_of(base), q, joined(base.velocity, ad));
  const Eigen::Isometry3d pose = reference::pose_of(joints.chain, frame, at);
  const Eigen::Vector4d& turn = found.turn;
  expect_close(Eigen::Quaterniond(turn[0], turn[1], turn[2], turn[3]).toRotationMatrix(), pose.linear(),
               1e-12);
  expect_close(found.place, pose.translation(), 1e-12);
  const MatrixXd by_joints = reference::jacobian_of(joints.chain, frame, at);
  expect_close(found.jacobian.leftCols<6>(),
               product(by_joints.leftCols<6>(), reference::inverse(base.by_rates(0))), 1e-11);
  expect_close(found.jacobian.rightCols(ad.size()), product(by_joints.rightCols(q.size()), rates),
               1e-11 * (1 + rates.norm()));
  const double time = 1e-5;
  const auto velocity = [&](double t) {
    const VectorXd then = at + t * qd + t * t / 2 * qdd;
    return product(reference::jacobian_of(joints.chain, frame, then), qd + t * qdd);
  };
  const MatrixXd expected = (velocity(time) - velocity(-time)) / (2 * time);
  expect_close(found.jacobian * joined(base.acceleration, none) + found.bias, expected,
               1e-6 * (1 + qd.norm()));
}

/// Expects that gravity of any direction acts as that along -z does on a world that is turned.
void expect_falling(const Functions& m, const BaseMotion& base, const VectorXd& q, const VectorXd& ad,
                    const VectorXd& more) {
  const Vector3d falling =
      gravity * Eigen::AngleAxisd(base.q[0], base.q.tail<3>().normalized()).toRotationMatrix().col(2);
  const Eigen::Quaterniond back(reference::shortest_turn(falling.normalized(), -Vector3d::UnitZ()));
  const VectorXd pose = pose_of(base);
  const Eigen::Quaterniond turn = back * Eigen::Quaterniond(base.rotation);
  VectorXd turned(7);
  turned << turn.w(), turn.x(), turn.y(), turn.z(), back * base.q.head<3>();
  const auto expect = [&](const std::string& name, const VectorXd& usual) {
    expect_close(m.falling(name, falling, pose, q, ad, more), usual, 1e-10 * (1 + more.norm()));
  };
  expect("driven_inverse_dynamics", m.forces(turned, q, ad, more));
  expect("driven_forward_dynamics", m.accelerations(turned, q, ad, more));
  expect("loop_forces", m.loop_forces(turned, q, ad, more));
}

/// The laws of one motion: joints q, at which the loops are closed, their rates by the motors, and those of
/// the base.
void expect_laws(const Functions& m, const reference::LoopMechanism& joints,
                 const reference::LoopMechanism& standing, const VectorXd& q, unsigned seed) {
  const BaseMotion base(seed);
  std::mt19937 random(seed);
  const auto driven = static_cast<Eigen::Index>(standing.driven.size());
  const auto draw = [&] {
    std::uniform_real_distribution<double> unit(-1.5, 1.5);
    return VectorXd::NullaryExpr(driven, [&] { return unit(random); }).eval();
  };
  const MatrixXd rates = m.rates(q);
  const VectorXd pose = pose_of(base), ad = draw(), all_rates = rates * ad, motors = 5 * draw();
  const VectorXd velocity = joined(base.velocity, ad), q_of_joints = joined(base.q, q);
  const VectorXd qd_of_joints = joined(base.qd, all_rates), wrench = 5 * base.acceleration;
  // Kinetic energy is that of the reference.
  const MatrixXd masses = m.masses(pose, q);
  const double energy = reference::kinetic_energy(joints.chain, q_of_joints, qd_of_joints);
  EXPECT_NEAR(velocity.dot(masses * velocity) / 2, energy, 1e-11 * (1 + energy) * (1 + rates.norm()));
  EXPECT_TRUE(masses == masses.transpose() ||
              reference::largest(masses - masses.transpose()) < 1e-12 * reference::largest(masses));
  // Multipliers give the accelerations of the base and of the motors.
  VectorXd forces = VectorXd::Zero(6 + q.size());
  const MatrixXd by_rates = base.by_rates(0);
  forces.head<6>() = by_rates.transpose() * wrench;
  for (Eigen::Index i = 0; i < driven; ++i)
    forces[6 + standing.driven[static_cast<std::size_t>(i)]] = motors[i];
  const VectorXd expected = reference::constrained_acceleration(joints, q_of_joints, qd_of_joints, forces);
  const VectorXd found = m.accelerations(pose, q, velocity, joined(wrench, motors));
  const double scale = (1 + expected.norm()) * (1 + qd_of_joints.norm());
  expect_close(found.head<6>(), base.acceleration + by_rates * (expected.head<6>() - base.qdd), 2e-6 * scale);
  for (Eigen::Index i = 0; i < driven; ++i)
    EXPECT_NEAR(found[6 + i], expected[6 + standing.driven[static_cast<std::size_t>(i)]], 2e-6 * scale);
  // So do MuJoCo's matrices and multipliers.
  const VectorXd on_joints = joined(wrench, forces.tail(q.size()));
  const VectorXd of_mujoco =
      MujocoLoops(joints, Base::floats).forward(pose, q, joined(base.velocity, all_rates), on_joints);
  expect_close(found.head<6>(), of_mujoco.head<6>(), 2e-6 * scale);
  for (Eigen::Index i = 0; i < driven; ++i)
    EXPECT_NEAR(found[6 + i], of_mujoco[6 + standing.driven[static_cast<std::size_t>(i)]], 2e-6 * scale);
  const VectorXd again = m.forces(pose, q, velocity, found);
  expect_close(again, joined(wrench, motors), 1e-10 * (1 + reference::largest(masses * found)));
  // Which forces these are is tried in tests/floating and tests/python.
  EXPECT_TRUE(m.loop_forces(pose, q, velocity, found).allFinite());
  expect_tip(m, joints, base, q, ad);
  expect_falling(m, base, q, velocity, joined(wrench, motors));
  // A base that is held gives the numbers of one that stands still.
  const VectorXd upright = VectorXd::Unit(7, 0), none = VectorXd::Zero(6);
  const VectorXd at_rest = m.forces(upright, q, joined(none, 0 * ad), joined(none, 0 * ad)).tail(driven);
  const VectorXd zero = VectorXd::Zero(q.size());
  expect_close(at_rest, rates.transpose() * reference::inverse_dynamics(standing.chain, q, zero, zero),
               1e-11);
  expect_close(masses.bottomRightCorner(driven, driven),
               product(rates.transpose(), product(reference::mass_matrix(standing.chain, q), rates)), 1e-11);
}

/// Closed loops, from Newton's steps. The motors' values are not wrapped, since gears have factors.
std::vector<VectorXd> closed(const reference::LoopMechanism& mechanism, unsigned seed) {
  const auto dof = static_cast<Eigen::Index>(mechanism.chain.joints.size());
  const std::vector<VectorXd> starts = reference::assemblies(mechanism, VectorXd::Zero(dof), {}, 20, seed);
  if (mechanism.gears.empty()) return starts;
  std::vector<VectorXd> found;
  for (const VectorXd& start : starts)
    for (const VectorXd& q : reference::assemblies(mechanism, start, mechanism.driven, 2, seed))
      found.push_back(q);
  return found;
}

struct Kind {
  bool has_gears;
  Language language;
};

/// Tries the laws at assemblies of a mechanism; returns how many. None is tried of one that is not derived.
int try_mechanism(const Descriptions& texts, Language language, unsigned seed,
                  const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / "m.toml";
  SCOPED_TRACE("seed " + std::to_string(seed) + "\n" + texts.floating);
  std::ofstream(file) << texts.floating;
  const auto read = description::read_file(file.string());
  if (!read.robot) {
    ADD_FAILURE() << description::to_string(read.diagnostics.front());
    return 0;
  }
  const model::Mechanism mechanism{*read.robot, read.tips, read.loops};
  const verify::Mobility mobility = verify::mobility_of(mechanism);
  const bool is_driven =
      mobility.free == static_cast<int>(mechanism.loops.actuated.size()) && mobility.loose.empty();
  if (!is_driven || !derive::loops::assembly_plan(mechanism, mechanism.loops.actuated).found) return 0;
  const reference::LoopMechanism joints = reference_of(texts.with_joints, folder);
  const reference::LoopMechanism standing = reference_of(texts.standing, folder);
  const std::vector<VectorXd> places = closed(standing, seed);
  if (places.empty()) return 0;
  const Compiled compiled(file, "dynamics,assembly", language);
  const Functions functions(compiled, static_cast<Eigen::Index>(standing.chain.joints.size()),
                            static_cast<Eigen::Index>(standing.driven.size()));
  int tried = 0;
  for (const VectorXd& q : places) {
    if (functions.drive_measure(q) < 0.03) continue;
    expect_laws(functions, joints, standing, q, seed + static_cast<unsigned>(tried));
    ++tried;
  }
  return tried;
}

Descriptions random_mechanism(unsigned seed, bool has_gears, const std::filesystem::path& folder) {
  const std::string rods = RandomRods(seed, folder / "m.toml").text();
  return on_floating_base(has_gears ? RandomGears(rods, seed).text() : rods, seed);
}

void try_mechanisms(const Kind& kind, unsigned count) {
  const Folder folder;
  unsigned mechanisms = 0;
  for (unsigned seed = 1; mechanisms < count && seed < 20 * count && !testing::Test::HasFailure(); ++seed)
    mechanisms += try_mechanism(random_mechanism(seed, kind.has_gears, folder.path), kind.language, seed,
                                folder.path) > 0
                      ? 1
                      : 0;
  EXPECT_EQ(mechanisms, count);
}

TEST(FloatingRods, MoveWithTheirBaseAsMultipliersSay) { try_mechanisms({false, Language::c}, wanted); }

TEST(FloatingRods, MoveSoWithGearsAndMotorsToo) { try_mechanisms({true, Language::c}, wanted); }

TEST(FloatingRods, MoveSoInCxxToo) {
  if (wanted < 10) GTEST_SKIP() << "in long runs alone, since C++ takes a minute to compile";
  try_mechanisms({true, Language::cxx}, wanted / 10);
}

/// Robots of tests/floating, whose loops are ankles and necks.
TEST(FloatingRods, AreStridersAndWalkersToo) {
  const Folder folder;
  std::vector<std::string> robots{"strider"};
  if (wanted > 1) robots.emplace_back("walker");
  for (const std::string& robot : robots) {
    const std::string text = floating::text_of(QVGEN_SOURCE_DIR "/tests/floating/" + robot + ".toml");
    const std::string named = replaced(text, "name = \"" + robot + '"', "name = \"m\"");
    const Descriptions texts{named, floating::with_six_joints(named), named};
    EXPECT_GT(try_mechanism(texts, Language::c, 1, folder.path), 0);
  }
}

}  // namespace
}  // namespace qvgen::test::loops
