#include "io/recording/stays.hpp"

#include "io/recording/flat_distance.hpp"

#include <cmath>

namespace beespace::io {
namespace {

constexpr std::size_t kManyFixes = 10;
constexpr std::size_t kFewestFixes = 6;  // where they last long
constexpr double kLong_s = 3.0;
// From one fix to another farther apart in time a velocity says little.
constexpr double kVelocityLasts_s = 60.0;

// Zero may also mean that no speed is known: then it is not said that the bee moves, either.
bool says_that_it_stands(const Velocity* velocity) {
  return velocity != nullptr && velocity->x == 0.0 && velocity->y == 0.0 &&
         !(std::abs(velocity->z) > 0.0);
}

Velocity over_ground(const Velocity* velocity) {
  const bool known =
      velocity != nullptr && std::isfinite(velocity->x) && std::isfinite(velocity->y);
  return known ? Velocity{velocity->x, velocity->y, 0.0} : Velocity{0.0, 0.0, 0.0};
}

}  // namespace

bool Stay::is_long() const {
  return fixes >= kManyFixes || (fixes >= kFewestFixes && lasted_s() >= kLong_s);
}

std::optional<LeftStay> Stays::take(const Fix& fix, const Velocity* velocity, Frame frame) {
  if (current_ && !(current_->until_s < fix.time_s)) return std::nullopt;
  const Velocity moves = over_ground(velocity);
  std::optional<LeftStay> left;
  if (current_ && current_->since.position == fix.position) {
    const double seconds = fix.time_s - current_->until_s;
    if (seconds <= kVelocityLasts_s) {
      current_->east_m += (velocity_.x + moves.x) / 2.0 * seconds;
      current_->north_m += (velocity_.y + moves.y) / 2.0 * seconds;
    }
  } else {
    if (current_) {
      left = {*current_, flat_distance_m(current_->since.position, fix.position, frame),
              fix.time_s - current_->until_s};
    }
    current_ = Stay{fix, fix.time_s};
  }
  current_->until_s = fix.time_s;
  ++current_->fixes;
  current_->stands = current_->stands || says_that_it_stands(velocity);
  velocity_ = moves;
  return left;
}

}  // namespace beespace::io
