#include "cli/console/error_json.hpp"
#include "cli/console/signals.hpp"
#include "cli/console/standard_output.hpp"
#include "cli/console/summary_line.hpp"
#include "cli/console/terminal.hpp"
#include "cli/guide/guide_intro.hpp"
#include "cli/guide/guided_fleet.hpp"
#include "cli/guide/setpoint_link.hpp"
#include "cli/input/clock_ticks.hpp"
#include "cli/input/line_source.hpp"
#include "cli/input/obstacle_file.hpp"
#include "io/bytes/number_text.hpp"
#include "io/fleet/fleet_reader.hpp"

#include <cerrno>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace beespace::cli {
namespace {

constexpr std::uint64_t kMostRefusalsSaid = 20;

class GuideRun {
 public:
  GuideRun(const GuideRequest& request, GuidedFleet fleet)
      : request_(request),
        fleet_(std::move(fleet)),
        reader_({request.options.figures, request.options.limits}),
        link_(request.options.link.period_s, request.options.figures.loop == LoopPlace::kGround) {}

  Result<ExitCode> run() {
    if (Status opened = open_log(); !opened) return opened.error();
    auto source = LineSource::open("-");
    if (!source) return std::move(source).error();
    let_interruption_wait();
    std::string_view line;
    for (;;) {
      if (Status done = step_by_clock(); !done) return done.error();
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
  // Goes on behind what is there; its readers see each tick at once.
  Status open_log() {
    if (request_.log.empty()) return std::monostate{};
    log_.open(request_.log, std::ios::app | std::ios::binary);
    return log_ ? Status(std::monostate{}) : Status(log_problem());
  }

  [[nodiscard]] Error log_problem() const {
    return {ErrorCode::kWriteFailed,
            "cannot write this file; check the folder, its permissions and the disk",
            {.source = request_.log}};
  }

  [[nodiscard]] int patience_ms() const {
    constexpr int kLong_ms = 1000;
    return request_.ticks_from_input ? kLong_ms : next_tick_in_ms(request_.options.link.period_s);
  }

  Status step_by_clock() {
    if (request_.ticks_from_input) return std::monostate{};
    const Tick now = clock_tick(request_.options.link.period_s).tick;
    // A clock that is set back is waited for.
    if (tick_ && now <= *tick_) return std::monostate{};
    return step(now);
  }

  Status step(Tick now) {
    std::string lines;
    std::string frames;
    if (request_.mavlink) link_.advance(now);
    Status done = fleet_.step(now, lines);
    if (done && request_.mavlink) done = link_.tell(now, fleet_, lines, frames);
    if (!done) {
      // The tick is wrong, or nothing may be said any more.
      if (done.error().code != ErrorCode::kTimeOrder) return done;
      refuse(std::move(done).error(), {}, lines);
    } else {
      tick_ = now;
    }
    write(lines, frames);
    return std::monostate{};
  }

  Status take(std::string_view line) {
    const auto message = reader_.take(line);
    std::string lines;
    if (!message) {
      if (reader_.bad_intruders()) fleet_.lose_intruders();
      refuse(message.error(), reader_.bad_id(), lines);
    } else if (*message) {
      if (const auto* tick = std::get_if<io::TickMessage>(&(**message).content)) {
        return take_tick(*tick);
      }
      Status taken =
          request_.mavlink ? link_.take(**message, fleet_, lines) : fleet_.take(**message, lines);
      if (!taken) refuse(std::move(taken).error(), (**message).id, lines);
    }
    write(lines, {});
    return std::monostate{};
  }

  Status take_tick(const io::TickMessage& tick) {
    if (request_.ticks_from_input) return step(tick.tick);
    std::string lines;
    refuse({ErrorCode::kInvalidArgument,
            "ticks are by the clock of this machine; leave it out, or give --ticks-from-input",
            {}},
           {}, lines);
    write(lines, {});
    return std::monostate{};
  }

  // What could not be taken is said, and all others go on.
  void refuse(Error error, std::string_view id, std::string& lines) {
    error.location.source = "<stdin>";
    error.location.line = reader_.lines();
    {
      io::JsonWriter json(lines);
      json.begin_object().member("event", "refused");
      if (!id.empty()) json.member("id", id);
      write_error(json.key("error"), error);
      json.end();
    }
    lines += '\n';
    if (++refused_ > kMostRefusalsSaid || request_.quiet) return;
    say("beespace: refused: " + printable(to_string(error)) + "\n");
  }

  void write(const std::string& lines, const std::string& frames) {
    if (log_.is_open()) log_ << lines << std::flush;
    const std::string& out = request_.mavlink ? frames : lines;
    if (write_error_ == 0 && !out.empty()) write_error_ = write_out(out);
  }

  Result<ExitCode> end() {
    const bool cut_off = interrupted() && (write_error_ == EPIPE || write_error_ == EINTR);
    if (log_.is_open() && !log_) return log_problem();
    if (write_error_ == EPIPE && !cut_off) return ExitCode::kPipeClosed;
    if (write_error_ != 0 && !cut_off) {
      return Error{ErrorCode::kWriteFailed, "cannot write to standard output", {}};
    }
    if (!request_.quiet) say(summary());
    return interrupted() ? exit_code_of_interruption() : ExitCode::kFine;
  }

  [[nodiscard]] std::string summary() const {
    std::string out;
    const GuidedCounts& counts = fleet_.counts();
    append_summary_line(out, "agents", io::grouped(fleet_.size()));
    if (fleet_.missing() > 0) {
      append_summary_line(out, "not found", red(io::grouped(fleet_.missing())));
    }
    append_summary_line(out, "ticks", io::grouped(counts.ticks));
    append_summary_line(out, "commands",
                        io::grouped(counts.commands) + ", " + io::grouped(counts.taken) +
                            " said to be taken, " + io::grouped(counts.refused) + " refused");
    if (refused_ > 0) {
      append_summary_line(out, "messages", red(io::grouped(refused_)) + " could not be taken");
    }
    return out;
  }

  const GuideRequest& request_;
  GuidedFleet fleet_;
  io::FleetReader reader_;
  SetpointLink link_;
  std::ofstream log_;
  std::optional<Tick> tick_;
  std::uint64_t refused_ = 0;
  int write_error_ = 0;  // the errno of it
};

}  // namespace

Result<ExitCode> run_guide(const GuideRequest& request) {
  GuideOptions options = request.options;
  ObstacleMap obstacles;
  if (!request.obstacles.empty()) {
    auto loaded = load_obstacle_map(request.obstacles);
    if (!loaded) return std::move(loaded).error();
    obstacles = *std::move(loaded);
    options.obstacles = &obstacles;
  }
  options.fences = request.fences;
  const auto tube = tube_of(options.figures, options.link, options.limits);
  if (!tube) return tube.error();
  // What makes no sense is said before the epoch is raised.
  if (const auto tried = Guide::make(options); !tried) return tried.error();
  auto store = FleetStore::open(request.store, options.epoch);
  if (!store) return std::move(store).error();
  options.epoch = store->epoch();
  auto guide = Guide::make(options);
  if (!guide) return std::move(guide).error();
  const std::size_t missing = store->members().size();
  if (!request.quiet) say(guide_intro(request, *tube, store->epoch(), missing));
  return GuideRun(request, GuidedFleet(request, *std::move(guide), *std::move(store))).run();
}

}  // namespace beespace::cli
