#include "avoidance/one_in_round.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace beespace::avoidance {

namespace {

Error about(PointId id, const std::string& message) {
  return {ErrorCode::kInvalidArgument, "agent " + std::to_string(id) + " " + message, {}};
}

}  // namespace

std::optional<Error> OneInRound::take(const AgentInRound& agent,
                                      std::span<const AgentInRound> others,
                                      const AdviseOptions& options) {
  all_.assign(1, &agent);
  for (const AgentInRound& other : others) all_.push_back(&other);
  std::sort(all_.begin(), all_.end(), [](const auto* a, const auto* b) { return a->id < b->id; });
  ids_.clear();
  movers_.clear();
  preferred_.clear();
  limits_.clear();
  claims_.clear();
  if (auto error = take_others(agent)) return error;
  own_ = static_cast<std::size_t>(std::find(all_.begin(), all_.end(), &agent) - all_.begin());
  options_ = options;
  options_.claims = claims_;
  options_.method = AdviseMethod::kCertified;
  take_unknown(options);
  return std::nullopt;
}

std::optional<Error> OneInRound::take_others(const AgentInRound& agent) {
  for (const AgentInRound* one : all_) {
    if (!ids_.empty() && ids_.back() == one->id) {
      return about(one->id, "is there twice; give each agent once");
    }
    if ((one->claim == nullptr) != (agent.claim == nullptr)) {
      return about(one->id, std::string(one->claim == nullptr ? "has no claim" : "has a claim") +
                                ", unlike agent " + std::to_string(agent.id) +
                                "; give the claims of all, or of none");
    }
    ids_.push_back(one->id);
    movers_.push_back(one->mover);
    preferred_.push_back(one->preferred);
    limits_.push_back(one->limits);
    if (one->claim != nullptr) claims_.push_back(*one->claim);
  }
  return std::nullopt;
}

// An unknown agent that is not among the others is only a ball.
void OneInRound::take_unknown(const AdviseOptions& options) {
  unknown_.assign(options.unknown.begin(), options.unknown.end());
  for (UnknownAgent& ball : unknown_) {
    if (!ball.agent) continue;
    const auto at = std::lower_bound(ids_.begin(), ids_.end(), *ball.agent);
    const bool found = at != ids_.end() && *at == *ball.agent;
    ball.agent = found ? std::optional(static_cast<PointId>(at - ids_.begin())) : std::nullopt;
  }
  options_.unknown = unknown_;
}

std::optional<PointId> OneInRound::number_in(const Intake& intake) const {
  for (std::size_t taken = 0; taken < intake.movers().size(); ++taken) {
    if (intake.given_bees()[taken] == own_) return static_cast<PointId>(taken);
  }
  return std::nullopt;
}

Error OneInRound::refusal() const {
  for (const Refused& refused : advised_.refused) {
    if (refused.kind == RefusedKind::kState && refused.index == own_) return refused.error;
  }
  return about(ids_[own_], "is an unknown agent, and gets no advice");
}

std::span<const char> OneInRound::too_close(const Intake& intake) {
  too_close_.clear();
  for (std::size_t taken = 0; taken < intake.movers().size(); ++taken) {
    too_close_.push_back(all_[intake.given_bees()[taken]]->too_close ? 1 : 0);
  }
  return too_close_;
}

}  // namespace beespace::avoidance
