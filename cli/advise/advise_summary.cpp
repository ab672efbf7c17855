#include "cli/advise/advise_summary.hpp"

#include "cli/console/summary_line.hpp"
#include "cli/console/terminal.hpp"
#include "cli/output/advice_words.hpp"
#include "io/bytes/byte_source.hpp"
#include "io/bytes/number_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace beespace::cli {
namespace {

// Of a list, so many are shown.
constexpr std::size_t kMostShown = 5;

std::string times(std::uint64_t count, const char* one, const char* several) {
  return io::grouped(count) + " " + (count == 1 ? one : several);
}

std::string method_text(AdviseMethod method) {
  return std::string(name_of(method)) +
         (method == AdviseMethod::kCertified ? "" : ", which promises nothing");
}

std::string threshold_text(const AdviseOptions& options) {
  std::string text = separation_text(options.threshold_m, std::nullopt, false);
  if (options.uncertainty_m > 0.0) {
    text += ", places known to " + io::exact(options.uncertainty_m) + " m";
  }
  return text;
}

std::string limits_text(const AdviceAnswer& answer) {
  if (answer.given.own_limits) return "of each bee, as the file tells";
  const FlightLimits& limits = answer.request.limits;
  const std::string text = io::exact(limits.max_speed_mps) + " m/s";
  if (std::isinf(limits.max_acceleration_mps2)) return text + ", velocities change at once";
  return text + ", " + io::exact(limits.max_acceleration_mps2) + " m/s^2";
}

void append_surroundings(std::string& out, const AdviceAnswer& answer) {
  const AdviseRequest& request = answer.request;
  if (!request.obstacles.empty()) {
    append_summary_line(out, "obstacles",
                        io::grouped(std::uint64_t{answer.given.obstacles.obstacles().size()}) +
                            ", clearance " + io::exact(request.advice.clearance_m) + " m");
  }
  if (!request.intruders.empty()) {
    append_summary_line(out, "intruders",
                        io::grouped(std::uint64_t{answer.given.intruders.size()}) +
                            ", seen to fly straight on for " +
                            io::exact(request.advice.intruder_horizon_s) + " s");
  }
}

void append_advice(std::string& out, const AdviceAnswer& answer) {
  struct Line {
    AdviceKind kind;
    const char* label;
    const char* meaning;
  };
  constexpr std::array<Line, 4> kLines = {
      {{AdviceKind::kAsPreferred, "preferred", ""},
       {AdviceKind::kDeflected, "deflected", ", for the sake of others"},
       {AdviceKind::kBraking, "braking", ", as hard as they can"},
       {AdviceKind::kWaiting, "waiting", ", as others are in their way"}}};
  for (const Line& line : kLines) {
    const std::uint64_t bees = count(answer.advised, line.kind);
    append_summary_line(out, line.label, io::grouped(bees) + (bees > 0 ? line.meaning : ""));
  }
  if (const std::uint64_t bees = count(answer.advised, AdviceKind::kNone); bees > 0) {
    append_summary_line(out, "no advice",
                        io::grouped(bees) + ", as what is said of them cannot be");
  }
}

void append_uncertain(std::string& out, const AdviceAnswer& answer) {
  std::string text = bold("none");
  if (answer.request.advice.method != AdviseMethod::kCertified) {
    text = "all: this method certifies no bee";
  } else if (const std::uint64_t bees = count_uncertified(answer.advised); bees > 0) {
    text = red(times(bees, "bee", "bees")) + " not certified";
  }
  append_summary_line(out, "uncertain", text);
}

std::string pair_text(const TooClose& close, const FlightNames& names) {
  std::string text = names.bee(close.pair.first) + " and " + names.bee(close.pair.second) + ", ";
  // Of ways that cross, nothing but rounding is left.
  constexpr double kCrossing_m = 1e-9;
  text += close.gap_m > kCrossing_m ? io::length(close.gap_m) + " between their ways to a stop"
                                    : std::string("whose ways to a stop cross");
  if (std::isinf(close.clear_s)) return text + ", and stay too close";
  if (close.clear_s > 0.0) return text + ", clear in " + io::grouped(close.clear_s, 2) + " s";
  return text + ", still far enough apart";
}

// "3 pairs", and below it the first few of them.
template <class Item, class Text>
void append_list(std::string& out, const char* label, const std::string& how_many,
                 const std::vector<Item>& items, const Text& text_of) {
  if (items.empty()) return;
  append_summary_line(out, label, red(how_many));
  for (std::size_t i = 0; i < std::min(items.size(), kMostShown); ++i) {
    append_summary_line(out, "", text_of(items[i]));
  }
  if (items.size() <= kMostShown) return;
  append_summary_line(out, "",
                      "and " + io::grouped(std::uint64_t{items.size() - kMostShown}) + " more");
}

std::string refused_text(const Refused& refused, const AdviceAnswer& answer) {
  const auto index = static_cast<PointId>(refused.index);
  const bool is_intruder = refused.kind == RefusedKind::kIntruder;
  const FlightNames& names = is_intruder ? answer.given.intruder_names : answer.given.names;
  std::string text = (is_intruder ? "the intruder " : "") + names.bee(index) + ": ";
  text += printable(refused.error.message);
  if (refused.kind == RefusedKind::kPreferred)
    return text + "; it is advised as if it preferred to stand";
  return text + "; it may be anywhere, so no bee is certified";
}

void append_findings(std::string& out, const AdviceAnswer& answer) {
  const Advised& advised = answer.advised;
  const FlightNames& names = answer.given.names;
  append_list(out, "refused", std::to_string(advised.refused.size()) + " that cannot be used",
              advised.refused,
              [&](const Refused& refused) { return refused_text(refused, answer); });
  append_list(out, "too close", times(advised.too_close.size(), "pair", "pairs"), advised.too_close,
              [&](const TooClose& close) { return pair_text(close, names); });
  append_list(
      out, "near", times(advised.near_obstacle.size(), "bee", "bees") + " to an obstacle",
      advised.near_obstacle, [&](const NearObstacle& near) {
        const Obstacle& obstacle = answer.given.obstacles.obstacles()[near.obstacle];
        const std::string which = names.obstacle(near.obstacle, obstacle);
        return names.bee(near.agent) + ", whose way to a stop " +
               (near.gap_m > 0.0 ? "comes within " + io::length(near.gap_m) + " of " : "meets ") +
               which;
      });
  append_list(
      out, "conflicts",
      times(advised.intruder_conflicts.size(), "conflict", "conflicts") + " with an intruder ahead",
      advised.intruder_conflicts, [&](const IntruderConflict& conflict) {
        const auto intruder = static_cast<PointId>(conflict.intruder);
        return names.bee(conflict.agent) + " and the intruder " +
               answer.given.intruder_names.bee(intruder) + ", in " +
               io::grouped(conflict.begins_s, 2) + " s, closest " +
               io::length_below(answer.request.advice.threshold_m, conflict.closest_m);
      });
}

}  // namespace

std::string advise_summary(const AdviceAnswer& answer, const AdviseTimes& times) {
  const AdviseRequest& request = answer.request;
  const AdviceInput& given = answer.given;
  std::string out;
  append_summary_line(
      out, "input",
      printable(io::source_name(request.input)) + " (" + given.format_description + ")");
  append_units(out, given.units);
  for (const std::string& note : given.notes) {
    append_summary_line(out, "note", printable(note));
  }
  append_summary_line(out, "bees", io::grouped(std::uint64_t{given.movers.size()}));
  append_summary_line(out, "method", method_text(request.advice.method));
  append_summary_line(out, "threshold", threshold_text(request.advice));
  append_summary_line(out, "limits", limits_text(answer));
  append_summary_line(out, "step", io::exact(request.advice.step_s) + " s");
  append_surroundings(out, answer);
  append_advice(out, answer);
  append_uncertain(out, answer);
  append_findings(out, answer);
  append_summary_line(
      out, "time",
      "read " + io::duration(times.read_s) + ", advise " + io::duration(times.advise_s));
  return out;
}

}  // namespace beespace::cli
