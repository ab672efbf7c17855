// What a live swarm left out because of a bound.
#pragma once

#include <beespace/swarm.hpp>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

namespace beespace::motion {

// Pairs that were left out because there were too many of a kind.
struct LeftOut {
  std::uint64_t count = 0;  // at least; not known where it is 0
  double from_m = std::numeric_limits<double>::infinity();
  bool any = false;

  void add(std::uint64_t more, double distance_m) {
    any = true;
    count += more;
    from_m = std::min(from_m, distance_m);
  }
  void report(double now_s, SwarmBound bound, std::vector<SwarmEvent>& events) const {
    if (!any) return;
    events.push_back({EventKind::kOverloaded, now_s, 0, 0, from_m, now_s, 0.0, count, bound});
  }
};

// The share of a separation within which there are few enough pairs: 1 as long as possible, else
// the last one or others by powers of 4.
class Share {
 public:
  [[nodiscard]] double value() const { return value_; }

  // Calls few(share) until it is true for one share and false for the next larger one, or true for
  // 1; the last true one is the value. Returns whether there is one.
  template <class Few>
  bool choose(Few&& few) {
    constexpr double kLeast = 0x1p-20;
    if (!few(value_)) {
      while (value_ > kLeast) {
        value_ *= 0.25;
        if (few(value_)) return true;
      }
      return false;
    }
    while (value_ < 1.0 && few(4.0 * value_)) value_ *= 4.0;
    return true;
  }

 private:
  double value_ = 1.0;
};

}  // namespace beespace::motion
