// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <memory>
#include <type_traits>
#include <vector>

#include <qvgen/path/complete.h>
#include <qvgen/path/cover.h>
#include <qvgen/path/follow.h>
#include <qvgen/path/held.h>
#include <qvgen/path/json.h>
#include <qvgen/path/least_time.h>
#include <qvgen/path/review.h>

/// The program that `qvgen path` compiles for an arm and runs. A file has the samples, eight numbers each:
/// w x y z of the orientation, the position, the time (NaN without). The result goes to the output as JSON,
/// and, if wanted, the motions at the samples to a file as CSV.
namespace qvgen::path {

/// A path to follow, and limits.
struct Request {
  std::vector<Pose<double>> samples;
  std::vector<double> times;  ///< empty without
  Between between = Between::straight;
  double radius = 0;                 ///< of a blend, m
  std::vector<double> lower, upper;  ///< limits: of six joints or motors, then of joints that have their own
  bool is_timed = false;             ///< the least time of each motion is wanted
  RateLimits<6> rates{};
  std::vector<double> forces;     ///< largest ones of all joints, N m or N; empty without
  std::vector<double> jerks;      ///< largest ones, rad/s^3 or m/s^3; empty without
  const char* motions = nullptr;  ///< the CSV's file
};

/// Stands for proofs where none are wanted.
struct NoProofs {};

/// Reads how the tool goes between the samples: "straight", "screw", "spline", or the radius of a blend.
inline void read_between(const std::string& word, Request& request) {
  request.between = word == "straight" ? Between::straight
                    : word == "screw"  ? Between::screw
                    : word == "spline" ? Between::spline
                                       : Between::blend;
  if (request.between == Between::blend) request.radius = std::strtod(word.c_str(), nullptr);
}

inline Curve curve_of(const Request& request) {
  return {request.samples.data(), request.samples.size(), request.between, request.radius};
}

inline bool read_samples(const char* file, Request& request) {
  std::FILE* from = std::fopen(file, "rb");
  if (from == nullptr) return false;
  double row[8];
  while (std::fread(row, sizeof row, 1, from) == 1) {
    request.samples.push_back({{row[0], row[1], row[2], row[3]}, {row[4], row[5], row[6]}});
    if (!std::isnan(row[7])) request.times.push_back(row[7]);
  }
  std::fclose(from);
  return !request.samples.empty();
}

/// All that was found along one path, with the memory that it takes.
template <class Arm, class Bounds, class Dynamics>
class Found {
 public:
  using Coupling = typename Arm::Limited;
  static constexpr int capacity = Arm::capacity;
  static constexpr bool has_proofs = !std::is_same_v<Bounds, NoProofs>;

  /// `bounds`: the arm in bounds, or NoProofs; `dynamics`: its forces, or NoDynamics.
  Found(const Arm& arm, const Request& request, const Bounds& bounds, const Dynamics& dynamics)
      : arm_(arm),
        bounds_(bounds),
        request_(request),
        limits_(limits_of(arm, request)),
        curve_(curve_of(request)),
        q_(request.samples.size() * capacity * 6),
        track_(request.samples.size() * capacity),
        tracks_(most_tracks),
        events_(most_events),
        record_(buffers()) {
    seconds_ = seconds_of([&] { follow(); });
    const int tracks = record_.tracks();
    if constexpr (has_proofs)
      complete_seconds_ = seconds_of(
          [&] { open_ = prove_complete(arm_, bounds_, curve_, record_, extra_, [&] { follow(); }); });
    found_ = record_.tracks() - tracks;
    const auto take = [&](const Motion& motion) { motions_.push_back(motion); };
    using Cut = MotionsOf<capacity, decltype(take), Coupling>;
    const auto cut = std::make_unique<Cut>(record_, limits_, arm_.revolute, take, arm_.coupling);
    record_.is_full = !cut->run() || record_.is_full;
    for (const Motion& motion : motions_)
      if (request.is_timed) times_.push_back(times_of(motion, dynamics));
  }

  void write_json() {
    std::printf("{\"samples\":%zu,\"seconds\":%.6f,\"full\":%s,\"doubtful\":%s,\"tracks\":%d,\n\"motions\":[",
                request_.samples.size(), seconds_, record_.is_full ? "true" : "false",
                record_.is_doubtful ? "true" : "false", record_.tracks());
    for (std::size_t i = 0; i < motions_.size(); ++i) {
      std::printf("%s\n", i > 0 ? "," : "");
      write_motion(motions_[i], i);
    }
    std::printf("],\n\"chain\":[");
    write_chain();
    std::printf("],\n\"gaps\":[");
    write_gaps();
    std::printf("]");
    if constexpr (has_proofs) write_complete();
    std::printf("}\n");
  }

