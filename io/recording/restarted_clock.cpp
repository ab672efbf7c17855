#include "io/recording/restarted_clock.hpp"

#include <algorithm>
#include <set>

namespace beespace::io {
namespace {

bool comes_before(const Origin& a, const Origin& b) {
  return a.source != b.source ? a.source < b.source : a.line < b.line;
}

bool is_within_one_file(const ClockCut& cut) {
  return cut.before.source == cut.begins.source;
}

bool is_in(const BeeClock& bee, std::uint64_t source) {
  return bee.first.source <= source && source <= bee.last.source;
}

RestartedClock restart_at(const std::vector<BeeClock>& bees, std::size_t bee) {
  const ClockCut& cut = *bees[bee].cut;
  RestartedClock found;
  found.before = cut.before;
  found.begins = cut.begins;
  found.from_s = cut.from_s;
  found.to_s = cut.to_s;
  found.bee = bee;
  found.bees = 1;
  found.alone =
      std::count_if(bees.begin(), bees.end(), [source = cut.begins.source](const BeeClock& other) {
        return is_in(other, source);
      }) == 1;
  return found;
}

// All go back in one place of the input: those who are there on either side, and not only some.
std::optional<RestartedClock> all_at_once(const std::vector<BeeClock>& bees,
                                          const std::vector<std::size_t>& cut) {
  constexpr std::size_t kSeveral = 2;
  if (cut.size() < kSeveral) return std::nullopt;
  RestartedClock found = restart_at(bees, cut.front());
  found.at_once = true;
  found.bees = 0;
  std::size_t apart = 0;
  std::size_t repeated = 0;
  for (const std::size_t bee : cut) {
    const ClockCut& own = *bees[bee].cut;
    if (!comes_before(own.before, found.begins)) continue;
    ++found.bees;
    if (own.apart) ++apart;
    if (own.repeated) ++repeated;
    if (comes_before(found.before, own.before)) found.before = own.before;
  }
  const auto both_sides = std::count_if(bees.begin(), bees.end(), [&found](const BeeClock& bee) {
    return bee.fixes > 0 && comes_before(bee.first, found.begins) &&
           !comes_before(bee.last, found.begins);
  });
  if (found.bees < kSeveral || found.bees < static_cast<std::size_t>(both_sides)) {
    return std::nullopt;
  }
  if (repeated == found.bees) return std::nullopt;  // written twice
  const bool of_two_files = found.before.source != found.begins.source;
  if (of_two_files && 2 * apart < found.bees - repeated) return std::nullopt;
  return found;
}

// Of a file that has the records of one bee after the other: all of them go back, each among its
// own records.
std::optional<RestartedClock> each_by_itself(const std::vector<BeeClock>& bees,
                                             const std::vector<std::size_t>& cut) {
  std::set<std::uint64_t> looked_at;
  for (const std::size_t first : cut) {
    const ClockCut& earliest = *bees[first].cut;
    const std::uint64_t source = earliest.begins.source;
    if (!is_within_one_file(earliest) || !looked_at.insert(source).second) continue;
    std::size_t repeated = 0;
    RestartedClock found = restart_at(bees, first);
    found.bees = 0;
    const bool all = std::all_of(bees.begin(), bees.end(), [&](const BeeClock& bee) {
      if (!is_in(bee, source) || bee.fixes < 2 * kFewestOfBothRuns) return true;
      if (!bee.cut || !is_within_one_file(*bee.cut)) return false;
      ++found.bees;
      if (bee.cut->repeated) ++repeated;
      return bee.cut->begins.source == source;
    });
    if (all && repeated < found.bees) return found;
  }
  return std::nullopt;
}

// One alone that is somewhere else when it is there again.
std::optional<RestartedClock> one_apart(const std::vector<BeeClock>& bees,
                                        const std::vector<std::size_t>& cut) {
  const auto found = std::find_if(cut.begin(), cut.end(), [&bees](std::size_t bee) {
    return bees[bee].cut->apart && is_within_one_file(*bees[bee].cut);
  });
  if (found == cut.end()) return std::nullopt;
  return restart_at(bees, *found);
}

}  // namespace

std::optional<RestartedClock> restarted_clock(const std::vector<BeeClock>& bees) {
  std::vector<std::size_t> cut;
  for (std::size_t bee = 0; bee < bees.size(); ++bee) {
    if (bees[bee].cut) cut.push_back(bee);
  }
  std::stable_sort(cut.begin(), cut.end(), [&bees](std::size_t a, std::size_t b) {
    return comes_before(bees[a].cut->begins, bees[b].cut->begins);
  });
  if (auto found = all_at_once(bees, cut)) return found;
  if (auto found = each_by_itself(bees, cut)) return found;
  return one_apart(bees, cut);
}

}  // namespace beespace::io
