#include "report/separation_words.hpp"

#include "report/number_label.hpp"

#include <cmath>

namespace beespace::report {
namespace {

constexpr AxisUnit kMile{1852.0, "NM"};
constexpr AxisUnit kFoot{0.3048, "ft"};

// With as many more decimals as it takes to be below a limit that it is below.
std::string in_unit(double metres, double limit_m, const AxisUnit& unit, int decimals) {
  constexpr int kMostDecimals = 9;
  const double value = metres / unit.metres;
  if (metres < limit_m) {
    const auto rounded = [value](int places) {
      const double power = std::pow(10.0, places);
      return std::round(value * power) / power;
    };
    while (decimals < kMostDecimals && !(rounded(decimals) < limit_m / unit.metres)) ++decimals;
  }
  return decimal_label(value, decimals) + " " + unit.name;
}

bool is_known(const std::optional<Apart>& apart) {
  return apart && std::isfinite(apart->horizontal_m) && std::isfinite(apart->height_m);
}

}  // namespace

AxisUnit distance_unit(const SwarmFacts& swarm) {
  if (!swarm.aviation) return {};
  return swarm.threshold_m >= kMile.metres ? kMile : kFoot;
}

AxisUnit height_unit(const SwarmFacts& swarm) {
  return swarm.aviation ? kFoot : AxisUnit{};
}

std::string distance_words(const SwarmFacts& swarm, double metres) {
  if (!swarm.aviation) return length_label_below(swarm.threshold_m, metres);
  const AxisUnit unit = distance_unit(swarm);
  const double value = metres / unit.metres;
  const bool whole = value == std::round(value);
  return in_unit(metres, swarm.threshold_m, unit, whole || unit.metres < 1.0 ? 0 : 2);
}

std::string height_words(const SwarmFacts& swarm, double metres) {
  const double limit_m = swarm.vertical_m.value_or(0.0);
  return swarm.aviation ? in_unit(metres, limit_m, kFoot, 0) : length_label_below(limit_m, metres);
}

std::string apart_words(const SwarmFacts& swarm, double metres, const std::optional<Apart>& apart) {
  if (!swarm.vertical_m || !is_known(apart)) return distance_words(swarm, metres);
  return distance_words(swarm, apart->horizontal_m) + " across, " +
         height_words(swarm, apart->height_m) + " in height";
}

std::string listed_apart(const SwarmFacts& swarm, double metres,
                         const std::optional<Apart>& apart) {
  if (!swarm.vertical_m || !is_known(apart)) {
    return swarm.aviation ? distance_words(swarm, metres)
                          : listed_length_below(swarm.threshold_m, metres);
  }
  if (swarm.aviation) {
    return distance_words(swarm, apart->horizontal_m) + ", " + height_words(swarm, apart->height_m);
  }
  return listed_length_below(swarm.threshold_m, apart->horizontal_m) + " across, " +
         listed_length_below(*swarm.vertical_m, apart->height_m) + " in height";
}

}  // namespace beespace::report
