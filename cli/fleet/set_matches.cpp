#include "cli/fleet/set_matches.hpp"

#include "analysis/recorded/matching_numbers.hpp"
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

// Where a bee was when that began which was set for it, or else when it was first heard of.
std::optional<Point> began_at(const Track& flown, const Track& set) {
  if (flown.fixes.empty() || set.fixes.empty()) return std::nullopt;
  const auto at = position_at(flown, set.fixes.front().time_s);
  return at ? at : flown.fixes.front().position;
}

// What was set to begin nearest to where this bee began, where no other is about as near.
std::optional<std::size_t> nearest_beginning(const Track& flown, const std::vector<Track>& set) {
  constexpr double kClearlyNearer = 2.0;
  std::optional<std::size_t> nearest;
  double least_m = 0.0;
  double next_m = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < set.size(); ++k) {
    const auto at = began_at(flown, set[k]);
    if (!at) continue;
    const double metres = distance(*at, set[k].fixes.front().position);
    if (!nearest || metres < least_m) {
      if (nearest) next_m = least_m;
      nearest = k;
      least_m = metres;
    } else {
      next_m = std::min(next_m, metres);
    }
  }
  if (kClearlyNearer * least_m > next_m) return std::nullopt;
  return nearest;
}

// Each bee with what was set to begin where it began: nothing where that is not clear of all.
std::optional<std::vector<Match>> matches_by_beginnings(const std::vector<Track>& flown,
                                                        const std::vector<Track>& set) {
  std::vector<Match> matches;
  matches.reserve(flown.size());
  std::vector<bool> taken(set.size());
  for (std::size_t i = 0; i < flown.size(); ++i) {
    const auto nearest = nearest_beginning(flown[i], set);
    if (!nearest || taken[*nearest]) return std::nullopt;
    taken[*nearest] = true;
    matches.push_back({i, *nearest});
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

Status settle_matches(const std::vector<Track>& flown, const std::vector<Track>& set,
                      const std::vector<std::string>& flown_ids,
                      const std::vector<std::string>& set_ids, Matches& matches,
                      std::vector<std::string>& notes) {
  std::vector<Match>& pairs = matches.pairs;
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
    notes.push_back("ids differ, and so each is to fly what was set to begin where it began: '" +
                    flown_ids[pairs.front().flown] + "' that of '" + set_ids[pairs.front().set] +
                    "'");
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