  /// Rows of motion, path coordinate, time if there is one, and joints; false if the file cannot be written.
  [[nodiscard]] bool write_motions(const char* header) const {
    std::FILE* to = std::fopen(request_.motions, "wb");
    if (to == nullptr) return false;
    std::fprintf(to, "motion,s%s%s\n", has_times() ? ",t [s]" : "", header);
    for (std::size_t i = 0; i < motions_.size(); ++i) {
      if (request_.is_timed)
        for (const TimedPlace& place : times_[i].places) write_row(to, i, place.s, place.time, place.q);
      else
        for_each_place(motions_[i], 1, [&](double s, const Values& q) {
          write_row(to, i, s, has_times() ? time_at(s) : 0, q);
        });
    }
    const bool failed = std::ferror(to) != 0;
    return std::fclose(to) == 0 && !failed;
  }

 private:
  static constexpr std::size_t most_tracks = 20000, most_events = 200000, most_drawn = 400;

  /// Limits of all values from those that are given.
  static JointLimits<Coupling::values> limits_of(const Arm& arm, const Request& request) {
    JointLimits<Coupling::values> limits;
    std::copy(request.lower.begin(), request.lower.end(), limits.lower.data());
    std::copy(request.upper.begin(), request.upper.end(), limits.upper.data());
    return arm.coupling.limits(limits);
  }

  [[nodiscard]] Buffers<capacity> buffers() {
    return {q_.data(), track_.data(), tracks_.data(), tracks_.size(), events_.data(), events_.size()};
  }

  /// Returns the processor time of a call, s.
  template <class Call>
  static double seconds_of(const Call& call) {
    const std::clock_t start = std::clock();
    call();
    return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  }

  /// Follows all solutions, with the places that the proof has added.
  void follow() {
    record_ = Record<capacity>(buffers());
    Options options;
    options.extra = extra_.data();
    options.extra_count = extra_.size();
    Follower<Arm>(arm_, curve_, limits_, record_, options).run();
  }

  /// Writes what is not proven to have no other motions, and how many tracks only the proof has met.
  void write_complete() const {
    std::printf(",\n\"complete\":{\"gaps\":[");
    for (std::size_t i = 0; i < open_.size(); ++i)
      std::printf("%s[%s,%s]", i > 0 ? "," : "", json::text(open_[i].first).c_str(),
                  json::text(open_[i].second).c_str());
    std::printf("],\"found\":%d,\"seconds\":%.6f}", found_, complete_seconds_);
  }

  /// Calls with the places of a motion: its ends and each sample between them, or some of these. Values are
  /// those that the caller reads, of joints or of motors.
  template <class Take>
  void for_each_place(const Motion& motion, std::size_t stride, const Take& take) const {
    const auto show = [&](double s, const Values& q) { take(s, arm_.coupling.shown(q)); };
    show(motion.begin.s, motion.begin.q);
    for (auto i = static_cast<std::size_t>(motion.begin.s) + 1; static_cast<double>(i) < motion.end.s; ++i) {
      Values q;
      if (i % stride == 0 && record_.at(i, motion.track, q)) show(static_cast<double>(i), q + motion.turns);
    }
    if (motion.end.s > motion.begin.s) show(motion.end.s, motion.end.q);
  }

  /// An end as the caller reads it.
  [[nodiscard]] End shown(const End& end) const {
    End shown = end;
    shown.q = arm_.coupling.shown(end.q);
    if (end.cause == Cause::limit) shown.partner = arm_.coupling.shown_index(end.partner);
    return shown;
  }

  /// Calls with the first and the last place, and some between.
  template <class Take>
  static void for_some(const std::vector<TimedPlace>& places, const Take& take) {
    const std::size_t stride = places.size() / most_drawn + 1;
    for (std::size_t i = 0; i < places.size(); ++i)
      if (i % stride == 0 || i + 1 == places.size()) take(places[i]);
  }

  [[nodiscard]] bool has_times() const { return request_.is_timed || !request_.times.empty(); }

  [[nodiscard]] LeastTimes times_of(const Motion& motion, const Dynamics& dynamics) const {
    std::vector<double> s;
    std::vector<Values> q;
    for_each_place(motion, 1, [&](double place, const Values& joints) {
      s.push_back(place);
      q.push_back(joints);
    });
    ForceLimits<Dynamics::forces> limits;
    if constexpr (Dynamics::forces > 0) {
      std::copy_n(request_.forces.begin(), Dynamics::forces, limits.most.begin());
      add_friction([&](const auto& qd) { return dynamics.friction(qd); }, limits);
    }
    LeastTime<Dynamics> least(dynamics, request_.rates, limits);
    if (!request_.jerks.empty()) least.limit_jerks(Values(Eigen::Map<const Values>(request_.jerks.data())));
    return least.run(s, q);
  }

