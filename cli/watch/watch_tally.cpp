#include "cli/watch/watch_tally.hpp"

#include "cli/console/summary_line.hpp"
#include "cli/console/terminal.hpp"
#include "cli/output/event_lines.hpp"
#include "io/bytes/number_text.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace beespace::cli {
namespace {

// To the tenth, as nothing more is known of when a bee fell silent.
std::string seconds(double value) {
  return io::exact(std::round(10.0 * value) / 10.0) + " s";
}

std::string several(std::uint64_t count, const char* one, const char* many) {
  return io::grouped(count) + " " + (count == 1 ? one : many);
}

double unknown_s(const std::vector<Silence>& silences) {
  double sum_s = 0.0;
  for (const Silence& silence : silences) sum_s += silence.unknown_s;
  return sum_s;
}

// Whose clocks differ: where these bees were at one moment is not known; or nothing.
std::string clocks_text(const analysis::LiveFeed& feed) {
  if (feed.apart() == 0) return {};
  return several(feed.apart(), "bee's clock differs from the others'",
                 "bees' clocks differ from those of the others");
}

// What has been heard and is not in the answer.
std::vector<std::string> untaken(const analysis::LiveFeed& feed, const LeftOutOfWatch& left_out) {
  std::vector<std::string> texts;
  const auto add = [&](std::uint64_t count, const char* one, const char* many) {
    if (count > 0) texts.push_back(several(count, one, many));
  };
  add(left_out.lines, "line was left out", "lines were left out");
  add(left_out.nowhere, "bee is known nowhere", "bees are known nowhere");
  add(left_out.shared, "id seems to be of two bees", "ids seem to be of two bees each");
  add(left_out.jumping, "bee jumps", "bees jump");
  add(left_out.frozen, "bee repeats a place that it has left", "bees repeat places that they left");
  add(left_out.no_place, "bee's places were none for a time, as what came later shows",
      "bees' places were none for a time, as what came later shows");
  add(left_out.untimed, "vehicle's clock is not believed", "vehicles' clocks are not believed");
  add(feed.counts().late, "report came too late", "reports came too late");
  add(left_out.contrary, "report contradicts another one", "reports contradict others");
  add(feed.clocks().left_out(), "report was left out for its time",
      "reports were left out for their times");
  return texts;
}

// What is known, but not well enough.
std::vector<std::string> doubtful(const analysis::LiveFeed& feed, const LeftOutOfWatch& left_out) {
  std::vector<std::string> texts;
  const auto add = [&](std::uint64_t count, const char* one, const char* many) {
    if (count > 0) texts.push_back(several(count, one, many));
  };
  add(feed.clocks().named(), "bee's clock was off", "bees' clocks were off");
  if (left_out.feet_doubted) texts.emplace_back("heights may be in metres, not in feet");
  if (feed.begun_anew() > 0) texts.emplace_back("all clocks began anew");
  if (feed.heard_of() == 1 && left_out.nowhere == 0) {
    texts.emplace_back("one bee alone was heard of, and no pair");
  }
  add(left_out.frozen_end,
      "bee repeats its place exactly to the end, though the places before waver",
      "bees repeat their places exactly to the end, though the places before waver");
  add(feed.missed(), "bee was heard of too late to be compared from then on",
      "bees were heard of too late to be compared from then on");
  add(feed.counts().heard_once, "bee was heard of once only", "bees were heard of once only");
  add(feed.silent_at_the_end(), "bee fell silent before the end",
      "bees fell silent before the end");
  add(feed.counts().predicted, "predicted conflict lay ahead at the end",
      "predicted conflicts lay ahead at the end");
  return texts;
}

}  // namespace

bool WatchTally::risk(const analysis::LiveFeed& feed, const LeftOutOfWatch& left_out) const {
  if (!untaken(feed, left_out).empty() || !doubtful(feed, left_out).empty()) return true;
  if (feed.apart() > 0) return true;
  return told(EventKind::kEntered) > 0 || told(EventKind::kLost) > 0 ||
         told(EventKind::kPossible) > 0 || told(EventKind::kOverloaded) > 0 ||
         (told(EventKind::kStale) > 0 && !speed_stated_);
}

