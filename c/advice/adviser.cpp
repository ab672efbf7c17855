// Advice for all agents.
#include <beespace/advise.hpp>

#include "c/advice/advice.hpp"
#include "c/advice/options.hpp"
#include "c/door/door.hpp"
#include "c/door/movers.hpp"
#include "c/door/points.hpp"
#include "c/door/watched_call.hpp"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

using namespace beespace::c;  // NOLINT(google-build-using-namespace): the functions are of C
using beespace::AdviseOptions;
using beespace::MoversView;
using beespace::PointsView;
using beespace::Result;
using beespace::RunOptions;
using beespace::Status;

// NOLINTNEXTLINE(readability-identifier-naming): a name of C
struct beespace_adviser {
  beespace::Adviser adviser;
  AdviseArrays arrays;
  beespace::Advised advised;
};

namespace {

Status read_preferred(const beespace_points* preferred, std::size_t agents,
                      std::vector<beespace::Velocity>& into) {
  const Result<PointsView> view = view_of(preferred, "preferred");
  if (!view) return view.error();
  if (view->size() != agents) {
    return invalid("there is not one preferred velocity for each agent", "preferred");
  }
  into.clear();
  for (std::size_t i = 0; i < agents; ++i) into.push_back(velocity_of((*view)[i]));
  return std::monostate{};
}

// Which option of C an error is about that C++ names as its own.
beespace::Error named_as_given(beespace::Error error) {
  const std::string& array = error.location.array;
  if (array == "intruders" || array == "unknown" || array == "fences") {
    error.location.array = array == "intruders" ? "intruder_margins"
                           : array == "unknown" ? "unknown_agents"
                                                : "fence_directions";
  }
  return error;
}

}  // namespace

extern "C" {

beespace_adviser* beespace_adviser_create(void) {
  try {
    return new beespace_adviser;
  } catch (...) {
    return nullptr;
  }
}

void beespace_adviser_free(beespace_adviser* adviser) {
  delete adviser;
}

void beespace_adviser_forget(beespace_adviser* adviser, int64_t agent) {
  constexpr std::int64_t kMost = std::numeric_limits<beespace::PointId>::max();
  if (adviser == nullptr || agent < 0 || agent > kMost) return;
  adviser->arrays.planes.forget(static_cast<beespace::PointId>(agent));
}

beespace_code beespace_advise(beespace_adviser* adviser, const beespace_points* positions,
                              const beespace_points* velocities, const beespace_points* preferred,
                              const beespace_limits* limits, const beespace_advise_options* options,
                              const beespace_run* run, beespace_advice* advice,
                              beespace_error* error) {
  if (advice != nullptr) advice->clear();
  return enter(error, [&]() -> Status {
    if (advice == nullptr) return invalid("the pointer to the advice is NULL", "advice");
    const Result<MoversView> movers = movers_of(positions, velocities, kMovers);
    if (!movers) return movers.error();
    std::optional<beespace_adviser> own;
    if (adviser == nullptr) own.emplace();
    beespace_adviser& used = adviser == nullptr ? *own : *adviser;
    Status read = read_preferred(preferred, movers->size(), used.arrays.preferred);
    if (!read) return read;
    read = read_limits(limits, movers->size(), used.arrays.limits);
    if (!read) return read;
    Status status = call_watched(run, [&](const RunOptions& run_options) -> Status {
      const Result<AdviseOptions> all =
          advise_options_of(options, movers->size(), run_options, used.arrays);
      if (!all) return all.error();
      Status done = used.adviser.advise(*movers, used.arrays.preferred, used.arrays.limits, *all,
                                        used.advised);
      return done ? done : named_as_given(std::move(done).error());
    });
    if (!status) return status;
    try {
      advice->write(used.advised, *movers);
    } catch (...) {
      advice->clear();
      throw;
    }
    return status;
  });
}

}  // extern "C"
