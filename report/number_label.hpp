// Numbers as figures show them: as many digits as tell them apart.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace beespace::report {

// "1,234,567".
std::string count_label(std::uint64_t count);
// "1 pair", "1,234 pairs".
std::string count_label(std::uint64_t count, std::string_view one, std::string_view several);

// With a fixed number of decimals: "\u22121,234.50"; very large ones as "1.2e+15". Never "-0".
std::string decimal_label(double value, int decimals);

// Lengths below this are told in micrometres, as of cells.
inline constexpr double kTiny_m = 1e-4;

// With three digits that count, or all before the point: "0.0571", "57.3", "1,234".
std::string short_label(double value);

// A length with its unit: "0 m", "6 µm", "5 mm", "57.3 m", "12.4 km".
std::string length_label(double metres);

// The same for lists: to a millimetre below 100 m.
std::string listed_length(double metres);

// The same two of a length below the limit: with as many more digits as it takes to say so, as
// "99.9996 m" below 100 m. Lengths that are not below it are as above.
std::string length_label_below(double limit_m, double metres);
std::string listed_length_below(double limit_m, double metres);

// Hours, minutes and seconds since midnight, or since a beginning: "12:03", "12:03:30" where a
// step of so many seconds needs it, "12:03:30.5".
std::string clock_label(double seconds, double step_s);

// The day in UTC: "2024-05-01"; nothing beyond the years 0 to 9999.
std::string date_label(double since_1970_s);
// The instant in UTC: "2024-05-01T12:03:30.25Z", as KML and CZML want it.
std::string instant_label(double since_1970_s);

}  // namespace beespace::report
