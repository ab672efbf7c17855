#include "io/tracks/excel_days.hpp"

#include "io/bytes/number.hpp"

#include <cmath>
#include <string_view>

namespace beespace::io {

bool may_be_excel_days(const FirstFields& times) {
  constexpr double kEarliest = 20'000.0;
  constexpr double kLatest = 80'000.0;
  bool fraction = false;
  for (const std::string_view time : times.texts) {
    double value = 0.0;
    if (parse_number(time, value) != NumberKind::kNumber) return false;
    if (!(value >= kEarliest && value < kLatest)) return false;
    fraction = fraction || value != std::floor(value);
  }
  return fraction;
}

}  // namespace beespace::io