  void write_row(std::FILE* to, std::size_t motion, double s, double time, const Values& q) const {
    std::fprintf(to, "%zu,%s", motion + 1, json::text(s).c_str());
    if (has_times()) std::fprintf(to, ",%s", std::isnan(time) ? "nan" : json::text(time).c_str());
    for (int i = 0; i < 6; ++i) std::fprintf(to, ",%s", json::text(q[i]).c_str());
    std::fprintf(to, "\n");
  }

  [[nodiscard]] double time_at(double s) const {
    if (curve_.pieces() == 0) return request_.times[0];
    const std::size_t i = curve_.piece_at(s);
    return request_.times[i] + (s - static_cast<double>(i)) * (request_.times[i + 1] - request_.times[i]);
  }

  static void write_extreme(const char* name, const Extreme& extreme) {
    std::printf(",\"%s\":{\"value\":%s,\"s\":%s,\"joint\":%d}", name, json::text(extreme.value).c_str(),
                json::text(extreme.s).c_str(), extreme.joint);
  }

  void write_motion(const Motion& motion, std::size_t number) const {
    std::printf("{\"track\":%d,\"representatives\":%.17g,\"begin\":%s,\"end\":%s,\"branches\":[%d,%d]",
                motion.track, motion.representatives, json::text(shown(motion.begin)).c_str(),
                json::text(shown(motion.end)).c_str(),
                tracks_[static_cast<std::size_t>(motion.track)].first_branch,
                tracks_[static_cast<std::size_t>(motion.track)].last_branch);
    write_crossings(motion);
    if constexpr (has_proofs) write_proof(motion);
    const Reviewer<Arm> reviewer(arm_, curve_, limits_, record_,
                                 request_.times.empty() ? nullptr : request_.times.data());
    const Review review = reviewer.review(motion);
    if (request_.is_timed) write_time(times_[number]);
    write_extreme("limit_distance", review.limit_distance);
    write_extreme("regularity", review.regularity);
    write_extreme("speed", review.speed);
    write_extreme("acceleration", review.acceleration);
    std::printf(",\"travel\":%s,\"curve\":[", json::text(review.travel).c_str());
    const char* separator = "";
    const auto write = [&](double s, const Values& q, const std::string& time) {
      std::printf("%s[%s,%s%s]", separator, json::text(s).c_str(), json::text(q).c_str(), time.c_str());
      separator = ",";
    };
    if (request_.is_timed)
      for_some(times_[number].places,
               [&](const TimedPlace& place) { write(place.s, place.q, "," + json::text(place.time)); });
    else
      for_each_place(motion, request_.samples.size() / most_drawn + 1,
                     [&](double s, const Values& q) { write(s, q, ""); });
    std::printf("]}");
  }

  static void write_time(const LeastTimes& least) {
    std::printf(",\"least_time\":%s", json::text(least.seconds).c_str());
    const Overload& overload = least.overload;
    if (overload.joint < 0) return;
    std::printf(",\"overload\":{\"joint\":%d,\"s\":%s,\"force\":%s,\"sure\":%s}", overload.joint,
                json::text(overload.s).c_str(), json::text(overload.force).c_str(),
                overload.is_sure ? "true" : "false");
  }

  void write_proof(const Motion& motion) const {
    std::printf(",\"proof\":{\"gaps\":[");
    const char* separator = "";
    Proven proven;
    const auto take_gap = [&](double from, double to) {
      std::printf("%s[%s,%s]", separator, json::text(from).c_str(), json::text(to).c_str());
      separator = ",";
    };
    const double seconds = seconds_of([&] { proven = prove(bounds_, curve_, record_, motion, take_gap); });
    std::printf("],\"boxes\":%ld,\"narrowest\":%s,\"seconds\":%.6f}", proven.boxes,
                json::text(proven.narrowest).c_str(), seconds);
  }

  void write_crossings(const Motion& motion) const {
    std::printf(",\"crossings\":[");
    const char* separator = "";
    for (std::size_t i = 0; i < record_.events(); ++i) {
      const Event& event = record_.event(i);
      const bool is_here = event.track == motion.track && event.kind == Event::Kind::crossing &&
                           event.s >= motion.begin.s && event.s <= motion.end.s;
      if (!is_here) continue;
      std::printf("%s{\"s\":%s,\"before\":%d,\"behind\":%d}", separator, json::text(event.s).c_str(),
                  event.branch_before, event.branch_behind);
      separator = ",";
    }
    std::printf("]");
  }

