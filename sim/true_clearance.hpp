// An independent check of true flights against obstacles, by beespace::Verifier: within instants
// too. It knows nothing of how velocities are found.
#pragma once

#include "sim/true_agent.hpp"

#include <beespace/obstacle.hpp>
#include <beespace/result.hpp>
#include <beespace/verify.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace beespace::sim {

class TrueClearance {
 public:
  // `obstacles`: null for none; must outlive this. An instant lasts `instant_s`.
  TrueClearance(const ObstacleMap* obstacles, double clearance_m, double instant_s);

  // Looks at a tick, from the given instant on: of each agent, `each` instants, one agent after the
  // other. Later calls may have more agents, behind the others. Returns who came too close in it,
  // ascending: indexes of agents in this order. Errors: those of Verifier::add.
  Result<std::span<const std::size_t>> look(std::int64_t instant,
                                            std::span<const Stretch> stretches, std::size_t each);

 private:
  Status look_at(Verifier& verifier, std::int64_t instant, std::span<const Stretch> flown) const;

  VerifyOptions options_;
  double instant_s_;
  std::vector<Verifier> verifiers_;  // one for each, as they join one after the other
  std::vector<std::size_t> lost_;
};

}  // namespace beespace::sim
