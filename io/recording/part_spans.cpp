#include "io/recording/part_spans.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace beespace::io {

void PartSpans::take(std::string_view group, std::string_view part, double time_s, Origin origin) {
  if (last_ >= spans_.size() || spans_[last_].part != part || spans_[last_].group != group) {
    // Neither has a byte 0: that is no text.
    key_.assign(group).append(1, '\0').append(part);
    const auto [at, added] = index_.try_emplace(key_, spans_.size());
    last_ = at->second;
    if (added) spans_.push_back({std::string(group), std::string(part), time_s, time_s, origin});
  }
  PartSpan& span = spans_[last_];
  span.first_s = std::min(span.first_s, time_s);
  span.last_s = std::max(span.last_s, time_s);
}

std::optional<std::pair<PartSpan, PartSpan>> PartSpans::overlapping() const {
  std::vector<std::size_t> order(spans_.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [this](std::size_t a, std::size_t b) {
    return std::tie(spans_[a].group, spans_[a].first_s, a) <
           std::tie(spans_[b].group, spans_[b].first_s, b);
  });
  std::size_t latest = 0;  // of those of the group so far, in `order`
  for (std::size_t i = 1; i < order.size(); ++i) {
    const PartSpan& before = spans_[order[latest]];
    const PartSpan& here = spans_[order[i]];
    const bool same_group = before.group == here.group;
    if (same_group && (here.first_s < before.last_s || here.first_s == before.first_s)) {
      const auto [first, second] = std::minmax(order[latest], order[i]);
      return std::pair(spans_[first], spans_[second]);
    }
    latest = i;
  }
  return std::nullopt;
}

}  // namespace beespace::io
