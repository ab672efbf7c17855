#include "report/ahead_words.hpp"

#include "report/number_label.hpp"
#include "report/separation_words.hpp"

#include <cstddef>

namespace beespace::report {
namespace {

// The look ahead ends there: the two may come closer behind it.
bool is_closing_at_the_end(const ConflictAhead& each, const Ahead& ahead) {
  constexpr double kRounded_s = 1e-6;
  return each.closest_in_s > each.begins_in_s && each.closest_in_s >= ahead.horizon_s - kRounded_s;
}

}  // namespace

std::string ahead_words(const SnapshotFacts& facts, std::size_t most) {
  if (facts.moment.empty()) return {};
  if (!facts.ahead) return "not known, as the input tells no velocities that can be flown on with";
  const Ahead& ahead = *facts.ahead;
  const std::string within = " within " + decimal_label(ahead.horizon_s, 0) + " s";
  const std::string of_known = ahead.complete ? "" : ", of those that are known";
  if (ahead.count == 0) return "flying straight on, no conflict begins" + within + of_known;
  std::string text = "flying straight on, " + count_label(ahead.count, "conflict", "conflicts");
  text += within + of_known;
  text += ahead.count > 1 ? ", the worst first: " : ": ";
  for (std::size_t i = 0; i < ahead.conflicts.size() && i < most; ++i) {
    const ConflictAhead& each = ahead.conflicts[i];
    if (i > 0) text += "; ";
    text += facts.swarm.names.of(each.first);
    text += " and ";
    text += facts.swarm.names.of(each.second);
    text += " in ";
    text += decimal_label(each.begins_in_s, 1);
    text += " s, down to ";
    text += apart_words(facts.swarm, each.closest_m, each.apart);
    if (is_closing_at_the_end(each, ahead)) text += ", still closing then";
  }
  if (ahead.count > most) text += "; and " + count_label(ahead.count - most) + " more";
  return text;
}

}  // namespace beespace::report
