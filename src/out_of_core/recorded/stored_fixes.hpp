// All fixes of a recording, on the disk: added in any order, and read agent by agent in the order
// of time.
#pragma once

#include "out_of_core/sorted_rows.hpp"

#include <beespace/agent_id.hpp>
#include <beespace/crew.hpp>
#include <beespace/points_view.hpp>
#include <beespace/recording_out_of_core.hpp>
#include <beespace/result.hpp>
#include <beespace/track.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace beespace::out_of_core {

struct StoredFix {
  AgentId agent = 0;
  Fix fix;
  double height_m = 0.0;  // where heights are apart from positions
  std::uint64_t row = 0;  // of all that were added, from 0

  friend bool operator<(const StoredFix& a, const StoredFix& b) {
    return std::tie(a.agent, a.fix.time_s, a.row) < std::tie(b.agent, b.fix.time_s, b.row);
  }
};

// Fixes of a time that their agent has one at already: no reader sees them.
struct RepeatedFixes {
  bool allowed = false;                 // to say the same place again
  std::uint64_t count = 0;              // of those that are allowed
  std::optional<LargeTimeClash> clash;  // of the others the one with the lowest second row
};

// Some of the times, evenly spread over the fixes as they come.
class TimeSample {
 public:
  void add(double time_s) {
    if (seen_++ % step_ != 0) return;
    times_.push_back(time_s);
    if (times_.size() < kMost) return;
    for (std::size_t at = 0; 2 * at < times_.size(); ++at) times_[at] = times_[2 * at];
    times_.resize((times_.size() + 1) / 2);
    step_ *= 2;
  }
  // Ascending, each once.
  [[nodiscard]] std::vector<double> sorted() const;

 private:
  static constexpr std::size_t kMost = std::size_t{1} << 16U;

  std::vector<double> times_;
  std::uint64_t seen_ = 0;
  std::uint64_t step_ = 1;
};

class StoredFixes {
 public:
  StoredFixes(std::string folder, const SortMemory& memory) : rows_(std::move(folder), memory) {}

  [[nodiscard]] std::uint64_t size() const { return rows_.size(); }
  // Whether heights are apart from positions; where there are fixes.
  [[nodiscard]] bool have_heights() const { return have_heights_; }
  [[nodiscard]] const TimeSample& times() const { return times_; }

  // As many of each, and positions with heights where those before have them. What is too small for
  // exact comparison becomes zero. Errors, none is added: kNotFinite, kOutsideDomain, with the
  // array and the row in it. kWriteFailed, after which nothing else may be done.
  Status add(std::span<const AgentId> agents, std::span<const double> times_s,
             const PointsView& positions, Crew& crew);

  // To be called before for_each(). Errors: those of SortedRows.
  Status settle(Crew& crew) { return rows_.settle(crew); }

  // Calls visit(fix) in ascending order of agents, then times, until it returns false; without
  // those that come again. Errors: those of SortedRows.
  template <class Visit>
  Status for_each(RepeatedFixes& repeated, Visit&& visit) const {
    repeated = {repeated.allowed, 0, {}};
    std::optional<StoredFix> last;
    return rows_.for_each([&](const StoredFix& fix) {
      if (last && last->agent == fix.agent && last->fix.time_s == fix.fix.time_s) {
        note(*last, fix, repeated);
        return true;
      }
      last = fix;
      return visit(fix);
    });
  }

 private:
  static void note(const StoredFix& first, const StoredFix& second, RepeatedFixes& repeated);

  SortedRows<StoredFix> rows_;
  TimeSample times_;
  bool have_heights_ = false;
};

}  // namespace beespace::out_of_core
