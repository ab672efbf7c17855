#include "report/figure/figure.hpp"

#include "io/bytes/number_text.hpp"
#include "report/ahead_words.hpp"
#include "report/figure/nearest_histogram.hpp"
#include "report/figure/picture_names.hpp"
#include "report/figure/recording_view.hpp"
#include "report/figure/separation_chart.hpp"
#include "report/figure/sheet.hpp"
#include "report/figure/snapshot_view.hpp"
#include "report/figure/style.hpp"
#include "report/figure/view.hpp"
#include "report/number_label.hpp"
#include "report/separation_words.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace beespace::report {
namespace {

constexpr Spot kViews = {100.0, kPanelsTop};
constexpr double kViewsWidth = 648.0;
constexpr Box kChart = {832.0, kPanelsTop, kRight - 832.0, 228.0};
constexpr double kBelowChart = 80.0;  // its labels, and the heading of the list
constexpr double kBelowViews = 44.0;  // their labels
constexpr std::size_t kMostRows = 30;

std::string name_of(const Names& names, PointId first, PointId second) {
  return picture_name(names, first) + " \u2013 " + picture_name(names, second);
}

// Who flies several flights one after the other is called after that of the moment.
std::string name_of(const Names& names, const Conflict& pair) {
  const auto name = [&](PointId bee) {
    std::string then = names.at(pair.closest_s, bee);
    return then == names.of(bee) ? picture_name(names, bee) : then;
  };
  return name(pair.first) + " \u2013 " + name(pair.second);
}

std::string counted(std::size_t count, const io::RecordedNoun& noun) {
  return count_label(count, noun.one, noun.several);
}

// What is found at the moment itself.
std::string findings_now(const SnapshotFacts& facts) {
  std::string text = counted(facts.positions.size(), facts.swarm.noun);
  text += facts.moment.empty() ? ". " : " at " + facts.moment + ". ";
  const std::string now = facts.moment.empty() ? "" : " at this moment";
  if (facts.at_risk.empty() && !facts.unknown.empty()) {
    return text + "Not known of all: " + facts.unknown + "; of those that are known none is " +
           too_close(facts.swarm) + " to another" + now + ".";
  }
  if (facts.at_risk.empty()) {
    return text + "No " + facts.swarm.noun.one + " is " + too_close(facts.swarm) + " to another" +
           now + ".";
  }
  text += count_label(facts.at_risk.size(), "is at risk", "are at risk") + ": " +
          count_label(facts.pair_count, "pair", "pairs") + " " + too_close(facts.swarm) + ", in " +
          count_label(facts.group_count, "group", "groups");
  if (facts.group_count > 1 && facts.largest_group > 2)
    text += " of up to " + count_label(facts.largest_group);
  if (!facts.unknown.empty()) text += "; " + facts.unknown;
  return text + ".";
}

// One of those ahead is enough: there is a list of them.
std::string findings_of(const SnapshotFacts& facts) {
  const std::string ahead = ahead_words(facts, 1);
  return findings_now(facts) + (ahead.empty() ? "" : " Ahead: " + ahead + ".");
}

std::string findings_of(const RecordingFacts& facts) {
  const std::size_t all = facts.tracks.size() + facts.nowhere_count;
  std::string text = counted(all, facts.swarm.noun) + ". ";
  if (facts.nothing_compared) {
    text +=
        "Nothing to compare: no two " + facts.swarm.noun.several + " are there at the same time";
    return text + (facts.unknown.empty() ? "." : "; " + facts.unknown + ".");
  }
  std::string but_for;
  if (facts.standing_count > 0) {
    but_for = ", but for " + count_label(facts.standing_count, "conflict", "conflicts") +
              " of two that both stand on the ground";
  }
  if (facts.low_count > 0) {
    but_for += (but_for.empty() ? ", but for " : " and ") + facts.low_text;
  }
  if (facts.conflict_count == 0 && facts.never_known && !facts.unknown.empty()) {
    return text + "Not seen as a whole: " + facts.unknown + "; no others come " +
           too_close(facts.swarm) + " in the known time" + but_for + ".";
  }
  if (facts.conflict_count == 0 && !facts.unknown.empty()) {
    return text + "No two come " + too_close(facts.swarm) + " in the known time" + but_for + "; " +
           facts.unknown + ".";
  }
  if (facts.conflict_count == 0) {
    return text + "No " + facts.swarm.noun.one + " comes " + too_close(facts.swarm) +
           " to another" + but_for + ".";
  }
  text += count_label(facts.conflict_count, "conflict", "conflicts") + " of " +
          count_label(facts.pair_count, "pair", "pairs") + ": " + too_close(facts.swarm);
  if (facts.possible_count > 0) {
    text += "; " + count_label(facts.possible_count) + " of them possible, not certain";
  }
  if (facts.low_count > 0) text += "; beside " + facts.low_text;
  if (!facts.unknown.empty()) text += "; " + facts.unknown;
  return text + ".";
}

Listing closest_pairs(const SnapshotFacts& facts) {
  // Where two limits count, the list is by how far apart they are in a straight line.
  Listing listing{facts.swarm.vertical_m ? "Closest pairs (straight line)" : "Closest pairs",
                  {},
                  facts.pair_count};
  for (std::size_t i = 0; i < std::min(kMostRows, facts.pairs.size()); ++i) {
    const auto& [first, second] = facts.pairs[i];
    listing.rows.push_back(
        {name_of(facts.swarm.names, first, second),
         listed_apart(facts.swarm, facts.distances_m[i],
                      i < facts.apart.size() ? std::optional(facts.apart[i]) : std::nullopt)});
  }
  const bool any_ahead = facts.ahead && facts.ahead->count > 0;
  if (facts.pairs.empty() && !any_ahead && facts.closest) {
    listing.heading = "Closest pair, not too close";
    listing.rows.push_back(
        {name_of(facts.swarm.names, facts.closest->first, facts.closest->second),
         listed_apart(facts.swarm, facts.closest->distance_m, facts.closest_apart)});
  }
  return listing;
}

// Those that come after the moment, the worst first.
Listing conflicts_ahead(const SnapshotFacts& facts) {
  Listing listing{"Ahead, flying straight on", {}, 0};
  if (!facts.ahead) return listing;
  listing.count = facts.ahead->count;
  for (const ConflictAhead& each : facts.ahead->conflicts) {
    listing.rows.push_back({name_of(facts.swarm.names, each.first, each.second),
                            listed_apart(facts.swarm, each.closest_m, each.apart) + " in " +
                                decimal_label(each.closest_in_s, 0) + " s"});
  }
  return listing;
}

// No more digits than say something to who looks at a picture; a line does not break before a unit.
std::string duration_words(double seconds) {
  constexpr double kWhole_s = 10.0;
  constexpr double kTenths_s = 1.0;
  double told_s = seconds;
  if (seconds >= kTenths_s) told_s = std::round(seconds * 10.0) / 10.0;
  if (seconds >= kWhole_s) told_s = std::round(seconds);
  std::string words;
  for (const char letter : io::time_span(told_s)) {
    if (letter == ' ') {
      words += "\u00a0";
    } else {
      words += letter;
    }
  }
  return words;
}

// ", for 2 h", or "; 19 conflicts, 2 h 10 min in all"; nothing of an encounter that is none.
std::string duration_of(const Conflict& conflict, const std::vector<PairInConflict>& pairs) {
  const auto ids = [](const auto& pair) { return std::pair(pair.first, pair.second); };
  const auto pair = std::lower_bound(
      pairs.begin(), pairs.end(), conflict,
      [&ids](const PairInConflict& a, const Conflict& b) { return ids(a) < ids(b); });
  if (pair != pairs.end() && ids(*pair) == ids(conflict) && pair->conflicts > 1) {
    return "; " + count_label(pair->conflicts, "conflict", "conflicts") + ", " +
           duration_words(pair->time_s) + " in all";
  }
  const double lasts_s = conflict.ends_s - conflict.begins_s;
  return lasts_s > 0.0 ? ", for " + duration_words(lasts_s) : std::string();
}

std::vector<Ink> inks_of(const Conflict& conflict, const RecordingFacts& facts) {
  const auto first = own_ink(conflict.first, facts.tracks.size());
  const auto second = own_ink(conflict.second, facts.tracks.size());
  return first && second ? std::vector<Ink>{*first, *second} : std::vector<Ink>();
}

// Which conflicts are with a drone on the ground.
class WithStanding {
 public:
  explicit WithStanding(const RecordingFacts& facts) {
    for (const Conflict& conflict : facts.with_standing) keys_.insert(key_of(conflict));
  }
  [[nodiscard]] bool any() const { return !keys_.empty(); }
  [[nodiscard]] bool has(const Conflict& conflict) const {
    return keys_.find(key_of(conflict)) != keys_.end();
  }

