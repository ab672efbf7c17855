#include "analysis/geometry/geometry.hpp"
#include "analysis/geometry/scale_doubt.hpp"
#include "analysis/live/live_feed.hpp"
#include "analysis/recorded/default_threshold.hpp"
#include "cli/console/signals.hpp"
#include "cli/console/standard_output.hpp"
#include "cli/console/terminal.hpp"
#include "cli/input/line_source.hpp"
#include "cli/input/moving_output.hpp"
#include "cli/output/event_lines.hpp"
#include "cli/watch/doubt_text.hpp"
#include "cli/watch/live_advice.hpp"
#include "cli/watch/no_places.hpp"
#include "cli/watch/pace.hpp"
#include "cli/watch/track_doubts.hpp"
#include "cli/watch/unplaced_bees.hpp"
#include "cli/watch/watch_request.hpp"
#include "cli/watch/watch_summary.hpp"
#include "cli/watch/watch_tally.hpp"
#include "io/bytes/number_text.hpp"
#include "io/live/report_lines.hpp"
#include "io/mavlink/telemetry_log.hpp"
#include "io/recording/frozen_places.hpp"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace beespace::cli {
namespace {

constexpr std::uint64_t kMostSaid = 20;
constexpr std::size_t kMostNotUnderstood = 10;

class Watch {
 public:
  explicit Watch(const WatchRequest& request)
      : request_(request),
        lines_(request.lines, request.input == "-" ? "<stdin>" : request.input),
        pace_(request.speed, request.rate),
        tally_(request.swarm.max_speed_mps.has_value()) {}

  Result<ExitCode> run() {
    auto source = LineSource::open(request_.input);
    if (!source) return std::move(source).error();
    // A recording, and what is read at a pace of ours, know no time but their own.
    live_ = source->live() && !request_.speed && !request_.rate;
    if (request_.by_arrival && !live_) {
      return Error{ErrorCode::kInvalidArgument,
                   "--clock arrival is for reports that come as things happen, not for a file; "
                   "leave it out",
                   {}};
    }
    let_interruption_wait();
    std::string_view line;
    while (write_error_ == 0) {
      const auto got = source->next(line, patience_ms(*source));
      if (!got) return got.error();
      if (*got == LineSource::Got::kEnd) break;
      came_s_ = source->looked_s();
      if (*got == LineSource::Got::kLine || *got == LineSource::Got::kFrame) {
        const bool frame = *got == LineSource::Got::kFrame;
        if (source->without_times() && !request_.by_arrival) return without_times();
        if (frame) take_default_of_drones();
        const auto read = frame ? lines_.take_frame(line) : lines_.take(line);
        if (const Status done = take(read); !done) return done.error();
      } else {
        advise_if_due();
      }
      if (live_ && feed_) {
        if (const Status done = feed_->look_if_due(wall_s()); !done) return done.error();
      }
    }
    if (feed_ && write_error_ == 0) {
      if (auto done = feed_->finish(); !done) return done.error();
      if (advice_) note_advice(advice_->finish());
    }
    return end();
  }

 private:
  // By a clock that never goes back, when the last line came, or nothing did; 0 where only the
  // clock of the reports counts.
  [[nodiscard]] double wall_s() const { return live_ ? came_s_ : 0.0; }

  // Until the next look, where nothing comes.
  [[nodiscard]] int patience_ms(const LineSource& source) const {
    double wait_s = 1.0;
    if (live_ && feed_) wait_s = std::min(wait_s, feed_->next_look_in_s(source.looked_s()));
    if (const auto due_s = advice_due_s()) {
      wait_s = std::min(wait_s, *due_s - source.looked_s());
    }
    return std::max(static_cast<int>(std::ceil(1000.0 * wait_s)), 1);
  }

  // Until when a look of advice that has begun waits for more reports.
  [[nodiscard]] std::optional<double> advice_due_s() const {
    const auto patience_ms = advice_ ? advice_->patience_ms() : std::nullopt;
    if (!patience_ms) return std::nullopt;
    return reported_s_ + *patience_ms / 1000.0;
  }

  void advise_if_due() {
    const auto due_s = advice_due_s();
    if (due_s && came_s_ >= *due_s) note_advice(advice_->waited());
  }

