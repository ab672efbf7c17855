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
  Search asked;
  asked.options.threshold_m = given->threshold_m;
  asked.options.inclusive = (given->flags & BEESPACE_INCLUSIVE) != 0;
  if ((given->flags & BEESPACE_VERTICAL) != 0) asked.options.vertical_m = given->vertical_m;
  if ((given->flags & BEESPACE_MAX_RESULTS) != 0) asked.options.max_results = given->max_results;
  asked.distances = (given->flags & BEESPACE_DISTANCES) != 0;
  asked.with_self = (given->flags & BEESPACE_WITH_SELF) != 0;
  return asked;
}

}  // namespace beespace::c
