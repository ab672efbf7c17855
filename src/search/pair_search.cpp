#include "search/pair_search.hpp"

#include "core/pair_order.hpp"
#include "core/validate.hpp"
#include "cpu/collect_pairs.hpp"
#include "cpu/sweep_all.hpp"
#include "search/count_in_crowds.hpp"
#include "search/crowded.hpp"
#include "search/question_grids.hpp"

#include <algorithm>

namespace beespace::search {

namespace {

// Measured: from about this many others in a cube of the threshold on, boxes are counted faster
// than pairs.
constexpr double kCrowded = 260.0;

std::uint64_t size_of(const core::Vector<core::FoundPairs>& found) {
  std::uint64_t size = 0;
  for (const core::FoundPairs& part : found) size += part.size();
  return size;
}

// A vector that is about to be written throughout, with huge pages if it must grow.
template <class T>
void resize_for(std::vector<T>& vector, std::size_t size) {
  if (vector.capacity() < size) {
    vector.clear();
    vector.reserve(size);
    core::advise_huge_pages(vector.data(), vector.capacity() * sizeof(T));
  }
  vector.resize(size);
}

core::Vector<core::FoundPairs> collect(const Frame& frame, const SearchOptions& options,
                                       const core::Resources& with, const Choices& choices,
                                       std::uint64_t most) {
  const QuestionGrids grids(frame, options, with, choices);
  return cpu::collect_pairs(grids.question(), with, most);
}

// Rows of the second ids of sorted pairs.
void write_rows(const core::Buffer<Pair>& pairs, std::size_t size, std::size_t row_count,
                const core::Resources& with, IdRows& rows) {
  resize_for(rows.offsets, row_count + 1);
  resize_for(rows.ids, size);
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

}  // namespace

Status find_pairs(const Frame& frame, const SearchOptions& options, const core::Resources& with,
                  const Choices& choices, std::vector<Pair>& pairs) {
  pairs.clear();
  const auto found = collect(frame, options, with, choices, options.max_results);
  const std::uint64_t size = size_of(found);
  if (size > options.max_results) return core::too_many_results(options.max_results);
  resize_for(pairs, size);
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
  const std::uint64_t rows_a_pair = frame.has_others() ? 1 : 2;
  const auto found = collect(frame, options, with, choices, options.max_results / rows_a_pair);
  const std::uint64_t size = rows_a_pair * size_of(found);
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
  resize_for(counts, frame.points().size());
  if (is_crowded(frame, options.threshold_m, kCrowded, choices)) {
    return count_in_crowds(frame, options, with, choices, counts.data());
  }
  const QuestionGrids grids(frame, options, with, choices);
  cpu::count_all(grids.question(), with, counts.data());
}

}  // namespace beespace::search
