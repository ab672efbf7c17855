#include "search/pair_search.hpp"

#include "base/pair_order.hpp"
#include "base/resize_for.hpp"
#include "exact/validate.hpp"
#include "search/candidates.hpp"
#include "search/count_in_crowds.hpp"
#include "search/crowded.hpp"
#include "search/query_grids.hpp"
#include "sweep/collect_pairs.hpp"
#include "sweep/collect_rows.hpp"
#include "sweep/sweep_all.hpp"

#include <algorithm>
#include <utility>

namespace beespace::search {

namespace {

// Measured: from about this many others in a cube of the threshold on, boxes are counted faster
// than pairs.
constexpr double kCrowdedForCounts = 260.0;

// From about this many others in a cube of the threshold on, rows that are sorted one by one are
// faster than pairs that are brought into order. Measured.
constexpr double kLongRows = 20.0;

core::Vector<core::FoundPairs> collect(const SearchDomain& domain, const PairOptions& options,
                                       const core::Resources& with, const TuningOverrides& tuning,
                                       std::uint64_t most) {
  const QueryGrids grids(domain, options, with, tuning);
  return cpu::collect_pairs(grids.question(), with, most);
}

// The rows of a domain: where each begins by the id of its point, and how they are written.
class LongRows {
 public:
  LongRows(const SearchDomain& domain, const PairOptions& options, cpu::Which which,
           const core::Resources& with, const TuningOverrides& tuning)
      : with_(with),
        grids_(domain, options, with, tuning),
        ids_(grids_.question().asked.grid.id),
        found_(cpu::collect_rows(grids_.question(), which, with, options.max_results, size_)) {}

  [[nodiscard]] std::uint64_t size() const { return size_; }

  // offsets[id] for every id, and one behind the last.
  void write_offsets(std::uint64_t* offsets) const {
    with_.crew.split(found_.size, [&](std::size_t begin, std::size_t end, unsigned) {
      for (std::size_t i = begin; i < end; ++i) offsets[ids_[i]] = found_.lengths[i];
    });
    std::uint64_t sum = 0;
    for (std::size_t id = 0; id < found_.size; ++id) sum += std::exchange(offsets[id], sum);
    offsets[found_.size] = sum;
  }

  // Calls write(id, row, length), several at once.
  template <class Write>
  void for_each(const Write& write) const {
    core::for_each_row(found_, with_,
                       [&](std::size_t point, const PointId* row, std::size_t length) {
                         write(ids_[point], row, length);
                       });
  }

 private:
  const core::Resources& with_;
  QueryGrids grids_;
  const PointId* ids_;
  std::uint64_t size_ = 0;
  core::AllFoundRows found_;
};

Status find_crowded(const SearchDomain& domain, const PairOptions& options, cpu::Which which,
                    const core::Resources& with, const TuningOverrides& tuning,
                    PairAnswer& answer) {
  const LongRows rows(domain, options, which, with, tuning);
  if (rows.size() > options.max_results) return core::too_many_results(options.max_results);
  core::Buffer<std::uint64_t> offsets(with.memory, domain.points().size() + 1);
  rows.write_offsets(offsets.data());
  answer.open(rows.size(), with);
  rows.for_each([&](PointId id, const PointId* row, std::size_t length) {
    answer.take_row(offsets[id], id, row, length);
  });
  return std::monostate{};
}

void count(const SearchDomain& domain, const PairOptions& options, const core::Resources& with,
           const TuningOverrides& tuning, std::uint32_t* counts) {
  if (is_crowded(domain, options.threshold_m, kCrowdedForCounts, tuning)) {
    return count_in_crowds(domain, options, with, tuning, counts);
  }
  const QueryGrids grids(domain, options, with, tuning);
  cpu::count_all(grids.question(), with, counts);
}

}  // namespace

Status take_pairs(const core::Vector<core::FoundPairs>& found, core::Direction direction,
                  std::size_t points, std::uint64_t most, const core::Resources& with,
                  PairAnswer& answer) {
  const std::uint64_t a_pair = direction == core::Direction::kBothWays ? 2 : 1;
  const std::uint64_t size = a_pair * core::size_of(found);
  if (size > most) return core::too_many_results(most);
  answer.open(size, with);
  core::order_pairs(found, direction, points, with, answer.place(),
                    [&](const core::SortedPairs& sorted) { answer.take(sorted); });
  return std::monostate{};
}

Status find_pairs(const SearchDomain& domain, const PairOptions& options,
                  const core::Resources& with, const TuningOverrides& tuning, PairAnswer& answer) {
  if (is_crowded(domain, options.threshold_m, kLongRows, tuning)) {
    const auto which = domain.has_others() ? cpu::Which::kAll : cpu::Which::kAboveOnly;
    return find_crowded(domain, options, which, with, tuning, answer);
  }
  const auto direction =
      domain.has_others() ? core::Direction::kAsFound : core::Direction::kAscending;
  return take_pairs(collect(domain, options, with, tuning, options.max_results), direction,
                    domain.points().size(), options.max_results, with, answer);
}

bool visit_pairs(const SearchDomain& domain, const PairOptions& options,
                 const core::Resources& with, const TuningOverrides& tuning,
                 const PairVisitor& visit) {
  const QueryGrids grids(domain, options, with, tuning);
  return cpu::show_pairs(grids.question(), with, visit);
}

Status find_neighbors(const SearchDomain& domain, const PairOptions& options,
                      const core::Resources& with, const TuningOverrides& tuning,
                      PairAnswer& answer) {
  if (is_crowded(domain, options.threshold_m, kLongRows, tuning)) {
    return find_crowded(domain, options, cpu::Which::kAll, with, tuning, answer);
  }
  const auto direction =
      domain.has_others() ? core::Direction::kAsFound : core::Direction::kBothWays;
  const std::uint64_t most = options.max_results / (domain.has_others() ? 1 : 2);
  return take_pairs(collect(domain, options, with, tuning, most), direction, domain.points().size(),
                    options.max_results, with, answer);
}

void count_neighbors(const SearchDomain& domain, const PairOptions& options,
                     const core::Resources& with, const TuningOverrides& tuning,
                     std::vector<std::uint32_t>& counts) {
  core::resize_for(counts, domain.points().size(), with.crew);
  const auto candidates = Candidates::of(domain, options.threshold_m, with, tuning);
  if (!candidates) return count(domain, options, with, tuning, counts.data());
  core::Buffer<std::uint32_t> found(with.memory, candidates->size());
  count(candidates->domain(with), options, with, tuning, found.data());
  std::fill(counts.begin(), counts.end(), 0U);
  for (std::size_t i = 0; i < candidates->size(); ++i) counts[candidates->id(i)] = found[i];
}

}  // namespace beespace::search
