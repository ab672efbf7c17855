// From the speeds that pilots are told to those through the air, in the standard atmosphere (ISO
// 2533) up to 20 km.
#pragma once

namespace beespace::io {

inline constexpr double kHighestAir_m = 20'000.0;

// The true airspeed of a calibrated one, and of a Mach number, at a height from -1,000 m to
// kHighestAir_m.
double true_of_calibrated(double calibrated_mps, double height_m);
double true_of_mach(double mach, double height_m);

}  // namespace beespace::io
