// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include <qvgen/path/arm.h>

/// Results of following a path, in buffers of the caller: tracks, which are solutions followed as far as they
/// are continuous, whatever the limits; their joints at the samples; and events along them.
namespace qvgen::path {

/// Why a track, or a motion, begins or ends.
enum class Cause : std::uint8_t {
  path_end,  ///< the path begins or ends there
  meeting,   ///< two branches meet and are gone behind; others go on
  boundary,  ///< two branches meet, and behind nothing reaches the path
  flip,      ///< a singular pose with free joints, which would have to turn while the tool stands still
  limit,     ///< a joint is on its limit
  unclear    ///< the inverse kinematics has lost it, or work is used up
};

/// One end of a track or motion.
struct End {
  double s = 0;  ///< path coordinate
  Cause cause = Cause::unclear;
  int partner = -1;       ///< meeting, boundary: the other track; limit: the value that is on it
  bool is_upper = false;  ///< limit: which
  unsigned free = 0;      ///< flip: bit i is set if joint i is free
  Values q = Values::Zero();
};

/// A solution followed as far as it is continuous. Its angles are not confined to (-pi, pi].
struct Track {
  End begin, end;
  int first_branch = -1, last_branch = -1;                   ///< -1 where branches have no numbers
  int crossings = 0;                                         ///< singular poses that it passes without a stop
  Values lowest = Values::Zero(), highest = Values::Zero();  ///< values of each joint along it
};

/// Something on the way of a track.
struct Event {
  enum class Kind : std::uint8_t { limit, crossing };
  double s = 0;
  int track = -1;
  Kind kind = Kind::limit;
  int limited = -1;       ///< limit: the value that is on it, as a rule a joint's
  bool is_upper = false;  ///< limit: the upper one
  bool rises = false;     ///< limit: the value rises there
  double value = 0;       ///< limit: the value on the track
  Values q = Values::Zero();
  int branch_before = -1;  ///< crossing: the branch's numbers on both sides
  int branch_behind = -1;
};

/// Buffers of the caller.
template <int capacity>
struct Buffers {
  double* q = nullptr;   ///< samples x capacity x 6, or null if joints at samples are not wanted
  int* track = nullptr;  ///< samples x capacity: whose joints these are, -1 for none
  Track* tracks = nullptr;
  std::size_t most_tracks = 0;
  Event* events = nullptr;
  std::size_t most_events = 0;
};

/// Contents of the buffers.
template <int capacity>
class Record {
 public:
  explicit Record(const Buffers<capacity>& buffers) : buffers_(buffers) {}

  bool is_full = false;  ///< there were more tracks or events than room
  /// The inverse kinematics may have missed solutions that no track led to.
  bool is_doubtful = false;

  [[nodiscard]] int tracks() const { return static_cast<int>(track_count_); }
  [[nodiscard]] Track& track(int i) const { return buffers_.tracks[i]; }
  [[nodiscard]] std::size_t events() const { return event_count_; }
  [[nodiscard]] const Event& event(std::size_t i) const { return buffers_.events[i]; }

  /// Returns the number of a new track; -1 if there is no room.
  int begin_track() {
    is_full = is_full || track_count_ == buffers_.most_tracks;
    if (track_count_ == buffers_.most_tracks) return -1;
    buffers_.tracks[track_count_] = Track();
    return static_cast<int>(track_count_++);
  }
  void add(const Event& event) {
    is_full = is_full || event_count_ == buffers_.most_events;
    if (event_count_ < buffers_.most_events) buffers_.events[event_count_++] = event;
  }

  [[nodiscard]] bool keeps_samples() const { return buffers_.q != nullptr; }
  void keep(std::size_t sample, std::size_t slot, int track, const Values& q) {
    const std::size_t place = sample * capacity + slot;
    buffers_.track[place] = track;
    if (track >= 0) Eigen::Map<Values>(buffers_.q + 6 * place) = q;
  }
  /// Returns the joints of a track at a sample; false if it is not there.
  [[nodiscard]] bool at(std::size_t sample, int track, Values& q) const {
    for (std::size_t slot = 0; slot < capacity; ++slot) {
      const std::size_t place = sample * capacity + slot;
      if (buffers_.track[place] != track) continue;
      q = Eigen::Map<const Values>(buffers_.q + 6 * place);
      return true;
    }
    return false;
  }

 private:
  Buffers<capacity> buffers_;
  std::size_t track_count_ = 0, event_count_ = 0;
};

}  // namespace qvgen::path
