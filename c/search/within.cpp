// Questions with a threshold whose answer has an entry a point: at risk, counts, groups, and the
// nearest within it.
#include "c/door/options.hpp"
#include "c/door/question.hpp"

using namespace beespace::c;  // NOLINT(google-build-using-namespace): the functions are of C
using beespace::Result;
using beespace::RunOptions;
using beespace::SearchOptions;
using beespace::Status;

extern "C" {

beespace_code beespace_at_risk(beespace_engine* engine, const beespace_points* points,
                               const beespace_points* others, const beespace_search* search,
                               const beespace_run* run, beespace_result* result,
                               beespace_error* error) {
  const auto ask = [search](const PointSets& sets, beespace_engine& used, const RunOptions& options,
                            beespace_result& into) -> Status {
    const Result<Search> asked = search_of(search, kWithin);
    if (!asked) return asked.error();
    const SearchOptions within = asked->points(options);
    Status status =
        sets.others ? used.engine.find_at_risk_between(sets.points, *sets.others, within, used.ids)
                    : used.engine.find_at_risk(sets.points, within, used.ids);
    if (status) write_ids(used.ids, into);
    return status;
  };
  return answer(engine, points, others, run, result, error, ask);
}

beespace_code beespace_count(beespace_engine* engine, const beespace_points* points,
                             const beespace_points* others, const beespace_search* search,
                             const beespace_run* run, beespace_result* result,
                             beespace_error* error) {
  const auto ask = [search](const PointSets& sets, beespace_engine& used, const RunOptions& options,
                            beespace_result& into) -> Status {
    const Result<Search> asked =
        search_of(search, sets.others ? kWithin : kWithin | BEESPACE_WITH_SELF);
    if (!asked) return asked.error();
    const SearchOptions within = asked->points(options);
    Status status = sets.others ? used.engine.count_neighbors_between(sets.points, *sets.others,
                                                                      within, used.counts)
                                : used.engine.count_neighbors(sets.points, within, used.counts);
    if (status) write_counts(used.counts, asked->with_self, into);
    return status;
  };
  return answer(engine, points, others, run, result, error, ask);
}

beespace_code beespace_groups(beespace_engine* engine, const beespace_points* points,
                              const beespace_search* search, const beespace_run* run,
                              beespace_result* result, beespace_error* error) {
  const auto ask = [search](const PointSets& sets, beespace_engine& used, const RunOptions& options,
                            beespace_result& into) -> Status {
    const Result<Search> asked = search_of(search, kWithin);
    if (!asked) return asked.error();
    Status status =
        used.engine.find_conflict_groups(sets.points, asked->points(options), used.rows);
    if (!status) return status;
    return write_rows(used.rows, used.rows.size(), options.stop, into);
  };
  return answer(engine, points, nullptr, run, result, error, ask);
}

beespace_code beespace_nearest_within(beespace_engine* engine, const beespace_points* points,
                                      const beespace_points* others, const beespace_search* search,
                                      const beespace_run* run, beespace_result* result,
                                      beespace_error* error) {
  const auto ask = [search](const PointSets& sets, beespace_engine& used, const RunOptions& options,
                            beespace_result& into) -> Status {
    const Result<Search> asked = search_of(search, kWithin);
    if (!asked) return asked.error();
    const SearchOptions within = asked->points(options);
    Status status = sets.others
                        ? used.engine.find_nearest_within_between(sets.points, *sets.others, within,
                                                                  used.nearest)
                        : used.engine.find_nearest_within(sets.points, within, used.nearest);
    if (!status) return status;
    return write_nearest(used.nearest, options.stop, into);
  };
  return answer(engine, points, others, run, result, error, ask);
}

}  // extern "C"
