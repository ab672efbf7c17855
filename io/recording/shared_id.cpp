#include "io/recording/shared_id.hpp"

#include "io/recording/flat_distance.hpp"

#include <algorithm>
#include <cmath>

namespace beespace::io {
namespace {

constexpr double kApart = 4.0;

bool jumps(const Fix& before, const Fix& at, const Fix& after, Frame frame) {
  const double there_m = flat_distance_m(before.position, at.position, frame);
  const double back_m = flat_distance_m(at.position, after.position, frame);
  if (!(kApart * flat_distance_m(before.position, after.position, frame) <=
        std::min(there_m, back_m))) {
    return false;
  }
  const double there_s = at.time_s - before.time_s;
  const double back_s = after.time_s - at.time_s;
  const double turn_mps2 = 2.0 * (there_m / there_s + back_m / back_s) / (there_s + back_s);
  return turn_mps2 > SharedId::kImpossible_mps2;
}

}  // namespace

void SharedId::take(const Fix& fix, Frame frame) {
  const std::uint64_t number = taken_++;
  if (found_ || (kept_ > 0 && !(fix.time_s > last_.time_s))) return;
  if (kept_ >= 2) {
    if (weight_ == 0.0) began_ = number - 1;
    weigh(jumps(before_, last_, fix, frame));
  }
  const auto first = mixture_.take(fix, number, frame);
  if (!found_) found_ = first;
  before_ = last_;
  last_ = fix;
  ++kept_;
}

// Two that report in turn, of whose reports some are lost, jump at 85 of 100; a coin at 50.
void SharedId::weigh(bool jumps) {
  const double by_two = jumps ? 0.85 : 0.15;
  weight_ = std::max(weight_ + std::log(by_two / 0.5), 0.0);
  constexpr double kRarely = 1000.0;
  if (weight_ > std::log(kRarely * static_cast<double>(kept_))) found_ = began_;
}

}  // namespace beespace::io
