#include "motion/live/live_encounters.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace beespace::motion {

void WalkedPairs::add(const LivePair& pair, const AgentPair& bees, std::size_t reported,
                      double distance_m, bool had_entered) {
  pairs_.push_back({pair, bees, static_cast<std::uint32_t>(reported), had_entered, distance_m});
  if (pairs_.size() > most_ + most_ / 4 + 1024) cut();
}

void WalkedPairs::clear() {
  events.clear();
  lost.clear();
  pairs_.clear();
  left_out = {};
}

void WalkedPairs::append(const WalkedPairs& other) {
  pairs_.insert(pairs_.end(), other.pairs_.begin(), other.pairs_.end());
  events.insert(events.end(), other.events.begin(), other.events.end());
  lost.insert(lost.end(), other.lost.begin(), other.lost.end());
  if (other.left_out.any) left_out.add(other.left_out.count, other.left_out.from_m);
}

// A pair that had entered is lost where it is last known; what has just become known of others is
// not reported at all.
void WalkedPairs::give_up(const Walked& walked) {
  if (walked.reported == 0 && !walked.pair.reported.entered)
    return;  // by the outer separation only
  left_out.add(1, walked.distance_m);
  if (!walked.had_entered) return;
  const Stretch& open = *walked.pair.state.open;
  lost.push_back({EventKind::kLost, open.conflict.ends_s, walked.bees.first, walked.bees.second,
                  open.end_m, open.conflict.closest_s, open.conflict.ends_s});
}

void WalkedPairs::cut() {
  if (pairs_.size() <= most_) return;
  // What has ended is reported in any case where its beginning was: it needs no room from now on.
  const auto stays = [](const Walked& walked) {
    return !walked.pair.state.open && walked.had_entered;
  };
  std::vector<std::uint32_t> order;
  order.reserve(pairs_.size());
  for (std::uint32_t i = 0; i < pairs_.size(); ++i) {
    if (!stays(pairs_[i])) order.push_back(i);
  }
  if (order.size() <= most_) return;
  const auto closer = [&](std::uint32_t a, std::uint32_t b) {
    const Walked& first = pairs_[a];
    const Walked& second = pairs_[b];
    if (first.key() != second.key()) return first.key() < second.key();
    return first.pair.places() < second.pair.places();
  };
  const auto end = order.begin() + static_cast<std::ptrdiff_t>(most_);
  std::nth_element(order.begin(), end, order.end(), closer);
  std::vector<bool> gone(pairs_.size());
  for (auto at = end; at != order.end(); ++at) gone[*at] = true;
  std::size_t from = 0;
  std::size_t to = 0;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    const Walked walked = pairs_[i];
    if (gone[i]) {
      give_up(walked);
    } else {
      for (std::uint32_t k = 0; k < walked.reported; ++k) events[to++] = events[from + k];
      pairs_[kept++] = walked;
    }
    from += walked.reported;
  }
  pairs_.resize(kept);
  events.resize(to);
}

void WalkedPairs::open(std::vector<LivePair>& open) const {
  open.clear();
  for (const Walked& walked : pairs_) {
    if (walked.pair.state.open) open.push_back(walked.pair);
  }
}

}  // namespace beespace::motion
