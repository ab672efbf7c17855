// Who is in the fleet of a Guide.
#include "fleet/check_command.hpp"
#include "guide/guide_state.hpp"
#include "motion/flush.hpp"
#include "motion/validate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace beespace {

Result<Tube> Guide::State::tube_for(const JoinRequest& request) const {
  const FleetFigures figures = request.figures.value_or(options_.figures);
  if (Status clock = check_clock(figures); !clock) return std::move(clock).error();
  if (Status ground = check_ground(figures); !ground) return std::move(ground).error();
  auto tube = tube_of(figures, options_.link, request.limits.value_or(options_.limits));
  if (!tube) return tube;
  if (auto error = fleet::check_planned(tube->planned, options_.link.period_s)) {
    return *std::move(error);
  }
  return tube;
}

Status Guide::State::check_new(const JoinRequest& request) const {
  const auto wrong = [&](const std::string& what) {
    Error error{ErrorCode::kInvalidArgument, what, {}};
    error.location.array = "agents";
    error.location.record = request.agent;
    return error;
  };
  if (find(request.agent) != nullptr) {
    return wrong("agent " + std::to_string(request.agent) +
                 " is in the fleet already; let it leave before it joins anew");
  }
  if (auto error = motion::check_position(request.position, request.agent)) {
    error->location.array = "agents";
    return *std::move(error);
  }
  if (!(request.radius_m >= 0.0) || !motion::in_motion_domain(request.radius_m)) {
    return wrong("the radius of agent " + std::to_string(request.agent) + " is " +
                 std::to_string(request.radius_m) + " m; give a finite one, zero or more");
  }
  const double most_mps2 = request.limits.value_or(options_.limits).max_acceleration_mps2;
  if (!std::isfinite(most_mps2)) {
    return wrong("agent " + std::to_string(request.agent) +
                 " has no greatest acceleration; give a finite one");
  }
  if (members_.size() >= std::numeric_limits<PointId>::max()) {
    return Error{ErrorCode::kTooManyPoints, "the fleet has as many agents as there are ids", {}};
  }
  return std::monostate{};
}

// How far apart two agents must be at most, in whichever direction.
double Guide::State::farthest_apart_m(double radius_m, double other_radius_m) const {
  const double apart_m = std::max(options_.threshold_m, radius_m + other_radius_m);
  const Separation& shape = options_.separation;
  if (shape.shape == SeparationShape::kEllipsoid) {
    return apart_m * std::max(1.0, shape.vertical_factor);
  }
  return shape.shape == SeparationShape::kCylinder ? apart_m + shape.vertical_m : apart_m;
}

Status Guide::State::check_height(const JoinRequest& request) const {
  if (!options_.planar || members_.empty()) return std::monostate{};
  const double height_m = members_.front().branches.base_state(now_.value_or(0)).position.z;
  if (request.position.z == height_m) return std::monostate{};
  Error error{ErrorCode::kInvalidArgument,
              "agent " + std::to_string(request.agent) + " stands at a height of " +
                  std::to_string(request.position.z) + " m, and the fleet moves in a plane at " +
                  std::to_string(height_m) + " m; give it the same",
              {}};
  error.location.array = "agents";
  error.location.record = request.agent;
  return error;
}

Status Guide::State::check_left(const JoinRequest& request) const {
  const auto before = sent_before_.find(request.agent);
  if (before == sent_before_.end()) return std::monostate{};
  const guide::BranchOptions options = branch_options(request, {});
  const Tick from = before->second.left + options_.link.command_delay + 3;
  const bool is_anew = options.epoch > before->second.epoch;
  if (is_anew || now_.value_or(0) >= from) return std::monostate{};
  Error error{ErrorCode::kInvalidArgument,
              "agent " + std::to_string(request.agent) +
                  " has just left, and may still take what "
                  "was sent to it before; let it join from tick " +
                  std::to_string(from) + " on, or with the epoch that it has promised since",
              {}};
  error.location.array = "agents";
  error.location.record = request.agent;
  return error;
}

