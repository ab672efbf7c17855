#include "sim/true_clearance.hpp"

#include <beespace/mover.hpp>

#include <variant>

namespace beespace::sim {

namespace {

Mover begin_of(const Stretch& s) {
  return {point_of(s.position), velocity_of(s.velocity)};
}

Mover end_of(const Stretch& s, double lasts_s) {
  return {point_of(s.position + s.velocity * lasts_s + s.acceleration * (0.5 * lasts_s * lasts_s)),
          velocity_of(s.velocity + s.acceleration * lasts_s)};
}

}  // namespace

TrueClearance::TrueClearance(const ObstacleMap* obstacles, double clearance_m, double instant_s)
    : instant_s_(instant_s) {
  options_.threshold_m = 1.0;  // each is looked at alone
  options_.obstacles = obstacles;
  options_.clearance_m = clearance_m;
}

Result<std::span<const std::size_t>> TrueClearance::look(std::int64_t instant,
                                                         std::span<const Stretch> stretches,
                                                         std::size_t each) {
  lost_.clear();
  if (options_.obstacles == nullptr) return std::span<const std::size_t>(lost_);
  for (std::size_t agent = 0; agent < stretches.size() / each; ++agent) {
    const auto flown = stretches.subspan(agent * each, each);
    if (agent == verifiers_.size()) {
      verifiers_.emplace_back(options_);
      const double begins_s = static_cast<double>(instant) * instant_s_;
      const Mover begin[] = {begin_of(flown.front())};
      const Status seen = verifiers_[agent].add(begins_s, std::span<const Mover>(begin));
      if (!seen) return seen.error();
    }
    const std::uint64_t before = verifiers_[agent].verdict().clearance_losses;
    if (const Status seen = look_at(verifiers_[agent], instant, flown); !seen) return seen.error();
    if (verifiers_[agent].verdict().clearance_losses > before) lost_.push_back(agent);
  }
  return std::span<const std::size_t>(lost_);
}

Status TrueClearance::look_at(Verifier& verifier, std::int64_t instant,
                              std::span<const Stretch> flown) const {
  for (const Stretch& s : flown) {
    const Mover end[] = {end_of(s, instant_s_)};
    const double ends_s = static_cast<double>(++instant) * instant_s_;
    if (Status seen = verifier.add(ends_s, std::span<const Mover>(end)); !seen) return seen;
  }
  return std::monostate{};
}

}  // namespace beespace::sim
