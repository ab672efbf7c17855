#include "c/motion/fixes.hpp"

#include "c/door/door.hpp"
#include "c/door/points.hpp"
#include "c/door/structs.hpp"

#include <beespace/mover.hpp>
#include <beespace/points_view.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>

namespace beespace::c {

namespace {

constexpr std::size_t kFixesBetweenStops = 4096;

// One number a fix, of any stride.
template <class Number>
class NumberColumn {
 public:
  NumberColumn(const Number* first, std::ptrdiff_t stride) : first_(first), stride_(stride) {}

  // What is wrong with it, if anything is.
  [[nodiscard]] const char* problem(std::size_t size) const {
    if (first_ == nullptr) return "this is NULL, but there are positions";
    constexpr auto kAlignment = static_cast<std::ptrdiff_t>(alignof(Number));
    if (!is_aligned(first_) || (size > 1 && stride_ % kAlignment != 0)) {
      return "these are not aligned as their type is: copy them first";
    }
    const std::ptrdiff_t farthest =
        std::numeric_limits<std::ptrdiff_t>::max() / static_cast<std::ptrdiff_t>(size);
    const bool beyond = stride_ > farthest || stride_ < -farthest;
    return size > 1 && beyond ? "a stride is so large that the last one is beyond all memory"
                              : nullptr;
  }
  Number operator[](std::size_t index) const {
    const auto* const bytes = reinterpret_cast<const std::byte*>(first_);
    return *reinterpret_cast<const Number*>(bytes + static_cast<std::ptrdiff_t>(index) * stride_);
  }

 private:
  const Number* first_;
  std::ptrdiff_t stride_;
};

// What is too small for exact comparison counts as 0 (see mover.hpp).
double flushed(double value) {
  return std::abs(value) < kSmallestInMotion ? 0.0 : value;
}

Error error_at(ErrorCode code, std::string message, const char* place, std::size_t record) {
  Error error{code, std::move(message), {}};
  error.location.array = place;
  error.location.record = record;
  return error;
}

std::optional<Error> check_value(double value, const char* place, std::size_t record) {
  if (std::abs(value) <= kLargestInMotion) return std::nullopt;
  if (!std::isfinite(value)) {
    return error_at(ErrorCode::kNotFinite, "this is no finite number; leave the fix out", place,
                    record);
  }
  return error_at(ErrorCode::kOutsideDomain, "this is beyond 1.3e+30 in magnitude; check its unit",
                  place, record);
}

Result<Fix> fix_of(double time_s, const Point& position, std::size_t record) {
  for (const double value : {position.x, position.y, position.z}) {
    if (auto error = check_value(value, "positions", record)) return *std::move(error);
  }
  if (auto error = check_value(time_s, "times", record)) return *std::move(error);
  return Fix{flushed(time_s), {flushed(position.x), flushed(position.y), flushed(position.z)}};
}

Status append(Track& track, const Fix& fix, std::size_t record) {
  if (!track.fixes.empty() && !(track.fixes.back().time_s < fix.time_s)) {
    const bool same = track.fixes.back().time_s == fix.time_s;
    return error_at(ErrorCode::kTimeOrder,
                    same ? "the agent has two fixes at this time; leave one of them out"
                         : "this time is before that of the agent's fix before it; sort the fixes "
                           "by time",
                    "times", record);
  }
  track.fixes.push_back(fix);
  return std::monostate{};
}

// The tracks in the order of their agents' ids.
Agents ordered(Agents agents) {
  std::vector<std::size_t> order(agents.ids.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return agents.ids[a] < agents.ids[b]; });
  Agents sorted;
  for (const std::size_t i : order) {
    sorted.ids.push_back(agents.ids[i]);
    sorted.tracks.push_back(std::move(agents.tracks[i]));
  }
  return sorted;
}

}  // namespace

Result<Agents> agents_of(const beespace_fixes* fixes, const beespace_points* positions,
                         const std::stop_token& stop) {
  const Result<beespace_fixes> given = read_struct(fixes, "fixes");
  if (!given) return given.error();
  const Result<PointsView> places = view_of(positions, "positions");
  if (!places) return places.error();
  const NumberColumn<std::int64_t> ids(given->agents, given->agents_stride);
  const NumberColumn<double> times(given->times_s, given->times_stride);
  const std::size_t size = places->size();
  if (size != 0) {
    if (const char* const problem = ids.problem(size)) return invalid(problem, "agents");
    if (const char* const problem = times.problem(size)) return invalid(problem, "times");
  }
  Agents agents;
  std::unordered_map<std::int64_t, std::size_t> known;
  for (std::size_t row = 0; row < size; ++row) {
    if (row % kFixesBetweenStops == 0 && stop.stop_requested()) {
      return Error{ErrorCode::kStopped, "a stop was requested", {}};
    }
    const Result<Fix> fix = fix_of(times[row], (*places)[row], row);
    if (!fix) return fix.error();
    const auto [at, is_new] = known.try_emplace(ids[row], agents.ids.size());
    if (is_new) {
      agents.ids.push_back(at->first);
      agents.tracks.emplace_back();
    }
    Status status = append(agents.tracks[at->second], *fix, row);
    if (!status) return std::move(status).error();
  }
  return ordered(std::move(agents));
}

std::vector<Gap> gaps_of(const Agents& agents, double max_gap_s) {
  std::vector<Gap> gaps;
  for (std::size_t id = 0; id < agents.tracks.size(); ++id) {
    const std::vector<Fix>& fixes = agents.tracks[id].fixes;
    for (std::size_t i = 1; i < fixes.size(); ++i) {
      const double before = fixes[i - 1].time_s;
      const double after = fixes[i].time_s;
      if (!(after - before <= max_gap_s)) {
        gaps.push_back({static_cast<PointId>(id), before, after});
      }
    }
  }
  return gaps;
}

}  // namespace beespace::c
