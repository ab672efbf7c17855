#include "search/pair_search.hpp"

#include "base/pair_order.hpp"
#include "base/resize_for.hpp"
#include "exact/validate.hpp"
#include "search/candidates.hpp"
#include "search/count_in_crowds.hpp"
#include "search/crowded.hpp"
#include "search/query_grids.hpp"
#include "sweep/collect_pairs.hpp"
#include "sweep/ordered_rows.hpp"
#include "sweep/sweep_all.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <span>
#include <utility>

namespace beespace::search {

namespace {

// Measured: from about this many others in a cube of the threshold on, boxes are counted faster
// than pairs.
constexpr double kCrowdedForCounts = 260.0;

// From about this many others in a cube of the threshold on, rows that are found in order are
// faster than pairs that are brought into order. Measured.
constexpr double kLongRows = 20.0;

core::Vector<core::FoundPairs> collect(const SearchDomain& domain, const PairOptions& options,
                                       const core::Resources& with, const TuningOverrides& tuning,
                                       std::uint64_t most) {
  const auto candidates = Candidates::of(domain, options.threshold_m, with, tuning);
  if (!candidates) {
    const QueryGrids grids(domain, options, with, tuning);
    return cpu::collect_pairs(grids.question(), with, most);
  }
  if (candidates->size() < 2) return core::Vector<core::FoundPairs>(&with.memory);
  const SearchDomain few = candidates->domain(with);
  const QueryGrids grids(few, options, with, tuning);
  core::Vector<core::FoundPairs> found = cpu::collect_pairs(grids.question(), with, most);
  for (core::FoundPairs& part : found) {
    part.renumber([&](PointId id) { return candidates->id(id); });
  }
  return found;
}

bool visit_among(const Candidates& candidates, const PairOptions& options,
                 const core::Resources& with, const TuningOverrides& tuning,
                 const PairVisitor& visit) {
  if (candidates.size() < 2) return true;
  const SearchDomain few = candidates.domain(with);
  const QueryGrids grids(few, options, with, tuning);
  std::array<Pair, kMostPairsAtOnce> batch;  // visitors are called one at a time
  const auto renumbered = [&](std::span<const Pair> pairs) {
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      batch[i] = {candidates.id(pairs[i].first), candidates.id(pairs[i].second)};
    }
    return visit(std::span(batch).first(pairs.size()));
  };
  return cpu::show_pairs(grids.question(), with, std::cref(renumbered));  // allocates nothing
}

// Where the row of each sorted point begins, if rows stand in the order of ids.
core::Buffer<std::uint64_t> row_begins(const core::SortedGrid& grid,
                                       const core::Buffer<std::uint32_t>& lengths,
                                       const core::Resources& with) {
  core::Buffer<std::uint64_t> by_id(with.memory, grid.size);
  for (std::size_t i = 0; i < grid.size; ++i) by_id[grid.id[i]] = lengths[i];
  std::uint64_t sum = 0;
  for (std::size_t id = 0; id < grid.size; ++id) sum += std::exchange(by_id[id], sum);
  core::Buffer<std::uint64_t> begins(with.memory, grid.size);
  for (std::size_t i = 0; i < grid.size; ++i) begins[i] = by_id[grid.id[i]];
  return begins;
}

Status find_crowded(const SearchDomain& domain, const PairOptions& options, cpu::Which which,
                    const core::Resources& with, const TuningOverrides& tuning,
                    PairAnswer& answer) {
  const QueryGrids grids(domain, options, with, tuning);
  const cpu::SweepQuery question = grids.question();
  const std::size_t points = domain.points().size();
  core::Buffer<std::uint32_t> lengths(with.memory, points);
  const std::uint64_t size =
      cpu::count_rows(question, which, with, options.max_results, lengths.data());
  if (size > options.max_results) return core::too_many_results(options.max_results);
  answer.open(size, with);
  const core::Buffer<std::uint64_t> begins = row_begins(question.asked.grid, lengths, with);
  const PointId* const ids = question.asked.grid.id;
  for (std::size_t i = 0; i < points; ++i) {
    if (lengths[i] == 0) answer.take_row(begins[i], ids[i], nullptr, 0);
  }
  const auto take = [&](std::uint32_t asked, const PointId* row, std::size_t length) {
    answer.take_row(begins[asked], ids[asked], row, length);
  };
  cpu::visit_rows(question, which, with, lengths.data(), std::cref(take));  // allocates nothing
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
  if (const auto candidates = Candidates::of(domain, options.threshold_m, with, tuning)) {
    return visit_among(*candidates, options, with, tuning, visit);
  }
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
