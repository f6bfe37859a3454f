// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

/// Other libraries, which have no batches for an arm: called in a loop, one configuration after the other.
namespace throughput {

/// A function of a library, for one thread: from q, qd and what else it takes, one behind the other, to its
/// own numbers, valid until the next call.
using PeerCall = std::function<const double*(const double*)>;

struct Peer {
  std::string name;
  std::function<PeerCall()> make;  ///< with a model of its own
};

/// Those that have a function, "puma560 inverse_dynamics" say.
std::vector<Peer> peers_of(const std::string& robot_and_function);

}  // namespace throughput
