// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include <qvgen/batch/inverse.h>
#include <qvgen/batch/machine.h>
#include <qvgen/batch/solutions.h>
#include <qvgen/batch/threads.h>
#include <qvgen/pose.h>

#include "throughput.h"

/// All solutions of many poses: batches against single calls, by the share of poses near singular ones.
namespace throughput {

using qvgen::Batch;
using qvgen::BatchOfSolutions;
using qvgen::Pose;

struct Request {
  Pose<double> pose;
  double given = 0;
};

/// Room for the solutions of so many poses.
struct Found {
  std::vector<double> q;
  std::vector<int> count, branch;
  std::vector<qvgen::Status> status;
  std::vector<unsigned> marks;

  Found(std::size_t rows, std::size_t joints, std::size_t n)
      : q(rows * joints * n), count(n), branch(rows * n), status(n), marks(n) {}
  BatchOfSolutions view() {
    const std::size_t n = count.size();
    return {{q.data(), n}, {count.data(), n}, {status.data(), n}, {branch.data(), n}, {marks.data(), n}};
  }
};

/// `single(request)` and `form(poses, given, found, set)` of an arm.
template <int dof, class Forward, class Single, class Form>
class Comparison {
 public:
  Comparison(const Forward& forward, const Single& single, const Form& form, int given_joint)
      : forward_(forward), single_(single), form_(form), given_joint_(given_joint) {}

  /// Most poses in a block: larger batches than a million, 500 MB, come in blocks, the same memory again and
  /// again.
  Times measure(std::size_t count, double share) {
    constexpr std::size_t most = 1000000;
    const std::vector<Request> all = requests(std::min(count, most), share);
    return measure(all, (count + most - 1) / most);
  }

 private:
  Request regular() {
    std::uniform_real_distribution<double> angle(-3.14, 3.14);
    Eigen::Matrix<double, dof, 1> q;
    for (double& each : q) each = angle(random_);
    return {forward_(q), given_joint_ < 0 ? 0 : q[given_joint_]};
  }

  /// At the outer or inner end of the arm's reach, where rounding decides about two solutions or none.
  Request doubtful() {
    while (true) {
      Request request = regular();
      const Eigen::Vector3d place = request.pose.position;
      double inside = 1, outside = random_() % 2 == 0 ? 8 : 0;
      for (int i = 0; i < 40; ++i) {
        const double middle = (inside + outside) / 2;
        request.pose.position = middle * place;
        (single_(request).empty() ? outside : inside) = middle;
      }
      request.pose.position = inside * place;
      if (single_(request).effort.passes > 0) return request;
    }
  }

  std::vector<Request> requests(std::size_t count, double share) {
    std::vector<Request> some(4096);
    for (std::size_t k = 0; k < some.size(); ++k)
      some[k] = static_cast<double>((k * 2654435761U) % 1000) < 1000 * share ? doubtful() : regular();
    std::vector<Request> all(count);
    for (std::size_t k = 0; k < count; ++k) all[k] = some[k % some.size()];
    return all;
  }

  Times measure(const std::vector<Request>& all, std::size_t blocks) {
    const std::size_t count = all.size();
    std::vector<double> poses(7 * count), given(count);
    for (std::size_t k = 0; k < count; ++k) {
      qvgen::batch::put_pose(all[k].pose, {poses.data(), count}, k);
      given[k] = all[k].given;
    }
    constexpr auto most = static_cast<std::size_t>(decltype(single_(all[0]))::max_size);
    Found found(most, dof, count);
    const Batch<const double> in{poses.data(), count}, joint{given.data(), count};
    const BatchOfSolutions out = found.view();
    volatile int sink = 0;
    const auto a_pose = [&](const auto& work) {
      const double time = shortest([&] {
        for (std::size_t block = 0; block < blocks; ++block) work();
      });
      return time / static_cast<double>(count * blocks);
    };
    const double single = a_pose([&] {
      int sum = 0;
      for (const Request& request : all) sum += single_(request).size();
      sink = sum;
    });
    Times times{single, {}, 0};
    for (const Lanes& lanes : lanes_of_machine())
      times.batch.push_back(a_pose([&] { form_(in, joint, out, lanes.set); }));
    times.threads = a_pose([&] {
      qvgen::in_threads(count, [&](std::size_t first, std::size_t part) {
        form_(in.part(first, part), joint.part(first, part), out.part(first, part),
              qvgen::widest_instruction_set());
      });
    });
    return times;
  }

  Forward forward_;
  Single single_;
  Form form_;
  int given_joint_;
  std::mt19937 random_{5};
};

template <int dof, class Forward, class Single, class Form>
InverseOfArm inverse_of_arm(const std::string& name, const Forward& forward, const Single& single,
                            const Form& form, int given_joint) {
  return {name, [=](std::size_t count, double share) {
            return Comparison<dof, Forward, Single, Form>(forward, single, form, given_joint)
                .measure(count, share);
          }};
}

}  // namespace throughput
