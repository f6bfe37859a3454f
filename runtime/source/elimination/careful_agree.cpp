// SPDX-License-Identifier: MIT
// When rows are accepted: eliminations at the pose, and at poses nearby, have to agree on them.
#include <algorithm>

#include "careful.h"
#include "near_structure.h"

namespace qvgen::inverse::elimination {
namespace {

/// Returns the pose on the other side of one in the middle.
Pose<double> mirrored(const Pose<double>& middle, const Pose<double>& pose) {
  Pose<double> result;
  result.position = 2 * middle.position - pose.position;
  result.orientation = (middle.orientation * pose.orientation.conjugate() * middle.orientation).normalized();
  return result;
}

}  // namespace

/// Agreement of eliminations on the rows of a pose.
struct Careful::Consensus {
  Consensus(Careful& careful, const Gathered& first)
      : of(careful), all_loud(first.loud), doubted(of.leaves_doubt(first)) {}

  Careful& of;
  /// Two eliminations may lose the same solutions.
  const bool few = of.setup_.count + of.setup_.further.count < 3;
  /// All eliminations of an arm that slides may lose the same ones between right angles, and those of a
  /// nearly spherical wrist next to its singularity: one has to be without doubt, and poses nearby are asked
  /// of each in turn.
  const bool strict =
      std::any_of(of.setup_.chain.slides, of.setup_.chain.slides + joints, [](bool is) { return is; }) ||
      nearly_has_structure(of.setup_.description, of.setup_.chain.size);
  bool all_loud, doubted, agreed = false, more_nearby = true;
  int asked_nearby = 0, clear = 0, quiet_nearby = 0;

  /// Poses near one at which solutions meet have others on each side.
  [[nodiscard]] bool is_clear() const { return !strict || clear >= (of.any_is_singular() ? 3 : 1); }
  /// Curves of solutions that cross make polynomials vanish: every elimination at the pose may lose another
  /// one. At poses nearby there are single solutions instead.
  [[nodiscard]] bool may_have_lost_curve() const { return quiet_nearby < 3 && of.any_is_on_continuum(); }
  [[nodiscard]] bool wants_nearby() const {
    return asked_nearby < most_nearby && (of.size_ == 0 || !of.is_even() || more_nearby || !is_clear() ||
                                          may_have_lost_curve() || (few && asked_nearby < 3));
  }

  /// Looks at a pose nearby. Returns true if that leaves no doubt.
  bool look_at(const Pose<double>& pose) {
    const int elimination = strict ? asked_nearby % of.setup_.count : 0;
    const Outcome near = of.pass_nearby(of.setup_.eliminations[elimination], pose);
    more_nearby = !near.same;
    quiet_nearby = near.same ? quiet_nearby + 1 : 0;
    const bool without_doubt = near.same && !near.doubtful;
    clear += without_doubt && of.size_ > 0 ? 1 : 0;
    return without_doubt;
  }
  bool look_nearby() {
    const Pose<double> pose = of.nearby(asked_nearby++);
    return look_at(pose);
  }

  /// Takes an elimination at the pose itself. Returns true if no other has to be asked.
  bool is_enough(const Gathered& found) {
    const Outcome here = of.settle_here(found);
    all_loud = all_loud && here.loud;
    agreed = here.same;
    doubted = doubted || here.doubtful;
    if (!agreed) more_nearby = true;
    if (!agreed || !of.is_even()) return false;
    if (!here.doubtful) more_nearby = false;
    clear += here.doubtful ? 0 : 3;
    if (!more_nearby) return true;
    // No elimination is without doubts where solutions meet, but one at a pose nearby is.
    if (all_loud || few || asked_nearby == most_nearby) return false;
    // Two that meet are apart on one side and gone on the other.
    const Pose<double> opposite = mirrored(of.pose_, of.nearby(asked_nearby));
    if (!look_nearby()) return false;
    return look_at(opposite);
  }

  /// Doubts that no singular row explains may be those of two that meet and are lost.
  [[nodiscard]] bool may_have_lost_two() {
    return asked_nearby < most_nearby && (of.any_is_exactly_singular() || (doubted && !of.any_is_singular()));
  }
  void look_on_both_sides() {
    const int before = of.size_;
    const Pose<double> beside = of.nearby(asked_nearby++);
    of.pass_nearby(of.setup_.eliminations[0], beside);
    of.pass_nearby(of.setup_.eliminations[0], mirrored(of.pose_, beside));
    more_nearby = more_nearby || of.size_ > before;
  }
};

void Careful::agree(const Gathered& first, const Gathered* second) {
  Consensus all(*this, first);
  bool enough = second != nullptr && all.is_enough(*second);
  while (!enough) {
    const Elimination* elimination = next_elimination();
    if (elimination == nullptr) break;
    Gathered found;
    look_here(*elimination, found);
    enough = all.is_enough(found);
  }
  if (all.may_have_lost_two()) all.look_on_both_sides();
  while (all.wants_nearby()) {
    all.look_nearby();
    all.agreed = all.few ? !all.more_nearby : all.agreed || !all.more_nearby;
  }
  search_valleys();
  // Accepts the rows if the last elimination, or a pose nearby, has added none. If rows are singular, there
  // must have been three.
  unsure_ = has_lonely_stray() || lacks_strays_ || !all.agreed || all.all_loud || !all.is_clear() ||
            !is_even() || (all.few && any_is_singular());
}

}  // namespace qvgen::inverse::elimination
