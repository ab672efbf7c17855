// Questions whose answer grows with the pairs: pairs, pairs shown to a visitor, rows of neighbours.
#include <beespace/pairs.hpp>

#include "c/door/options.hpp"
#include "c/door/question.hpp"

#include <beespace/columns.hpp>
#include <beespace/nearest.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <string>

using namespace beespace::c;  // NOLINT(google-build-using-namespace): the functions are of C
using beespace::Pair;
using beespace::PairColumns;
using beespace::PairOptions;
using beespace::PointsView;
using beespace::Result;
using beespace::RowColumns;
using beespace::RunOptions;
using beespace::Status;

namespace {

constexpr std::uint32_t kOfPairs = kWithin | BEESPACE_MAX_RESULTS | BEESPACE_DISTANCES;

beespace::Error too_many_with_self(std::uint64_t most) {
  return {
      beespace::ErrorCode::kTooManyResults,
      "there are more than " + std::to_string(most) +
          " results, as each point is its own neighbour; raise max_results or lower the threshold",
      {}};
}

Status find_rows(const Search& asked, const PointSets& sets, beespace_engine& used,
                 const RunOptions& run, beespace_result& into) {
  const PairOptions options = asked.pairs(run);
  const auto room = [&](std::uint64_t rows, std::uint64_t size) {
    into.offsets.resize(rows + 1);
    into.ids.resize(size);
    if (asked.distances) into.distances_m.resize(size);
    return RowColumns{into.offsets.data(), into.ids.data(),
                      asked.distances ? into.distances_m.data() : nullptr};
  };
  return sets.others ? used.engine.find_neighbors_between(sets.points, *sets.others, options, room)
                     : used.engine.find_neighbors(sets.points, options, room);
}

// The same of one set, with each point in its own row.
Status find_rows_with_self(const Search& asked, const PointSets& sets, beespace_engine& used,
                           const RunOptions& run, beespace_result& into) {
  const std::size_t count = sets.points.size();
  PairOptions options = asked.pairs(run);
  const std::uint64_t most = options.max_results;
  if (most < count) return too_many_with_self(most);
  options.max_results -= count;
  Status status = used.engine.find_neighbors(sets.points, options, used.rows);
  if (!status && status.error().code == beespace::ErrorCode::kTooManyResults) {
    return too_many_with_self(most);
  }
  if (status) status = write_rows_with_self(used.rows, count, run.stop, into);
  if (!status || !asked.distances) return status;
  return write_row_distances(sets.points, sets.points, run.stop, into);
}

// A batch of pairs in the widths of C.
class Batch {
 public:
  Batch(const PointsView& points, bool distances) : points_(points), distances_(distances) {}

  bool show(std::span<const Pair> pairs, beespace_pair_visitor visit, void* data) {
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      first_[i] = pairs[i].first;
      second_[i] = pairs[i].second;
      if (distances_) {
        distances_m_[i] = beespace::distance(points_[pairs[i].first], points_[pairs[i].second]);
      }
    }
    return visit(data, first_.data(), second_.data(), distances_ ? distances_m_.data() : nullptr,
                 static_cast<std::int64_t>(pairs.size())) != 0;
  }

 private:
  PointsView points_;
  bool distances_;
  std::array<std::int64_t, beespace::kMostPairsAtOnce> first_{};
  std::array<std::int64_t, beespace::kMostPairsAtOnce> second_{};
  std::array<double, beespace::kMostPairsAtOnce> distances_m_{};
};

}  // namespace

extern "C" {

beespace_code beespace_pairs(beespace_engine* engine, const beespace_points* points,
                             const beespace_points* others, const beespace_search* search,
                             const beespace_run* run, beespace_result* result,
                             beespace_error* error) {
  const auto ask = [search](const PointSets& sets, beespace_engine& used, const RunOptions& options,
                            beespace_result& into) -> Status {
    const Result<Search> asked = search_of(search, kOfPairs);
    if (!asked) return asked.error();
    const PairOptions within = asked->pairs(options);
    const auto room = [&](std::uint64_t size) {
      into.first.resize(size);
      into.second.resize(size);
      if (asked->distances) into.distances_m.resize(size);
      return PairColumns{into.first.data(), into.second.data(),
                         asked->distances ? into.distances_m.data() : nullptr};
    };
    return sets.others ? used.engine.find_pairs_between(sets.points, *sets.others, within, room)
                       : used.engine.find_pairs(sets.points, within, room);
  };
  return answer(engine, points, others, run, result, error, ask);
}

beespace_code beespace_visit_pairs(beespace_engine* engine, const beespace_points* points,
                                   const beespace_search* search, const beespace_run* run,
                                   beespace_pair_visitor visit, void* data, beespace_error* error) {
  return enter(error, [&]() -> Status {
    if (visit == nullptr) return invalid("the pointer to the visitor is NULL", "visit");
    const Result<PointsView> view = view_of(points, "points");
    if (!view) return view.error();
    const Result<Search> asked = search_of(search, kWithin | BEESPACE_DISTANCES);
    if (!asked) return asked.error();
    CallEngine used(engine);
    const auto batch = std::make_unique<Batch>(*view, asked->distances);
    return call_watched(run, [&](const RunOptions& options) -> Status {
      const Result<bool> seen = (*used).engine.visit_pairs(
          *view, asked->points(options),
          [&](std::span<const Pair> pairs) { return batch->show(pairs, visit, data); });
      if (!seen) return seen.error();
      return std::monostate{};
    });
  });
}

beespace_code beespace_neighbors(beespace_engine* engine, const beespace_points* points,
                                 const beespace_points* others, const beespace_search* search,
                                 const beespace_run* run, beespace_result* result,
                                 beespace_error* error) {
  const auto ask = [search](const PointSets& sets, beespace_engine& used, const RunOptions& options,
                            beespace_result& into) -> Status {
    const Result<Search> asked =
        search_of(search, sets.others ? kOfPairs : kOfPairs | BEESPACE_WITH_SELF);
    if (!asked) return asked.error();
    return asked->with_self ? find_rows_with_self(*asked, sets, used, options, into)
                            : find_rows(*asked, sets, used, options, into);
  };
  return answer(engine, points, others, run, result, error, ask);
}

}  // extern "C"
