// One agent that follows: messages in, messages out, and what it must remember on the disk before
// it says so. It knows no clock and no pipe.
#pragma once

#include "cli/follow/follow_request.hpp"
#include "io/bytes/file_lock.hpp"
#include "io/fleet/fleet_message.hpp"

#include <beespace/follower.hpp>
#include <beespace/result.hpp>

#include <cstdint>
#include <optional>
#include <string>

namespace beespace::cli {

class Following {
 public:
  // Goes on with what was stored, where there is something. The store is its own until it goes.
  // Errors: limits that make no sense; of the store.
  static Result<Following> begin(const FollowRequest& request);

  // Appends what there is to say. Errors: of the store; then nothing was said.
  Status advance(Tick tick, std::string& out);
  Status take(const io::FleetMessage& message, std::string& out);

  // What an operator must know, once; empty: nothing.
  std::string take_warning();

  [[nodiscard]] const Follower& follower() const { return follower_; }
  [[nodiscard]] std::uint64_t taken() const { return taken_; }
  [[nodiscard]] std::uint64_t refused() const { return refused_; }

 private:
  Following(const FollowRequest& request, const Follower& follower)
      : request_(request), follower_(follower) {}

  Status load();
  [[nodiscard]] Status store() const;
  [[nodiscard]] io::AdoptMessage to_be_adopted() const;
  Status take_command(const io::CommandMessage& message, std::string& out);
  Status take_hello(const io::HelloMessage& message, std::string& out);
  void take_measured(const io::MeasuredMessage& measured, std::string& out);
  [[nodiscard]] bool fits(const io::CommandMessage& message);
  void ask_to_join(std::string& out);
  void report(std::string& out) const;
  void tell_setpoint(std::string& out) const;
  void say(std::string& out, const io::FleetContent& content) const;

  io::FileLock lock_;  // of the store
  FollowRequest request_;
  Follower follower_;
  std::optional<Point> at_;        // as it was measured last
  std::optional<Point> asks_for_;  // the place where it joins
  std::optional<Tick> asked_at_;
  std::string warning_;
  bool warned_ = false;
  std::uint64_t taken_ = 0;
  std::uint64_t refused_ = 0;
};

}  // namespace beespace::cli
