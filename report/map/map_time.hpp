// Times as globes want them: dates, also of recordings that have none.
#pragma once

#include "report/number_label.hpp"

#include <algorithm>
#include <string>

namespace beespace::report {

// Said where seconds do not count from 1970.
inline constexpr const char* kTimeNote =
    "Times are the recording's seconds, shown as if they counted from 1970-01-01T00:00:00Z.";

// Times before the year 0 and after 9999 are shown as these.
inline std::string map_instant(double time_s) {
  return instant_label(std::clamp(time_s, -62'167'219'200.0, 253'402'300'799.0));
}

}  // namespace beespace::report
