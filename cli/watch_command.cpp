#include "cli/watch_command.hpp"

#include "cli/failure.hpp"
#include "cli/moving/line_source.hpp"
#include "cli/moving/live_advice.hpp"
#include "cli/moving/live_feed.hpp"
#include "cli/moving/moving_input.hpp"
#include "cli/moving/moving_output.hpp"
#include "cli/moving/pace.hpp"
#include "cli/number_text.hpp"
#include "cli/signals.hpp"
#include "cli/standard_output.hpp"
#include "cli/terminal.hpp"
#include "cli/watch_request.hpp"
#include "io/report_lines.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <optional>
#include <utility>

namespace beespace::cli {
namespace {

constexpr std::uint64_t kMostBadLinesSaid = 20;

class Watch {
 public:
  explicit Watch(const WatchRequest& request)
      : request_(request),
        lines_(request.lines, request.input == "-" ? "<stdin>" : request.input),
        pace_(request.speed, request.rate) {}

  Result<ExitCode> run() {
    auto source = LineSource::open(request_.input);
    if (!source) return std::move(source).error();
    let_interruption_wait();
    std::string_view line;
    while (write_error_ == 0) {
      // A look of advice that has begun waits for less.
      const auto advice_ms = advice_ ? advice_->patience_ms() : std::nullopt;
      const auto got = source->next(line, std::min(kPatienceMs, advice_ms.value_or(kPatienceMs)));
      if (!got) return got.error();
      if (*got == LineSource::Got::kEnd) break;
      if (*got == LineSource::Got::kNothingYet && advice_ms) {
        note_advice(advice_->waited());
        continue;
      }
      const Status done = *got == LineSource::Got::kLine ? take(line) : wait();
      if (!done) return done.error();
    }
    if (feed_ && write_error_ == 0) {
      if (auto done = feed_->finish(); !done) return done.error();
      if (advice_) note_advice(advice_->finish());
    }
    return end();
  }

 private:
  static constexpr int kPatienceMs = 1000;

  static std::size_t place(EventKind kind) { return static_cast<std::size_t>(kind); }

  // What is said last, and how it ends.
  Result<ExitCode> end() {
    // Ctrl-C ends whoever reads as well, or a write that waits for them.
    const bool cut_off = interrupted() && (write_error_ == EPIPE || write_error_ == EINTR);
    if (write_error_ == EPIPE && !cut_off) return ExitCode::kPipeClosed;
    if (write_error_ != 0 && !cut_off) {
      return Error{ErrorCode::kWriteFailed, "cannot write to standard output", {}};
    }
    if (!request_.quiet) say(summary());
    if (interrupted()) return ExitCode::kInterrupted;
    if (!feed_) return nothing_read();
    return request_.fail_on_risk && told_[place(EventKind::kEntered)] > 0 ? ExitCode::kRiskFound
                                                                          : ExitCode::kFine;
  }

  // Whose first report tells what distances are taken of.
  void begin(io::Frame frame) {
    frame_ = frame;
    geometry_ = request_.swarm.vertical_m && frame == io::Frame::kWgs84 ? Geometry::kGroundAndHeight
                                                                        : Geometry::kSpace;
    SwarmOptions options = request_.swarm;
    options.heights_apart = geometry_ == Geometry::kGroundAndHeight;
    feed_.emplace(options, request_.look_every_s,
                  [this](const std::vector<SwarmEvent>& events) { tell(events); });
    if (!request_.advice) return;
    advice_.emplace(
        *request_.advice, frame, [this](PointId id) -> const BeeName& { return feed_->name(id); },
        [this](const std::string& lines) {
          if (write_error_ == 0) write_error_ = write_out(lines);
        });
    feed_->after_each_report([this](const Report& report) { note_advice(advice_->take(report)); });
  }

  Status take(std::string_view line) {
    const auto read = lines_.take(line);
    if (!read) {
      if (!lines_.understood()) return read.error();  // about the input as a whole
      note_bad(read.error());
      return std::monostate{};
    }
    if (!*read) return std::monostate{};
    const io::ReportLine& at = **read;
    if (!feed_) begin(at.frame);
    const auto metres = in_metres(at.position, at.velocity, at.frame, geometry_);
    if (!metres) {
      note_bad(metres.error());
      return std::monostate{};
    }
    pace_.wait_for(at.time_s);
    if (interrupted()) return std::monostate{};
    Status taken = feed_->take({feed_->number(at.id, at.label), at.time_s, metres->position,
                                metres->velocity, metres->height_m, metres->climb_mps});
    if (taken) return taken;
    note_bad(taken.error());
    return std::monostate{};
  }

