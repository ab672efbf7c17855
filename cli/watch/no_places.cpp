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
  if (at.frame != io::Frame::kMetres) {
    look_for_feet(track, fix, at.stated_velocity);
    return std::nullopt;
  }
  if (track.zeros.is_none(fix)) return "is " + std::string(io::kZeroRun.which);
  track.taken.take(fix, 0);
  if (metres_) {
    if (track.last) metres_->take_step(*track.last, fix);
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

std::optional<Error> NoPlaces::doubt_of_metres() {
  if (!metres_ || !metres_->is_settled()) return std::nullopt;
  auto doubt = metres_->doubt();
  metres_.reset();
  return doubt;
}

bool NoPlaces::thaws(AgentId bee, double time_s, const io::ReportLine& at) {
  Track& track = tracks_[bee];
  const bool jumps =
      track.frozen.take({time_s, at.position}, at.velocity ? &*at.velocity : nullptr, at.frame);
  if (!jumps || track.thawed) return false;
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

}  // namespace beespace::cli