  // What is said last, and how it ends.
  Result<ExitCode> end() {
    // Of few reports it is asked once no more come.
    if (!interrupted() && write_error_ == 0 && left_out_.shared == 0 && left_out_.jumping == 0) {
      if (auto doubt = no_places_.doubt_of_metres(true)) return *std::move(doubt);
    }
    left_out_.nowhere = unplaced_.count();
    left_out_.untimed = lines_.untimed();
    left_out_.no_place = no_places_.late();
    const NoPlaces::AtTheEnd ends = no_places_.at_the_end();
    left_out_.frozen_end = ends.frozen;
    for (const AgentId bee : ends.perhaps) {
      perhaps_frozen_.take(feed_->name(bee).id, no_places_.since_s(bee));
    }
    const bool in_feet = request_.lines.units.convention == io::UnitConvention::kAviation;
    const auto doubt = in_feet ? std::nullopt : no_places_.doubt_of_feet(lines_.units());
    left_out_.feet_doubted = doubt.has_value();
    // A signal may end the reader as well, or a write that waits for them.
    const bool cut_off = interrupted() && (write_error_ == EPIPE || write_error_ == EINTR);
    if (write_error_ == EPIPE && !cut_off) return ExitCode::kPipeClosed;
    if (write_error_ != 0 && !cut_off) {
      return Error{ErrorCode::kWriteFailed, "cannot write to standard output", {}};
    }
    if (doubt && !request_.quiet) say("beespace: " + printable(doubt->message) + "\n");
    if (!request_.quiet) say(summary());
    if (interrupted()) return exit_code_of_interruption();
    if (!feed_ || feed_->counts().taken == 0) return nothing_read();
    return request_.fail_on_risk && tally_.risk(*feed_, left_out_) ? ExitCode::kRiskFound
                                                                   : ExitCode::kFine;
  }

  // Whose first report tells what distances are taken of.
  void begin(io::Frame frame, io::Unit height_unit) {
    frame_ = frame;
    height_unit_ = height_unit;
    if (analysis::are_without_unit(lines_.units(), frame)) {
      no_places_.look_for_metres(analysis::fastest_in_metres(request_.threshold),
                                 request_.threshold, request_.lines.frame == io::Frame::kMetres);
    }
    geometry_ = analysis::geometry_for(frame, height_unit, request_.vertical);
    SwarmOptions options = request_.swarm;
    options.vertical_m = vertical_in(geometry_, request_.vertical, height_unit);
    options.heights_apart = heights_apart(geometry_);
    options.height_unit_m = height_unit_m(geometry_, height_unit);
    feed_.emplace(options, request_.times,
                  [this](const std::vector<SwarmEvent>& events) { tell(events); });
    feed_->after_each_note([this](const analysis::ClockNote& note) { tell(note); });
    feed_->after_each_contrary([this](const PositionReport& report) { note_contrary(report); });
    if (!request_.advice) return;
    begin_advice();
    feed_->after_each_report([this](const PositionReport& report, double now_s) {
      reported_s_ = came_s_;
      note_placed(feed_->name(report.id).id);
      note_advice(advice_->take(report, now_s));
    });
  }

  void begin_advice() {
    advice_.emplace(
        *request_.advice, frame_,
        [this](AgentId id) -> const analysis::BeeName& { return feed_->name(id); },
        [this](const std::string& lines) {
          if (write_error_ == 0) write_error_ = write_out(lines);
        });
    tell_advice_of_unplaced();
  }

  // A bee has been heard of, perhaps in a line that cannot be taken otherwise: as long as it is not
  // known where it is, the verdict says so, and advice certifies no bee.
  void note_heard_of(std::string_view id) {
    if (id.empty()) return;
    const auto number = feed_ ? feed_->known(id) : std::nullopt;
    if (number && (!advice_ || advice_->knows(*number))) return;
    unplaced_.add(id);
    tell_advice_of_unplaced();
  }

  void note_placed(std::string_view id) {
    if (unplaced_.remove(id)) tell_advice_of_unplaced();
  }

  // From here on it is not known where all are.
  void doubt_places() {
    unplaced_.add_for_good();
    tell_advice_of_unplaced();
  }

  void tell_advice_of_unplaced() {
    if (advice_) advice_->note_unplaced(unplaced_.any());
  }

