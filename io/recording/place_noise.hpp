// Whether the places of a bee waver as what is measured does, and how it came to where it stands.
//
// What is measured is beside the smooth way of the bee by something else each time: from one fix to
// the next the second difference of places changes its sign more often than not, and by more than
// rounding explains. What is computed goes on smoothly, at any speed; rounded places waver, too,
// but by no more than two units of their last digit.
#pragma once

#include "io/frames/coordinate_frame.hpp"

#include <beespace/track.hpp>

#include <array>
#include <cstddef>
#include <optional>

namespace beespace::io {

class PlaceNoise {
 public:
  // Fixes in the order of time, each at another place than the one before.
  void take(const Fix& fix, Frame frame);

  // Whether its places waver.
  [[nodiscard]] bool is_measured() const;
  // Whether it stood while they did.
  [[nodiscard]] bool stood() const { return stood_; }
  // Whether it would have stopped at the last one from nearly full speed, harder than what drives
  // or flies brakes as a rule. What comes down lands, and what is rounded goes by leaps.
  [[nodiscard]] bool stops_at_once() const;

 private:
  struct Wavering {
    std::size_t steps = 0;   // of which two second differences are known
    std::size_t clear = 0;   // of these: both are more than rounding
    std::size_t turned = 0;  // of these: of opposite sign
  };
  // Of some steps in a row: how far they lead together, and each.
  struct Block {
    Fix since = {};
    std::size_t steps = 0;
    double squares_m2 = 0.0;
  };

  void take_digits(double value);
  void take_block(const Fix& fix, double step_m, Frame frame);

  std::optional<Fix> last_ = {};
  double last_s_ = 0.0;            // how long the step to it took
  std::array<double, 2> step_{};   // the step to it, to the east and to the north
  std::array<double, 2> bends_{};  // the second difference there
  std::size_t steps_ = 0;          // in a row, about equally long in time
  double speed_mps_ = 0.0;         // of the last step over ground
  bool clear_ = false;             // which is longer than rounding makes it
  double usual_mps_ = 0.0;         // of the steps before, of which the last ones count most
  bool falls_ = false;             // the last step
  std::size_t digits_ = 0;         // behind the point, as they are written
  Wavering wavering_ = {};
  Block block_ = {};
  bool stood_ = false;
};

}  // namespace beespace::io
