#include "cli/console/signals.hpp"
#include "cli/console/standard_output.hpp"
#include "cli/console/summary_line.hpp"
#include "cli/console/terminal.hpp"
#include "cli/follow/following.hpp"
#include "cli/input/clock_ticks.hpp"
#include "cli/input/line_source.hpp"
#include "io/bytes/number_text.hpp"
#include "io/fleet/fleet_reader.hpp"

#include <cerrno>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace beespace::cli {
namespace {

constexpr std::uint64_t kMostBadLinesSaid = 20;

class Follow {
 public:
  Follow(const FollowRequest& request, Following following)
      : request_(request),
        following_(std::move(following)),
        reader_({}, "<stdin>", request.agent) {}

  Result<ExitCode> run() {
    auto source = LineSource::open("-");
    if (!source) return std::move(source).error();
    let_interruption_wait();
    std::string_view line;
    for (;;) {
      if (Status done = advance_by_clock(); !done) return done.error();
      if (write_error_ != 0) break;
      const auto got = source->next(line, patience_ms());
      if (!got) return got.error();
      if (*got == LineSource::Got::kEnd) break;
      if (*got == LineSource::Got::kNothingYet) continue;
      if (Status done = take(line); !done) return done.error();
    }
    return end();
  }

 private:
  [[nodiscard]] int patience_ms() const {
    constexpr int kLong_ms = 1000;
    return request_.ticks_from_input ? kLong_ms : next_tick_in_ms(request_.period_s);
  }

  Status advance_by_clock() {
    if (request_.ticks_from_input) return std::monostate{};
    const Tick now = clock_tick(request_.period_s).tick;
    if (tick_ && now <= *tick_) return std::monostate{};
    return advance(now);
  }

  Status advance(Tick tick) {
    tick_ = tick;
    std::string out;
    if (Status done = following_.advance(tick, out); !done) return done;
    write(out);
    return std::monostate{};
  }

  Status take(std::string_view line) {
    const auto message = reader_.take(line);
    if (!message) {
      note_bad(message.error());
      return std::monostate{};
    }
    if (!*message) return std::monostate{};
    // The line may have waited.
    if (Status done = advance_by_clock(); !done) return done;
    if (const auto* tick = std::get_if<io::TickMessage>(&(**message).content)) {
      return request_.ticks_from_input ? advance(tick->tick) : Status(std::monostate{});
    }
    std::string out;
    if (Status done = following_.take(**message, out); !done) return done;
    write(out);
    if (const std::string warning = following_.take_warning(); !warning.empty()) {
      say_error(printable(warning));
    }
    return std::monostate{};
  }

  void write(const std::string& out) {
    if (write_error_ == 0 && !out.empty()) write_error_ = write_out(out);
  }

  void note_bad(const Error& error) {
    if (++bad_lines_ > kMostBadLinesSaid || request_.quiet) return;
    say("beespace: left out: " + printable(to_string(error)) + "\n");
  }

  Result<ExitCode> end() {
    const bool cut_off = interrupted() && (write_error_ == EPIPE || write_error_ == EINTR);
    if (write_error_ == EPIPE && !cut_off) return ExitCode::kPipeClosed;
    if (write_error_ != 0 && !cut_off) {
      return Error{ErrorCode::kWriteFailed, "cannot write to standard output", {}};
    }
    if (!request_.quiet) say(summary());
    return interrupted() ? exit_code_of_interruption() : ExitCode::kFine;
  }

  [[nodiscard]] std::string summary() const {
    std::string out;
    const Follower& follower = following_.follower();
    append_summary_line(out, "agent", printable(request_.agent));
    append_summary_line(out, "commands",
                        io::grouped(following_.taken()) + " taken, " +
                            io::grouped(following_.refused()) + " refused");
    if (bad_lines_ > 0) {
      append_summary_line(out, "bad lines", red(io::grouped(bad_lines_)) + " left out");
    }
    append_summary_line(out, "branch",
                        follower.held() == 0 ? red("none") : io::branch_text(follower.held()));
    return out;
  }

  const FollowRequest& request_;
  Following following_;
  io::FleetReader reader_;
  std::optional<Tick> tick_;
  std::uint64_t bad_lines_ = 0;
  int write_error_ = 0;  // the errno of it
};

}  // namespace

Result<ExitCode> run_follow(const FollowRequest& request) {
  auto following = Following::begin(request);
  if (!following) return std::move(following).error();
  return Follow(request, *std::move(following)).run();
}

}  // namespace beespace::cli
