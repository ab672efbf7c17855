// A channel for messages that come late, not at all, twice, or in another order: all within bounds,
// and the same for the same seed.
//
// Time is counted in integers, as the caller likes. Each sender has runs of losses of its own.
#pragma once

#include "scenes/random_stream.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace beespace::sim {

struct ChannelErrors {
  // How late messages come; where the two differ each comes as late as chance will have it, and so
  // in another order.
  std::int64_t least_latency = 0;
  std::int64_t most_latency = 0;
  double loss = 0.0;        // which share is lost
  double duplicates = 0.0;  // which share comes twice
  // How many of one sender are lost at most, one after the other; and how likely it is that after a
  // lost one the next is lost too, where that is more than `loss`.
  int longest_run = 1;
  double in_a_row = 0.5;
};

// Which messages of each sender are lost.
class Losses {
 public:
  Losses(const ChannelErrors& errors, scenes::RandomStream& random)
      : errors_(errors), random_(random) {}
  bool loses(std::size_t sender);

 private:
  const ChannelErrors& errors_;
  scenes::RandomStream& random_;
  std::vector<int> in_a_row_;  // of each sender
};

template <class Message>
class Channel {
 public:
  Channel(const ChannelErrors& errors, std::uint64_t seed) : errors_(errors), random_(seed) {}
  Channel(const Channel&) = delete;
  Channel& operator=(const Channel&) = delete;
  ~Channel() = default;

  void send(std::int64_t now, std::size_t sender, const Message& message) {
    ++sent_;
    if (losses_.loses(sender)) {
      ++lost_;
      return;
    }
    on_the_way_[now + latency()].push_back(message);
    if (errors_.duplicates > 0.0 && random_.uniform() < errors_.duplicates) {
      on_the_way_[now + latency()].push_back(message);
    }
  }

  // What has come until now: `take` is called with each message.
  template <class Take>
  void deliver(std::int64_t now, const Take& take) {
    while (!on_the_way_.empty() && on_the_way_.begin()->first <= now) {
      const std::vector<Message> come = std::move(on_the_way_.begin()->second);
      on_the_way_.erase(on_the_way_.begin());
      for (const Message& message : come) take(message);
    }
  }

  [[nodiscard]] std::uint64_t sent() const { return sent_; }
  [[nodiscard]] std::uint64_t lost() const { return lost_; }

 private:
  std::int64_t latency() {
    const std::int64_t more = errors_.most_latency - errors_.least_latency;
    if (more <= 0) return errors_.least_latency;
    return errors_.least_latency + random_.index(static_cast<std::uint32_t>(more) + 1);
  }

  ChannelErrors errors_;
  scenes::RandomStream random_;
  Losses losses_{errors_, random_};
  std::map<std::int64_t, std::vector<Message>> on_the_way_;  // by when they come
  std::uint64_t sent_ = 0;
  std::uint64_t lost_ = 0;
};

}  // namespace beespace::sim
