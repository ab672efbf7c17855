#include "io/recording/one_clock_note.hpp"

#include "io/bytes/number_text.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace beespace::io {

std::optional<std::string> one_clock_note(std::span<const TimeSpan> files,
                                          const std::string& shift) {
  constexpr double kTogether_s = 1.0;
  constexpr std::size_t kMostNamed = 4;
  std::vector<TimeSpan> spans(files.begin(), files.end());
  std::sort(spans.begin(), spans.end(),
            [](const TimeSpan& a, const TimeSpan& b) { return a.begins_s < b.begins_s; });
  if (spans.empty() || spans.back().begins_s - spans.front().begins_s <= kTogether_s) {
    return std::nullopt;
  }
  double until_s = spans.front().ends_s;
  bool beside = false;
  for (std::size_t i = 1; i < spans.size(); ++i) {
    beside = beside || spans[i].begins_s < until_s;
    until_s = std::max(until_s, spans[i].ends_s);
  }
  if (!beside) return std::nullopt;
  std::string begins;
  if (spans.size() <= kMostNamed) {
    for (std::size_t i = 0; i < spans.size(); ++i) {
      begins += i == 0 ? "" : i + 1 == spans.size() ? " and " : ", ";
      begins += exact(spans[i].begins_s);
    }
  } else {
    begins = "from " + exact(spans.front().begins_s) + " to " + exact(spans.back().begins_s);
  }
  std::string text = "the times of these " + std::to_string(spans.size()) +
                     " files are taken for one clock (they begin at " + begins +
                     " s): where each has its own, as from when a vehicle was switched on, the "
                     "answer is wrong; add to those of one what its clock is behind";
  if (!shift.empty()) text.append(", as by ").append(shift);
  return text + " (--one-clock: they have one)";
}

}  // namespace beespace::io
