// The index: questions about any position.
#include <beespace/index.hpp>

#include "c/door/door.hpp"
#include "c/door/options.hpp"
#include "c/door/points.hpp"
#include "c/door/result.hpp"
#include "c/door/watched_call.hpp"

#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <utility>

using namespace beespace::c;  // NOLINT(google-build-using-namespace): the functions are of C
using beespace::AroundOptions;
using beespace::IdRows;
using beespace::Index;
using beespace::NearestRows;
using beespace::Point;
using beespace::PointId;
using beespace::PointsView;
using beespace::Result;
using beespace::RunOptions;
using beespace::Status;

// NOLINTNEXTLINE(readability-identifier-naming): a name of C
struct beespace_index {
  Index index;
};

namespace {

Result<PointId> id_of(std::int64_t id) {
  if (id < 0 || id > std::numeric_limits<PointId>::max()) {
    return invalid("there is no point of this id in the index", "id");
  }
  return static_cast<PointId>(id);
}

// Asks ask(view of the places, run options), which writes into the result.
template <class Ask>
beespace_code answer_of(const beespace_index* index, const beespace_points* places,
                        const beespace_run* run, beespace_result* result, beespace_error* error,
                        Ask&& ask) {
  const beespace_code code = enter(error, [&]() -> Status {
    if (index == nullptr) return invalid("the pointer to the index is NULL", "index");
    if (result == nullptr) return invalid("the pointer to the result is NULL", "result");
    result->clear();
    const Result<PointsView> view = view_of(places, "places");
    if (!view) return view.error();
    return call_watched(run,
                        [&](const RunOptions& options) -> Status { return ask(*view, options); });
  });
  if (code != BEESPACE_OK && result != nullptr) result->clear();
  return code;
}

// Calls change(index, id, position) where all of these are there.
template <class Change>
beespace_code change(beespace_index* index, std::int64_t id, const double* position,
                     beespace_error* error, Change&& make) {
  return enter(error, [&]() -> Status {
    if (index == nullptr) return invalid("the pointer to the index is NULL", "index");
    if (position == nullptr) return invalid("the pointer to the position is NULL", "position");
    const Result<PointId> known = id_of(id);
    if (!known) return known.error();
    return make(index->index, *known, Point{position[0], position[1], position[2]});
  });
}

}  // namespace

extern "C" {

beespace_code beespace_index_create(const beespace_points* points, const beespace_run* run,
                                    beespace_index** index, beespace_error* error) {
  if (index != nullptr) *index = nullptr;
  return enter(error, [&]() -> Status {
    if (index == nullptr) return invalid("the pointer to the index is NULL", "index");
    const Result<PointsView> view = view_of(points, "points");
    if (!view) return view.error();
    std::unique_ptr<beespace_index> made;
    Status status = call_watched(run, [&](const RunOptions& options) -> Status {
      Result<Index> built = Index::build(*view, options);
      if (!built) return std::move(built).error();
      made = std::make_unique<beespace_index>(beespace_index{std::move(*built)});
      return std::monostate{};
    });
    if (status) *index = made.release();
    return status;
  });
}

void beespace_index_free(beespace_index* index) {
  delete index;
}

int64_t beespace_index_size(const beespace_index* index) {
  return index == nullptr ? 0 : static_cast<int64_t>(index->index.size());
}

beespace_code beespace_index_position(const beespace_index* index, int64_t id, double position[3],
                                      beespace_error* error) {
  return enter(error, [&]() -> Status {
    if (index == nullptr) return invalid("the pointer to the index is NULL", "index");
    if (position == nullptr) return invalid("the pointer to the position is NULL", "position");
    const Result<PointId> known = id_of(id);
    if (!known) return known.error();
    const Result<Point> point = index->index.point(*known);
    if (!point) return point.error();
    position[0] = point->x;
    position[1] = point->y;
    position[2] = point->z;
    return std::monostate{};
  });
}

beespace_code beespace_index_around(const beespace_index* index, const beespace_points* places,
                                    const beespace_search* search, const beespace_run* run,
                                    beespace_result* result, beespace_error* error) {
  const auto ask = [&](const PointsView& view, const RunOptions& options) -> Status {
    const Result<Search> asked = search_of(search, BEESPACE_INCLUSIVE | BEESPACE_MAX_RESULTS);
    if (!asked) return asked.error();
    const AroundOptions around{asked->options.threshold_m, asked->options.inclusive,
                               options.threads, asked->options.max_results, options.stop};
    const Result<IdRows> rows = index->index.find_around(view, around);
    if (!rows) return rows.error();
    return write_rows(*rows, view.size(), options.stop, *result);
  };
  return answer_of(index, places, run, result, error, ask);
}

beespace_code beespace_index_around_each(const beespace_index* index, const beespace_points* places,
                                         const double* radii_m, const beespace_search* search,
                                         const beespace_run* run, beespace_result* result,
                                         beespace_error* error) {
  const auto ask = [&](const PointsView& view, const RunOptions& options) -> Status {
    const Result<Search> asked = search_of(search, BEESPACE_INCLUSIVE | BEESPACE_MAX_RESULTS);
    if (!asked) return asked.error();
    if (asked->options.threshold_m != 0.0) {
      return invalid("there is a radius for each place: threshold_m must be 0", "search");
    }
    if (radii_m == nullptr && !view.empty()) return invalid("the pointer is NULL", "radii");
    AroundOptions around;
    around.inclusive = asked->options.inclusive;
    around.threads = options.threads;
    around.max_results = asked->options.max_results;
    around.stop = options.stop;
    const Result<IdRows> rows =
        index->index.find_around(view, std::span(radii_m, view.size()), around);
    if (!rows) return rows.error();
    return write_rows(*rows, view.size(), options.stop, *result);
  };
  return answer_of(index, places, run, result, error, ask);
}

beespace_code beespace_index_nearest(const beespace_index* index, const beespace_points* places,
                                     int64_t k, const beespace_run* run, beespace_result* result,
                                     beespace_error* error) {
  const auto ask = [&](const PointsView& view, const RunOptions& options) -> Status {
    if (k < 0) return invalid("k is below zero", "k");
    const Result<NearestRows> rows =
        index->index.k_nearest(view, static_cast<std::size_t>(k), options);
    if (!rows) return rows.error();
    return write_nearest_rows(rows->entries, rows->length, view.size(), options.stop, *result);
  };
  return answer_of(index, places, run, result, error, ask);
}

beespace_code beespace_index_insert(beespace_index* index, const double position[3], int64_t* id,
                                    beespace_error* error) {
  return change(index, 0, position, error, [&](Index& used, PointId, const Point& point) -> Status {
    const Result<PointId> given = used.insert(point);
    if (!given) return given.error();
    if (id != nullptr) *id = *given;
    return std::monostate{};
  });
}

beespace_code beespace_index_move(beespace_index* index, int64_t id, const double position[3],
                                  beespace_error* error) {
  return change(index, id, position, error,
                [](Index& used, PointId known, const Point& point) -> Status {
                  return used.move(known, point);
                });
}

beespace_code beespace_index_remove(beespace_index* index, int64_t id, beespace_error* error) {
  constexpr double kUnused[3] = {};
  return change(index, id, kUnused, error, [](Index& used, PointId known, const Point&) -> Status {
    return used.remove(known);
  });
}

}  // extern "C"
