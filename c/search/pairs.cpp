// Questions whose answer grows with the pairs: pairs, pairs shown to a visitor, rows of neighbours.
#include <beespace/pairs.hpp>

#include "c/door/options.hpp"
#include "c/door/question.hpp"

#include <beespace/nearest.hpp>

#include <array>
#include <cstdint>
#include <span>

using namespace beespace::c;  // NOLINT(google-build-using-namespace): the functions are of C
using beespace::Pair;
using beespace::PairOptions;
using beespace::PointsView;
using beespace::Result;
using beespace::RunOptions;
using beespace::Status;

namespace {

constexpr std::uint32_t kOfPairs = kWithin | BEESPACE_MAX_RESULTS | BEESPACE_DISTANCES;

// Of rows with the point itself, the limit counts it, too.
Result<PairOptions> leave_room_for_self(PairOptions options, std::size_t points) {
  if (options.max_results < points) {
    return beespace::Error{beespace::ErrorCode::kTooManyResults,
                           "each point is its own neighbour, and there are more points than "
                           "max_results",
                           {}};
  }
  options.max_results -= points;
  return options;
}

Status find_rows(const Search& asked, const PointSets& sets, beespace_engine& used,
                 const RunOptions& run, beespace_result& into) {
  PairOptions options = asked.pairs(run);
  const std::size_t count = sets.points.size();
  if (asked.with_self) {
    const Result<PairOptions> less = leave_room_for_self(options, count);
    if (!less) return less.error();
    options = *less;
  }
  Status status = sets.others ? used.engine.find_neighbors_between(sets.points, *sets.others,
                                                                   options, used.rows)
                              : used.engine.find_neighbors(sets.points, options, used.rows);
  if (!status) return status;
  status = asked.with_self ? write_rows_with_self(used.rows, count, run.stop, into)
                           : write_rows(used.rows, count, run.stop, into);
  if (!status || !asked.distances) return status;
  return write_row_distances(sets.points, sets.others ? *sets.others : sets.points, run.stop, into);
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
    Status status =
        sets.others ? used.engine.find_pairs_between(sets.points, *sets.others, within, used.pairs)
                    : used.engine.find_pairs(sets.points, within, used.pairs);
    if (!status) return status;
    status = write_pairs(used.pairs, options.stop, into);
    if (!status || !asked->distances) return status;
    return write_pair_distances(sets.points, sets.others ? *sets.others : sets.points, options.stop,
                                into);
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
    return find_rows(*asked, sets, used, options, into);
  };
  return answer(engine, points, others, run, result, error, ask);
}

}  // extern "C"
