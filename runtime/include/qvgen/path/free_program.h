// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <qvgen/path/free_best.h>
#include <qvgen/path/program.h>
#include <qvgen/path/tolerance.h>

/// The program that `qvgen path --free` compiles for an arm and runs: the best motion along a path that
/// leaves coordinates free. Samples and outputs are files as for `run` (program.h).
namespace qvgen::path {

/// Arguments behind the file of samples, the way between them, and the file of motions.
template <int dof>
struct FreeRequest {
  Request path;
  Freedoms freedoms;
  FreeCosts costs;
  JointLimits<dof> limits;
  Joints<dof> preferred = Joints<dof>::Zero();
};

/// `solve(pose, value)` returns all solutions; the value is that of a free joint, if there is one.
template <int dof, int capacity, class Solve>
struct FreeResult {
  std::vector<FreePlace<dof>> places;
  double followed =
      -1;  ///< path coordinate up to which the motion is continuous; -1: not even the first pose
  double cost = 0, seconds = 0;

  FreeResult(const Solve& solve, const FreeRequest<dof>& request, const JointKinds<dof>& revolute) {
    const Curve curve = curve_of(request.path);
    const auto solve_at = [&](double s, const FreeValues& values) {
      return solve(request.freedoms.moved(curve.at(s), values), request.freedoms.joint(values));
    };
    FreeTask<dof> task;
    task.samples = request.path.samples.size();
    task.space = request.freedoms.space;
    task.costs = request.costs;
    task.limits = request.limits;
    task.preferred = request.preferred;
    const auto start = std::chrono::steady_clock::now();
    auto best = FreeBest<dof, capacity, decltype(solve_at)>(solve_at, task, revolute).run();
    seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    places = std::move(best.places);
    followed = best.followed;
    cost = best.cost;
  }
};

template <class Numbers>
std::string numbers_text(const Numbers& numbers) {
  std::string text;
  for (Eigen::Index i = 0; i < numbers.size(); ++i) text += (i > 0 ? "," : "") + json::text(numbers[i]);
  return text;
}

/// Rows of pose number, time if there is one, the free coordinates, and joints.
template <int dof>
bool write_free_motion(const Request& request, const std::vector<FreePlace<dof>>& places,
                       const std::string& header) {
  std::FILE* to = std::fopen(request.motions, "wb");
  if (to == nullptr) return false;
  std::fprintf(to, "s%s%s\n", request.times.empty() ? "" : ",t [s]", header.c_str());
  for (std::size_t i = 0; i < places.size(); ++i) {
    std::fprintf(to, "%zu", i);
    if (!request.times.empty()) std::fprintf(to, ",%s", json::text(request.times[i]).c_str());
    std::fprintf(to, ",%s,%s\n", numbers_text(places[i].values).c_str(), numbers_text(places[i].q).c_str());
  }
  const bool failed = std::ferror(to) != 0;
  return std::fclose(to) == 0 && !failed;
}

template <int dof, int capacity, class Solve>
void write_free_json(std::size_t samples, const FreeResult<dof, capacity, Solve>& result) {
  std::printf("{\"samples\":%zu,\"seconds\":%.6f,\"followed\":%s,\"cost\":%s,\"motion\":[", samples,
              result.seconds, json::text(result.followed).c_str(), json::text(result.cost).c_str());
  const char* separator = "";
  for (const FreePlace<dof>& place : result.places) {
    std::printf("%s\n{\"values\":[%s],\"branch\":%d,\"q\":[%s]}", separator,
                numbers_text(place.values).c_str(), place.branch, numbers_text(place.q).c_str());
    separator = ",";
  }
  std::printf("]}\n");
}

/// Reads name, lower and upper end, and "circle" or "range" of each free coordinate (`add_named`).
inline bool read_freedoms(int count, char** words, int values, Freedoms& freedoms) {
  bool fits = count > 0 && count % 4 == 0;
  for (int i = 0; fits && i < count; i += 4) {
    FreeRange range;
    range.lower = std::strtod(words[i + 1], nullptr);
    range.upper = std::strtod(words[i + 2], nullptr);
    range.is_circle = std::string(words[i + 3]) == "circle";
    range.count = values;
    fits = add_named(freedoms, words[i], range);
  }
  return fits;
}

/// Arguments: the file of samples, the way between them (`read_between`), the file of the motion or "-", how
/// many values of what is free are tried, the weight of the preferred joints, lower limits, upper limits,
/// preferred joints, the header of the free coordinates' columns, and these (`read_freedoms`). `joints` is
/// the header of the joints' columns. `solve(pose, value)` returns all solutions.
template <int dof, int capacity, class Solve>
int run_free(int argc, char** argv, const char* joints, const JointKinds<dof>& revolute, const Solve& solve) {
  constexpr int first = 7 + 3 * dof;
  FreeRequest<dof> request;
  if (argc < first || !read_samples(argv[1], request.path)) return 2;
  if (!read_freedoms(argc - first, argv + first, std::atoi(argv[4]), request.freedoms)) return 2;
  const auto number = [&](int i) { return std::strtod(argv[i], nullptr); };
  read_between(argv[2], request.path);
  if (std::string(argv[3]) != "-") request.path.motions = argv[3];
  request.costs.preferred = number(5);
  for (int i = 0; i < dof; ++i) {
    request.limits.lower[i] = number(6 + i);
    request.limits.upper[i] = number(6 + dof + i);
    request.preferred[i] = number(6 + 2 * dof + i);
  }
  const FreeResult<dof, capacity, Solve> result(solve, request, revolute);
  write_free_json(request.path.samples.size(), result);
  const std::string header = argv[first - 1] + std::string(joints);
  if (request.path.motions != nullptr && !write_free_motion<dof>(request.path, result.places, header))
    return 1;
  return std::fflush(stdout) == 0 ? 0 : 1;
}

}  // namespace qvgen::path
