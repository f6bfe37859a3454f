// SPDX-License-Identifier: MIT
// `qvgen identify` as its users meet it.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include "command_line.h"
#include "random_arm.h"
#include "simulated.h"

namespace qvgen::test {
namespace {

using testing::HasSubstr;

class IdentifyCommand : public CommandLine {
 protected:
  const std::string text = ArmWriter(21).text("RRR");
  const reference::Chain chain = reference::load_text(text);
  std::string arm;
  void SetUp() override {
    CommandLine::SetUp();
    arm = write("arm.toml", without_inertia(text));
  }

  /// A log of positions with noise in micro-radians, and torques with noise.
  std::string log(const std::string& name, unsigned seed, double noise) {
    identify::MotionLog motion = simulated(chain, 4000, seed, 8);
    add_noise(motion, Eigen::Vector3d::Constant(noise), seed);
    std::string rows = "time [s], q1 [deg], q2 [deg], q3 [deg], torque1 [Nm], torque2 [Nm], torque3 [Nm]\n";
    constexpr double degree = 3.14159265358979323846 / 180;
    for (Eigen::Index k = 0; k < motion.samples(); ++k) {
      rows += fmt::format("{}", motion.time[static_cast<std::size_t>(k)]);
      for (Eigen::Index i = 0; i < 3; ++i) rows += fmt::format(", {:.7f}", motion.q(k, i) / degree);
      for (Eigen::Index i = 0; i < 3; ++i) rows += fmt::format(", {:.6f}", motion.torque(k, i));
      rows += "\n";
    }
    return write(name, rows);
  }
};

TEST_F(IdentifyCommand, WritesADescriptionWithTheArmsTorques) {
  const std::string first = log("first.csv", 1, 0.1), second = log("second.csv", 2, 0.1),
                    third = log("third.csv", 3, 0.1);
  const std::string output = (folder / "found.toml").string(), table = (folder / "table.csv").string(),
                    page = (folder / "page.html").string();
  const ToolRun result = run("identify " + arm + " " + first + " " + second + " --hold-out " + third +
                             " -o " + output + " --table " + table + " --page " + page);
  ASSERT_EQ(result.code, 0) << result.output;
  EXPECT_THAT(result.output, HasSubstr("rates and accelerations from polynomials of degree 4"));
  EXPECT_THAT(result.output, HasSubstr("full set"));
  EXPECT_THAT(result.output, HasSubstr("Ia1 has no column of its own"));
  EXPECT_EQ(run("check --strict " + output).code, 0);
  std::ifstream file(output);
  const std::string found{std::istreambuf_iterator<char>(file), {}};
  identify::MotionLog motion = simulated(chain, 500, 9);
  const Eigen::MatrixXd torque = motion.torque;
  fill_torques(reference::load_text(found), motion);
  for (Eigen::Index i = 0; i < 3; ++i)
    EXPECT_LT((motion.torque - torque).col(i).norm(), 0.02 * torque.col(i).norm()) << result.output;
  std::ifstream parameters(table);
  std::string header;
  std::getline(parameters, header);
  EXPECT_EQ(header, "parameter,value,deviation,t,told,definition");
  std::ifstream html(page);
  const std::string shown{std::istreambuf_iterator<char>(html), {}};
  for (const char* part :
       {"Residual of q3", "Nine tenths of the residual", "Ia1 has no column of its own", "95 % from"})
    EXPECT_THAT(shown, HasSubstr(part));
}

TEST_F(IdentifyCommand, NothingIsWrittenWhereALogIsWrong) {
  const std::string file = write("log.csv", "time, q1, q2, q3, torque1, torque2, torque3\n0,0,0,0,0,0,x\n");
  const std::string output = (folder / "found.toml").string();
  const ToolRun result = run("identify " + arm + " " + file + " -o " + output);
  EXPECT_EQ(result.code, 3) << result.output;
  EXPECT_THAT(result.output, HasSubstr("log.csv:2:"));
  EXPECT_FALSE(fs::exists(output));
}

TEST_F(IdentifyCommand, WrongOptionsAreNamed) {
  const std::string file = log("log.csv", 1, 0.1);
  EXPECT_THAT(run("identify " + arm + " " + file + " --drives springs").output,
              HasSubstr("--drives: there is no 'springs'"));
  EXPECT_THAT(run("identify " + arm + " " + file + " --torque-constants 1,2").output,
              HasSubstr("2 numbers for 3 joints"));
  EXPECT_EQ(run("identify " + arm + " " + file + " --window 10").code, 2);
  EXPECT_EQ(run("identify " + arm + " missing.csv").code, 3);
  EXPECT_EQ(run("identify " + arm + " " + file + " --format urdf").code, 2);
  EXPECT_THAT(run("identify " + arm + " " + file + " --temperature").output,
              HasSubstr("there is no column 'temperature'"));
  EXPECT_THAT(
      run("identify " + arm + " " + file + " --format urdf -o " + (folder / "a.urdf").string()).output,
      HasSubstr("only a URDF"));
}

}  // namespace
}  // namespace qvgen::test
