// What times are counted from where dates and times, or times of day, name no time zone.
#pragma once

#include <cstdint>

namespace beespace::io {

struct WallClock {
  bool dated = false;       // whether the day is known
  std::int64_t zero_s = 0;  // the midnight that times are counted from, in seconds since 1970-01-01
                            // 00:00:00 on that clock; 0 where the day is not known

  friend bool operator==(const WallClock&, const WallClock&) = default;
};

}  // namespace beespace::io