  // Nothing has come for a while: whoever is silent grows old all the same.
  Status wait() {
    if (!feed_) return std::monostate{};
    return feed_->idle(kPatienceMs / 1000.0);
  }

  void note_bad(const Error& error) {
    if (++bad_lines_ > kMostBadLinesSaid || request_.quiet) return;
    say("beespace: left out: " + printable(to_string(error)) + "\n");
  }

  void tell(const std::vector<SwarmEvent>& events) {
    std::string text;
    for (const SwarmEvent& event : events) {
      ++told_[place(event.kind)];
      text += event_line(event, *feed_);
    }
    if (write_error_ == 0) write_error_ = write_out(text);
  }

  // A look without advice is no reason to stop looking.
  void note_advice(const Status& advised) {
    if (advised) return;
    if (unadvised_looks_++ == 0 && !request_.quiet) {
      say("beespace: no advice: " + printable(to_string(advised.error())) + "\n");
    }
  }

  [[nodiscard]] Error nothing_read() const {
    return {ErrorCode::kNoPoints,
            bad_lines_ > 0 ? "no line of the input could be read as a report"
                           : "there is no report in the input",
            {}};
  }

  [[nodiscard]] std::string summary() const {
    std::string out;
    append_summary_line(out, "input", printable(lines_.description()));
    if (feed_) append_frame_lines(out, frame_, "", lines_.heights());
    for (const std::string& note : lines_.notes())
      append_summary_line(out, "note", printable(note));
    const SwarmCounts counts = feed_ ? feed_->counts() : SwarmCounts{};
    append_summary_line(out, "reports", grouped(counts.taken));
    if (counts.late > 0) append_summary_line(out, "late", grouped(counts.late) + " left out");
    if (counts.repeated > 0) {
      append_summary_line(out, "repeated", grouped(counts.repeated) + " left out");
    }
    if (feed_ && feed_->ahead() > 0) {
      append_summary_line(
          out, "ahead",
          red(grouped(feed_->ahead())) + " left out: far ahead of all others in time");
    }
    if (bad_lines_ > 0) {
      append_summary_line(out, "bad lines", red(grouped(bad_lines_)) + " left out");
    }
    append_summary_line(out, "bees",
                        grouped(counts.bees) + " heard of, " + grouped(counts.stale) + " stale");
    append_summary_line(
        out, "threshold",
        separation_text(request_.swarm.threshold_m, request_.swarm.vertical_m, false));
    for (const EventKind kind : {EventKind::kPredicted, EventKind::kEntered, EventKind::kLeft}) {
      append_summary_line(out, name_of(kind), grouped(told_[place(kind)]));
    }
    if (advice_) append_advice(out);
    return out;
  }

  void append_advice(std::string& out) const {
    std::string text = grouped(advice_->told());
    if (advice_->uncertified() > 0) {
      text += ", " + red(grouped(advice_->uncertified())) + " not certified";
    }
    append_summary_line(out, "advice", text);
    const std::uint64_t without = unadvised_looks_ + advice_->skipped();
    if (without == 0) return;
    append_summary_line(out, "no advice", red(grouped(without)) + " looks");
  }

  const WatchRequest& request_;
  io::ReportLines lines_;
  Pace pace_;
  io::Frame frame_ = io::Frame::kMetres;  // once there is a feed
  Geometry geometry_ = Geometry::kSpace;
  std::optional<LiveFeed> feed_;
  std::optional<LiveAdvice> advice_;
  std::array<std::uint64_t, kEventKinds> told_{};  // by kind
  std::uint64_t bad_lines_ = 0;
  std::uint64_t unadvised_looks_ = 0;
  int write_error_ = 0;  // the errno of it
};

}  // namespace

ExitCode run_watch(const WatchOptions& options) {
  const auto request = watch_request(options);
  if (!request) return fail(request.error(), false);
  const auto code = Watch(*request).run();
  return code ? *code : fail(code.error(), false);
}

}  // namespace beespace::cli
