#include "io/recording/stated_accuracy.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace beespace::io {
namespace {

constexpr double kLeastOff_m = 0.1;  // all that is less is one
constexpr double kRatioOfSteps = 1.1;

double in_two_digits_above(double value) {
  const double unit = std::pow(10.0, std::floor(std::log10(value)) - 1.0);
  return std::ceil(value / unit) * unit;
}

}  // namespace

void AccuracyGathering::take(std::string_view id, double off_m, std::string_view column) {
  if (column_.empty()) column_ = column;
  const double above =
      std::log(std::max(off_m, kLeastOff_m) / kLeastOff_m) / std::log(kRatioOfSteps);
  const double step = std::min(above, static_cast<double>(kSteps - 1));
  ++counts_[std::string(id)][static_cast<std::size_t>(step)];
}

StatedAccuracy AccuracyGathering::found() const {
  StatedAccuracy found{column_, {}};
  found.medians_m.reserve(counts_.size());
  for (const auto& [id, counts] : counts_) {
    std::uint64_t all = 0;
    for (const std::uint32_t count : counts) all += count;
    std::uint64_t below = 0;
    double upper_m = kLeastOff_m;
    for (const std::uint32_t count : counts) {
      upper_m *= kRatioOfSteps;
      below += count;
      if (2 * below >= all) break;
    }
    found.medians_m.push_back(in_two_digits_above(upper_m));
  }
  return found;
}

}  // namespace beespace::io
