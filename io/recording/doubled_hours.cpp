#include "io/recording/doubled_hours.hpp"

#include <utility>

namespace beespace::io {
namespace {

constexpr double kTimesStep = 1.5;  // so much longer may a step be than the one before it

}  // namespace

DoubledHours::Bee& DoubledHours::bee_of(std::string_view id) {
  const auto found = bees_.find(id);
  return found != bees_.end() ? found->second : bees_.try_emplace(std::string(id)).first->second;
}

std::optional<Error> DoubledHours::take(std::string_view id, double time_s) {
  Bee& bee = bee_of(id);
  if (bee.pending) return bee.pending;
  bee.again = false;
  if (bee.last_s) bee.step_s = time_s - *bee.last_s;
  bee.last_s = time_s;
  return std::nullopt;
}

// The first record within the hour is taken for one of the first time, and must be followed by one
// that begins again, at the pace of those before; from there on all are of the second time.
Result<double> DoubledHours::take_doubled(std::string_view id, double time_s, double by_s,
                                          Error unclear) {
  Bee& bee = bee_of(id);
  if (bee.again && bee.last_s && time_s > *bee.last_s + by_s) bee.again = false;  // another year
  if (!bee.again && bee.pending && time_s <= *bee.last_s) {
    if (time_s + by_s - *bee.last_s > kTimesStep * bee.step_s) return unclear;
    bee.again = true;
    bee.pending.reset();
  }
  const double at_s = bee.again ? time_s + by_s : time_s;
  const double step_s = bee.last_s ? at_s - *bee.last_s : 0.0;
  if (step_s < 0.0 || (bee.again && step_s == 0.0)) return unclear;
  if (!bee.again && !bee.pending) bee.pending = std::move(unclear);
  bee.step_s = step_s;
  bee.last_s = at_s;
  return at_s;
}

std::optional<Error> DoubledHours::unclear() const {
  for (const auto& [id, bee] : bees_) {
    if (bee.pending) return bee.pending;
  }
  return std::nullopt;
}

}  // namespace beespace::io
