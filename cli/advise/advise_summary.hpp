// What came of `beespace advise`, for people.
#pragma once

#include "cli/advise/advise_output.hpp"

#include <string>

namespace beespace::cli {

struct AdviseTimes {
  double read_s = 0.0;
  double advise_s = 0.0;
};

std::string advise_summary(const AdviceAnswer& answer, const AdviseTimes& times);

}  // namespace beespace::cli
