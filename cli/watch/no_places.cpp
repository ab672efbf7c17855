#include "cli/watch/no_places.hpp"

#include <algorithm>

namespace beespace::cli {

std::optional<std::string> NoPlaces::zero(const io::ReportLine& at) {
  if (at.frame != io::Frame::kWgs84) return std::nullopt;
  zeros_.look_at(at.position);
  if (!zeros_.is_none(at.position)) return std::nullopt;
  return "is " + std::string(io::kZeroPlace.which);
}

std::optional<std::string> NoPlaces::stale(AgentId bee, double time_s, const io::ReportLine& at) {
  if (bee >= tracks_.size()) tracks_.resize(bee + 1);
  Track& track = tracks_[bee];
  const Fix fix{time_s, at.position};
  if (track.stale.take(fix, &at.stated_velocity)) {
    return "says the same place as for more than 3 s before, though its speed is more than 3 m/s, "
           "as where the last place is said again once contact is lost,";
  }
  if (at.frame == io::Frame::kMetres && track.zeros.is_none(fix)) {
    return "is " + std::string(io::kZeroRun.which);
  }
  using Now = io::FrozenWatch::Now;
  const Now now = track.frozen.take(fix, at.velocity ? &*at.velocity : nullptr, at.frame);
  if (now == Now::kLedAway) {
    return "says exactly the same place as before, though the bee has moved on by its own "
           "velocity, "
           "as where the last place is said again once it is lost,";
  }
  track.jumps = now == Now::kJumps;
  if (at.frame != io::Frame::kMetres) {
    look_for_feet(track, fix, at.stated_velocity);
    return std::nullopt;
  }
  track.taken.take(fix, 0);
  if (metres_) {
    if (track.last) metres_->take_step(*track.last, fix);
    whole_.add(fix.position);
    track.last = fix;
  }
  return std::nullopt;
}

void NoPlaces::look_for_feet(Track& track, const Fix& fix, const Velocity& stated) {
  degrees_ = true;
  feet_.take_height(fix.position.z);
  feet_.take_speed(stated);
  if (track.last) feet_.take_step(*track.last, track.stated, fix);
  track.last = fix;
  track.stated = stated;
}

std::optional<Error> NoPlaces::doubt_of_feet(const std::vector<io::UnitTaken>& units) const {
  if (!degrees_ || !io::FeetDoubt::concerns(units)) return std::nullopt;
  return feet_.doubt();
}

std::optional<Error> NoPlaces::doubt_of_metres(bool at_the_end) {
  if (!metres_ || !(at_the_end ? metres_->tells() : metres_->is_settled())) return std::nullopt;
  auto doubt = metres_->doubt();
  if (!doubt) doubt = whole_.doubt(threshold_);
  metres_.reset();
  return doubt;
}

bool NoPlaces::thaws(AgentId bee) {
  Track& track = tracks_[bee];
  if (!track.jumps || track.thawed) return false;
  track.thawed = true;
  return true;
}

void NoPlaces::forget(AgentId bee) {
  if (bee >= tracks_.size()) return;
  if (tracks_[bee].was_at_no_place()) ++late_;
  tracks_[bee] = {};
}

std::size_t NoPlaces::late() const {
  return late_ + static_cast<std::size_t>(
                     std::count_if(tracks_.begin(), tracks_.end(),
                                   [](const Track& track) { return track.was_at_no_place(); }));
}

NoPlaces::AtTheEnd NoPlaces::at_the_end() const {
  std::vector<double> since_s;
  std::size_t known = 0;
  for (const Track& track : tracks_) {
    if (track.frozen.is_known()) ++known;
    if (track.frozen.end() != io::FrozenEnd::kNo) since_s.push_back(track.frozen.since_s());
  }
  const bool usual = io::ends_are_usual(since_s, known);
  AtTheEnd found;
  for (AgentId bee = 0; bee < tracks_.size(); ++bee) {
    const io::FrozenEnd end = tracks_[bee].frozen.end();
    if (end == io::FrozenEnd::kNo) continue;
    if (end == io::FrozenEnd::kMeasured && !usual) {
      ++found.frozen;
    } else {
      found.perhaps.push_back(bee);
    }
  }
  return found;
}

}  // namespace beespace::cli