 private:
  using Key = std::tuple<PointId, PointId, double>;
  static Key key_of(const Conflict& conflict) {
    return {conflict.first, conflict.second, conflict.begins_s};
  }
  std::set<Key> keys_;
};

// Of each pair the closest of its conflicts, by place: those in the air first, and behind them of
// each pair that which is with a drone on the ground, if it has no other.
std::vector<std::size_t> closest_of_each_pair(const RecordingFacts& facts,
                                              const WithStanding& with_standing) {
  std::vector<std::size_t> places;
  std::set<std::pair<PointId, PointId>> pairs;
  for (const bool standing : {false, true}) {
    if (standing && !with_standing.any()) break;
    for (std::size_t i = 0; i < facts.conflicts.size(); ++i) {
      const Conflict& conflict = facts.conflicts[i];
      if (with_standing.has(conflict) != standing) continue;
      if (pairs.emplace(conflict.first, conflict.second).second) places.push_back(i);
    }
  }
  return places;
}

// Animals meet; who are together for longest come first, and of drones who may collide.
void sort_longest_first(const RecordingFacts& facts, std::vector<std::size_t>& places) {
  std::map<std::pair<PointId, PointId>, double> together_s;
  for (const PairInConflict& pair : facts.pairs) {
    together_s[{pair.first, pair.second}] = pair.time_s;
  }
  const auto lasts_s = [&](std::size_t place) {
    return together_s[{facts.conflicts[place].first, facts.conflicts[place].second}];
  };
  std::stable_sort(places.begin(), places.end(),
                   [&lasts_s](std::size_t a, std::size_t b) { return lasts_s(a) > lasts_s(b); });
}

Listing closest_conflicts(const RecordingFacts& facts) {
  const bool of_animals = facts.swarm.noun.one == "animal";
  // Where two limits count, those are first who are farthest within both.
  Listing listing{of_animals               ? "Pairs that are together for longest"
                  : facts.swarm.vertical_m ? "Worst pairs in conflict"
                                           : "Closest pairs in conflict",
                  {},
                  facts.pair_count};
  const auto add = [&](const Conflict& conflict, const std::optional<Apart>& apart,
                       const char* kind) {
    listing.rows.push_back({name_of(facts.swarm.names, conflict),
                            listed_apart(facts.swarm, conflict.closest_m, apart) + " at " +
                                moment_label(conflict.closest_s, facts) + kind +
                                duration_of(conflict, facts.pairs),
                            inks_of(conflict, facts)});
  };
  const WithStanding with_standing(facts);
  std::vector<std::size_t> places = closest_of_each_pair(facts, with_standing);
  if (of_animals) sort_longest_first(facts, places);
  for (const std::size_t place : places) {
    if (listing.rows.size() == kMostRows) break;
    const Conflict& conflict = facts.conflicts[place];
    const bool known = place < facts.conflicts_apart.size();
    add(conflict, known ? std::optional(facts.conflicts_apart[place]) : std::nullopt,
        with_standing.has(conflict) ? with_one_standing(facts.swarm)
        : conflict.certain          ? ""
                                    : ", possible");
  }
  if (facts.conflicts.empty() && facts.closest) {
    listing.heading = facts.closest_left_out  ? "Closest encounter, left out"
                      : facts.unknown.empty() ? "Closest encounter, not too close"
                                              : "Closest encounter in the known time";
    add(*facts.closest, facts.closest_apart, "");
  }
  return listing;
}

// The views on the left; returns where they end.
template <class Draw>
double draw_views(const std::vector<View>& views, const Draw& draw, Drawing& drawing) {
  for (const View& view : views) {
    draw_panel(view.panel, drawing);
    draw(view);
  }
  return views.back().panel.box.bottom() + kBelowViews;
}

// The list below the chart; returns where the sheet ends above its notes. Some rows have room where
// the views are low, too.
double draw_below_chart(const Listing& listing, double bottom, Drawing& drawing) {
  constexpr std::size_t kFew = 6;
  const Spot corner{kChart.left, kChart.bottom() + kBelowChart};
  const double least = corner.y + listing_height(listing, kChart.width, kFew);
  bottom = std::max(bottom, least);
  draw_listing(listing, corner, kChart.width, bottom, drawing);
  return bottom;
}

// Of one moment: some of those that are too close at it, and below these those ahead.
double draw_both_below_chart(const Listing& now, const Listing& ahead, double bottom,
                             Drawing& drawing) {
  constexpr std::size_t kFewNow = 6;
  constexpr double kBetween = 34.0;
  if (now.rows.empty()) return draw_below_chart(ahead, bottom, drawing);
  if (ahead.rows.empty()) return draw_below_chart(now, bottom, drawing);
  const Spot corner{kChart.left, kChart.bottom() + kBelowChart};
  const double end = corner.y + listing_height(now, kChart.width, kFewNow);
  draw_listing(now, corner, kChart.width, end, drawing);
  const Spot next{kChart.left, end + kBetween};
  bottom = std::max(bottom, next.y + listing_height(ahead, kChart.width, kFewNow));
  draw_listing(ahead, next, kChart.width, bottom, drawing);
  return bottom;
}

}  // namespace

