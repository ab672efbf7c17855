#include "io/recording/coasting.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

namespace beespace::io {
namespace {

// Between two records of a bee, of which some may say the same fix; nothing of one fix.
std::optional<double> record_interval_s(const RecordedBee& bee) {
  const std::vector<Fix>& fixes = bee.fixes;
  if (fixes.size() < 2) return std::nullopt;
  std::vector<double> steps_s;
  steps_s.reserve(fixes.size() - 1);
  for (std::size_t i = 1; i < fixes.size(); ++i) {
    steps_s.push_back(fixes[i].time_s - fixes[i - 1].time_s);
  }
  const auto middle = steps_s.begin() + static_cast<std::ptrdiff_t>(steps_s.size() / 2);
  std::nth_element(steps_s.begin(), middle, steps_s.end());
  const double again = static_cast<double>(bee.repeats - bee.repeats_of_last);
  return *middle / (1.0 + again / static_cast<double>(fixes.size() - 1));
}

// The longest of all: for those of one fix, which tell none of their own.
double longest_interval_s(const std::vector<RecordedBee>& bees) {
  double longest_s = 0.0;
  for (const RecordedBee& bee : bees) {
    longest_s = std::max(longest_s, record_interval_s(bee).value_or(0.0));
  }
  return longest_s;
}

double last_fix_s(const std::vector<RecordedBee>& bees) {
  double last_s = -std::numeric_limits<double>::infinity();
  for (const RecordedBee& bee : bees) {
    if (!bee.fixes.empty()) last_s = std::max(last_s, bee.fixes.back().time_s);
  }
  return last_s;
}

}  // namespace

void lose_coasting(std::vector<RecordedBee>& bees) {
  const double end_s = last_fix_s(bees);
  std::optional<double> otherwise_s;
  for (RecordedBee& bee : bees) {
    if (bee.repeats_of_last == 0 || bee.fixes.empty()) continue;
    std::optional<double> interval_s = record_interval_s(bee);
    if (!interval_s) {
      if (!otherwise_s) otherwise_s = longest_interval_s(bees);
      interval_s = otherwise_s;
    }
    const double last_s = bee.fixes.back().time_s;
    const double until_s =
        std::min(end_s, last_s + static_cast<double>(bee.repeats_of_last) * *interval_s);
    if (!(until_s > last_s)) continue;
    bee.unplaced_until_s = std::max(until_s, bee.unplaced_until_s.value_or(until_s));
  }
}

}  // namespace beespace::io
