#include "analysis/recorded/unknown_around.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>

namespace beespace::analysis {
namespace {

// Those of that bee, ascending; none overlap.
std::span<const Gap> spans_of(PointId bee, const std::vector<Gap>& spans) {
  const auto first = std::partition_point(spans.begin(), spans.end(),
                                          [bee](const Gap& span) { return span.track < bee; });
  const auto last = std::partition_point(first, spans.end(),
                                         [bee](const Gap& span) { return span.track == bee; });
  return {first, last};
}

// Whether one of them is that moment's, or all that comes just before it, or just after it.
bool covers_before(std::span<const Gap> spans, double time_s) {
  const auto last = std::partition_point(
      spans.begin(), spans.end(), [time_s](const Gap& span) { return span.ends_s < time_s; });
  return last != spans.end() && last->begins_s < time_s;
}

bool covers_after(std::span<const Gap> spans, double time_s) {
  const auto first = std::partition_point(
      spans.begin(), spans.end(), [time_s](const Gap& span) { return span.ends_s <= time_s; });
  return first != spans.end() && first->begins_s <= time_s;
}

}  // namespace

UnknownAround unknown_around(const Conflict& conflict, const std::vector<Gap>& unknown) {
  UnknownAround around;
  for (const PointId bee : {conflict.first, conflict.second}) {
    const auto spans = spans_of(bee, unknown);
    around.before = around.before || covers_before(spans, conflict.begins_s);
    around.after = around.after || covers_after(spans, conflict.ends_s);
  }
  return around;
}

double unknown_of_pair_s(PointId first, PointId second, const std::vector<Gap>& unknown) {
  const auto some = spans_of(first, unknown);
  const auto others = spans_of(second, unknown);
  double total_s = 0.0;
  double covered_until_s = -std::numeric_limits<double>::infinity();
  std::size_t next = 0;
  std::size_t next_other = 0;
  while (next < some.size() || next_other < others.size()) {
    const bool of_other =
        next == some.size() ||
        (next_other < others.size() && others[next_other].begins_s < some[next].begins_s);
    const Gap& span = of_other ? others[next_other++] : some[next++];
    const double from_s = std::max(span.begins_s, covered_until_s);
    if (span.ends_s > from_s) total_s += span.ends_s - from_s;
    covered_until_s = std::max(covered_until_s, span.ends_s);
  }
  return total_s;
}

}  // namespace beespace::analysis
