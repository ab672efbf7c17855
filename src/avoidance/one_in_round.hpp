// The input of one agent and of those that it may meet, as that of a call for all of them: in
// ascending order of ids, on which the order of pairs and constraints depends.
#pragma once

#include "avoidance/intake.hpp"

#include <beespace/advise.hpp>

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace beespace::avoidance {

class OneInRound {
 public:
  // Errors: two of one id, claims of some only.
  std::optional<Error> take(const AgentInRound& agent, std::span<const AgentInRound> others,
                            const AdviseOptions& options);

  [[nodiscard]] const AdviseOptions& options() const { return options_; }
  [[nodiscard]] std::span<const Mover> movers() const { return movers_; }
  [[nodiscard]] std::span<const Velocity> preferred() const { return preferred_; }
  [[nodiscard]] std::span<const FlightLimits> limits() const { return limits_; }
  [[nodiscard]] std::span<const PointId> ids() const { return ids_; }
  [[nodiscard]] Advised& advised() { return advised_; }

  // The number of the agent among those that were taken in; none if it was not.
  [[nodiscard]] std::optional<PointId> number_in(const Intake& intake) const;
  // Why it was not.
  [[nodiscard]] Error refusal() const;
  // The marks of those that were taken in.
  [[nodiscard]] std::span<const char> too_close(const Intake& intake);

 private:
  std::optional<Error> take_others(const AgentInRound& agent);
  void take_unknown(const AdviseOptions& options);

  std::vector<const AgentInRound*> all_;
  std::vector<PointId> ids_;
  std::vector<Mover> movers_;
  std::vector<Velocity> preferred_;
  std::vector<FlightLimits> limits_;
  std::vector<Claim> claims_;
  std::vector<UnknownAgent> unknown_;
  std::vector<char> too_close_;
  AdviseOptions options_;
  std::size_t own_ = 0;  // the agent's number
  Advised advised_;
};

}  // namespace beespace::avoidance
