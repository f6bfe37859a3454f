// SPDX-License-Identifier: MIT
// Examples and exit codes: the end of each help text, and of the man page.
#include "cli/examples.h"

namespace qvgen::cli {

const char* const examples = R"(
  qvgen generate my_arm.toml --output out     one robot, into out/; without --output into ./generated
  qvgen generate                              all robots that qvgen knows
  qvgen generate arm.urdf --tip tool0         an arm of a URDF (or MJCF), from its root to the link tool0
  qvgen generate quad.urdf --tips all         a whole robot: its dynamics, and each limb as an arm
  qvgen generate quad.urdf --floating         likewise, with a base that moves freely
  qvgen generate ur5 --language c -o out      out/c/qvgen_ur5.h and .c: C99 that needs nothing but libm
  qvgen generate ur5 --language rust -o out   out/rust/qvgen_ur5: a crate; --language javascript: a module
  qvgen generate ur5 --language octave -o out out/octave/+qvgen_ur5: functions of Octave and MATLAB
  qvgen generate four_bar.toml -o out         a mechanism with closed loops, [[loop]]: its assemblies, its dynamics
  qvgen languages                             which parts each language has, and why not
  qvgen import arm.urdf > arm.toml            the same as a description to read and edit
  qvgen new RRP --wrist euler > my_arm.toml   a description to begin with
  qvgen check my_arm.toml                     every mistake of a description, nothing written
  qvgen show ns                               the closed form of the forward kinematics
  qvgen show my_arm.toml --latex              the same typeset
  qvgen show puma560 --singularities          where the arm is singular, factor by factor
  qvgen show nn --dynamics --joints 3 --masses end   joint forces of its first three joints, written out
  qvgen counts --format markdown              operation counts of everything generated
  qvgen counts ur5 --functions jacobian       of one function of one robot
  qvgen counts --against before.json          what a change has made cheaper or dearer
  qvgen report puma560 -o pages               a page that opens in any browser, pages/puma560.html
  qvgen map ur5 -o ur5.npz -o ur5.svg         what the arm reaches: arrays for NumPy, slices as a picture
  qvgen calibrate ur5 poses.csv -o my_ur5.toml   this very arm, from measurements
  qvgen identify my_arm.toml log.csv -o measured.toml   inertias and friction from a log of motion and torques
  qvgen path ur5 seam.csv -o motions.csv      all continuous motions of the joints along a path of the tool
  qvgen compare puma560 ns                    formulations by their operations: pairs, Denavit-Hartenberg, ...
)";

const char* const compare_examples = R"(
  qvgen compare                               all known robots, and a summary by their workspaces
  qvgen compare my_arm.toml --level textbook  as a library multiplies that does not know the robot
  qvgen compare ns --formulations pairs,dh    two of them
  qvgen compare rx90 --what dynamics          Newton-Euler by matrices and by quaternions
  qvgen compare ns --time                     with nanoseconds on this machine
  qvgen compare --format csv > compared.csv   for other programs
)";

const char* const report_examples = R"(
  qvgen report                                all known robots, into ./report; begin with report/index.html
  qvgen report my_arm.toml -o pages           one robot, pages/my_arm.html, and the index of all that are there
  qvgen report four_bar.toml -o pages         a mechanism with closed loops: moved, dragged, all its assemblies
  qvgen report arm.urdf --generated my_code   with the counts and signatures of the code in my_code/
  qvgen report puma560 --times puma.json      with times: qvgen compare puma560 --time --format json > puma.json
)";

const char* const map_examples = R"(
  qvgen map ur5 -o ur5.npz -o ur5.svg         arrays for NumPy, and slices as a picture
  qvgen map arm.urdf --tip tool0 --limits --resolution 0.02 --orientations 500 -o arm.vtk   for ParaView
  qvgen map ur5 --blocks 0:499 -o a.part      one half, anywhere; blocks are numbered 0 to 999
  qvgen map --merge a.part b.part -o ur5.npz  the parts together, the same file as of one run
)";

const char* const calibrate_examples = R"(
  qvgen calibrate ur5 poses.csv -o my_ur5.toml    all errors from poses; then qvgen generate ur5 my_ur5.toml
  qvgen calibrate scara tracker.csv --errors zeros -o my_scara.toml   positions; zeros of the joints alone
  qvgen calibrate arm.toml poses.csv --known tracker,target   poses of the tool in the described world
  qvgen calibrate arm.urdf board.csv --tip tool0 --camera -o my_arm.toml   a camera on the tool sees a board
  qvgen calibrate arm.urdf poses.csv --tip tool0 --format urdf -o my_arm.urdf --page my_arm.html   the same file, origins changed
  qvgen calibrate ur5 --plan 40 > postures.csv    postures to measure that tell most, within limits
  qvgen calibrate ur5 poses.csv --unit mm --angle-unit deg --sigma 0.00005   headers without units
)";

const char* const identify_examples = R"(
  qvgen identify my_arm.toml log.csv -o measured.toml          the description with inertias and friction
  qvgen identify my_arm.toml slow.csv fast.csv --hold-out third.csv --table parameters.csv
  qvgen identify my_arm.toml log.csv --torque-constants 11.3,11.3,8.4,2.9,2.9,2.9      currents in place of torques
  qvgen identify my_arm.toml log.csv --drives viscous_friction,coulomb_friction        no rotor inertia, no offset
  qvgen identify my_arm.toml empty.csv --payload with_gripper.csv   mass, centre and inertia of what it carries
  qvgen identify arm.urdf log.csv --tip tool0 --format urdf -o measured.urdf --page measured.html
  qvgen identify my_arm.toml --plan 30 -o motion.csv                a motion to record: it tells much
)";

const char* const path_examples = R"(
  qvgen path ur5 seam.csv                     what follows the path, and where and why the other motions end
  qvgen path ur5 seam.csv -o motions.csv -o motions.svg   joints at the poses, and a picture
  qvgen path arm.urdf seam.csv --speed 0.1    with the largest joint speeds, the tool going 0.1 m/s
  qvgen path ur5 seam.csv --limit theta1=-170:170deg --limit theta6=-360:360deg
  qvgen path arm.urdf seam.csv --time 10 --joint-torques description   the least time, within the effort limits too
  qvgen path iiwa14 seam.csv --hold theta3=0  seven joints, the third of which stays
  qvgen path ur5 weld.csv --free tool_z -o motion.csv   the best motion, the tool turning about its z as it likes
  qvgen path ur5 weld.csv --free tool_z,cone_z=15deg,shift_z=2mm   likewise, within tolerances
  qvgen path iiwa14 seam.csv --free arm_angle -o motion.csv   likewise, the elbow where it is best
)";

const char* const exit_codes =
    "0 success, 1 failure, 2 wrong arguments, 3 mistakes in a description or in data, 70 a check of qvgen "
    "itself has "
    "failed: a defect "
    "of the tool, the parts that it does not concern are written";

}  // namespace qvgen::cli
