// Places that are none, and are left out once all is read: zeros, and what is said again after a
// bee was lost, and where a bee only jumps to.
#include "io/bytes/number_text.hpp"
#include "io/problems/unplaced.hpp"
#include "io/recording/frozen_in_air.hpp"
#include "io/recording/frozen_places.hpp"
#include "io/recording/jumped_stretches.hpp"
#include "io/recording/moment_text.hpp"
#include "io/recording/recording_assembly.hpp"
#include "io/recording/stale_places.hpp"
#include "io/recording/zero_places.hpp"
#include "io/recording/zero_runs.hpp"

#include <cstddef>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace beespace::io {

// Where no place is known, zeros may be written.
void RecordingAssembly::leave_out_zeros() {
  if (!facts_ || facts_->frame != Frame::kWgs84 || frame_is_settled_) return;
  ZeroPlaces zeros;
  for (const Point& at : tracks_.positions()) zeros.look_at(at);
  const auto which = [&zeros](const RecordedBee& bee) {
    const std::vector<Fix>& fixes = bee.fixes;
    std::vector<bool> none(fixes.size());
    bool any = false;
    for (std::size_t i = 0; i < fixes.size(); ++i) {
      none[i] = zeros.is_none(fixes[i].position);
      any = any || none[i];
    }
    return any ? none : std::vector<bool>();
  };
  tracks_.leave_out(which, [this](const std::string& id, const Fix& fix) {
    leave_out(kZeroPlace, id);
    unplaced(id, fix.time_s);
  });
}

// The same in metres, once all are in order; plans are no measurements.
void RecordingAssembly::leave_out_zero_runs() {
  if (!facts_ || facts_->frame != Frame::kMetres || frame_is_settled_ || is_show()) return;
  tracks_.leave_out([](const RecordedBee& bee) { return zero_runs(bee.fixes); },
                    [this](const std::string& id, const Fix& fix) {
                      leave_out(kZeroRun, id);
                      unplaced(id, fix.time_s);
                    });
}

// Once all are in order.
void RecordingAssembly::leave_out_stale_places() {
  const auto which = [this](const RecordedBee& bee) {
    if (bee.velocities.empty() || told_by_others_.contains(bee.id)) return std::vector<bool>();
    StalePlaces places;
    std::vector<bool> none(bee.fixes.size());
    bool any = false;
    for (std::size_t i = 0; i < none.size(); ++i) {
      none[i] = places.take(bee.fixes[i], &bee.velocities[i]);
      any = any || none[i];
    }
    return any ? none : std::vector<bool>();
  };
  tracks_.leave_out(which, [this](const std::string& id, const Fix& fix) { stale(id, fix); });
}

// Likewise, of those that say no speed, or a small one.
void RecordingAssembly::leave_out_frozen_places() {
  if (!facts_ || is_show()) return;
  std::unordered_map<std::string, FrozenPlaces> found;
  std::vector<double> ends_s;
  for (std::size_t i = 0; i < tracks_.size(); ++i) {
    const RecordedBee& bee = tracks_.recorded(i);
    if (told_by_others_.contains(bee.id)) continue;
    FrozenPlaces places = frozen_places(bee.fixes, bee.velocities, facts_->frame);
    if (places.none()) continue;
    if (places.end != FrozenEnd::kNo) ends_s.push_back(places.end_since_s);
    found.emplace(bee.id, std::move(places));
  }
  FrozenEnds perhaps;
  const bool usual = ends_are_usual(ends_s, tracks_.size());
  for (std::size_t i = 0; i < tracks_.size() && !found.empty(); ++i) {
    const auto known = found.find(tracks_.id(i));
    if (known == found.end() || known->second.end == FrozenEnd::kNo) continue;
    if (usual || known->second.end == FrozenEnd::kPerhaps) {
      known->second.end = FrozenEnd::kPerhaps;
      perhaps.take(tracks_.id(i), known->second.end_since_s);
    } else {
      known->second.leave_end_out(tracks_.recorded(i).fixes.size());
    }
  }
  note_frozen(perhaps);
  tracks_.leave_out(
      [&found](const RecordedBee& bee) {
        const auto known = found.find(bee.id);
        return known == found.end() ? std::vector<bool>() : known->second.fixes;
      },
      [&found, this](const std::string& id, const Fix& fix) {
        const FrozenPlaces& places = found.at(id);
        const bool at_end = places.end == FrozenEnd::kMeasured && fix.time_s > places.end_since_s;
        leave_out(at_end ? kFrozenToTheEnd : kFrozenPlace, id);
        unplaced(id, fix.time_s);
      });
}

// Likewise, of drones that hover or fly slowly.
void RecordingAssembly::leave_out_frozen_in_air() {
  const bool of_drones = recording_.of_drones || recording_.called_drones;
  if (!facts_ || is_show() || !of_drones || facts_->dimensions != 3) return;
  const Frame frame = facts_->frame;
  tracks_.leave_out(
      [frame, this](const RecordedBee& bee) {
        return told_by_others_.contains(bee.id) ? std::vector<bool>()
                                                : frozen_in_air(bee.fixes, frame);
      },
      [this](const std::string& id, const Fix& fix) {
        leave_out(kFrozenInAir, id);
        unplaced(id, fix.time_s);
      });
}

// Once it is known who jumps; of an id that two share none of both places is wrong.
void RecordingAssembly::leave_out_spikes(const std::unordered_set<std::string>& shared) {
  const JumpsOf of{recording_.frame, recording_.of_aircraft};
  for (std::size_t i = 0; i < tracks_.size(); ++i) {
    const RecordedBee& bee = tracks_.recorded(i);
    if (shared.contains(bee.id)) continue;
    for (const JumpedStretch& stretch : jumped_stretches(bee, of)) {
      if (!is_spike(bee, stretch)) continue;
      lose(bee.id, {bee.fixes[stretch.before].time_s, bee.fixes[stretch.behind].time_s});
    }
  }
  tracks_.leave_out(
      [&shared, &of](const RecordedBee& bee) {
        return shared.contains(bee.id) ? std::vector<bool>() : fixes_in_spikes(bee, of);
      },
      [this](const std::string& id, const Fix& fix) {
        leave_out(kSpike, id);
        unplaced(id, fix.time_s);
      });
}

void RecordingAssembly::note_frozen(const FrozenEnds& ends) {
  if (ends.bees() == 0) return;
  const Calendar calendar{facts_->since_1970, options_.time_zone, facts_->clock};
  const std::string date = calendar.text(ends.since_s());
  note(ends.text(date.empty() ? exact(ends.since_s()) + " s" : date));
}

void RecordingAssembly::stale(const std::string& id, const Fix& fix) {
  leave_out(kStalePlace, id);
  unplaced(id, fix.time_s);
}

}  // namespace beespace::io
