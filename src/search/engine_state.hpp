// The state that an Engine keeps between calls, threads and memory, and how searches get them.
#pragma once

#include "base/kept_crew.hpp"
#include "base/resources.hpp"
#include "base/stopping.hpp"
#include "exact/validate.hpp"
#include "search/cylinder_search.hpp"
#include "search/pair_answer.hpp"
#include "search/search_domain.hpp"
#include "search/tuning_overrides.hpp"
#include "tree/nearest_list.hpp"

#include <beespace/engine.hpp>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace beespace {

class __attribute__((visibility("hidden"))) Engine::EngineState {
 public:
  explicit EngineState(Crew* lent) : crew_(lent) {}

  // Threads and memory for a search of so many points. `how` says how many threads there are and
  // what ends it early: it must outlive the search.
  template <class Options>
  core::Resources resources(const Options& how, std::size_t points) {
    memory_.start_call();
    return {stoppable_.emplace(crew_.of(how.threads, points), how.stop), memory_};
  }
  core::Memory& memory() { return memory_; }

  // Measures the points and calls search(domain, resources), whose Status it returns.
  template <class Options, class Search>
  Status run(const PointsView& points, const Options& how, Search&& search) {
    const core::Resources with = resources(how, points.size());
    const Result<search::SearchDomain> domain = search::SearchDomain::of(points, with);
    if (!domain) return domain.error();
    return search(*domain, with);
  }
  template <class Options, class Search>
  Status run(const PointsView& points, const PointsView& others, const Options& how,
             Search&& search) {
    const core::Resources with = resources(how, std::max(points.size(), others.size()));
    const Result<search::SearchDomain> domain = search::SearchDomain::of(points, others, with);
    if (!domain) return domain.error();
    return search(*domain, with);
  }

  // Checks a search with a vertical threshold and calls search(CylinderSearch), whose answer it
  // returns. `others` is null for one swarm.
  template <class Search>
  auto run_cylinder(const PointsView& points, const PointsView* others, const PairOptions& options,
                    Search&& search)
      -> decltype(search(std::declval<const search::CylinderSearch&>())) {
    const bool between = others != nullptr;
    if (auto error = core::check_options(options)) return *std::move(error);
    if (auto error = between ? core::check_vertical(options, points, *others)
                             : core::check_vertical(options, points)) {
      return *std::move(error);
    }
    if (auto error = core::check_set(points, core::kPointsName)) {
      return *std::move(error);
    }
    if (between) {
      if (auto error = core::check_set(*others, core::kOthersName)) return *std::move(error);
    }
    const std::size_t most = std::max(points.size(), between ? others->size() : 0);
    const core::Resources with = resources(options, most);
    return search(search::CylinderSearch(points, others, options, with, tuning));
  }

  static bool is_vertical(const PairOptions& options, const PointsView& points,
                          const PointsView& others = {}) {
    return options.vertical_m || points.has_heights() || others.has_heights();
  }

  // Pairs, and rows of neighbours, in one swarm or, with `others`, between two.
  Status find_pairs(const PointsView& points, const PointsView* others, const PairOptions& options,
                    search::PairAnswer& answer);
  Status find_neighbors(const PointsView& points, const PointsView* others,
                        const PairOptions& options, search::PairAnswer& answer);

  const search::TuningOverrides tuning = {};
  std::vector<Nearest> nearest;                  // of the closest pair between two swarms
  std::vector<core::NearestList> nearest_lists;  // of each worker

 private:
  core::Memory memory_;
  core::KeptCrew crew_;
  std::optional<core::StoppableCrew> stoppable_;  // of the call under way
};

}  // namespace beespace
