// SPDX-License-Identifier: MIT
#include <qvgen/inverse/certified/tube.h>

#include "goals.h"
#include "node.h"

namespace qvgen::inverse::certified {
namespace {

class Tube {
 public:
  Tube(const Arm& arm, const Way& way, int most, TubeProof& proof)
      : goals_(arm, way), most_(most), proof_(proof) {}

  void prove(const TubeEnd& start, const TubeEnd& goal) {
    prove(place(start.u, start.q), place(goal.u, goal.q));
  }

 private:
  static constexpr double shortest = 1e-8;  ///< of a stretch of the way

  struct Place {
    double u;
    Node node;
  };
  Place place(double u, const double (&q)[joints]) { return {u, node_at(goals_.at(u), q)}; }

  /// Solves at a place between two: in the middle, or nearer to one, where Newton's start is better.
  bool divide(const Place& a, const Place& b, double& u, double (&q)[joints]) {
    for (const double share : {0.5, 0.06, 0.94, 0.004, 0.996}) {
      u = a.u + share * (b.u - a.u);
      for (int k = 0; k < joints; ++k) q[k] = a.node.q[k] + share * (b.node.q[k] - a.node.q[k]);
      if (settle(goals_.at(u), q)) return true;
    }
    return false;
  }

  void prove(const Place& a, const Place& b) {
    ++proof_.tried;
    if (a.node.proven && b.node.proven && has_one_motion(a, b)) return;
    double u = 0, q[joints];
    if (proof_.tried >= most_ || b.u - a.u < 2 * shortest || !divide(a, b, u, q)) return add_gap(a.u, b.u);
    const Place middle = place(u, q);
    prove(a, middle);
    prove(middle, b);
  }

  bool has_one_motion(const Place& a, const Place& b) {
    TubeBox box;
    if (!certified::has_one_motion(goals_.to(a.u, b.u), a.node, b.node, box)) return false;
    for (int k = 0; k < joints; ++k)
      proof_.range[k] =
          proof_.boxes == 0 ? box.solution.solution[k] : hull(proof_.range[k], box.solution.solution[k]);
    ++proof_.boxes;
    proof_.narrowest = std::min(proof_.narrowest, box.narrowest());
    return true;
  }

  /// Neighbours are one; the last gap takes what there is no room for.
  void add_gap(double from, double to) {
    const bool joins = proof_.gap_count > 0 && (proof_.gaps[proof_.gap_count - 1].to == from ||
                                                proof_.gap_count == TubeProof::most_gaps);
    if (joins)
      proof_.gaps[proof_.gap_count - 1].to = to;
    else
      proof_.gaps[proof_.gap_count++] = {from, to};
  }

  Goals goals_;
  int most_;
  TubeProof& proof_;
};

}  // namespace

TubeProof prove_tube(const Arm& arm, const Way& way, const TubeEnd& start, const TubeEnd& goal, int most) {
  TubeProof proof;
  if (!is_moderate(arm, way)) {
    proof.gaps[proof.gap_count++] = {start.u, goal.u};
    return proof;
  }
  Tube(arm, way, most, proof).prove(start, goal);
  return proof;
}

}  // namespace qvgen::inverse::certified