  Status take(const Result<std::optional<io::ReportLine>>& read) {
    if (!read) {
      if (lines_.ended()) return read.error();
      note_heard_of(lines_.bad_id());
      if (lines_.understood()) {
        note_bad(read.error());
        return std::monostate{};
      }
      return not_understood(read.error());
    }
    if (lines_.understood() && !not_understood_.empty()) {
      for (const Error& error : not_understood_) note_bad(error);
      not_understood_.clear();
    }
    if (!*read) {
      note_heard_of(lines_.hidden_id());
      return std::monostate{};
    }
    const io::ReportLine& at = **read;
    if (at.leaves) {
      note_placed(at.id);
      const auto bee = feed_ ? feed_->leave(at.id) : std::nullopt;
      if (bee && advice_) advice_->remove(*bee);
      if (bee) tracks_.forget(*bee);
      if (bee) no_places_.forget(*bee);
      return std::monostate{};
    }
    if (auto apart = clocks_apart(at)) return *std::move(apart);
    if (counts_as_none(no_places_.zero(at), at.id)) return std::monostate{};
    if (!feed_) {
      const bool asked = request_.lines.frame == io::Frame::kMetres;
      if (auto doubt =
              analysis::doubt_of_unit({lines_.units(), at.frame, asked}, request_.threshold)) {
        return *std::move(doubt);
      }
      begin(at.frame, at.height_unit);
    }
    if (auto needed = threshold_needed(at)) return *std::move(needed);
    const auto metres = in_metres(at.position, at.velocity, at.frame, geometry_,
                                  {at.stated_height, at.height_unit});
    if (!metres) {
      note_heard_of(at.id);
      note_bad(metres.error());
      return std::monostate{};
    }
    pace_.wait_for(at.time_s);
    if (interrupted()) return std::monostate{};
    const auto number = feed_->number(at.id, at.label);
    if (!number) {
      note_heard_of(at.id);
      note_bad(feed_->too_many());
      return std::monostate{};
    }
    // Logs of vehicles have each place as it was told.
    if (!lines_.in_frames() && counts_as_none(no_places_.stale(*number, time_of(at), at), at.id)) {
      return std::monostate{};
    }
    if (!lines_.in_frames() && no_places_.thaws(*number)) note_thawed(*number, at);
    look_for_doubt(*number, at, {time_of(at), metres->position},
                   metres->velocity ? &*metres->velocity : nullptr);
    // What goes to and fro is fast in any unit.
    if (left_out_.shared == 0 && left_out_.jumping == 0) {
      if (auto doubt = no_places_.doubt_of_metres()) return *std::move(doubt);
    }
    Status taken = feed_->take({*number, time_of(at), metres->position, metres->velocity,
                                metres->height_m, metres->climb_mps},
                               wall_s());
    if (!taken) {
      note_heard_of(at.id);
      note_bad(taken.error());
    } else if (!advice_) {
      note_placed(at.id);
    } else if (!advice_->knows(*number)) {
      note_heard_of(at.id);
    }
    return std::monostate{};
  }

  // Asked of the first report, and where a later one is the first to show that these are aircraft.
  std::optional<Error> threshold_needed(const io::ReportLine& at) {
    const bool of_aircraft = lines_.of_aircraft();
    if (traffic_looked_for_ && of_aircraft == of_aircraft_) return std::nullopt;
    traffic_looked_for_ = true;
    of_aircraft_ = of_aircraft;
    return analysis::threshold_needed(
        analysis::TrafficSigns{at.frame, at.height_unit, lines_.heights(), of_aircraft},
        request_.threshold, request_.vertical);
  }

  // A line before any that is a report, or may be: a damaged one, as in the middle of a stream; or
  // the input is none that can be read.
  Status not_understood(const Error& error) {
    not_understood_.push_back(error);
    if (not_understood_.size() < kMostNotUnderstood) return std::monostate{};
    return none_understood(not_understood_);
  }

  // When a report was: as it says, or by the clock of this machine, in seconds since 1970.
  [[nodiscard]] double time_of(const io::ReportLine& at) const {
    if (!request_.by_arrival) return at.time_s;
    return came_s_ + since_1970_;
  }

  // What is too close in logs of drones where nothing says it, as 'replay' has it.
  void take_default_of_drones() {
    if (request_.threshold || feed_) return;
    request_.swarm.threshold_m = analysis::kDefaultDroneThreshold_m;
    if (request_.advice) request_.advice->options.threshold_m = request_.swarm.threshold_m;
  }

  // A second vehicle whose times count from when it was switched on, as those of the first do.
  std::optional<Error> clocks_apart(const io::ReportLine& at) {
    if (at.own_clock.empty() || request_.by_arrival) return std::nullopt;
    if (!own_clock_of_) own_clock_of_ = at.id;
    if (*own_clock_of_ == at.id) return std::nullopt;
    return placed(own_clocks_problem(*own_clock_of_, at, live_));
  }

  // Frames of MAVLink as they come over the air, whose times are asked for.
  [[nodiscard]] Error without_times() const {
    return {ErrorCode::kUnsupportedFormat,
            live_ ? "this is " + std::string(io::kStreamOverTheAir) +
                        "; to take the time at which each frame comes, add --clock arrival"
                  : "this is " + std::string(io::kStreamWithoutTimes),
            {request_.input == "-" ? "<stdin>" : request_.input}};
  }

  // Where the report is that was read last.
  [[nodiscard]] Error placed(Error error) const {
    error.location.source = request_.input == "-" ? "<stdin>" : request_.input;
    (lines_.in_frames() ? error.location.record : error.location.line) = line_number();
    return error;
  }