Drawing figure_of(const SnapshotFacts& facts) {
  Extent extent;
  for (const Point& position : facts.positions) extent.add(position);
  if (facts.ahead) {
    for (const ConflictAhead& each : facts.ahead->conflicts) {
      extent.add(each.first_there);
      extent.add(each.second_there);
    }
  }
  const auto views = views_of(extent, facts.swarm, kViews, kViewsWidth);
  Drawing drawing = begin_sheet(facts.swarm, findings_of(facts), key_of_bees(facts, views.front()));
  double bottom = draw_views(
      views, [&](const View& view) { draw_bees(facts, view, drawing); }, drawing);
  if (const auto histogram = nearest_histogram(facts)) {
    draw_histogram(*histogram, facts.swarm, kChart, drawing);
  }
  bottom = draw_both_below_chart(closest_pairs(facts), conflicts_ahead(facts), bottom, drawing);
  finish_sheet(facts.swarm, bottom, drawing);
  return drawing;
}

Drawing figure_of(const RecordingFacts& facts) {
  Extent extent;
  for (const Track& track : facts.tracks) {
    for (const Fix& fix : track.fixes) extent.add(fix.position);
  }
  const auto views = views_of(extent, facts.swarm, kViews, kViewsWidth);
  Drawing drawing =
      begin_sheet(facts.swarm, findings_of(facts), key_of_paths(facts, views.front()));
  double bottom = draw_views(
      views, [&](const View& view) { draw_paths(facts, view, drawing); }, drawing);
  draw_separation(facts, kChart, drawing);
  bottom = draw_below_chart(closest_conflicts(facts), bottom, drawing);
  finish_sheet(facts.swarm, bottom, drawing);
  return drawing;
}

}  // namespace beespace::report
