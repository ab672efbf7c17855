// Reports whose places are none: zeros that are written where no place is known, and places that a
// bee must have left by its own speed. Judged by the reports before.
#pragma once

#include "analysis/geometry/scale_doubt.hpp"
#include "io/live/report_lines.hpp"
#include "io/recording/feet_doubt.hpp"
#include "io/recording/frozen_places.hpp"
#include "io/recording/metres_doubt.hpp"
#include "io/recording/stale_places.hpp"
#include "io/recording/zero_places.hpp"
#include "io/recording/zero_runs.hpp"
#include "io/units/stated_length.hpp"

#include <beespace/mover.hpp>
#include <beespace/result.hpp>
#include <beespace/swarm.hpp>
#include <beespace/track.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace beespace::cli {

class NoPlaces {
 public:
  // What such a report says, as a phrase; nothing where it says a place.
  std::optional<std::string> zero(const io::ReportLine& at);
  // The same of a bee that is known: `time_s` is when it was.
  std::optional<std::string> stale(AgentId bee, double time_s, const io::ReportLine& at);
  // Of one that says a place, which stale() has taken: whether it jumps to there out of one that
  // was said again and again though it had left it. Each bee is told of once.
  bool thaws(AgentId bee);
  void forget(AgentId bee);

  // At the end, of units that names alone tell (FeetDoubt): whether nothing bears them out.
  [[nodiscard]] std::optional<Error> doubt_of_feet(const std::vector<io::UnitTaken>& units) const;

  // Of places in metres whose unit nothing names: they are no metres if they move faster than that.
  // And they are doubted where they are whole numbers (analysis::WholePlaces), unless they were
  // asked for.
  void look_for_metres(double fastest_mps, const std::optional<io::StatedLength>& threshold,
                       bool asked) {
    metres_.emplace(fastest_mps);
    threshold_ = asked ? std::nullopt : threshold;
  }
  // Once enough was heard, and then no more; or at the end of a few reports.
  std::optional<Error> doubt_of_metres(bool at_the_end = false);

  // At the end: how many bees were at no place for a time without having been told of, as only what
  // came later showed.
  [[nodiscard]] std::size_t late() const;
  // At the end: who repeats a place exactly though the places before waver, and who may be
  // somewhere else, as it stops at once (frozen_places.hpp).
  struct AtTheEnd {
    std::size_t frozen = 0;
    std::vector<AgentId> perhaps = {};
  };
  [[nodiscard]] AtTheEnd at_the_end() const;
  // Since when that bee is where it is.
  [[nodiscard]] double since_s(AgentId bee) const { return tracks_[bee].frozen.since_s(); }

 private:
  struct Track {
    io::StalePlaces stale = {};
    io::ZeroRunFilter zeros = {};
    io::ZeroRunWatch taken = {};
    io::FrozenWatch frozen = {};
    std::optional<Fix> last = {};  // in degrees with what it said of its velocity, or in metres
    Velocity stated = io::kNoVelocity;
    bool jumps = false;  // out of such a place, with its last report
    bool thawed = false;

    [[nodiscard]] bool was_at_no_place() const {
      return taken.found().has_value() || (!thawed && frozen.found());
    }
  };

  void look_for_feet(Track& track, const Fix& fix, const Velocity& stated);

  io::ZeroPlaces zeros_;
  io::FeetDoubt feet_;
  std::optional<io::MetresDoubt> metres_;
  analysis::WholePlaces whole_;
  std::optional<io::StatedLength> threshold_;
  bool degrees_ = false;
  std::vector<Track> tracks_;  // by number
  std::size_t late_ = 0;       // of those that are forgotten
};

}  // namespace beespace::cli
