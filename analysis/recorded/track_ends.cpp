#include "analysis/recorded/track_ends.hpp"

#include <algorithm>
#include <cstddef>

namespace beespace::analysis {
namespace {

// Puts a fix among those that come first by `before`; returns how many there are then.
template <typename Before>
std::size_t keep(std::array<Fix, 2>& kept, std::size_t count, const Fix& fix, Before before) {
  for (std::size_t i = 0; i < count; ++i) {
    if (kept[i].time_s == fix.time_s) return count;
  }
  if (count == 0 || before(fix.time_s, kept[0].time_s)) {
    if (count > 0) kept[1] = kept[0];
    kept[0] = fix;
  } else if (count == 1 || before(fix.time_s, kept[1].time_s)) {
    kept[1] = fix;
  } else {
    return count;
  }
  return std::min<std::size_t>(count + 1, kept.size());
}

}  // namespace

void TrackEnds::add(std::size_t bee, const Fix& fix) {
  if (bee >= ends_.size()) ends_.resize(bee + 1);
  Ends& ends = ends_[bee];
  keep(ends.last, ends.count, fix, [](double a, double b) { return a > b; });
  ends.count = keep(ends.first, ends.count, fix, [](double a, double b) { return a < b; });
}

std::vector<Fix> TrackEnds::of(std::size_t bee) const {
  if (bee >= ends_.size()) return {};
  const Ends& ends = ends_[bee];
  std::vector<Fix> fixes(ends.first.begin(),
                         ends.first.begin() + static_cast<std::ptrdiff_t>(ends.count));
  for (std::size_t i = ends.count; i > 0; --i) {
    const Fix& fix = ends.last[i - 1];
    if (fix.time_s > fixes.back().time_s) fixes.push_back(fix);
  }
  return fixes;
}

}  // namespace beespace::analysis
