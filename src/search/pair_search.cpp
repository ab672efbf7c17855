#include "search/pair_search.hpp"

#include "base/pair_order.hpp"
#include "base/resize_for.hpp"
#include "exact/validate.hpp"
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

Status find_crowded_pairs(const SearchDomain& domain, const PairOptions& options,
                          const core::Resources& with, const TuningOverrides& tuning,
                          std::vector<Pair>& pairs) {
  const auto which = domain.has_others() ? cpu::Which::kAll : cpu::Which::kAboveOnly;
  const LongRows rows(domain, options, which, with, tuning);
  if (rows.size() > options.max_results) return core::too_many_results(options.max_results);
  core::Buffer<std::uint64_t> offsets(with.memory, domain.points().size() + 1);
  rows.write_offsets(offsets.data());
  core::resize_for(pairs, rows.size(), with.crew);
  rows.for_each([&](PointId id, const PointId* row, std::size_t length) {
    Pair* const to = pairs.data() + offsets[id];
    for (std::size_t k = 0; k < length; ++k) to[k] = {id, row[k]};
  });
  return std::monostate{};
}

Status find_crowded_neighbors(const SearchDomain& domain, const PairOptions& options,
                              const core::Resources& with, const TuningOverrides& tuning,
                              IdRows& neighbors) {
  const LongRows rows(domain, options, cpu::Which::kAll, with, tuning);
  if (rows.size() > options.max_results) return core::too_many_results(options.max_results);
  core::resize_for(neighbors.offsets, domain.points().size() + 1, with.crew);
  rows.write_offsets(neighbors.offsets.data());
  core::resize_for(neighbors.ids, rows.size(), with.crew);
  rows.for_each([&](PointId id, const PointId* row, std::size_t length) {
    std::copy_n(row, length, neighbors.ids.data() + neighbors.offsets[id]);
  });
  return std::monostate{};
}

}  // namespace

void write_rows(const core::Buffer<Pair>& pairs, std::size_t size, std::size_t row_count,
                const core::Resources& with, IdRows& rows) {
  core::resize_for(rows.offsets, row_count + 1, with.crew);
  core::resize_for(rows.ids, size, with.crew);
  with.crew.split(size, [&](std::size_t begin, std::size_t end, unsigned) {
    // Each pair that is the first of its row starts the rows since the pair before.
    std::uint64_t next_row = begin == 0 ? 0 : std::uint64_t{pairs[begin - 1].first} + 1;
    core::in_stretches(end - begin, [&](std::size_t from, std::size_t to) {
      for (std::size_t i = begin + from; i < begin + to; ++i) {
        rows.ids[i] = pairs[i].second;
        for (; next_row <= pairs[i].first; ++next_row) rows.offsets[next_row] = i;
      }
    });
  });
  std::uint64_t next_row = size == 0 ? 0 : std::uint64_t{pairs[size - 1].first} + 1;
  for (; next_row <= row_count; ++next_row) rows.offsets[next_row] = size;
}

Status find_pairs(const SearchDomain& domain, const PairOptions& options,
                  const core::Resources& with, const TuningOverrides& tuning,
                  std::vector<Pair>& pairs) {
  pairs.clear();
  if (is_crowded(domain, options.threshold_m, kLongRows, tuning)) {
    return find_crowded_pairs(domain, options, with, tuning, pairs);
  }
  const auto found = collect(domain, options, with, tuning, options.max_results);
  const std::uint64_t size = core::size_of(found);
  if (size > options.max_results) return core::too_many_results(options.max_results);
  core::resize_for(pairs, size, with.crew);
  core::order_pairs(found,
                    domain.has_others() ? core::Direction::kAsFound : core::Direction::kAscending,
                    domain.points().size(), with, pairs.data());
  return std::monostate{};
}

bool visit_pairs(const SearchDomain& domain, const PairOptions& options,
                 const core::Resources& with, const TuningOverrides& tuning,
                 const PairVisitor& visit) {
  const QueryGrids grids(domain, options, with, tuning);
  return cpu::show_pairs(grids.question(), with, visit);
}

Status find_neighbors(const SearchDomain& domain, const PairOptions& options,
                      const core::Resources& with, const TuningOverrides& tuning,
                      IdRows& neighbors) {
  neighbors.offsets.clear();
  neighbors.ids.clear();
  if (domain.points().empty()) return std::monostate{};
  if (is_crowded(domain, options.threshold_m, kLongRows, tuning)) {
    return find_crowded_neighbors(domain, options, with, tuning, neighbors);
  }
  const std::uint64_t rows_a_pair = domain.has_others() ? 1 : 2;
  const auto found = collect(domain, options, with, tuning, options.max_results / rows_a_pair);
  const std::uint64_t size = rows_a_pair * core::size_of(found);
  if (size > options.max_results) return core::too_many_results(options.max_results);
  core::Buffer<Pair> pairs(with.memory, size);
  core::order_pairs(found,
                    domain.has_others() ? core::Direction::kAsFound : core::Direction::kBothWays,
                    domain.points().size(), with, pairs.data());
  write_rows(pairs, size, domain.points().size(), with, neighbors);
  return std::monostate{};
}

void count_neighbors(const SearchDomain& domain, const PairOptions& options,
                     const core::Resources& with, const TuningOverrides& tuning,
                     std::vector<std::uint32_t>& counts) {
  core::resize_for(counts, domain.points().size(), with.crew);
  if (is_crowded(domain, options.threshold_m, kCrowdedForCounts, tuning)) {
    return count_in_crowds(domain, options, with, tuning, counts.data());
  }
  const QueryGrids grids(domain, options, with, tuning);
  cpu::count_all(grids.question(), with, counts.data());
}

}  // namespace beespace::search
