#include "analysis/recorded/common_times.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include "analysis/geometry/geometry.hpp"
#include "io/bytes/number_text.hpp"
#include "io/recording/moment_text.hpp"

namespace beespace::analysis {
namespace {

Error unsuited(std::string message) {
  return {ErrorCode::kUnsupportedFormat, std::move(message), {}};
}

std::string quoted(const io::RecordedBee& bee) {
  return "bee '" + bee.id + "'";
}

// The first time at which one of the two has a fix and the other has none.
std::optional<Error> difference(const io::RecordedBee& first, const io::RecordedBee& second,
                                const io::Recording& recording) {
  const auto& some = first.fixes;
  const auto& others = second.fixes;
  const auto [at, there] =
      std::mismatch(some.begin(), some.end(), others.begin(), others.end(),
                    [](const Fix& a, const Fix& b) { return a.time_s == b.time_s; });
  if (at == some.end() && there == others.end()) return std::nullopt;
  const bool second_lacks =
      there == others.end() || (at != some.end() && at->time_s < there->time_s);
  const double time_s = second_lacks ? at->time_s : there->time_s;
  const io::RecordedBee& lacks = second_lacks ? second : first;
  const io::RecordedBee& has = second_lacks ? first : second;
  std::string when = io::moment_text(time_s, recording);
  if (!recording.since_1970) when = io::exact(time_s) + " s";
  return unsuited(quoted(lacks) + " has no fix at " + when + ", where " + quoted(has) +
                  " has one; this checks bees with fixes at the same times, and 'beespace replay' "
                  "checks others");
}

}  // namespace

Result<std::vector<double>> common_times(const io::Recording& recording) {
  for (const io::RecordedBee& bee : recording.bees) {
    if (!bee.path) continue;
    return unsuited(quoted(bee) +
                    " flies along the curve of a show, which has no fixes; ask "
                    "'beespace replay' about it");
  }
  std::vector<double> times;
  if (recording.bees.empty()) return times;
  const io::RecordedBee& first = recording.bees.front();
  for (const io::RecordedBee& bee : recording.bees) {
    if (auto error = difference(first, bee, recording)) return *std::move(error);
  }
  if (first.fixes.size() < 2) {
    return unsuited(
        "there is one time only, and nothing is flown in it; ask 'beespace detect' or "
        "'beespace predict' about it");
  }
  for (const Fix& fix : first.fixes) times.push_back(fix.time_s);
  return times;
}

std::optional<MissingVelocity> missing_velocity(const io::Recording& recording) {
  std::optional<MissingVelocity> missing;
  for (std::size_t bee = 0; bee < recording.bees.size(); ++bee) {
    const std::vector<Velocity>& velocities = recording.bees[bee].velocities;
    for (std::size_t fix = 0; fix < recording.bees[bee].fixes.size(); ++fix) {
      if (fix < velocities.size() && is_known(velocities[fix])) continue;
      if (!missing) missing = MissingVelocity{bee, fix, 0};
      ++missing->count;
    }
  }
  return missing;
}

Result<std::vector<Mover>> movers_at(const io::Recording& recording, std::size_t fix) {
  std::vector<Mover> movers;
  movers.reserve(recording.bees.size());
  for (std::size_t bee = 0; bee < recording.bees.size(); ++bee) {
    const auto at = in_metres(recording, bee, fix, Geometry::kSpace);
    if (!at) {
      Error error = at.error();
      error.message.insert(0, quoted(recording.bees[bee]) + ": ");
      return error;
    }
    movers.push_back({at->position, at->velocity.value_or(Velocity{})});
  }
  return movers;
}

}  // namespace beespace::analysis
