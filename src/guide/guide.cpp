#include <beespace/guide.hpp>

#include "guide/guide_state.hpp"

#include <utility>

namespace beespace {

void Guidance::clear() {
  commands.clear();
  agents.clear();
  pairs.clear();
  near_obstacle.clear();
  near_fence.clear();
  intruder_conflicts.clear();
}

Result<Guide> Guide::make(const GuideOptions& options) {
  auto state = std::make_unique<State>(options);
  if (Status fine = state->check(); !fine) return std::move(fine).error();
  return Guide(std::move(state));
}

Guide::Guide(std::unique_ptr<State> state) : state_(std::move(state)) {
}
Guide::Guide(Guide&&) noexcept = default;
Guide& Guide::operator=(Guide&&) noexcept = default;
Guide::~Guide() = default;

Result<JoinAnswer> Guide::join(const JoinRequest& request) {
  return state_->join(request, true);
}
Result<JoinAnswer> Guide::may_join(const JoinRequest& request) {
  return state_->join(request, false);
}
Status Guide::adopt(const JoinRequest& request, const StoredBranch& stored) {
  return state_->adopt(request, stored);
}
void Guide::expect(std::span<const AgentId> agents) {
  state_->expect(agents);
}
Status Guide::leave(AgentId agent) {
  return state_->leave(agent);
}
Status Guide::set_goal(AgentId agent, const Point& goal) {
  return state_->set_goal(agent, goal);
}
Status Guide::set_preferred(AgentId agent, const Velocity& velocity) {
  return state_->set_preferred(agent, velocity);
}
Status Guide::take(const AgentReport& report) {
  return state_->take(report);
}
Status Guide::take(const Acknowledgement& acknowledgement) {
  return state_->take(acknowledgement);
}
Status Guide::set_intruders(std::span<const Intruder> intruders) {
  return state_->set_intruders(intruders);
}
Status Guide::step(Tick now, Guidance& guidance, const std::stop_token& stop) {
  return state_->step(now, guidance, stop);
}
std::size_t Guide::size() const {
  return state_->size();
}
Result<Tube> Guide::tube(AgentId agent) const {
  return state_->tube(agent);
}
Result<std::vector<Point>> Guide::claim(AgentId agent) const {
  return state_->claim(agent);
}

}  // namespace beespace
