// Where a bee is somewhere else for a while and then back: two steps of its track that nothing so
// slow could make, as where motion capture takes one body for another, or a filter of places is
// off until it finds its satellites again. Each of them alone may be a late record, or one of a
// bee that was set down elsewhere; both together say that the places between are wrong.
//
// Such a step, a leap, is longer than the bee could get in kTimesFastestOther times the speed of
// its fastest other step (and half a second more, as times may be those of arrival), and would take
// more than kMostAcceleration_mps2 from the one fix to the next. Where the same place is repeated
// until the next is known, the time between two is that from place to place. Who leaps often does
// so by its nature, and who is faster than OwnMotion::kFastest_mps has old places: of these it is
// not asked. A bee is back where it can have got meanwhile at the speed of its other steps, much
// closer to where it was than the leaps are long; or where both leaps are the same way, out and
// back.
//
// Heights of aircraft go in steps, and their places are seconds old: who asks leaves them out.
#pragma once

#include "io/frames/coordinate_frame.hpp"

#include <beespace/point.hpp>
#include <beespace/track.hpp>

#include <cstddef>
#include <optional>
#include <vector>

namespace beespace::io {

struct Excursion {
  std::size_t before = 0;               // the fix from which the bee leaps away
  std::size_t behind = 0;               // the one to which it leaps back
  std::vector<std::size_t> leaps = {};  // to which fixes it leaps; the last one is `behind`
};

struct LongStep {
  Fix from;
  Fix to;
  Point way = {};  // in metres
  double metres = 0.0;
};

// Of all fixes of a bee, in the order of time; in that order, none within another one.
std::vector<Excursion> excursions(const std::vector<Fix>& fixes, Frame frame);

// The same of fixes that come one after the other, judged by those before; those that go back in
// time count for nothing.
class ExcursionWatch {
 public:
  // Whether the bee is back with this fix.
  bool take(const Fix& fix, Frame frame);

 private:
  // The step to `to`, which is at another place.
  bool takes_step(const LongStep& step, Frame frame);

  std::optional<Fix> last_ = {};
  double since_s_ = 0.0;              // of the first fix
  std::size_t steps_ = 0;             // to other places
  std::size_t sudden_ = 0;            // of these: too sudden for anything
  double fastest_mps_ = 0.0;          // of the others
  std::vector<LongStep> leaps_ = {};  // the last ones
};

}  // namespace beespace::io