void WatchTally::append_clocks(std::string& out, const analysis::LiveFeed& feed) const {
  const analysis::BeeClocks& clocks = feed.clocks();
  if (clocks.named() > 0) {
    const std::string whose = clocks.named() == 1 ? " bee's is off" : " bees' are off";
    append_summary_line(out, "clocks",
                        red(io::grouped(clocks.named())) + whose +
                            ", the last named: " + printable(feed.name(last_off_->bee).id) +
                            ", by " + io::exact(last_off_->ahead_s) + " s");
  }
  if (feed.apart() > 0) {
    const double ahead_s = last_apart_->ahead_s;
    append_summary_line(
        out, "clocks",
        red(several(feed.apart(), "bee's differs", "bees' differ")) +
            " from the others', the last " + "named: " + printable(feed.name(last_apart_->bee).id) +
            ", " + seconds(std::abs(ahead_s)) + (ahead_s > 0.0 ? " ahead" : " behind, or late"));
  }
  if (clocks.left_out() > 0) {
    const char* const for_what = clocks.left_out() == 1 ? " report left out for its time"
                                                        : " reports left out for their times";
    append_summary_line(out, "clocks", red(io::grouped(clocks.left_out())) + for_what);
  }
  if (feed.begun_anew() == 0) return;
  std::string text = "all began anew";
  if (feed.begun_anew() > 1) text += ", " + io::grouped(feed.begun_anew()) + " times";
  append_summary_line(out, "clocks", text);
}

void WatchTally::append_unknown(std::string& out, const analysis::LiveFeed& feed) const {
  constexpr std::size_t kMostNamed = 5;
  if (feed.missed() > 0) {
    const analysis::LiveFeed::Missed& most = feed.longest_missed();
    append_summary_line(out, "missed",
                        red(several(feed.missed(), "bee was", "bees were")) + " heard of late, " +
                            printable(most.id) + " by " + seconds(most.lasted_s) +
                            ": sort the reports by time, or give the file to 'beespace replay'");
  }
  std::vector<Silence> longest = feed.silences();
  if (longest.empty()) return;
  const double sum_s = unknown_s(longest);
  const std::size_t named = std::min(kMostNamed, longest.size());
  std::partial_sort(longest.begin(), longest.begin() + static_cast<std::ptrdiff_t>(named),
                    longest.end(), [](const Silence& a, const Silence& b) {
                      return std::pair(b.unknown_s, a.id) < std::pair(a.unknown_s, b.id);
                    });
  std::string text = red(several(longest.size(), "bee", "bees")) + " for " + seconds(sum_s) +
                     (longest.size() > 1 ? " in all: " : ": ");
  for (std::size_t i = 0; i < named; ++i) {
    if (i > 0) text += ", ";
    text += printable(feed.name(longest[i].id).id) + " " + seconds(longest[i].unknown_s);
    if (longest[i].since_s) text += " (to the end)";
  }
  if (named < longest.size()) text += " and " + io::grouped(longest.size() - named) + " more";
  append_summary_line(out, "unknown", text);
}

void WatchTally::append_events(std::string& out, const analysis::LiveFeed& feed,
                               const LeftOutOfWatch& left_out) const {
  for (const EventKind kind : {EventKind::kPredicted, EventKind::kEntered, EventKind::kLeft}) {
    append_summary_line(out, name_of(kind), io::grouped(told(kind)));
  }
  for (const EventKind kind :
       {EventKind::kLost, EventKind::kPossible, EventKind::kEnded, EventKind::kOverloaded}) {
    if (told(kind) > 0) append_summary_line(out, name_of(kind), io::grouped(told(kind)));
  }
  append_summary_line(out, "verdict", verdict(feed, left_out));
}

std::string WatchTally::verdict(const analysis::LiveFeed& feed,
                                const LeftOutOfWatch& left_out) const {
  const std::string clocks = clocks_text(feed);
  const bool known = clocks.empty() || told(EventKind::kEntered) > 0;
  std::string text;
  if (told(EventKind::kEntered) > 0) {
    text = red(several(told(EventKind::kEntered), "conflict", "conflicts"));
  } else if (!known) {
    text = "not known, as " + red(clocks);
  } else {
    text = "no conflict";
  }
  if (told(EventKind::kPossible) > 0) {
    text +=
        ", " + red(several(told(EventKind::kPossible), "possible conflict", "possible conflicts"));
  }
  if (told(EventKind::kOverloaded) > 0) text += ", " + red("overloaded: not all was watched");
  const std::vector<std::string> left = untaken(feed, left_out);
  const bool stale = told(EventKind::kStale) > 0;
  if (stale) text += " in the known time";
  if (!left.empty()) text += stale ? ", among what was taken" : " among what was taken";
  if (stale) {
    const std::size_t unknown = std::max<std::size_t>(feed.silences().size(), 1);
    text += "; " + red(several(unknown, "bee was", "bees were")) + " unknown for a time";
    if (!speed_stated_) text += " (state --max-speed, and it is said whom they may have met)";
  }
  const char* before = "; ";
  if (known && !clocks.empty()) text += std::exchange(before, ", ") + red(clocks);
  for (const auto& reasons : {left, doubtful(feed, left_out)}) {
    for (const std::string& reason : reasons) {
      text += std::exchange(before, ", ") + red(reason);
    }
  }
  return text;
}

}  // namespace beespace::cli
