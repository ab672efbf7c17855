#include "io/encounters/air_data.hpp"

#include <algorithm>
#include <cmath>

namespace beespace::io {
namespace {

// At mean sea level, and of dry air.
constexpr double kPressure_Pa = 101'325.0;
constexpr double kTemperature_K = 288.15;
constexpr double kGas = 287.05287;  // J/(kg K)
constexpr double kGravity_mps2 = 9.80665;
constexpr double kLapse_K_m = 0.0065;
constexpr double kTropopause_m = 11'000.0;
constexpr double kRatioOfHeats = 1.4;

struct Air {
  double temperature_k;
  double pressure_pa;
};

Air air_at(double height_m) {
  const double below_m = std::min(height_m, kTropopause_m);
  const double temperature_k = kTemperature_K - kLapse_K_m * below_m;
  const double pressure_pa =
      kPressure_Pa * std::pow(temperature_k / kTemperature_K, kGravity_mps2 / (kGas * kLapse_K_m));
  const double above_m = height_m - below_m;
  return {temperature_k, pressure_pa * std::exp(-kGravity_mps2 * above_m / (kGas * temperature_k))};
}

double speed_of_sound(double temperature_k) {
  return std::sqrt(kRatioOfHeats * kGas * temperature_k);
}

// The Mach number at which the pressure of the flow, compressed without loss, is that much above
// the pressure around it.
double mach_of(double impact_pa, double pressure_pa) {
  return std::sqrt(5.0 * (std::pow(impact_pa / pressure_pa + 1.0, 2.0 / 7.0) - 1.0));
}

}  // namespace

double true_of_calibrated(double calibrated_mps, double height_m) {
  const double at_sea_level = calibrated_mps / speed_of_sound(kTemperature_K);
  const double impact_pa =
      kPressure_Pa * (std::pow(1.0 + 0.2 * at_sea_level * at_sea_level, 3.5) - 1.0);
  return true_of_mach(mach_of(impact_pa, air_at(height_m).pressure_pa), height_m);
}

double true_of_mach(double mach, double height_m) {
  return mach * speed_of_sound(air_at(height_m).temperature_k);
}

}  // namespace beespace::io
