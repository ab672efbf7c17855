// The clock of one agent: in nanoseconds, off by at most a bound, and never backwards.
//
// Time is counted in integers throughout: instants (sub-steps of a tick) by the true clock,
// nanoseconds by that of the agent.
#pragma once

#include "scenes/random_stream.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace beespace::sim {

struct ClockErrors {
  double bound_s = 0.0;  // how far it is off at most
  // Whether it wanders within the bound, at most so fast; else it is always off by as much.
  bool wanders = false;
  double slew = 0.02;  // seconds a second
};

class AgentClock {
 public:
  AgentClock(const ClockErrors& errors, std::int64_t instant_ns, std::uint64_t seed)
      : errors_(errors), instant_ns_(instant_ns), random_(seed) {
    bound_ns_ = static_cast<std::int64_t>(errors.bound_s * 1e9);
    offset_ns_ = off();
    aim_ns_ = errors.wanders ? off() : offset_ns_;
  }

  void begin_at(std::int64_t instant) { instant_ = instant; }
  // What it shows at the present instant.
  [[nodiscard]] std::int64_t shows_ns() const { return instant_ * instant_ns_ + offset_ns_; }
  // What it will show at the next one: it wanders towards its aim, and then chooses another.
  [[nodiscard]] std::int64_t will_show_ns() const {
    return (instant_ + 1) * instant_ns_ + next_offset_ns();
  }

  void go_on() {
    offset_ns_ = next_offset_ns();
    ++instant_;
    if (errors_.wanders && offset_ns_ == aim_ns_) aim_ns_ = off();
  }

 private:
  std::int64_t off() {
    const auto bound = static_cast<double>(bound_ns_);
    return static_cast<std::int64_t>(random_.uniform(-bound, bound));
  }
  [[nodiscard]] std::int64_t next_offset_ns() const {
    const auto most =
        static_cast<std::int64_t>(std::floor(errors_.slew * static_cast<double>(instant_ns_)));
    return offset_ns_ + std::clamp(aim_ns_ - offset_ns_, -most, most);
  }

  ClockErrors errors_;
  std::int64_t instant_ns_;
  std::int64_t bound_ns_ = 0;
  std::int64_t instant_ = 0;
  std::int64_t offset_ns_ = 0;
  std::int64_t aim_ns_ = 0;
  scenes::RandomStream random_;
};

// Rounded down, below zero too.
constexpr std::int64_t floor_divided(std::int64_t a, std::int64_t b) {
  return a / b - (a % b < 0 ? 1 : 0);
}

}  // namespace beespace::sim
