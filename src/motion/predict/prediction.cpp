#include "motion/predict/prediction.hpp"

#include "base/memory.hpp"
#include "base/pair_order.hpp"
#include "base/resize_for.hpp"
#include "exact/validate.hpp"
#include "motion/predict/prediction_steps.hpp"
#include "motion/separation.hpp"
#include "motion/validate.hpp"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>

namespace beespace::motion {

namespace {

bool by_pair(const Conflict& a, const Conflict& b) {
  return std::tie(a.first, a.second) < std::tie(b.first, b.second);
}
bool same_pair(const Conflict& a, const Conflict& b) {
  return a.first == b.first && a.second == b.second;
}

// Judges the pairs that the steps have found, into a list.
class Judge {
 public:
  Judge(const MoversView& movers, const Separation& separation, double horizon_s,
        const core::Resources& with, std::vector<Conflict>& found)
      : movers_(movers),
        separation_(separation),
        horizon_s_(horizon_s),
        with_(with),
        found_(found) {}

  // In ascending order, so that the first of each pair is read in sequence, and the results need
  // not be sorted.
  void add(const core::Vector<core::FoundPairs>& candidates) {
    const std::size_t size = core::size_of(candidates);
    core::Buffer<Pair> pairs(with_.memory, size);
    core::order_pairs(candidates, core::Direction::kAscending, movers_.size(), with_, pairs.data());
    const std::size_t before = found_.size();
    found_.reserve(before + size);
    core::advise_huge_pages(found_.data() + before, size * sizeof(Conflict));
    found_.resize(before + size);
    core::Vector<std::size_t> ends(with_.crew.size(), &with_.memory);  // of what each has found
    with_.crew.split(size, [&](std::size_t begin, std::size_t end, unsigned worker) {
      std::size_t to = before + begin;
      for (std::size_t k = begin; k < end; ++k) {
        constexpr std::size_t kAhead = 16;
        if (k + kAhead < end) prefetch(pairs[k + kAhead].second);
        const auto [first, second] = pairs[k];
        const State a = state_of(movers_, first);
        const State b = state_of(movers_, second);
        const auto report = conflict_of(a, b, separation_, horizon_s_);
        if (!report) continue;
        found_[to++] = {first,
                        second,
                        report->span.begins_s,
                        report->closest_s,
                        report->span.ends_s,
                        report->closest_m};
      }
      ends[worker] = to;
    });
    close_gaps(before, size, ends);
  }

  // Sorts what several steps have found, and drops repeated pairs.
  void settle() {
    const auto not_below = [](const Conflict& a, const Conflict& b) { return !by_pair(a, b); };
    if (std::adjacent_find(found_.begin(), found_.end(), not_below) == found_.end()) return;
    std::sort(found_.begin(), found_.end(), by_pair);
    found_.erase(std::unique(found_.begin(), found_.end(), same_pair), found_.end());
  }

 private:
  // Joins the results of all threads, each at the beginning of its share, one behind the other.
  void close_gaps(std::size_t before, std::size_t size, const core::Vector<std::size_t>& ends) {
    auto to = found_.begin() + static_cast<std::ptrdiff_t>(before);
    for (unsigned worker = 0; worker < ends.size(); ++worker) {
      const auto from = found_.begin() +
                        static_cast<std::ptrdiff_t>(before + with_.crew.share(size, worker).first);
      const auto end = found_.begin() + static_cast<std::ptrdiff_t>(ends[worker]);
      if (from < end) to = from == to ? end : std::move(from, end, to);
    }
    found_.erase(to, found_.end());
  }

  void prefetch(PointId id) const {
    for (const PointsView* view : {&movers_.positions(), &movers_.velocities()}) {
      const auto* const first = static_cast<const std::byte*>(view->axes()[0]);
      __builtin_prefetch(first + static_cast<std::ptrdiff_t>(id) * view->stride_bytes()[0]);
    }
  }

  const MoversView& movers_;
  const Separation& separation_;
  double horizon_s_;
  const core::Resources& with_;
  std::vector<Conflict>& found_;
};

constexpr std::uint64_t kUnlimited = std::numeric_limits<std::uint64_t>::max();

// The steps have checked positions and velocities on their way.
std::optional<Error> check(const MoversView& movers, const PredictionSteps& steps) {
  if (steps.in_domain() && !movers.has_heights()) return std::nullopt;
  return check_movers(movers);
}

}  // namespace

Status predict_pairs(const MoversView& movers, const PredictOptions& options,
                     const core::Resources& with, std::vector<Pair>& pairs,
                     const PredictionTuning& tuning) {
  PredictionSteps steps(movers, options, with, tuning);
  if (auto error = check(movers, steps)) return *std::move(error);
  const auto exactly = [&](PointId a, PointId b) {
    return in_conflict(state_of(movers, a), state_of(movers, b), steps.separation(),
                       options.horizon_s);
  };
  const DecidePass decide = std::cref(exactly);  // a copy would need memory
  core::Vector<core::FoundPairs> found(&with.memory);
  std::size_t found_in = 0;  // so many steps
  const auto settle = [&] {
    core::resize_for(pairs, core::size_of(found), with.crew);
    core::order_pairs(found, core::Direction::kAscending, movers.size(), with, pairs.data());
    if (found_in > 1) pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    return pairs.size() <= options.max_results;
  };
  bool fits = true;
  steps.for_each(decide, options.max_results, [&](auto&& step) {
    ++found_in;
    for (core::FoundPairs& part : step) found.push_back(std::move(part));
    // Few are found twice, so this rarely runs and is more rarely true.
    fits = core::size_of(found) <= options.max_results || settle();
    return fits;
  });
  if (!fits || !settle()) return core::too_many_results(options.max_results);
  return std::monostate{};
}

Status predict(const MoversView& movers, const PredictOptions& options, const core::Resources& with,
               std::vector<Conflict>& conflicts, const PredictionTuning& tuning) {
  conflicts.clear();
  if (options.max_results < kUnlimited) {
    // Candidates may be many more than conflicts; their ids take less memory, and are exact.
    std::vector<Pair> pairs;
    if (Status few = predict_pairs(movers, options, with, pairs, tuning); !few) return few;
  }
  PredictionSteps steps(movers, options, with, tuning);
  if (auto error = check(movers, steps)) return *std::move(error);
  Judge judge(movers, steps.separation(), options.horizon_s, with, conflicts);
  steps.for_each({}, kUnlimited, [&](const auto& candidates) {
    judge.add(candidates);
    return true;
  });
  judge.settle();
  return std::monostate{};
}

}  // namespace beespace::motion
