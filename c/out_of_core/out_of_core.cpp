// Points beyond memory: where they wait, and how they come there.
#include "c/out_of_core/out_of_core.hpp"

#include "c/door/door.hpp"
#include "c/door/number_column.hpp"
#include "c/door/points.hpp"
#include "c/door/structs.hpp"

#include <beespace/points_view.hpp>

#include <cstdint>
#include <memory>
#include <span>

using namespace beespace::c;  // NOLINT(google-build-using-namespace): the functions are of C
using beespace::OutOfCore;
using beespace::OutOfCoreFacts;
using beespace::OutOfCoreOptions;
using beespace::PointsView;
using beespace::Result;
using beespace::Status;

namespace {

Result<PointsView> view_with_heights(const beespace_points* points, const double* heights_m) {
  Result<PointsView> view = view_of(points, "points");
  if (!view || heights_m == nullptr || view->empty()) return view;
  if (const char* const problem = NumberColumn(heights_m).problem(view->size())) {
    return invalid(problem, "heights");
  }
  return view->with_heights(std::span(heights_m, view->size()));
}

// Calls take(search, view).
template <class Take>
beespace_code take_points(beespace_out_of_core* out_of_core, const beespace_points* points,
                          const double* heights_m, beespace_error* error, Take&& take) {
  return enter(error, [&]() -> Status {
    if (out_of_core == nullptr) return invalid("the pointer to the search is NULL", "out_of_core");
    const Result<PointsView> view = view_with_heights(points, heights_m);
    if (!view) return view.error();
    return take(out_of_core->search, *view);
  });
}

}  // namespace

extern "C" {

beespace_code beespace_out_of_core_create(const beespace_out_of_core_options* options,
                                          beespace_out_of_core** out_of_core,
                                          beespace_error* error) {
  if (out_of_core != nullptr) *out_of_core = nullptr;
  return enter(error, [&]() -> Status {
    if (out_of_core == nullptr) return invalid("the pointer to the search is NULL", "out_of_core");
    const Result<beespace_out_of_core_options> given = read_struct(options, "options");
    if (!given) return given.error();
    const Result<OutOfCoreOptions> wanted = options_of(*given);
    if (!wanted) return wanted.error();
    const double unit_m = given->height_unit_m == 0.0 ? 1.0 : given->height_unit_m;
    *out_of_core =
        std::make_unique<beespace_out_of_core>(beespace_out_of_core{OutOfCore(*wanted), unit_m})
            .release();
    return std::monostate{};
  });
}

void beespace_out_of_core_free(beespace_out_of_core* out_of_core) {
  delete out_of_core;
}

int64_t beespace_out_of_core_size(const beespace_out_of_core* out_of_core) {
  return out_of_core == nullptr ? 0 : static_cast<int64_t>(out_of_core->search.size());
}

beespace_code beespace_out_of_core_add(beespace_out_of_core* out_of_core,
                                       const beespace_points* points, const double* heights_m,
                                       beespace_error* error) {
  return take_points(
      out_of_core, points, heights_m, error,
      [](OutOfCore& search, const PointsView& view) -> Status { return search.add(view); });
}

beespace_code beespace_out_of_core_refer(beespace_out_of_core* out_of_core,
                                         const beespace_points* points, const double* heights_m,
                                         beespace_error* error) {
  return take_points(
      out_of_core, points, heights_m, error,
      [](OutOfCore& search, const PointsView& view) -> Status { return search.refer(view); });
}

beespace_code beespace_out_of_core_facts_of(const beespace_out_of_core* out_of_core,
                                            beespace_out_of_core_facts* facts,
                                            beespace_error* error) {
  return enter(error, [&]() -> Status {
    if (out_of_core == nullptr) return invalid("the pointer to the search is NULL", "out_of_core");
    const OutOfCoreFacts known = out_of_core->search.facts();
    beespace_out_of_core_facts told{};
    told.cells = static_cast<std::int64_t>(known.cells);
    told.copies = static_cast<std::int64_t>(known.copies);
    told.crowded_cells = static_cast<std::int64_t>(known.crowded_cells);
    told.largest_cell = static_cast<std::int64_t>(known.largest_cell);
    return write_struct(facts, told, "facts");
  });
}

}  // extern "C"
