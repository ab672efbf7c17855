#include "fleet/loop_needs.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace beespace::fleet {

namespace {

// More than all roundings of the few operations below together, relatively.
constexpr double kRoundedUp = 1.0 + 0x1p-40;

// A loop that takes more than this of a deviation away in a period is next to one that does so in
// two periods flat: it gains little, and its gain grows beyond bounds.
constexpr double kGreatestShare = 0.9375;

constexpr double kE = std::numbers::e;

// (1 - share)^count, for counts of zero and more.
double left_after(double share, double count) {
  return std::exp(count * std::log1p(-share));
}

// The greatest of m (1 - share)^(m - 1), m = 1, 2, ...: it rises up to m = 1/share, and then falls.
// The neighbours are looked at as well: so the rounding of 1/share does no harm.
double greatest_velocity(double share) {
  double greatest = 1.0;
  for (const double beside : {-1.0, 0.0, 1.0}) {
    const double m = std::max(1.0, std::floor(1.0 / share) + beside);
    greatest = std::max(greatest, m * left_after(share, m - 1.0));
  }
  return greatest;
}

// The greatest of (1 - share)^(m - 2) (m share - 1), m = 2, 3, ...: up to m = 2/share.
double greatest_return(double share) {
  double greatest = 0.0;
  for (const double beside : {-1.0, 0.0, 1.0}) {
    const double m = std::max(2.0, std::floor(2.0 / share) + beside);
    greatest = std::max(greatest, left_after(share, m - 2.0) * (m * share - 1.0));
  }
  return greatest;
}

bool are_met(const LoopNeeds& needs, double most_mps, double most_mps2) {
  return needs.speed_mps <= most_mps && needs.thrust_mps2 <= most_mps2;
}

LoopNeeds rounded_up(double radius_m, double speed_mps, double thrust_mps2) {
  return {radius_m * kRoundedUp, speed_mps, thrust_mps2 * kRoundedUp};
}

// The speed is the deviation's, exactly, where there is no error: so that a reserve of as much is
// enough.
double speed_of(double deviation_mps, double for_error_mps) {
  return for_error_mps > 0.0 ? (deviation_mps + for_error_mps) * kRoundedUp : deviation_mps;
}

}  // namespace

LoopNeeds continuous_needs(double gain_per_s, const LoopBurden& burden) {
  const double k = gain_per_s;
  const double for_error_mps = 2.0 / kE * k * burden.error_m;
  return rounded_up(
      2.0 * burden.deviation_mps / k + burden.error_m,
      speed_of(burden.deviation_mps, for_error_mps),
      2.0 / kE * k * burden.deviation_mps + 2.0 * (1.0 + 1.0 / (kE * kE)) * k * k * burden.error_m);
}

LoopNeeds sampled_needs(double share, double period_s, const LoopBurden& burden) {
  const double peak = 2.0 * share * share * greatest_velocity(share) / period_s;
  const double swing = 2.0 * share * share * (1.0 + greatest_return(share)) / (period_s * period_s);
  return rounded_up(burden.deviation_mps * period_s * (2.0 / share - 0.5) + burden.error_m,
                    speed_of(burden.deviation_mps, peak * burden.error_m),
                    peak * burden.deviation_mps + swing * burden.error_m);
}

double fastest_continuous(const LoopBurden& burden, double most_mps, double most_mps2) {
  constexpr double kRoundedDown = 1.0 - 0x1p-38;
  // The acceleration is a quadratic function of k, the speed a linear one.
  const double linear = 2.0 / kE * burden.deviation_mps;
  const double square = 2.0 * (1.0 + 1.0 / (kE * kE)) * burden.error_m;
  double k = 2.0 * most_mps2 / (linear + std::sqrt(linear * linear + 4.0 * square * most_mps2));
  if (burden.error_m > 0.0) {
    k = std::min(k, (most_mps - burden.deviation_mps) * kE / (2.0 * burden.error_m));
  }
  k *= kRoundedDown;
  return k > 0.0 && are_met(continuous_needs(k, burden), most_mps, most_mps2) ? k : 0.0;
}

double fastest_sampled(double period_s, const LoopBurden& burden, double most_mps,
                       double most_mps2) {
  const auto met = [&](double share) {
    return are_met(sampled_needs(share, period_s, burden), most_mps, most_mps2);
  };
  if (met(kGreatestShare)) return kGreatestShare;
  double fails = kGreatestShare;
  double holds = 0.5 * fails;
  while (!met(holds)) {
    fails = holds;
    holds *= 0.5;
    if (holds < 0x1p-40) return 0.0;
  }
  for (double middle = 0.5 * (holds + fails); middle > holds && middle < fails;
       middle = 0.5 * (holds + fails)) {
    (met(middle) ? holds : fails) = middle;
  }
  return holds;
}

}  // namespace beespace::fleet