  void write_chain() const {
    std::vector<int> first(motions_.size()), last(motions_.size());
    std::vector<Chain> best(motions_.size()), next(motions_.size());
    Cover<capacity, Coupling> cover(record_, motions_.data(), motions_.size(), request_.samples.size(),
                                    {first.data(), last.data(), best.data(), next.data()}, arm_.coupling);
    const Chain chain = cover.fewest();
    for (int i = 0; i < chain.count; ++i) {
      const Change& change = chain.changes[static_cast<std::size_t>(i)];
      std::printf("%s{\"motion\":%d,\"s\":%s,\"way\":%s}", i > 0 ? "," : "", change.motion,
                  json::text(change.s).c_str(), json::text(change.way).c_str());
    }
  }

  /// Stretches of the path that no motion follows.
  void write_gaps() const {
    std::vector<std::pair<double, double>> covered;
    for (const Motion& motion : motions_) covered.emplace_back(motion.begin.s, motion.end.s);
    std::sort(covered.begin(), covered.end());
    covered.emplace_back(curve_.end(), curve_.end());
    double reached = 0;
    const char* separator = "";
    bool is_first = motions_.empty() || covered.front().first > 0;
    for (const auto& [from, to] : covered) {
      if (from > reached + 1e-9 || (is_first && curve_.end() == 0)) {
        std::printf("%s[%s,%s]", separator, json::text(reached).c_str(), json::text(from).c_str());
        separator = ",";
      }
      is_first = false;
      reached = std::max(reached, to);
    }
  }

  const Arm& arm_;
  const Bounds& bounds_;
  const Request& request_;
  JointLimits<Coupling::values> limits_;
  Curve curve_;
  std::vector<double> q_;
  std::vector<int> track_;
  std::vector<Track> tracks_;
  std::vector<Event> events_;
  Record<capacity> record_;
  std::vector<Motion> motions_;
  std::vector<LeastTimes> times_;  ///< of each motion, if they are wanted
  std::vector<double> extra_;      ///< places that the proof has added
  Stretches open_;                 ///< stretches not proven to have no other motions
  int found_ = 0;                  ///< tracks that only the proof has met
  double seconds_ = 0, complete_seconds_ = 0;
};

/// Arguments: the file of samples, the way between them (`read_between`), the file of motions or "-", the
/// value of the joint that is held (0 without), lower limits of six joints or motors and of joints that have
/// limits beside their motors', as many upper ones, and, for least times, six speeds, six accelerations, the
/// largest forces of all joints where `dynamics_of` has any, and, if wanted where it has none, six jerks.
/// `arm_of` makes the arm from the value that is held, `bounds_of` its bounds for proofs, `dynamics_of` its
/// dynamics.
template <class ArmOf, class BoundsOf, class DynamicsOf>
int run(int argc, char** argv, const char* header, const ArmOf& arm_of, const BoundsOf& bounds_of,
        const DynamicsOf& dynamics_of) {
  const double held = argc > 4 ? std::strtod(argv[4], nullptr) : 0;
  const auto dynamics = dynamics_of(held);
  constexpr int forces = std::decay_t<decltype(dynamics)>::forces;
  const auto arm = arm_of(held);
  constexpr int limited = std::decay_t<decltype(arm)>::Limited::given, rates = 5 + 2 * limited;
  const bool has_jerks = forces == 0 && argc == rates + 18;
  if (argc != rates && argc != rates + 12 + forces && !has_jerks) return 2;
  Request request;
  if (!read_samples(argv[1], request)) return 2;
  read_between(argv[2], request);
  if (std::string(argv[3]) != "-") request.motions = argv[3];
  request.is_timed = argc > rates;
  for (int i = 0; i < limited; ++i) {
    request.lower.push_back(std::strtod(argv[5 + i], nullptr));
    request.upper.push_back(std::strtod(argv[5 + limited + i], nullptr));
  }
  for (int i = 0; request.is_timed && i < 6; ++i) {
    request.rates.speed[i] = std::strtod(argv[rates + i], nullptr);
    request.rates.acceleration[i] = std::strtod(argv[rates + 6 + i], nullptr);
  }
  for (int i = rates + 12; i < argc; ++i)
    (has_jerks ? request.jerks : request.forces).push_back(std::strtod(argv[i], nullptr));
  const auto bounds = bounds_of(held);
  Found<std::decay_t<decltype(arm)>, std::decay_t<decltype(bounds)>, std::decay_t<decltype(dynamics)>> found(
      arm, request, bounds, dynamics);
  found.write_json();
  if (request.motions != nullptr && !found.write_motions(header)) return 1;
  return std::fflush(stdout) == 0 ? 0 : 1;
}

}  // namespace qvgen::path
