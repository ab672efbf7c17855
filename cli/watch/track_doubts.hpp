// What speaks against a track being that of one bee: two that report in turn under one id, and one
// that is somewhere else too fast.
#pragma once

#include "io/frames/coordinate_frame.hpp"
#include "io/recording/excursions.hpp"
#include "io/recording/jumps.hpp"
#include "io/recording/shared_id.hpp"

#include <beespace/agent_id.hpp>
#include <beespace/mover.hpp>
#include <beespace/track.hpp>

#include <utility>
#include <vector>

namespace beespace::cli {

class TrackDoubts {
 public:
  // What a report is the first to show of its bee.
  struct Found {
    bool jumps = false;
    bool shared = false;
  };

  // `as_told` is where it says that it is, in that frame; `fix` the same in metres. Of aircraft
  // excursions are not looked for.
  Found take(AgentId bee, const Fix& as_told, io::Frame frame, const Fix& fix,
             const Velocity* velocity, bool of_aircraft) {
    if (bee >= tracks_.size()) tracks_.resize(bee + 1);
    Track& track = tracks_[bee];
    Found found;
    const bool leaps = !of_aircraft && track.excursions.take(fix, io::Frame::kMetres);
    found.jumps = (track.jumps.take(fix, velocity) || leaps) && !std::exchange(track.jumping, true);
    if (track.shared.found()) return found;
    track.shared.take(as_told, frame);
    found.shared = track.shared.found().has_value();
    return found;
  }

  // It has left.
  void forget(AgentId bee) {
    if (bee < tracks_.size()) tracks_[bee] = {};
  }

 private:
  struct Track {
    io::SharedId shared = {};
    io::Jumps jumps = {};
    io::ExcursionWatch excursions = {};
    bool jumping = false;
  };

  std::vector<Track> tracks_;  // by number
};

}  // namespace beespace::cli
