// Questions without a threshold: the nearest points, and the closest pair.
#include <beespace/nearest.hpp>

#include "c/door/question.hpp"

#include <beespace/index.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <span>

using namespace beespace::c;  // NOLINT(google-build-using-namespace): the functions are of C
using beespace::ClosestPair;
using beespace::Index;
using beespace::Nearest;
using beespace::NearestRows;
using beespace::Pair;
using beespace::Result;
using beespace::RunOptions;
using beespace::Status;

namespace {

// Of one neighbour the search by cells is faster than that of many.
Status find_one(const PointSets& sets, beespace_engine& used, const RunOptions& run,
                beespace_result& into) {
  Status status =
      sets.others ? used.engine.find_nearest_between(sets.points, *sets.others, used.nearest, run)
                  : used.engine.find_nearest(sets.points, used.nearest, run);
  if (!status) return status;
  const std::size_t count = sets.points.size();
  // All have one, or there is no point to be had.
  const bool found = count != 0 && used.nearest.front().id != Nearest::kNone;
  return write_nearest_rows(
      found ? std::span<const Nearest>(used.nearest) : std::span<const Nearest>(), found ? 1 : 0,
      count, run.stop, into);
}

Status find_many(const PointSets& sets, std::size_t k, beespace_engine& used, const RunOptions& run,
                 beespace_result& into) {
  Status status = std::monostate{};
  if (sets.others) {
    const Result<Index> index = Index::build(*sets.others, run);
    if (!index) {
      beespace::Error error = index.error();
      if (error.location.array == "points") error.location.array = "others";
      return error;
    }
    Result<NearestRows> rows = index->k_nearest(sets.points, k, run);
    if (!rows) {
      beespace::Error error = rows.error();
      if (error.location.array == "places") error.location.array = "points";
      return error;
    }
    used.nearest_rows = std::move(*rows);
  } else {
    status = used.engine.find_k_nearest(sets.points, k, used.nearest_rows, run);
    if (!status) return status;
  }
  return write_nearest_rows(used.nearest_rows.entries, used.nearest_rows.length, sets.points.size(),
                            run.stop, into);
}

}  // namespace

extern "C" {

beespace_code beespace_nearest(beespace_engine* engine, const beespace_points* points,
                               const beespace_points* others, int64_t k, const beespace_run* run,
                               beespace_result* result, beespace_error* error) {
  const auto ask = [k](const PointSets& sets, beespace_engine& used, const RunOptions& options,
                       beespace_result& into) -> Status {
    if (k < 0) return invalid("k is below zero", "k");
    if (k == 1) return find_one(sets, used, options, into);
    return find_many(sets, static_cast<std::size_t>(k), used, options, into);
  };
  return answer(engine, points, others, run, result, error, ask);
}

beespace_code beespace_closest_pair(beespace_engine* engine, const beespace_points* points,
                                    const beespace_points* others, const beespace_run* run,
                                    beespace_result* result, beespace_error* error) {
  const auto ask = [](const PointSets& sets, beespace_engine& used, const RunOptions& options,
                      beespace_result& into) -> Status {
    const Result<std::optional<ClosestPair>> closest =
        sets.others ? used.engine.find_closest_pair_between(sets.points, *sets.others, options)
                    : used.engine.find_closest_pair(sets.points, options);
    if (!closest) return closest.error();
    if (*closest) {
      const std::array pair = {Pair{(*closest)->first, (*closest)->second}};
      Status status = write_pairs(pair, options.stop, into);
      if (!status) return status;
      into.distances_m.resize(1);
      into.distances_m[0] = (*closest)->distance_m;
    }
    return std::monostate{};
  };
  return answer(engine, points, others, run, result, error, ask);
}

}  // extern "C"