  // The report that was read last counts as none, if there is a reason: its bee is silent.
  bool counts_as_none(const std::optional<std::string>& why, std::string_view id) {
    if (!why) return false;
    note_heard_of(id);
    note_bad(
        placed({ErrorCode::kOutsideDomain, "this report " + *why + " and counts as none", {}}));
    return true;
  }

  // Of the report that was read last; of a log, the number of its record.
  [[nodiscard]] std::uint64_t line_number() const {
    return lines_.lines() - (lines_.in_frames() ? 1 : 0);
  }
  [[nodiscard]] std::string line_text() const {
    return (lines_.in_frames() ? "record " : "line ") + std::to_string(line_number());
  }

  // It is not known where they are of whose track it is in doubt that it is that of one bee.
  void look_for_doubt(AgentId number, const io::ReportLine& at, const Fix& fix,
                      const Velocity* velocity) {
    const auto [jumps, shared] =
        tracks_.take(number, {fix.time_s, at.position}, at.frame, fix, velocity, of_aircraft_);
    if (jumps || shared) doubt_places();
    const std::string& id = feed_->name(number).id;
    if (jumps && is_said(++left_out_.jumping)) say(jump_text(id, line_text(), fix.time_s));
    if (shared && is_said(++left_out_.shared)) say(shared_text(id, line_text(), fix.time_s));
  }

  void note_thawed(AgentId number, const io::ReportLine& at) {
    doubt_places();
    if (is_said(++left_out_.frozen)) {
      say(thawed_text(feed_->name(number).id, line_text(), time_of(at)));
    }
  }

  void note_contrary(const PositionReport& report) {
    if (is_said(++left_out_.contrary)) {
      say(contrary_text(feed_->name(report.id).id, report.time_s));
    }
  }

  void note_bad(const Error& error) {
    if (is_said(++left_out_.lines)) {
      say("beespace: left out: " + printable(to_string(error)) + "\n");
    }
  }

  // Of so many of a kind; the others are counted only.
  [[nodiscard]] bool is_said(std::uint64_t count) const {
    return count <= kMostSaid && !request_.quiet;
  }

  void tell(const std::vector<SwarmEvent>& events) {
    std::string text;
    for (const SwarmEvent& event : events) {
      tally_.count(event);
      text += event_line(event, feed_->looked_s(), *feed_);
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

  void tell(const analysis::ClockNote& note) {
    tally_.count(note);
    if (advice_ && note.kind == analysis::ClockNote::Kind::kAnew) {
      advice_->start_anew(note.time_s);
    } else if (advice_) {
      advice_->note_clock(note.bee, note.kind != analysis::ClockNote::Kind::kRight);
    }
    if (write_error_ == 0) write_error_ = write_out(clock_line(note, *feed_));
  }

  [[nodiscard]] Error nothing_read() const {
    if (!not_understood_.empty()) return none_understood(not_understood_);
    return {ErrorCode::kNoPoints,
            left_out_.lines > 0 ? "no line of the input could be read as a report"
                                : "there is no report in the input",
            {}};
  }

  [[nodiscard]] std::string summary() const {
    return watch_summary({request_, lines_, tally_, left_out_, feed_ ? &*feed_ : nullptr,
                          advice_ ? &*advice_ : nullptr, unadvised_looks_, frame_, height_unit_,
                          perhaps_frozen_});
  }

  WatchRequest request_;
  io::ReportLines lines_;
  Pace pace_;
  bool traffic_looked_for_ = false;
  bool of_aircraft_ = false;
  io::Frame frame_ = io::Frame::kMetres;  // once there is a feed
  io::Unit height_unit_ = io::Unit::kMetre;
  analysis::Geometry geometry_ = analysis::Geometry::kSpace;
  std::optional<analysis::LiveFeed> feed_;
  std::optional<LiveAdvice> advice_;
  WatchTally tally_;
  std::optional<std::string> own_clock_of_;  // the first bee, where each has a zero of its own
  std::vector<Error> not_understood_;        // before the first that was
  bool live_ = false;
  double came_s_ = 0.0;      // when the last line came, or nothing did
  double reported_s_ = 0.0;  // when the last report that advice was told of came
  // What that is less than the time since 1970.
  double since_1970_ =
      std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch() -
                                    std::chrono::steady_clock::now().time_since_epoch())
          .count();
  LeftOutOfWatch left_out_;
  TrackDoubts tracks_;
  NoPlaces no_places_;
  io::FrozenEnds perhaps_frozen_;
  UnplacedBees unplaced_;
  std::uint64_t unadvised_looks_ = 0;
  int write_error_ = 0;  // the errno of it
};

}  // namespace

Result<ExitCode> run_watch(const WatchRequest& request) {
  return Watch(request).run();
}

}  // namespace beespace::cli
