// Places that are said again and again, bit by bit, by what has lost a bee, as motion capture and
// filters do; the bee moves on meanwhile. What stands may be said so, too: that its track goes on
// with a jump, farther and faster than it ever moves elsewhere, tells the two apart. Places that
// are rounded, or held until the next is known, go on by such jumps always.
#pragma once

#include "io/frames/coordinate_frame.hpp"
#include "io/problems/left_out.hpp"

#include <beespace/mover.hpp>
#include <beespace/track.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace beespace::io {

inline constexpr LeftOutReason kFrozenPlace = {
    "that repeat a place exactly, from which the bee then jumps more than three times as far and "
    "as "
    "fast as it ever moves elsewhere,",
    "where such a bee was is not known, as where the last place is said again after it was lost"};

// How a bee moves from one fix to the next but for jumps out of places that may be such.
class UsualSteps {
 public:
  void take(double metres, double seconds);
  [[nodiscard]] bool exceeded_by(double metres, double seconds) const;

 private:
  std::size_t count_ = 0;
  double farthest_m_ = 0.0;
  double fastest_mps_ = 0.0;
};

// Which fixes of a bee, in the order of time, are such: all but the first at each such place; empty
// where none is. Velocities may be those of all fixes: who says that it stands does.
std::vector<bool> frozen_places(const std::vector<Fix>& fixes,
                                const std::vector<Velocity>& velocities, Frame frame);

// The same of fixes that come one after the other; those that go back in time count for nothing.
class FrozenWatch {
 public:
  // Whether the bee jumps to this fix out of such a place, by what came before. `number`: how the
  // caller knows the fix again.
  bool take(const Fix& fix, const Velocity* velocity, Frame frame, std::uint64_t number = 0);
  // Once all came: the fix with which a bee jumps out of such a place; nothing where none does.
  [[nodiscard]] std::optional<std::uint64_t> found() const;

 private:
  struct Jump {
    double metres;
    double seconds;
    std::uint64_t number;
  };

  std::optional<Fix> since_ = {};  // the first fix at the place of the last
  double last_s_ = 0.0;
  std::size_t fixes_ = 0;  // at that place
  bool stands_ = false;    // as one of them says
  UsualSteps usual_ = {};
  std::optional<Jump> farthest_ = {};  // out of a place that may be such
};

}  // namespace beespace::io