// Members whose claims may be so near to a place that the Adviser must say whether they touch.
std::vector<PointId> Guide::State::near(const Point& place, double tube_m, double radius_m) {
  std::vector<PointId> found;
  std::vector<Point> places;
  for (PointId index = 0; index < members_.size(); ++index) {
    Member& other = members_[index];
    if (!other.around) {
      places.clear();
      other.branches.append_places(now_ ? claims_from(other, *now_) : other.heard, places);
      other.around = guide::ball_around(places);
    }
    const guide::Ball& ball = *other.around;
    const double apart_m = farthest_apart_m(radius_m, other.radius_m);
    const double within_m = (ball.radius_m + apart_m + tube_m + other.tube.radius_m) * (1.0 + 1e-6);
    if (length(core::vector_of(place) - ball.middle) <= within_m) found.push_back(index);
  }
  return found;
}

// Its claim is a point; those of others are what they were after the last step, as nothing has been
// sent since. The Adviser says which touch.
Status Guide::State::find_touching(const JoinRequest& request, const Tube& tube,
                                   JoinAnswer& answer) {
  const std::vector<PointId> others = near(request.position, tube.radius_m, request.radius_m);
  std::vector<Mover> movers;
  std::vector<std::vector<Point>> places(others.size());
  std::vector<Claim> claims;
  for (std::size_t k = 0; k < others.size(); ++k) {
    const Member& other = members_[others[k]];
    other.branches.append_places(now_ ? claims_from(other, *now_) : other.heard, places[k]);
    movers.push_back({places[k].front(), {}});
    claims.push_back({places[k], other.tube.radius_m, other.radius_m, true});
  }
  movers.push_back({motion::flushed(request.position), {}});
  claims.push_back({{}, tube.radius_m, request.radius_m, true});
  const std::vector<Velocity> preferred(movers.size());
  AdviseOptions options = advise_options_;
  options.fences = fences_;
  options.claims = claims;
  const std::vector<FlightLimits> limits(1, tube.planned);
  Adviser adviser;
  Advised advised;
  if (Status done = adviser.advise(movers, preferred, limits, options, advised); !done) return done;
  const auto self = static_cast<PointId>(others.size());
  for (const TooClose& close : advised.too_close) {
    if (close.pair.second == self) {
      answer.touches.push_back(members_[others[close.pair.first]].id);
    }
  }
  for (const NearObstacle& close : advised.near_obstacle) {
    if (close.agent == self) answer.obstacles.push_back(close.obstacle);
  }
  for (const NearFence& close : advised.near_fence) {
    if (close.agent == self) answer.fences.push_back(close.fence);
  }
  for (const Refused& refused : advised.refused) {
    if (refused.index == self) return refused.error;
  }
  // It would be named at once beside one that is out of its tube.
  for (PointId index = 0; index < members_.size() && now_; ++index) {
    if (!is_unknown(members_[index])) continue;
    const UnknownAgent ball = ball_of(members_[index], *now_, index);
    const double within_m = ball.radius_m + ball.growth_mps * unknown_horizon_s() +
                            farthest_apart_m(request.radius_m, 0.0) + tube.radius_m;
    if (length(core::vector_of(request.position) - core::vector_of(ball.center)) <= within_m) {
      answer.touches.push_back(members_[index].id);
    }
  }
  std::sort(answer.touches.begin(), answer.touches.end());
  answer.touches.erase(std::unique(answer.touches.begin(), answer.touches.end()),
                       answer.touches.end());
  return std::monostate{};
}

Result<JoinAnswer> Guide::State::join(const JoinRequest& request, bool for_good) {
  if (Status fine = check_new(request); !fine) return std::move(fine).error();
  if (Status fine = check_left(request); !fine) return std::move(fine).error();
  if (Status fine = check_height(request); !fine) return std::move(fine).error();
  const Result<Tube> tube = tube_for(request);
  if (!tube) return tube.error();
  JoinAnswer answer;
  if (Status found = find_touching(request, *tube, answer); !found) {
    return std::move(found).error();
  }
  answer.joined =
      for_good && answer.touches.empty() && answer.obstacles.empty() && answer.fences.empty();
  if (!answer.joined) return answer;
  add(request, *tube,
      guide::Branches::rooted(branch_options(request, *tube), motion::flushed(request.position),
                              now_.value_or(0)),
      now_.value_or(0));
  return answer;
}

