// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <qvgen/path/free.h>
#include <qvgen/path/program.h>

/// The program that `qvgen path --free` compiles for an arm and runs: the best motion along a path that
/// leaves one coordinate free. Samples and outputs are files as for `run` (program.h).
namespace qvgen::path {

/// The pose with the tool turned about one of its own axes, 0 to 2 for x to z.
inline Pose<double> turned(const Pose<double>& pose, int axis, double angle) {
  Vector3<double> turn = Vector3<double>::Zero();
  turn[axis] = angle;
  return {pose.orientation * from_rotation_vector<double>(turn), pose.position};
}

/// The pose as an arm sees it whose base has travelled along one of its own axes, 0 to 2 for x to z.
inline Pose<double> from_rail(const Pose<double>& pose, int axis, double way) {
  Pose<double> seen = pose;
  seen.position[axis] -= way;
  return seen;
}

/// Arguments behind the file of samples, the way between them, and the file of motions.
template <int dof>
struct FreeRequest {
  Request path;
  FreeRange range;
  FreeCosts costs;
  JointLimits<dof> limits;
  Joints<dof> preferred;
};

template <int dof, int capacity, class Solve>
struct FreeResult {
  std::vector<FreePlace<dof>> places;
  double followed =
      -1;  ///< path coordinate up to which the motion is continuous; -1: not even the first pose
  double seconds = 0;

  FreeResult(const Solve& solve, const FreeRequest<dof>& request, const JointKinds<dof>& revolute) {
    using Search = FreeSearch<dof, capacity, Solve>;
    const std::size_t samples = request.path.samples.size();
    const auto count = static_cast<std::size_t>(request.range.count), width = count * capacity;
    std::vector<typename Search::Node> nodes(2 * width);
    std::vector<int> sizes(2 * count);
    std::vector<std::int32_t> from(samples * width);
    places.resize(samples);
    const auto start = std::chrono::steady_clock::now();
    Search search(solve, request.range, request.limits, revolute, request.costs);
    search.preferred = request.preferred;
    const std::size_t reached =
        search.search(samples, {nodes.data(), sizes.data(), from.data()}, places.data());
    places.resize(reached);
    search.smooth(reached, places.data());
    if (reached > 0) followed = search.follow(reached, places.data());
    seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }
};

template <int dof>
std::string joints_text(const Joints<dof>& q, const char* separator) {
  std::string text;
  for (int i = 0; i < dof; ++i) text += (i > 0 ? separator : "") + json::text(q[i]);
  return text;
}

/// Rows of pose number, time if there is one, the free coordinate, and joints.
template <int dof>
bool write_free_motion(const Request& request, const std::vector<FreePlace<dof>>& places,
                       const char* header) {
  std::FILE* to = std::fopen(request.motions, "wb");
  if (to == nullptr) return false;
  std::fprintf(to, "s%s%s\n", request.times.empty() ? "" : ",t [s]", header);
  for (std::size_t i = 0; i < places.size(); ++i) {
    std::fprintf(to, "%zu", i);
    if (!request.times.empty()) std::fprintf(to, ",%s", json::text(request.times[i]).c_str());
    std::fprintf(to, ",%s,%s\n", json::text(places[i].value).c_str(),
                 joints_text<dof>(places[i].q, ",").c_str());
  }
  const bool failed = std::ferror(to) != 0;
  return std::fclose(to) == 0 && !failed;
}

template <int dof>
void write_free_json(std::size_t samples, double followed, double seconds,
                     const std::vector<FreePlace<dof>>& places) {
  std::printf("{\"samples\":%zu,\"seconds\":%.6f,\"followed\":%s,\"motion\":[", samples, seconds,
              json::text(followed).c_str());
  for (std::size_t i = 0; i < places.size(); ++i)
    std::printf("%s\n{\"value\":%s,\"branch\":%d,\"q\":[%s]}", i > 0 ? "," : "",
                json::text(places[i].value).c_str(), places[i].branch,
                joints_text<dof>(places[i].q, ",").c_str());
  std::printf("]}\n");
}

/// Arguments: the file of samples, the way between them (`read_between`), the file of the motion or "-",
/// lower and upper end of the free coordinate, "circle" or "range", how many values are tried, the weight of
/// the preferred joints, lower limits, upper limits, preferred joints. `solve(pose, value)` returns all
/// solutions.
template <int dof, int capacity, class Solve>
int run_free(int argc, char** argv, const char* header, const JointKinds<dof>& revolute, const Solve& solve) {
  FreeRequest<dof> request;
  if (argc != 9 + 3 * dof || !read_samples(argv[1], request.path)) return 2;
  const auto number = [&](int i) { return std::strtod(argv[i], nullptr); };
  read_between(argv[2], request.path);
  if (std::string(argv[3]) != "-") request.path.motions = argv[3];
  request.range.lower = number(4);
  request.range.upper = number(5);
  request.range.is_circle = std::string(argv[6]) == "circle";
  request.range.count = std::atoi(argv[7]);
  request.costs.preferred = number(8);
  for (int i = 0; i < dof; ++i) {
    request.limits.lower[i] = number(9 + i);
    request.limits.upper[i] = number(9 + dof + i);
    request.preferred[i] = number(9 + 2 * dof + i);
  }
  const Curve curve = curve_of(request.path);
  const auto solve_at = [&](double s, double value) { return solve(curve.at(s), value); };
  const FreeResult<dof, capacity, decltype(solve_at)> result(solve_at, request, revolute);
  write_free_json<dof>(request.path.samples.size(), result.followed, result.seconds, result.places);
  if (request.path.motions != nullptr && !write_free_motion<dof>(request.path, result.places, header))
    return 1;
  return std::fflush(stdout) == 0 ? 0 : 1;
}

}  // namespace qvgen::path
