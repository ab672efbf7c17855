// Places that are said again and again, bit by bit, by what has lost a bee, as motion capture and
// filters do; the bee moves on meanwhile. What stands may be said so, too. They are told apart
// - by the bee's own velocity, which leads it farther away than it ever goes from place to place;
// - by how its track goes on: with a jump, farther and faster than it ever moves elsewhere. Places
//   that are rounded, or held until the next is known, go on by such jumps always;
// - also of what says that it stands, by a jump that its own velocities cannot have led it
//   (own_motion.hpp);
// - at the end of the track, by what was before: what is measured wavers, also where it stands, and
//   what moves brakes. Who has stood exactly still before, and then gone on, may do so again; and
//   of what is computed, with no noise, it is only told that it stops at once.
#pragma once

#include "io/frames/coordinate_frame.hpp"
#include "io/problems/left_out.hpp"
#include "io/recording/own_motion.hpp"
#include "io/recording/place_noise.hpp"
#include "io/recording/stays.hpp"

#include <beespace/mover.hpp>
#include <beespace/track.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace beespace::io {

inline constexpr LeftOutReason kFrozenPlace = {
    "that repeat a place exactly, from which the bee then jumps more than three times as far and "
    "as fast as it ever moves elsewhere or farther than its own velocities lead it, or has moved "
    "on by its own velocity,",
    "where such a bee was is not known, as where the last place is said again after it was lost"};
inline constexpr LeftOutReason kFrozenToTheEnd = {
    "that repeat a place exactly to the end, though the places before waver as measured ones do,",
    "where such a bee was is not known, as where the last place is said again after it was lost"};

// How a bee moves from one fix to the next but for jumps out of places that may be such.
class UsualSteps {
 public:
  // From a place that is none of these.
  void take(const LeftStay& left);
  // Whether a bee jumps so out of a place that may be such.
  [[nodiscard]] bool exceeded_by(const LeftStay& left) const;
  // Whether its own velocity led it away from there.
  [[nodiscard]] bool led_away(const Stay& stay) const;

 private:
  std::size_t count_ = 0;
  double farthest_m_ = 0.0;
  double fastest_mps_ = 0.0;
};

// Whether the place at the end of a track is such. kPerhaps: a bee stops there at once, from one
// fix to the next, but nothing else tells.
enum class FrozenEnd : std::uint8_t { kNo, kPerhaps, kMeasured };

// Of each such end of a recording since when it is. Where most bees come to an end so, one here and
// one there, that is how they are written, and none is more than kPerhaps.
bool ends_are_usual(std::vector<double> since_s, std::size_t bees);

struct FrozenPlaces {
  // All but the first fix at each such place, but those at the end of the track; empty where none
  // is.
  std::vector<bool> fixes = {};
  FrozenEnd end = FrozenEnd::kNo;
  std::size_t end_begins = 0;  // the first fix at the last place
  double end_since_s = 0.0;

  [[nodiscard]] bool none() const { return fixes.empty() && end == FrozenEnd::kNo; }
  // Of so many fixes in all.
  void leave_end_out(std::size_t count);
};

// Of all fixes of a bee, in the order of time. Velocities may be those of all fixes: who says that
// it stands does.
FrozenPlaces frozen_places(const std::vector<Fix>& fixes, const std::vector<Velocity>& velocities,
                           Frame frame);

// The same of fixes that come one after the other; those that go back in time count for nothing.
class FrozenWatch {
 public:
  // Whether the bee jumps to this fix out of such a place, or has left the place by its own
  // velocity, by what came before.
  enum class Now : std::uint8_t { kUsual, kJumps, kLedAway };
  // `number`: how the caller knows the fix again.
  Now take(const Fix& fix, const Velocity* velocity, Frame frame, std::uint64_t number = 0);
  // Once all came: the fix with which a bee jumps out of such a place; nothing where none does.
  [[nodiscard]] std::optional<std::uint64_t> found() const;
  // Of the place where the bee is now, as if its track ended there; it is not one that the bee was
  // led away from.
  [[nodiscard]] FrozenEnd end() const;
  [[nodiscard]] bool is_known() const { return stays_.current().has_value(); }  // some fix came
  [[nodiscard]] double since_s() const {
    return stays_.current() ? stays_.current()->since.time_s : 0.0;
  }

 private:
  // Whether its own velocities have led it there, as far as they tell.
  bool take_own(const Fix& fix, const Velocity* velocity, Frame frame);

  Stays stays_ = {};
  UsualSteps usual_ = {};
  OwnMotion own_ = {};
  std::optional<Fix> last_ = {};
  std::optional<Velocity> velocity_ = {};  // of the last one
  PlaceNoise noise_ = {};
  bool stood_still_ = false;  // at some place before that may have been such, and went on as usual
  std::optional<LeftStay> farthest_ = {};  // out of a place that may be such
  std::uint64_t farthest_number_ = 0;
  std::optional<std::uint64_t> jumped_ = {};  // out of a place where it had said that it stands
  Frame frame_ = Frame::kMetres;
};

// Those whose ends are kPerhaps, to be told in one sentence.
class FrozenEnds {
 public:
  void take(const std::string& id, double since_s) {
    if (bees_++ > 0) return;
    first_ = id;
    since_s_ = since_s;
  }
  [[nodiscard]] std::size_t bees() const { return bees_; }
  [[nodiscard]] double since_s() const { return since_s_; }  // of the first one
  // "bee 'a' and 2 more stop at once ...", with that moment as it is told.
  [[nodiscard]] std::string text(const std::string& since) const;

 private:
  std::size_t bees_ = 0;
  std::string first_;
  double since_s_ = 0.0;
};

}  // namespace beespace::io
