#include "io/recording/frozen_places.hpp"

#include "io/recording/flat_distance.hpp"

#include <algorithm>
#include <cmath>

namespace beespace::io {
namespace {

constexpr double kTimesMore = 3.0;
constexpr std::size_t kFewestUsual = 10;  // steps

// Shorter repetitions are bridged by a straight line, as missing records are.
constexpr std::size_t kManyFixes = 10;
constexpr std::size_t kFewestFixes = 6;  // where they last long
constexpr double kLong_s = 3.0;

bool may_be_frozen(std::size_t fixes, double lasted_s) {
  return fixes >= kManyFixes || (fixes >= kFewestFixes && lasted_s >= kLong_s);
}

// Zero may also mean that no speed is known: then it is not said that the bee moves, either.
bool says_that_it_stands(const Velocity& velocity) {
  return velocity.x == 0.0 && velocity.y == 0.0 && !(std::abs(velocity.z) > 0.0);
}

// Fixes [begin, end) are at one place.
struct Stay {
  std::size_t begin;
  std::size_t end;
  bool may_be_frozen;
};

std::vector<Stay> stays_of(const std::vector<Fix>& fixes, const std::vector<Velocity>& velocities) {
  std::vector<Stay> stays;
  for (std::size_t begin = 0; begin < fixes.size();) {
    std::size_t end = begin;
    bool stands = false;
    for (; end < fixes.size() && fixes[end].position == fixes[begin].position; ++end) {
      stands = stands || (end < velocities.size() && says_that_it_stands(velocities[end]));
    }
    const double lasted_s = fixes[end - 1].time_s - fixes[begin].time_s;
    stays.push_back({begin, end, !stands && may_be_frozen(end - begin, lasted_s)});
    begin = end;
  }
  return stays;
}

}  // namespace

void UsualSteps::take(double metres, double seconds) {
  ++count_;
  farthest_m_ = std::max(farthest_m_, metres);
  fastest_mps_ = std::max(fastest_mps_, metres / seconds);
}

bool UsualSteps::exceeded_by(double metres, double seconds) const {
  return count_ >= kFewestUsual && metres > kTimesMore * farthest_m_ &&
         metres > kTimesMore * fastest_mps_ * seconds;
}

std::vector<bool> frozen_places(const std::vector<Fix>& fixes,
                                const std::vector<Velocity>& velocities, Frame frame) {
  const std::vector<Stay> stays = stays_of(fixes, velocities);
  if (std::none_of(stays.begin(), stays.end(), [](const Stay& stay) { return stay.may_be_frozen; }))
    return {};
  // From the last fix of a stay to the next; the last stay has none.
  const auto step = [&](const Stay& stay, auto&& use) {
    if (stay.end == fixes.size()) return;
    const Fix& from = fixes[stay.end - 1];
    const Fix& to = fixes[stay.end];
    use(flat_distance_m(from.position, to.position, frame), to.time_s - from.time_s);
  };
  UsualSteps usual;
  for (const Stay& stay : stays) {
    if (stay.may_be_frozen) continue;
    step(stay, [&](double metres, double seconds) { usual.take(metres, seconds); });
  }
  std::vector<bool> frozen;
  for (const Stay& stay : stays) {
    if (!stay.may_be_frozen) continue;
    step(stay, [&](double metres, double seconds) {
      if (!usual.exceeded_by(metres, seconds)) return;
      frozen.resize(fixes.size());
      std::fill(frozen.begin() + static_cast<std::ptrdiff_t>(stay.begin + 1),
                frozen.begin() + static_cast<std::ptrdiff_t>(stay.end), true);
    });
  }
  return frozen;
}

bool FrozenWatch::take(const Fix& fix, const Velocity* velocity, Frame frame,
                       std::uint64_t number) {
  const bool stands = velocity != nullptr && says_that_it_stands(*velocity);
  if (since_ && !(last_s_ < fix.time_s)) return false;
  bool frozen = false;
  if (since_ && since_->position == fix.position) {
    ++fixes_;
    stands_ = stands_ || stands;
  } else {
    if (since_) {
      const double metres = flat_distance_m(since_->position, fix.position, frame);
      const double seconds = fix.time_s - last_s_;
      if (stands_ || !may_be_frozen(fixes_, last_s_ - since_->time_s)) {
        usual_.take(metres, seconds);
      } else {
        frozen = usual_.exceeded_by(metres, seconds);
        if (!farthest_ || metres > farthest_->metres) farthest_ = Jump{metres, seconds, number};
      }
    }
    since_ = fix;
    fixes_ = 1;
    stands_ = stands;
  }
  last_s_ = fix.time_s;
  return frozen;
}

std::optional<std::uint64_t> FrozenWatch::found() const {
  if (!farthest_ || !usual_.exceeded_by(farthest_->metres, farthest_->seconds)) return std::nullopt;
  return farthest_->number;
}

}  // namespace beespace::io
