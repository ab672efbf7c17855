// What `watch` has told, counted; and what that comes to in the end.
#pragma once

#include "analysis/live/live_feed.hpp"

#include <beespace/swarm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace beespace::cli {

// What was heard and not taken into account beside what the feed counts.
struct LeftOutOfWatch {
  std::uint64_t lines = 0;       // bad ones
  std::uint64_t contrary = 0;    // reports of a bee that is elsewhere at that time
  std::uint64_t nowhere = 0;     // bees of which no line says where they are
  std::uint64_t shared = 0;      // ids that two bees seem to share
  std::uint64_t jumping = 0;     // bees that are somewhere else faster than anything flies
  std::uint64_t frozen = 0;      // bees that jump out of a place that they repeated
  std::uint64_t no_place = 0;    // of others: bees whose places were none for a time
  std::uint64_t frozen_end = 0;  // bees whose last place is repeated though places waver
  bool feet_doubted = false;     // whether heights are in feet, as they were taken
  std::uint64_t untimed = 0;     // bees whose own clocks do not go on as that of the link
};

class WatchTally {
 public:
  // Whether the greatest speed of bees was stated: then events say where an unknown bee may matter.
  explicit WatchTally(bool speed_stated) : speed_stated_(speed_stated) {}

  void count(const SwarmEvent& event) { ++told_[static_cast<std::size_t>(event.kind)]; }
  void count(const analysis::ClockNote& note) {
    if (note.kind == analysis::ClockNote::Kind::kOff) last_off_ = note;
    if (note.kind == analysis::ClockNote::Kind::kApart) last_apart_ = note;
  }
  [[nodiscard]] std::uint64_t told(EventKind kind) const {
    return told_[static_cast<std::size_t>(kind)];
  }

  // Whether it does not follow from what is known that no two have come too close: two have, or
  // may have or are about to, or it is not known where bees were, or not all that was heard could
  // be taken into account.
  [[nodiscard]] bool risk(const analysis::LiveFeed& feed, const LeftOutOfWatch& left_out) const;

  // Lines of the summary, once the input has ended: of clocks, of who was unknown for how long; and
  // of events, with the verdict.
  void append_clocks(std::string& out, const analysis::LiveFeed& feed) const;
  void append_unknown(std::string& out, const analysis::LiveFeed& feed) const;
  void append_events(std::string& out, const analysis::LiveFeed& feed,
                     const LeftOutOfWatch& left_out) const;

 private:
  [[nodiscard]] std::string verdict(const analysis::LiveFeed& feed,
                                    const LeftOutOfWatch& left_out) const;

  bool speed_stated_;
  std::array<std::uint64_t, kEventKinds> told_{};
  std::optional<analysis::ClockNote> last_off_;
  std::optional<analysis::ClockNote> last_apart_;
};

}  // namespace beespace::cli
