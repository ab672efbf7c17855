#include "cli/fleet/set_matches.hpp"

#include "analysis/recorded/matching_numbers.hpp"
#include "analysis/recorded/take_off_offset.hpp"
#include "cli/fleet/fleet_errors.hpp"
#include "io/bytes/number_text.hpp"

#include <beespace/nearest.hpp>
#include <beespace/point.hpp>

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <utility>

namespace beespace::cli {
namespace {

// A bee may stand so far from where it was set to, and from one more than another.
constexpr double kStandsBeside_m = 1.0;
// Whose id tells nothing stands no farther from where it was set to, by satellite fixes without
// corrections.
constexpr double kStandsNear_m = 5.0;

// Where a bee was when that began which was set for it, or else when it was first heard of.
std::optional<Point> began_at(const Track& flown, const Track& set) {
  if (flown.fixes.empty() || set.fixes.empty()) return std::nullopt;
  const auto at = position_at(flown, set.fixes.front().time_s);
  return at ? at : flown.fixes.front().position;
}

// What was set to begin nearest to where a bee began.
struct NearestBeginning {
  std::optional<std::size_t> set = {};
  double metres = std::numeric_limits<double>::infinity();
  double next_m = std::numeric_limits<double>::infinity();

  // Whether no other is about as near.
  [[nodiscard]] bool is_clear() const {
    constexpr double kClearlyNearer = 2.0;
    return set && kClearlyNearer * metres <= next_m;
  }
  [[nodiscard]] bool is_near() const { return is_clear() && metres <= kStandsNear_m; }
};

NearestBeginning nearest_beginning(const Track& flown, const std::vector<Track>& set) {
  NearestBeginning nearest;
  for (std::size_t k = 0; k < set.size(); ++k) {
    const auto at = began_at(flown, set[k]);
    if (!at) continue;
    const double metres = distance(*at, set[k].fixes.front().position);
    if (metres < nearest.metres) {
      nearest.next_m = nearest.metres;
      nearest.set = k;
      nearest.metres = metres;
    } else {
      nearest.next_m = std::min(nearest.next_m, metres);
    }
  }
  return nearest;
}

// Each bee with what was set to begin where it began: nothing where that is not clear of all.
std::optional<std::vector<Match>> matches_by_beginnings(const std::vector<Track>& flown,
                                                        const std::vector<Track>& set) {
  std::vector<Match> matches;
  matches.reserve(flown.size());
  std::vector<bool> taken(set.size());
  for (std::size_t i = 0; i < flown.size(); ++i) {
    const NearestBeginning nearest = nearest_beginning(flown[i], set);
    if (!nearest.is_clear() || taken[*nearest.set]) return std::nullopt;
    taken[*nearest.set] = true;
    matches.push_back({i, *nearest.set});
  }
  return matches;
}

// Of bees that began where another one was set to: their ids may not mean the same in both files.
struct OtherBeginnings {
  std::size_t count = 0;
  std::string example = {};
};

OtherBeginnings other_beginnings(const std::vector<Track>& flown, const std::vector<Track>& set,
                                 const std::vector<Match>& matches,
                                 const std::vector<std::string>& flown_ids,
                                 const std::vector<std::string>& set_ids) {
  OtherBeginnings others;
  for (const Match& match : matches) {
    const auto at = began_at(flown[match.flown], set[match.set]);
    if (!at) continue;
    const double own_m = distance(*at, set[match.set].fixes.front().position);
    if (own_m <= kStandsBeside_m) continue;
    const auto other = std::find_if(set.begin(), set.end(), [&](const Track& one) {
      return !one.fixes.empty() &&
             distance(*at, one.fixes.front().position) + kStandsBeside_m < own_m;
    });
    if (other == set.end()) continue;
    if (++others.count > 1) continue;
    others.example = "'" + flown_ids[match.flown] + "' nearer to that of '" +
                     set_ids[static_cast<std::size_t>(other - set.begin())] +
                     "' than to that of '" + set_ids[match.set] + "'";
  }
  return others;
}

// Where ids tell nothing, and who has none to fly is no error: each near where it began.
Status match_by_beginnings(const std::vector<Track>& flown, const std::vector<Track>& set,
                           const std::vector<std::string>& flown_ids,
                           const std::vector<std::string>& set_ids, std::vector<Match>& pairs) {
  std::vector<std::optional<std::size_t>> taken_by(set.size());
  const auto not_told = [&](std::size_t bee, const std::string& why) {
    return cannot_compare(
        "no bee was both set and flown: their ids differ ('" + flown_ids.front() + "' and '" +
        set_ids.front() +
        "'), and so do their numbers, and where each begins does not tell which "
        "is which: '" +
        flown_ids[bee] + "' begins " + why +
        "; give both the same ids, or numbers, as by names of files: 'drone 3.bin' for 'Drone 3'");
  };
  pairs.clear();
  for (std::size_t i = 0; i < flown.size(); ++i) {
    const NearestBeginning nearest = nearest_beginning(flown[i], set);
    if (!nearest.set) continue;
    const std::string distance_text =
        io::grouped(nearest.metres, 2) + " m from that of '" + set_ids[*nearest.set] + "'";
    if (!nearest.is_clear()) {
      return not_told(i, distance_text + ", and another is about as near");
    }
    if (!nearest.is_near()) return not_told(i, distance_text + ", the nearest that was set");
    if (taken_by[*nearest.set]) {
      return not_told(
          i, distance_text + ", as '" + flown_ids[*taken_by[*nearest.set]] + "' does, too");
    }
    taken_by[*nearest.set] = i;
    pairs.push_back({i, *nearest.set});
  }
  return std::monostate{};
}

// Who has no match flies what none of the others does, where it began.
void match_spares(const std::vector<Track>& flown, const std::vector<Track>& set,
                  const std::vector<std::string>& flown_ids,
                  const std::vector<std::string>& set_ids, std::vector<Match>& pairs,
                  std::vector<std::string>& notes) {
  std::vector<bool> flies(flown.size());
  std::vector<bool> is_flown(set.size());
  for (const Match& match : pairs) {
    flies[match.flown] = true;
    is_flown[match.set] = true;
  }
  for (std::size_t i = 0; i < flown.size(); ++i) {
    if (flies[i]) continue;
    const NearestBeginning nearest = nearest_beginning(flown[i], set);
    if (!nearest.is_near() || is_flown[*nearest.set]) continue;
    is_flown[*nearest.set] = true;
    pairs.push_back({i, *nearest.set});
    notes.push_back("'" + flown_ids[i] + "' was not set to fly, and begins where '" +
                    set_ids[*nearest.set] +
                    "' was set to, which did not: it is compared with that");
  }
}

}  // namespace

std::vector<std::string> ids_of(const io::Recording& recording) {
  std::vector<std::string> ids;
  ids.reserve(recording.bees.size());
  for (const io::RecordedBee& bee : recording.bees) ids.push_back(bee.id);
  return ids;
}

Matches matches_of(const std::vector<std::string>& flown, const std::vector<std::string>& set) {
  std::map<std::string, std::size_t> set_by_id;
  for (std::size_t i = 0; i < set.size(); ++i) set_by_id.emplace(set[i], i);
  Matches matches;
  for (std::size_t i = 0; i < flown.size(); ++i) {
    const auto found = set_by_id.find(flown[i]);
    if (found != set_by_id.end()) matches.pairs.push_back({i, found->second});
  }
  if (!matches.pairs.empty()) return matches;
  matches.by_numbers = true;
  const auto by_numbers = analysis::match_by_numbers(flown, set);
  for (std::size_t i = 0; i < by_numbers.size(); ++i) {
    if (by_numbers[i]) matches.pairs.push_back({i, *by_numbers[i]});
  }
  return matches;
}

std::span<const Fix> fixes_with_heights(const io::Recording& recording,
                                        const std::vector<Track>& tracks, std::size_t bee) {
  if (recording.frame == io::Frame::kMetres) return tracks[bee].fixes;
  return recording.bees[bee].fixes;
}

void match_by_take_offs(const FixesByBee& flown, const FixesByBee& set, Matches& matches) {
  const auto in_order = [](const FixesByBee& bees) {
    std::vector<std::pair<double, std::size_t>> order;
    order.reserve(bees.size());
    for (std::size_t i = 0; i < bees.size(); ++i) {
      constexpr double kNever = std::numeric_limits<double>::infinity();
      order.emplace_back(analysis::first_take_off_s(bees[i]).value_or(kNever), i);
    }
    std::sort(order.begin(), order.end());
    return order;
  };
  const auto of_flown = in_order(flown);
  const auto of_set = in_order(set);
  matches.by_take_offs = true;
  matches.pairs.clear();
  for (std::size_t i = 0; i < std::min(flown.size(), set.size()); ++i) {
    matches.pairs.push_back({of_flown[i].second, of_set[i].second});
  }
}

Status settle_matches(const std::vector<Track>& flown, const std::vector<Track>& set,
                      const std::vector<std::string>& flown_ids,
                      const std::vector<std::string>& set_ids, Matches& matches,
                      std::vector<std::string>& notes) {
  std::vector<Match>& pairs = matches.pairs;
  const auto note_by_beginnings = [&] {
    notes.push_back("ids differ, and so each is to fly what was set to begin where it began: '" +
                    flown_ids[pairs.front().flown] + "' that of '" + set_ids[pairs.front().set] +
                    "'");
  };
  if (matches.by_take_offs) {
    if (Status told = match_by_beginnings(flown, set, flown_ids, set_ids, pairs); !told) {
      return told;
    }
    if (!pairs.empty()) note_by_beginnings();
    return std::monostate{};
  }
  match_spares(flown, set, flown_ids, set_ids, pairs, notes);
  const OtherBeginnings others = other_beginnings(flown, set, pairs, flown_ids, set_ids);
  const std::string text = io::counted(others.count, "begins", "begin") +
                           " nearer to another beginning than to the own one that was set, as " +
                           others.example;
  if (matches.by_numbers && 2 * others.count > pairs.size()) {
    auto by_beginnings = matches_by_beginnings(flown, set);
    if (!by_beginnings) {
      return Error{ErrorCode::kUnsupportedFormat,
                   "ids of what was set and flown differ, and their numbers do not mean "
                   "the same: " +
                       text + "; give both the same ids",
                   {}};
    }
    pairs = *std::move(by_beginnings);
    note_by_beginnings();
    return std::monostate{};
  }
  if (matches.by_numbers && !pairs.empty()) {
    notes.push_back("ids are matched by their numbers: '" + flown_ids[pairs.front().flown] +
                    "' is to fly what was set for '" + set_ids[pairs.front().set] + "'");
  }
  if (others.count > 0) {
    notes.push_back(text +
                    ": where places were given out anew, ids of both do not mean the same, and "
                    "deviations are not those of flying");
  }
  return std::monostate{};
}

}  // namespace beespace::cli
