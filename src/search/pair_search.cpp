#include "search/pair_search.hpp"

#include "core/pair_order.hpp"
#include "core/resize_for.hpp"
#include "core/validate.hpp"
#include "cpu/collect_pairs.hpp"
#include "cpu/collect_rows.hpp"
#include "cpu/sweep_all.hpp"
#include "search/count_in_crowds.hpp"
#include "search/crowded.hpp"
#include "search/question_grids.hpp"

#include <algorithm>
#include <utility>

namespace beespace::search {

namespace {

// Measured: from about this many others in a cube of the threshold on, boxes are counted faster
// than pairs.
constexpr double kCrowded = 260.0;

// From about this many others in a cube of the threshold on, rows that are sorted one by one are
// faster than pairs that are brought into order. Measured.
constexpr double kLongRows = 20.0;

core::Vector<core::FoundPairs> collect(const Frame& frame, const SearchOptions& options,
                                       const core::Resources& with, const Choices& choices,
                                       std::uint64_t most) {
  const QuestionGrids grids(frame, options, with, choices);
  return cpu::collect_pairs(grids.question(), with, most);
}

// The rows of a frame: where each begins by the id of its point, and how they come there.
class LongRows {
 public:
  LongRows(const Frame& frame, const SearchOptions& options, cpu::Which which,
           const core::Resources& with, const Choices& choices)
      : with_(with),
        grids_(frame, options, with, choices),
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
  QuestionGrids grids_;
  const PointId* ids_;
  std::uint64_t size_ = 0;
  core::AllFoundRows found_;
};

Status find_crowded_pairs(const Frame& frame, const SearchOptions& options,
                          const core::Resources& with, const Choices& choices,
                          std::vector<Pair>& pairs) {
  const auto which = frame.has_others() ? cpu::Which::kAll : cpu::Which::kAboveOnly;
  const LongRows rows(frame, options, which, with, choices);
  if (rows.size() > options.max_results) return core::too_many_results(options.max_results);
  core::Buffer<std::uint64_t> offsets(with.memory, frame.points().size() + 1);
  rows.write_offsets(offsets.data());
  core::resize_for(pairs, rows.size());
  rows.for_each([&](PointId id, const PointId* row, std::size_t length) {
    Pair* const to = pairs.data() + offsets[id];
    for (std::size_t k = 0; k < length; ++k) to[k] = {id, row[k]};
  });
  return std::monostate{};
}

Status find_crowded_neighbors(const Frame& frame, const SearchOptions& options,
                              const core::Resources& with, const Choices& choices,
                              IdRows& neighbors) {
  const LongRows rows(frame, options, cpu::Which::kAll, with, choices);
  if (rows.size() > options.max_results) return core::too_many_results(options.max_results);
  core::resize_for(neighbors.offsets, frame.points().size() + 1);
  rows.write_offsets(neighbors.offsets.data());
  core::resize_for(neighbors.ids, rows.size());
  rows.for_each([&](PointId id, const PointId* row, std::size_t length) {
    std::copy_n(row, length, neighbors.ids.data() + neighbors.offsets[id]);
  });
  return std::monostate{};
}

}  // namespace

void write_rows(const core::Buffer<Pair>& pairs, std::size_t size, std::size_t row_count,
                const core::Resources& with, IdRows& rows) {
  core::resize_for(rows.offsets, row_count + 1);
  core::resize_for(rows.ids, size);
  with.crew.split(size, [&](std::size_t begin, std::size_t end, unsigned) {
    // Each pair that is the first of its row starts the rows since the pair before.
    std::uint64_t next_row = begin == 0 ? 0 : std::uint64_t{pairs[begin - 1].first} + 1;
    for (std::size_t i = begin; i < end; ++i) {
      rows.ids[i] = pairs[i].second;
      for (; next_row <= pairs[i].first; ++next_row) rows.offsets[next_row] = i;
    }
  });
  std::uint64_t next_row = size == 0 ? 0 : std::uint64_t{pairs[size - 1].first} + 1;
  for (; next_row <= row_count; ++next_row) rows.offsets[next_row] = size;
}

Status find_pairs(const Frame& frame, const SearchOptions& options, const core::Resources& with,
                  const Choices& choices, std::vector<Pair>& pairs) {
  pairs.clear();
  if (is_crowded(frame, options.threshold_m, kLongRows, choices)) {
    return find_crowded_pairs(frame, options, with, choices, pairs);
  }
  const auto found = collect(frame, options, with, choices, options.max_results);
  const std::uint64_t size = core::size_of(found);
  if (size > options.max_results) return core::too_many_results(options.max_results);
  core::resize_for(pairs, size);
  core::order_pairs(found,
                    frame.has_others() ? core::Direction::kAsFound : core::Direction::kAscending,
                    frame.points().size(), with, pairs.data());
  return std::monostate{};
}

bool visit_pairs(const Frame& frame, const SearchOptions& options, const core::Resources& with,
                 const Choices& choices, const PairVisitor& visit) {
  const QuestionGrids grids(frame, options, with, choices);
  return cpu::show_pairs(grids.question(), with, visit);
}

Status find_neighbors(const Frame& frame, const SearchOptions& options, const core::Resources& with,
                      const Choices& choices, IdRows& neighbors) {
  neighbors.offsets.clear();
  neighbors.ids.clear();
  if (frame.points().empty()) return std::monostate{};
  if (is_crowded(frame, options.threshold_m, kLongRows, choices)) {
    return find_crowded_neighbors(frame, options, with, choices, neighbors);
  }
  const std::uint64_t rows_a_pair = frame.has_others() ? 1 : 2;
  const auto found = collect(frame, options, with, choices, options.max_results / rows_a_pair);
  const std::uint64_t size = rows_a_pair * core::size_of(found);
  if (size > options.max_results) return core::too_many_results(options.max_results);
  core::Buffer<Pair> pairs(with.memory, size);
  core::order_pairs(found,
                    frame.has_others() ? core::Direction::kAsFound : core::Direction::kBothWays,
                    frame.points().size(), with, pairs.data());
  write_rows(pairs, size, frame.points().size(), with, neighbors);
  return std::monostate{};
}

void count_neighbors(const Frame& frame, const SearchOptions& options, const core::Resources& with,
                     const Choices& choices, std::vector<std::uint32_t>& counts) {
  core::resize_for(counts, frame.points().size());
  if (is_crowded(frame, options.threshold_m, kCrowded, choices)) {
    return count_in_crowds(frame, options, with, choices, counts.data());
  }
  const QuestionGrids grids(frame, options, with, choices);
  cpu::count_all(grids.question(), with, counts.data());
}

}  // namespace beespace::search
