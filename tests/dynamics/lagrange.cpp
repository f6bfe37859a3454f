// SPDX-License-Identifier: MIT
#include "lagrange.h"

#include <cmath>
#include <vector>

#include "lagrangian.h"

namespace lagrange {
namespace {

/// A value and its derivative along one direction; of duals again for second derivatives.
template <class T>
struct Dual {
  T value{}, rate{};
  Dual() = default;
  Dual(double number) : value(number), rate(0.0) {}
  Dual(const T& v, const T& r) : value(v), rate(r) {}

  friend Dual operator+(const Dual& a, const Dual& b) { return {a.value + b.value, a.rate + b.rate}; }
  friend Dual operator-(const Dual& a, const Dual& b) { return {a.value - b.value, a.rate - b.rate}; }
  friend Dual operator*(const Dual& a, const Dual& b) {
    return {a.value * b.value, a.rate * b.value + a.value * b.rate};
  }
  friend Dual sin(const Dual& a) {
    using std::cos;
    using std::sin;
    return {sin(a.value), cos(a.value) * a.rate};
  }
  friend Dual cos(const Dual& a) {
    using std::cos;
    using std::sin;
    return {cos(a.value), T(-1.0) * sin(a.value) * a.rate};
  }
};
using First = Dual<double>;
using Second = Dual<First>;

}  // namespace

Eigen::VectorXd forces(const reference::Chain& chain, const Eigen::VectorXd& q, const Eigen::VectorXd& qd,
                       const Eigen::VectorXd& qdd, const Eigen::Vector3d& gravity) {
  Eigen::VectorXd result(q.size());
  for (Eigen::Index i = 0; i < q.size(); ++i) {
    std::vector<First> moved, still;
    std::vector<Second> position, rate;  // inner derivative by time, outer by rate i
    for (Eigen::Index k = 0; k < q.size(); ++k) {
      const double unit = k == i ? 1 : 0;
      moved.push_back({q[k], unit});
      still.push_back({qd[k], 0.0});
      position.push_back({First(q[k], qd[k]), First(0.0)});
      rate.push_back({First(qd[k], qdd[k]), First(unit)});
    }
    result[i] =
        lagrangian(chain, position, rate, gravity).rate.rate - lagrangian(chain, moved, still, gravity).rate;
  }
  return result;
}

}  // namespace lagrange