Status Guide::State::adopt(const JoinRequest& request, const StoredBranch& stored) {
  JoinRequest known = request;
  known.position = {};
  if (Status fine = check_new(known); !fine) return fine;
  const Result<Tube> tube = tube_for(request);
  if (!tube) return tube.error();
  if (Status fine = check_stored(request, stored.tick); !fine) return fine;
  auto branches =
      guide::Branches::adopted(branch_options(request, *tube), stored, now_.value_or(stored.tick));
  if (!branches) return branches.error();
  add(request, *tube, *std::move(branches), now_.value_or(stored.tick));
  // It is on that branch or on a newer one since then.
  members_.back().since = stored.tick;
  members_.back().taken = {stored.branch.number, stored.tick};
  return std::monostate{};
}

Status Guide::State::check_stored(const JoinRequest& request, Tick tick) const {
  Status fine = check_tick(tick);
  const Tick ahead = clock_ticks(request.figures.value_or(options_.figures));
  if (fine && now_ && tick > *now_ + ahead + 1) {
    fine = Error{ErrorCode::kInvalidArgument,
                 "agent " + std::to_string(request.agent) + " says where it was at tick " +
                     std::to_string(tick) + ", and the last step was of tick " +
                     std::to_string(*now_) +
                     ": its clock is wrong, or that of the planner; take its answer after the next "
                     "step",
                 {}};
  }
  if (fine) return fine;
  Error error = std::move(fine).error();
  error.location.array = "agents";
  error.location.record = request.agent;
  return error;
}

guide::BranchOptions Guide::State::branch_options(const JoinRequest& request,
                                                  const Tube& tube) const {
  const auto left = sent_before_.find(request.agent);
  const std::uint32_t before = left != sent_before_.end() ? left->second.epoch : 0;
  // None earlier than before: no number is used twice.
  const std::uint32_t epoch = std::max({options_.epoch, request.promised, before});
  const bool in_this_epoch = before == epoch;
  return {.agent = request.agent,
          .planned = tube.planned,
          .period_s = options_.link.period_s,
          .command_delay = options_.link.command_delay,
          .epoch = epoch,
          .earlier = in_this_epoch ? left->second.count : 0};
}

void Guide::State::add(const JoinRequest& request, const Tube& tube, guide::Branches&& branches,
                       Tick heard) {
  expected_.erase(request.agent);
  const FleetFigures figures = request.figures.value_or(options_.figures);
  const auto index = static_cast<PointId>(members_.size());
  const auto place = static_cast<std::ptrdiff_t>(place_of(request.agent));
  by_id_.insert(by_id_.begin() + place, {request.agent, index});
  members_.push_back({.id = request.agent,
                      .figures = figures,
                      .tube = tube,
                      .radius_m = request.radius_m,
                      .branches = std::move(branches),
                      .monitor = guide::ContractMonitor(figures, options_.link, tube),
                      .heard = heard,
                      .since = heard});
  members_.back().since += clock_ticks(figures);
  if (figures.loop == LoopPlace::kGround) {
    members_.back().loop = {tube, figures, options_.link.period_s};
  }
  planes_.forget(index);
}

void Guide::State::expect(std::span<const AgentId> agents) {
  for (const AgentId agent : agents) {
    if (find(agent) == nullptr) expected_.insert(agent);
  }
}

// The last one takes its index.
Status Guide::State::leave(AgentId agent) {
  if (expected_.erase(agent) > 0) return std::monostate{};
  const std::size_t place = place_of(agent);
  if (!is_at(place, agent)) return unknown_agent(agent);
  const PointId index = by_id_[place].index;
  const auto last = static_cast<PointId>(members_.size() - 1);
  const guide::Branches& branches = members_[index].branches;
  sent_before_[agent] = {branches.epoch(), branches.count(), now_.value_or(0)};
  by_id_.erase(by_id_.begin() + static_cast<std::ptrdiff_t>(place));
  if (index != last) {
    members_[index] = std::move(members_[last]);
    by_id_[place_of(members_[index].id)].index = index;
  }
  members_.pop_back();
  planes_.forget(index);
  planes_.forget(last);
  return std::monostate{};
}

Result<Tube> Guide::State::tube(AgentId agent) const {
  const Member* const member = find(agent);
  if (member == nullptr) return unknown_agent(agent);
  return member->tube;
}

Result<std::vector<Point>> Guide::State::claim(AgentId agent) const {
  const Member* const member = find(agent);
  if (member == nullptr) return unknown_agent(agent);
  std::vector<Point> places;
  member->branches.append_places(now_ ? claims_from(*member, *now_) : member->heard, places);
  return places;
}

}  // namespace beespace
