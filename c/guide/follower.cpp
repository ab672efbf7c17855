// The agent's side of the protocol.
#include <beespace/follower.hpp>

#include "c/door/agents.hpp"
#include "c/door/door.hpp"
#include "c/door/points.hpp"
#include "c/door/structs.hpp"
#include "c/guide/messages.hpp"

#include <memory>
#include <utility>

using namespace beespace::c;  // NOLINT(google-build-using-namespace): the functions are of C
using beespace::Command;
using beespace::Follower;
using beespace::Result;
using beespace::Setpoint;
using beespace::Status;
using beespace::StoredBranch;

// NOLINTNEXTLINE(readability-identifier-naming): a name of C
struct beespace_follower {
  Follower follower;
  beespace::AgentId agent;
};

namespace {

// Calls work(the C++ follower), which returns a Status.
template <class Handle, class Work>
beespace_code with_follower(Handle* follower, beespace_error* error, Work&& work) {
  return enter(error, [&]() -> Status {
    if (follower == nullptr) return invalid("the pointer to the follower is NULL", "follower");
    return work(follower->follower);
  });
}

}  // namespace

extern "C" {

beespace_code beespace_follower_create(int64_t agent, double planned_speed_mps,
                                       double planned_acceleration_mps2, double period_s,
                                       beespace_follower** follower, beespace_error* error) {
  if (follower != nullptr) *follower = nullptr;
  return enter(error, [&]() -> Status {
    if (follower == nullptr) return invalid("the pointer to the follower is NULL", "follower");
    Result<Follower> made = Follower::make(
        agent_id_of(agent), {planned_speed_mps, planned_acceleration_mps2}, period_s);
    if (!made) return made.error();
    *follower =
        std::make_unique<beespace_follower>(beespace_follower{*made, agent_id_of(agent)}).release();
    return std::monostate{};
  });
}

void beespace_follower_free(beespace_follower* follower) {
  delete follower;
}

beespace_code beespace_follower_restore(beespace_follower* follower,
                                        const beespace_stored_branch* stored,
                                        beespace_error* error) {
  return with_follower(follower, error, [&](Follower& used) -> Status {
    const Result<StoredBranch> given = stored_of(stored);
    if (!given) return given.error();
    Status restored = used.restore(*given);
    return restored ? restored : with_agent_number(restored.error(), follower->agent);
  });
}

void beespace_follower_advance(beespace_follower* follower, int64_t tick) {
  if (follower != nullptr) follower->follower.advance(tick);
}

beespace_code beespace_follower_receive(beespace_follower* follower,
                                        const beespace_command* command,
                                        beespace_acknowledgement* reply, beespace_error* error) {
  return with_follower(follower, error, [&](Follower& used) -> Status {
    const Result<Command> given = command_of(command, "command");
    if (!given) return given.error();
    // First, so that nothing is taken without a reply.
    Status can_reply = write_struct(reply, beespace_acknowledgement{}, "reply");
    if (!can_reply) return can_reply;
    return write_struct(reply, c_acknowledgement_of(used.receive(*given)), "reply");
  });
}

int32_t beespace_follower_promise(beespace_follower* follower, uint32_t epoch) {
  return follower != nullptr && follower->follower.promise(epoch) ? 1 : 0;
}

void beespace_follower_lose(beespace_follower* follower) {
  if (follower != nullptr) follower->follower.lose();
}

uint64_t beespace_follower_held(const beespace_follower* follower) {
  return follower == nullptr ? 0 : follower->follower.held();
}

int64_t beespace_follower_tick(const beespace_follower* follower) {
  return follower == nullptr ? 0 : follower->follower.tick();
}

beespace_code beespace_follower_stored(const beespace_follower* follower,
                                       beespace_stored_branch* stored, beespace_error* error) {
  return with_follower(follower, error, [&](const Follower& used) -> Status {
    return write_struct(stored, c_stored_of(used.stored()), "stored");
  });
}

beespace_code beespace_follower_setpoint(const beespace_follower* follower, double after_s,
                                         beespace_setpoint* setpoint, beespace_error* error) {
  return with_follower(follower, error, [&](const Follower& used) -> Status {
    if (!(after_s >= 0.0)) {
      return invalid("this is no time after the tick; give zero or more", "after_s");
    }
    if (used.held() == 0) {
      return invalid("the agent is on no branch, so nothing says where it should be", "follower");
    }
    const Setpoint found = used.setpoint(after_s);
    beespace_setpoint shown{};
    shown.holding = found.holding ? 1 : 0;
    write_three(found.nominal.position, shown.position);
    write_three(found.nominal.velocity, shown.velocity);
    write_three(found.correction, shown.correction);
    return write_struct(setpoint, shown, "setpoint");
  });
}

}  // extern "C"
