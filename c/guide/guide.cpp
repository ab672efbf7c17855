// The planner's side of a fleet.
#include <beespace/guide.hpp>

#include "c/advice/options.hpp"
#include "c/door/agents.hpp"
#include "c/door/door.hpp"
#include "c/door/structs.hpp"
#include "c/door/watched_call.hpp"
#include "c/guide/guidance.hpp"
#include "c/guide/guide.hpp"
#include "c/guide/messages.hpp"
#include "c/guide/tube.hpp"
#include "c/obstacles/obstacles.hpp"

#include <beespace/obstacle.hpp>

#include <memory>
#include <utility>

using namespace beespace::c;  // NOLINT(google-build-using-namespace): the functions are of C
using beespace::Guide;
using beespace::GuideOptions;
using beespace::ObstacleMap;
using beespace::Result;
using beespace::RunOptions;
using beespace::Status;
using beespace::Tube;

namespace {

// Refers to `fences` and to `map`, which the caller's map is copied to.
Result<GuideOptions> guide_options_of(const beespace_guide_options* options,
                                      std::vector<beespace::Fence>& fences, ObstacleMap& map) {
  const Result<beespace_guide_options> given = read_struct(options, "options");
  if (!given) return given.error();
  if ((given->flags & ~static_cast<std::uint32_t>(BEESPACE_PLANAR)) != 0) {
    return invalid("flags ask for what this function cannot do", "options");
  }
  if (given->more_reserved != 0) {
    return invalid("the reserved field of this structure is not zero", "options");
  }
  const auto figures = figures_of(given->figures);
  if (!figures) return figures.error();
  const auto link = link_of(given->link);
  if (!link) return link.error();
  Status read = read_fences(given->fence_directions, given->fence_offsets_m, fences);
  if (!read) return std::move(read).error();
  const auto separation = separation_of(given->shape, given->vertical_factor, given->vertical_m);
  if (!separation) return separation.error();
  GuideOptions all;
  all.threshold_m = given->threshold_m;
  all.separation = *separation;
  all.link = *link;
  all.figures = *figures;
  all.limits = {given->max_speed_mps, given->max_acceleration_mps2};
  if (given->obstacles != nullptr) {
    map = given->obstacles->map;
    all.obstacles = &map;
  }
  all.fences = fences;
  all.clearance_m = given_or_not(given->clearance_m);
  all.intruder_horizon_s = given_or(given->intruder_horizon_s, all.intruder_horizon_s);
  all.planar = (given->flags & BEESPACE_PLANAR) != 0;
  all.epoch = given->epoch == 0 ? 1 : given->epoch;
  all.threads = threads_of(given->threads);
  return all;
}

}  // namespace

extern "C" {

beespace_code beespace_guide_create(const beespace_guide_options* options, beespace_guide** guide,
                                    beespace_error* error) {
  if (guide != nullptr) *guide = nullptr;
  return enter(error, [&]() -> Status {
    if (guide == nullptr) return invalid("the pointer to the guide is NULL", "guide");
    auto map = std::make_unique<ObstacleMap>();
    std::vector<beespace::Fence> fences;
    const Result<GuideOptions> all = guide_options_of(options, fences, *map);
    if (!all) return all.error();
    Result<Guide> made = Guide::make(*all);
    if (!made) return made.error();
    *guide = new beespace_guide{std::move(map), std::move(made).value(), {}, {}, {}, {}};
    return std::monostate{};
  });
}

void beespace_guide_free(beespace_guide* guide) {
  delete guide;
}

int64_t beespace_guide_size(const beespace_guide* guide) {
  return guide == nullptr ? 0 : static_cast<int64_t>(guide->guide.size());
}

beespace_code beespace_guide_tube(const beespace_guide* guide, int64_t agent, beespace_tube* tube,
                                  beespace_error* error) {
  return with_guide(guide, error, [&](const beespace_guide& used) -> Status {
    const Result<Tube> found = used.guide.tube(agent_id_of(agent));
    return found ? write_tube(*found, tube) : Status(found.error());
  });
}

beespace_code beespace_guide_claim(beespace_guide* guide, int64_t agent, const double** xyz,
                                   int64_t* count, beespace_error* error) {
  if (xyz != nullptr) *xyz = nullptr;
  if (count != nullptr) *count = 0;
  return with_guide(guide, error, [&](beespace_guide& used) -> Status {
    if (xyz == nullptr || count == nullptr) return invalid("a pointer to the claim is NULL", "xyz");
    auto found = used.guide.claim(agent_id_of(agent));
    if (!found) return found.error();
    used.claim = std::move(found).value();
    *xyz = used.claim.empty() ? nullptr : &used.claim.front().x;
    *count = static_cast<int64_t>(used.claim.size());
    return std::monostate{};
  });
}

beespace_code beespace_guide_step(beespace_guide* guide, int64_t now, const beespace_run* run,
                                  beespace_guidance* guidance, beespace_error* error) {
  if (guidance != nullptr) guidance->clear();
  const beespace_code code = with_guide(guide, error, [&](beespace_guide& used) -> Status {
    if (guidance == nullptr) return invalid("the pointer to the guidance is NULL", "guidance");
    return call_watched(run, [&](const RunOptions& options) -> Status {
      Status stepped = used.guide.step(now, guidance->given, options.stop);
      if (stepped) guidance->write();
      return stepped;
    });
  });
  if (code != BEESPACE_OK && guidance != nullptr) guidance->clear();
  return code;
}

}  // extern "C"
