// Whether the clock of a bee begins again, of fixes that are handed out as they come and not kept:
// of each run of times some steps stay, which the next run is compared with.
#pragma once

#include "io/frames/coordinate_frame.hpp"
#include "io/recording/restarted_clock.hpp"
#include "io/recording/track_gathering.hpp"

#include <beespace/track.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace beespace::io {

class RestartWatch {
 public:
  // The next fix, in the order of the input.
  void take(const Fix& fix, Origin origin, Frame frame);

  // Of all of them so far; no fixes where there are none.
  [[nodiscard]] BeeClock clock() const;

 private:
  struct Step {
    Fix from;
    Fix to;
  };
  // Times that do not go back: their first and last fix, steps spread over all of them, and the
  // last ones.
  struct Run {
    Fix begins;
    Fix last;
    std::uint64_t fixes = 0;
    std::vector<Step> steps = {};
    std::uint64_t every = 1;  // one of so many steps is among them
    std::array<Step, 4> latest = {};

    void add(const Fix& fix);
    [[nodiscard]] bool spans(double time_s) const;
    // A step during which that time was; null where it is not known.
    [[nodiscard]] const Step* at(double time_s) const;
    // How many fixes it has about, from one time to another.
    [[nodiscard]] std::uint64_t between(double from_s, double until_s) const;
    [[nodiscard]] std::size_t latest_size() const;
  };
  struct Compared {
    std::uint64_t in_both = 0;  // fixes within the times of the run before
    std::uint64_t fixes = 0;    // of these, such of which it is known where the other run was
    std::uint64_t same = 0;
    std::uint64_t apart = 0;
  };

  void compare(const Fix& fix, Frame frame);
  [[nodiscard]] std::optional<ClockCut> cut_of_runs() const;

  BeeClock all_;
  std::uint64_t times_back_ = 0;
  Run run_;
  std::optional<Run> before_;  // the run before that one, while no cut is found
  ClockCut between_;           // the two
  Compared compared_;          // the same
};

}  // namespace beespace::io
