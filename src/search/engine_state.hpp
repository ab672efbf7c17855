// The state that an Engine keeps between calls, threads and memory, and how searches get them.
#pragma once

#include "base/crew_size.hpp"
#include "base/resources.hpp"
#include "exact/validate.hpp"
#include "search/cylinder_search.hpp"
#include "search/search_domain.hpp"
#include "search/tuning_overrides.hpp"

#include <beespace/engine.hpp>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace beespace {

class Engine::EngineState {
 public:
  explicit EngineState(Crew* lent) : lent_(lent) {}

  // Threads and memory for a search of so many points.
  core::Resources resources(unsigned threads, std::size_t points) {
    memory_.start_call();
    return {crew(threads, points), memory_};
  }
  core::Memory& memory() { return memory_; }

  // Measures the points and calls search(domain, resources), whose Status it returns.
  template <class Search>
  Status run(const PointsView& points, unsigned threads, Search&& search) {
    const core::Resources with = resources(threads, points.size());
    const Result<search::SearchDomain> domain = search::SearchDomain::of(points, with);
    if (!domain) return domain.error();
    return search(*domain, with);
  }
  template <class Search>
  Status run(const PointsView& points, const PointsView& others, unsigned threads,
             Search&& search) {
    const core::Resources with = resources(threads, std::max(points.size(), others.size()));
    const Result<search::SearchDomain> domain = search::SearchDomain::of(points, others, with);
    if (!domain) return domain.error();
    return search(*domain, with);
  }

  // Checks a search with a vertical threshold and calls search(CylinderSearch), whose answer it
  // returns. `others` is null for one swarm.
  template <class Search>
  auto run_cylinder(const PointsView& points, const PointsView* others,
                    const SearchOptions& options, Search&& search)
      -> decltype(search(std::declval<const search::CylinderSearch&>())) {
    const bool between = others != nullptr;
    if (auto error = core::check_options(options)) return *std::move(error);
    if (auto error = between ? core::check_vertical(options, points.size(), others->size())
                             : core::check_vertical(options, points.size())) {
      return *std::move(error);
    }
    if (auto error = core::check_set(points, between ? core::kPointsName : "")) {
      return *std::move(error);
    }
    if (between) {
      if (auto error = core::check_set(*others, core::kOthersName)) return *std::move(error);
    }
    const std::size_t most = std::max(points.size(), between ? others->size() : 0);
    const core::Resources with = resources(options.threads, most);
    return search(search::CylinderSearch(points, others, options, with, tuning));
  }

  const search::TuningOverrides tuning = {};
  std::vector<Nearest> nearest;  // of the closest pair between two swarms

 private:
  Crew& crew(unsigned threads, std::size_t points) {
    if (lent_ != nullptr) return *lent_;
    const unsigned size = cpu::crew_size(threads, points);
    if (size == 1) return alone_;
    if (!own_ || asked_for_ != size) {
      own_.emplace(size);
      asked_for_ = size;
    }
    return *own_;
  }

  core::Memory memory_;
  Crew* lent_;
  Crew alone_;
  std::optional<ThreadCrew> own_;
  unsigned asked_for_ = 0;
};

}  // namespace beespace
