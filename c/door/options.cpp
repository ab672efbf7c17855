#include "c/door/options.hpp"

#include "c/door/door.hpp"
#include "c/door/structs.hpp"

namespace beespace::c {

PairOptions Search::pairs(const RunOptions& run) const {
  PairOptions all = options;
  all.threads = run.threads;
  all.stop = run.stop;
  return all;
}

SearchOptions Search::points(const RunOptions& run) const {
  return pairs(run).without_limit();
}

Result<Search> search_of(const beespace_search* search, std::uint32_t known) {
  const Result<beespace_search> given = read_struct(search, "search");
  if (!given) return given.error();
  if ((given->flags & ~known) != 0) {
    return invalid("flags ask for what this function cannot do", "search");
  }
  const auto has = [&](std::uint32_t flag) { return (given->flags & flag) != 0; };
  if (!has(BEESPACE_VERTICAL) && given->vertical_m != 0.0) {
    return invalid("vertical_m is given without its flag, BEESPACE_VERTICAL", "search");
  }
  if (!has(BEESPACE_MAX_RESULTS) && given->max_results != 0) {
    return invalid("max_results is given without its flag, BEESPACE_MAX_RESULTS", "search");
  }
  Search asked;
  asked.options.threshold_m = given->threshold_m;
  asked.options.inclusive = has(BEESPACE_INCLUSIVE);
  if (has(BEESPACE_VERTICAL)) asked.options.vertical_m = given->vertical_m;
  if (has(BEESPACE_MAX_RESULTS)) asked.options.max_results = given->max_results;
  asked.distances = has(BEESPACE_DISTANCES);
  asked.with_self = has(BEESPACE_WITH_SELF);
  return asked;
}

}  // namespace beespace::c
