#include "io/recording/frozen_places.hpp"

#include "io/problems/excerpt.hpp"

#include <algorithm>
#include <cmath>

namespace beespace::io {
namespace {

constexpr double kTimesMore = 3.0;
constexpr std::size_t kFewestUsual = 10;  // steps
// What stands says some speed, too: so little is none, nor is so little of the fastest.
constexpr double kMovesAtLeast_mps = 0.1;
constexpr double kMovesOfFastest = 0.05;

constexpr std::size_t kFewestEnds = 4;

FrozenEnd end_at(const Stay& stay, bool stood_still, const PlaceNoise& before, Frame frame) {
  if (!stay.may_be_frozen() || stood_still) return FrozenEnd::kNo;
  const bool at_once = before.stops_at_once();
  // Receivers of satellites may hold a place while they stand, and not always.
  const bool wavered_where_it_stood = frame == Frame::kMetres && before.stood();
  if (before.is_measured() && (at_once || wavered_where_it_stood)) return FrozenEnd::kMeasured;
  return at_once ? FrozenEnd::kPerhaps : FrozenEnd::kNo;
}

}  // namespace

void UsualSteps::take(const LeftStay& left) {
  ++count_;
  farthest_m_ = std::max(farthest_m_, left.metres);
  fastest_mps_ = std::max(fastest_mps_, left.metres / left.seconds);
}

bool UsualSteps::exceeded_by(const LeftStay& left) const {
  return count_ >= kFewestUsual && left.metres > kTimesMore * farthest_m_ &&
         left.metres > kTimesMore * fastest_mps_ * left.seconds;
}

bool UsualSteps::led_away(const Stay& stay) const {
  const double metres = std::hypot(stay.east_m, stay.north_m);
  return count_ >= kFewestUsual && stay.may_be_frozen() && metres > kTimesMore * farthest_m_ &&
         metres > std::max(kMovesAtLeast_mps, kMovesOfFastest * fastest_mps_) * stay.lasted_s();
}

bool ends_are_usual(std::vector<double> since_s, std::size_t bees) {
  if (since_s.size() < kFewestEnds || 2 * since_s.size() <= bees) return false;
  std::sort(since_s.begin(), since_s.end());
  const auto times = std::unique(since_s.begin(), since_s.end()) - since_s.begin();
  return 2 * static_cast<std::size_t>(times) > since_s.size();
}

FrozenPlaces frozen_places(const std::vector<Fix>& fixes, const std::vector<Velocity>& velocities,
                           Frame frame) {
  const auto velocity = [&](std::size_t i) {
    return i < velocities.size() ? &velocities[i] : nullptr;
  };
  // Those that may be such, and their first fix and the one behind.
  struct Doubtful {
    LeftStay left;
    std::size_t begin;
    std::size_t end;
  };
  std::vector<Doubtful> doubtful;
  std::vector<Doubtful> standing;  // by their own word
  OwnMotion own;
  Stays stays;
  UsualSteps usual;
  std::size_t begin = 0;
  for (std::size_t i = 0; i < fixes.size(); ++i) {
    if (i > 0 && i < velocities.size()) {
      own.take(fixes[i - 1], velocity(i - 1), fixes[i], velocity(i), frame);
    }
    const auto over = stays.take(fixes[i], velocity(i), frame);
    if (!over) continue;
    if (over->stay.may_be_frozen()) {
      doubtful.push_back({*over, begin, i});
    } else {
      if (over->stay.is_long()) standing.push_back({*over, begin, i});
      usual.take(*over);
    }
    begin = i;
  }
  FrozenPlaces found;
  const auto leave_out = [&](std::size_t first, std::size_t end) {
    found.fixes.resize(fixes.size());
    std::fill(found.fixes.begin() + static_cast<std::ptrdiff_t>(first + 1),
              found.fixes.begin() + static_cast<std::ptrdiff_t>(end), true);
  };
  bool stood_still = false;
  for (const auto& [at, first, end] : doubtful) {
    if (usual.exceeded_by(at) || usual.led_away(at.stay)) {
      leave_out(first, end);
    } else {
      stood_still = true;
    }
  }
  for (const auto& [at, first, end] : standing) {
    if (own.contradicted_by(fixes[end - 1], velocity(end - 1), fixes[end], velocity(end), frame)) {
      leave_out(first, end);
    }
  }
  const auto& last = stays.current();
  if (!last || !last->may_be_frozen()) return found;
  if (usual.led_away(*last)) {
    leave_out(begin, fixes.size());
    return found;
  }
  if (stood_still) return found;
  PlaceNoise noise;
  for (std::size_t i = 0; i <= begin; ++i) {
    if (i == 0 || !(fixes[i].position == fixes[i - 1].position)) noise.take(fixes[i], frame);
  }
  found.end = end_at(*last, stood_still, noise, frame);
  found.end_begins = begin;
  found.end_since_s = last->since.time_s;
  return found;
}

void FrozenPlaces::leave_end_out(std::size_t count) {
  fixes.resize(count);
  std::fill(fixes.begin() + static_cast<std::ptrdiff_t>(end_begins + 1), fixes.end(), true);
}

FrozenWatch::Now FrozenWatch::take(const Fix& fix, const Velocity* velocity, Frame frame,
                                   std::uint64_t number) {
  frame_ = frame;
  const auto before = stays_.current();
  if (before && !(before->until_s < fix.time_s)) return Now::kUsual;
  const auto over = stays_.take(fix, velocity, frame);
  const bool led_so = take_own(fix, velocity, frame);
  if (!before || over) noise_.take(fix, frame);
  if (!over) return usual_.led_away(*stays_.current()) ? Now::kLedAway : Now::kUsual;
  if (!over->stay.may_be_frozen()) {
    usual_.take(*over);
    if (led_so || !over->stay.is_long()) return Now::kUsual;
    if (!jumped_) jumped_ = number;
    return Now::kJumps;
  }
  if (!farthest_ || over->metres > farthest_->metres) {
    farthest_ = over;
    farthest_number_ = number;
  }
  if (usual_.exceeded_by(*over)) return Now::kJumps;
  stood_still_ = stood_still_ || !usual_.led_away(over->stay);
  return Now::kUsual;
}

bool FrozenWatch::take_own(const Fix& fix, const Velocity* velocity, Frame frame) {
  bool led_so = true;
  if (last_ && velocity_) {
    led_so = !own_.contradicted_by(*last_, &*velocity_, fix, velocity, frame);
    own_.take(*last_, &*velocity_, fix, velocity, frame);
  }
  last_ = fix;
  velocity_ = velocity == nullptr ? std::nullopt : std::optional(*velocity);
  return led_so;
}

std::optional<std::uint64_t> FrozenWatch::found() const {
  if (jumped_) return jumped_;
  if (!farthest_ || !usual_.exceeded_by(*farthest_)) return std::nullopt;
  return farthest_number_;
}

FrozenEnd FrozenWatch::end() const {
  const auto& last = stays_.current();
  return last && !usual_.led_away(*last) ? end_at(*last, stood_still_, noise_, frame_)
                                         : FrozenEnd::kNo;
}

std::string FrozenEnds::text(const std::string& since) const {
  const bool one = bees_ == 1;
  return "bee " + excerpt(first_) + (one ? "" : " and " + std::to_string(bees_ - 1) + " more") +
         (one ? " stops at once, from one fix to the next, and repeats its place exactly to the "
                "end, "
                "since "
              : " stop at once, from one fix to the next, and repeat their places exactly to the "
                "end, the first since ") +
         since + ": if that is said again after " + (one ? "it was" : "they were") + " lost, and " +
         (one ? "it does" : "they do") + " not stand, where " + (one ? "it is" : "they are") +
         " then is not known";
}

}  // namespace beespace::io
