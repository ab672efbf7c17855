// The corrections of one agent whose loop is closed on the ground.
//
// From its newest report, and from what it has been told since, follows how far it will be from its
// nominal path when the next command takes effect; the law of the loop then says how fast it shall
// fly back. What is corrected is not what is planned: the nominal path stays where it is.
#pragma once

#include "base/vector3.hpp"
#include "fleet/correction_loop.hpp"

#include <beespace/command.hpp>

#include <cstddef>
#include <limits>
#include <vector>

namespace beespace::guide {

using core::Vector3;

class GroundLoop {
 public:
  // How many ticks back a report may lie, so that all corrections since are known.
  static constexpr Tick kHistory = 128;

  // What it flies in addition at a tick; none where nothing was said.
  [[nodiscard]] Vector3 at(Tick tick) const {
    if (entries_.empty()) return {};
    const Entry& entry = entries_[index(tick)];
    return entry.tick == tick ? entry.correction : Vector3{};
  }
  void set(Tick tick, const Vector3& correction) {
    entries_.resize(kHistory);
    entries_[index(tick)] = {tick, correction};
  }

  // The deviation was this, so long after a tick.
  void measure(Tick tick, double after_s, const Vector3& deviation) {
    measured_ = true;
    tick_ = tick;
    after_s_ = after_s;
    deviation_ = deviation;
  }
  [[nodiscard]] bool has_measured() const { return measured_; }

  // The deviation to be expected at a later tick, as corrected since.
  [[nodiscard]] Vector3 expected(Tick tick, double period_s) const {
    Vector3 sum = deviation_;
    if (tick - tick_ >= kHistory) return sum;
    double from_s = after_s_;
    for (Tick t = tick_; t < tick; ++t) {
      // It changes evenly within a tick.
      const Vector3 begin = at(t);
      const Vector3 end = at(t + 1);
      const double share = from_s / period_s;
      if (share < 1.0) {
        const Vector3 there = begin + (end - begin) * share;
        sum = sum + (there + end) * (0.5 * (period_s - from_s));
        from_s = 0.0;
      } else {
        from_s -= period_s;
      }
    }
    return sum;
  }

  // What it shall fly in addition at the end of the tick that begins at `tick`.
  [[nodiscard]] Vector3 next(Tick tick, const fleet::CorrectionLoop& loop) const {
    if (!measured_) return {};
    return loop.next(expected(tick, loop.period_s()), at(tick));
  }

 private:
  struct Entry {
    Tick tick = std::numeric_limits<Tick>::min();
    Vector3 correction = {};
  };
  static std::size_t index(Tick tick) { return static_cast<std::size_t>(tick & (kHistory - 1)); }

  std::vector<Entry> entries_;  // of the last ticks; none before the first correction
  bool measured_ = false;
  Tick tick_ = 0;
  double after_s_ = 0.0;
  Vector3 deviation_;
};

}  // namespace beespace::guide
