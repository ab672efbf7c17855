// What is behind beespace_guide.
#pragma once

#include "c/door/agents.hpp"
#include "c/door/door.hpp"

#include <beespace.h>
#include <beespace/guide.hpp>
#include <beespace/obstacle.hpp>
#include <beespace/point.hpp>
#include <beespace/result.hpp>

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

// NOLINTNEXTLINE(readability-identifier-naming): a name of C
struct beespace_guide {
  std::unique_ptr<const beespace::ObstacleMap> obstacles;  // the guide refers to it
  beespace::Guide guide;
  // What the last call gave away pointers to.
  std::vector<beespace::Point> claim;
  std::vector<std::int64_t> touches;
  std::vector<std::int64_t> near_obstacles;
  std::vector<std::int64_t> near_fences;
};

namespace beespace::c {

// Calls work(the handle), which returns a Status.
template <class Handle, class Work>
beespace_code with_guide(Handle* guide, beespace_error* error, Work&& work) {
  return enter(error, [&]() -> Status {
    if (guide == nullptr) return invalid("the pointer to the guide is NULL", "guide");
    Status done = std::forward<Work>(work)(*guide);
    if (done || !done.error().location.record) return done;
    const ErrorLocation& where = done.error().location;
    if (where.array != "agents") return done;
    return with_agent_number(done.error(), *where.record);
  });
}

}  // namespace beespace::c
