#include "analysis/recorded/along_curves.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace beespace::analysis {
namespace {

constexpr double kExact_s = 1e-6;

// Of two paths, piece by piece.
class CloserSearch {
 public:
  CloserSearch(const BezierPath& first, const BezierPath& second, double threshold_m)
      : first_(first), second_(second), threshold_m_(threshold_m) {}

  Status add_to(std::vector<Conflict>& found, const TimeSpan& both) {
    const std::vector<double> ends_s = piece_ends(both);
    for (std::size_t i = 0; i < std::max<std::size_t>(1, ends_s.size() - 1); ++i) {
      const TimeSpan window{ends_s[i], ends_s[std::min(i + 1, ends_s.size() - 1)]};
      if (Status looked = look(found, window); !looked) return looked;
    }
    return std::monostate{};
  }

 private:
  // When a piece of either begins or ends, within that time.
  [[nodiscard]] std::vector<double> piece_ends(const TimeSpan& both) const {
    std::vector<double> ends_s = {both.begins_s, both.ends_s};
    for (const BezierPath* path : {&first_, &second_}) {
      for (auto piece = piece_at(*path, both.begins_s); piece != path->pieces.end(); ++piece) {
        if (piece->ends_s >= both.ends_s) break;
        ends_s.push_back(piece->ends_s);
      }
    }
    std::sort(ends_s.begin(), ends_s.end());
    ends_s.erase(std::unique(ends_s.begin(), ends_s.end()), ends_s.end());
    return ends_s;
  }

  // The first that is not over at that time.
  static std::vector<BezierPiece>::const_iterator piece_at(const BezierPath& path, double time_s) {
    return std::partition_point(path.pieces.begin(), path.pieces.end(),
                                [&](const BezierPiece& piece) { return piece.ends_s < time_s; });
  }

  // The piece in which that window lies, as a path.
  static BezierPath part_of(const BezierPath& path, const TimeSpan& window) {
    const auto piece = piece_at(path, window.ends_s);
    if (piece == path.pieces.end()) return path;  // without any
    if (piece == path.pieces.begin()) return {path.begins_s, path.begin, {*piece}};
    const BezierPiece& before = *std::prev(piece);
    return {before.ends_s, before.end, {*piece}};
  }

  // In one piece of both.
  Status look(std::vector<Conflict>& all, const TimeSpan& window) {
    pieces_ = {part_of(first_, window), part_of(second_, window)};
    const auto found = closest(window);
    if (!found) return found.error();
    if (!*found || !(*found)->closer) return std::monostate{};
    const auto begins_s = end_of_closeness(window.ends_s, window.begins_s);
    if (!begins_s) return begins_s.error();
    const auto ends_s = end_of_closeness(*begins_s, window.ends_s);
    if (!ends_s) return ends_s.error();
    const Conflict next{0, 0, *begins_s, (*found)->closest_s, *ends_s, (*found)->closest_m};
    if (all.empty() || all.back().ends_s != *begins_s) {
      all.push_back(next);
      return std::monostate{};
    }
    const auto meeting = closest({*begins_s, *begins_s});
    if (!meeting) return meeting.error();
    if (*meeting && (*meeting)->closer) {
      join(all.back(), next);
    } else {
      all.push_back(next);
    }
    return std::monostate{};
  }

  static void join(Conflict& one, const Conflict& next) {
    one.ends_s = next.ends_s;
    if (next.closest_m >= one.closest_m) return;
    one.closest_m = next.closest_m;
    one.closest_s = next.closest_s;
  }

  // They are closer somewhere between the two times: that of the first or the last such instant,
  // seen from `from_s`, or up to a microsecond beyond it, but not beyond `to_s`.
  [[nodiscard]] Result<double> end_of_closeness(double from_s, double to_s) const {
    double within_s = from_s;
    double beyond_s = to_s;
    const auto at_end = closest({to_s, to_s});
    if (!at_end) return at_end.error();
    if (*at_end && (*at_end)->closer) return to_s;
    while (std::max(within_s, beyond_s) - std::min(within_s, beyond_s) > kExact_s) {
      const double middle_s = within_s + 0.5 * (beyond_s - within_s);
      if (middle_s == within_s || middle_s == beyond_s) break;
      const auto found = closest({std::min(middle_s, beyond_s), std::max(middle_s, beyond_s)});
      if (!found) return found.error();
      (*found && (*found)->closer ? within_s : beyond_s) = middle_s;
    }
    return beyond_s;
  }

  [[nodiscard]] Result<std::optional<PathEncounter>> closest(const TimeSpan& window) const {
    return closest_as_written(pieces_.first, pieces_.second, window, threshold_m_);
  }

  const BezierPath& first_;
  const BezierPath& second_;
  double threshold_m_;
  // Those of the window that is looked at.
  std::pair<BezierPath, BezierPath> pieces_;
};

}  // namespace

Result<std::vector<Conflict>> along_curves(const Conflict& conflict, const Flight& first,
                                           const Flight& second, double threshold_m) {
  std::vector<Conflict> found;
  bool together = false;
  for (const BezierPath& whole : first) {
    for (const BezierPath& other_whole : second) {
      const TimeSpan both{std::max({whole.begins_s, other_whole.begins_s, conflict.begins_s}),
                          std::min({path_end_s(whole), path_end_s(other_whole), conflict.ends_s})};
      if (both.begins_s > both.ends_s) continue;
      together = true;
      const Status added = CloserSearch(whole, other_whole, threshold_m).add_to(found, both);
      if (!added) return added.error();
    }
  }
  if (!together) return std::vector{conflict};
  for (Conflict& one : found) {
    one.first = conflict.first;
    one.second = conflict.second;
  }
  return found;
}

}  // namespace beespace::analysis
