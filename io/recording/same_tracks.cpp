#include "io/recording/same_tracks.hpp"

#include "io/bytes/number_text.hpp"
#include "io/problems/excerpt.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <tuple>

namespace beespace::io {
namespace {

constexpr std::size_t kFewestToBeSame = 4;

bool are_same(const std::vector<Fix>& some, const std::vector<Fix>& others) {
  return std::equal(
      some.begin(), some.end(), others.begin(), others.end(),
      [](const Fix& a, const Fix& b) { return a.time_s == b.time_s && a.position == b.position; });
}

}  // namespace

std::optional<std::string> same_tracks_note(const std::vector<RecordedBee>& bees) {
  // By how many fixes there are, and when and where the last one is.
  using Key = std::tuple<std::size_t, double, double, double, double>;
  std::map<Key, const RecordedBee*> firsts;
  const RecordedBee* first = nullptr;
  const RecordedBee* second = nullptr;
  std::size_t count = 0;
  for (const RecordedBee& bee : bees) {
    if (bee.path || bee.fixes.size() < kFewestToBeSame) continue;
    const Fix& last = bee.fixes.back();
    const Point& at = last.position;
    const auto [known, is_new] =
        firsts.try_emplace({bee.fixes.size(), last.time_s, at.x, at.y, at.z}, &bee);
    if (is_new || !are_same(known->second->fixes, bee.fixes)) continue;
    ++count;
    if (first != nullptr) continue;
    first = known->second;
    second = &bee;
  }
  if (first == nullptr) return std::nullopt;
  const std::string more = count == 1
                               ? ""
                               : ", and " + counted(count - 1, "more bee has that of another",
                                                    "more have those of others");
  return excerpt(first->id) + " and " + excerpt(second->id) + " have the same track" + more +
         ", so that they are at distance 0 all the time: where one flight was read twice, or acts "
         "follow one after the other, read each for itself";
}

}  // namespace beespace::io
