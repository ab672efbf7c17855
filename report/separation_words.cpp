#include "report/separation_words.hpp"

#include "io/bytes/number_text.hpp"
#include "report/number_label.hpp"

#include <cmath>

namespace beespace::report {
namespace {

constexpr AxisUnit kMile{1852.0, "NM"};
constexpr AxisUnit kFoot{0.3048, "ft"};
constexpr AxisUnit kKilometre{1e3, "km"};
constexpr AxisUnit kMillimetre{1e-3, "mm"};
constexpr AxisUnit kMicrometre{1e-6, "\u00B5m"};
constexpr double kSmall_m = 0.1;  // what is shorter is told in millimetres
constexpr double kLongInMicrometres_m = 0.01;
constexpr double kLongInMillimetres_m = 10.0;

// By a rounding of instants since 1970.
bool is_just_under(double metres, double limit_m) {
  constexpr double kNothing = 1e-7;  // of the limit
  return metres < limit_m && metres > limit_m - kNothing * limit_m;
}

// With as many more decimals as it takes to be below a limit that it is below.
std::string in_unit(double metres, double limit_m, const AxisUnit& unit, int decimals) {
  constexpr int kMostDecimals = 9;
  const double value = metres / unit.metres;
  if (is_just_under(metres, limit_m)) {
    return "just under " + decimal_label(limit_m / unit.metres, decimals) + " " + unit.name;
  }
  if (metres < limit_m) {
    const auto rounded = [value](int places) {
      const double power = std::pow(10.0, places);
      return std::round(value * power) / power;
    };
    while (decimals < kMostDecimals && !(rounded(decimals) < limit_m / unit.metres)) ++decimals;
  }
  return decimal_label(value, decimals) + " " + unit.name;
}

// What is less than one of a small unit has two digits that say something.
int small_decimals(double metres, const AxisUnit& unit) {
  int decimals = 1;
  for (double least = 1.0; decimals < 5 && metres / unit.metres < least; ++decimals) least /= 10.0;
  return metres > 0.0 ? decimals : 1;
}

AxisUnit metric_unit(double limit_m) {
  return limit_m < kTiny_m ? kMicrometre : limit_m < kSmall_m ? kMillimetre : AxisUnit{};
}

bool is_known(const std::optional<Apart>& apart) {
  return apart && std::isfinite(apart->horizontal_m) && std::isfinite(apart->height_m);
}

}  // namespace

AxisUnit distance_unit(const SwarmFacts& swarm) {
  if (!swarm.aviation) return metric_unit(swarm.threshold_m);
  return swarm.threshold_m >= kMile.metres ? kMile : kFoot;
}

AxisUnit height_unit(const SwarmFacts& swarm) {
  if (swarm.aviation) return kFoot;
  return metric_unit(swarm.vertical_m.value_or(swarm.threshold_m));
}

AxisUnit axis_unit(const SwarmFacts& swarm, double length_m) {
  if (swarm.aviation) return length_m >= 5.0 * kMile.metres ? kMile : distance_unit(swarm);
  if (length_m >= 20.0 * kKilometre.metres) return kKilometre;
  if (length_m >= kLongInMillimetres_m) return AxisUnit{};
  const AxisUnit unit = distance_unit(swarm);
  return unit.metres == kMicrometre.metres && length_m >= kLongInMicrometres_m ? kMillimetre : unit;
}

std::string distance_words(const SwarmFacts& swarm, double metres) {
  if (!swarm.aviation) return length_label_below(swarm.threshold_m, metres);
  const AxisUnit unit = distance_unit(swarm);
  const double value = metres / unit.metres;
  const bool whole = value == std::round(value);
  const int decimals =
      unit.metres < 1.0 ? io::decimals_around(swarm.threshold_m / kFoot.metres) : 2;
  return in_unit(metres, swarm.threshold_m, unit, whole ? 0 : decimals);
}

std::string height_words(const SwarmFacts& swarm, double metres) {
  const double limit_m = swarm.vertical_m.value_or(0.0);
  if (!swarm.aviation) return length_label_below(limit_m, metres);
  const double value = metres / kFoot.metres;
  return in_unit(metres, limit_m, kFoot,
                 value == std::round(value) ? 0 : io::decimals_around(limit_m / kFoot.metres));
}

std::string apart_words(const SwarmFacts& swarm, double metres, const std::optional<Apart>& apart,
                        bool keep_apart) {
  const auto told = [keep_apart](double length_m, double limit_m) {
    return keep_apart && is_just_under(length_m, limit_m) ? limit_m : length_m;
  };
  if (!swarm.vertical_m || !is_known(apart)) {
    return distance_words(swarm, told(metres, swarm.threshold_m));
  }
  return distance_words(swarm, told(apart->horizontal_m, swarm.threshold_m)) + " across, " +
         height_words(swarm, told(apart->height_m, *swarm.vertical_m)) + " in height";
}

std::string listed_apart(const SwarmFacts& swarm, double metres,
                         const std::optional<Apart>& apart) {
  if (!swarm.vertical_m || !is_known(apart)) {
    if (swarm.aviation) return distance_words(swarm, metres);
    const AxisUnit unit = distance_unit(swarm);
    return unit.metres < 1.0
               ? in_unit(metres, swarm.threshold_m, unit, small_decimals(metres, unit))
               : listed_length_below(swarm.threshold_m, metres);
  }
  if (swarm.aviation) {
    return distance_words(swarm, apart->horizontal_m) + ", " + height_words(swarm, apart->height_m);
  }
  return listed_length_below(swarm.threshold_m, apart->horizontal_m) + " across, " +
         listed_length_below(*swarm.vertical_m, apart->height_m) + " in height";
}

// A drone has landed by its own word; of an aircraft it is known that it stands, and not where.
const char* with_one_standing(const SwarmFacts& swarm) {
  return swarm.noun.one == "aircraft" ? ", with one that stands still" : ", with one on the ground";
}

const char* closest_of_moving(const SwarmFacts& swarm) {
  return swarm.noun.one == "aircraft" ? "closest while both move" : "closest in the air";
}

}  // namespace beespace::report
