#include "analysis/recorded/verify_paths.hpp"

#include "analysis/geometry/geometry.hpp"
#include "analysis/recorded/all_conflicts.hpp"
#include "analysis/recorded/along_curves.hpp"
#include "analysis/recorded/earth_flights.hpp"
#include "analysis/recorded/findings.hpp"
#include "analysis/recorded/flights.hpp"
#include "analysis/recorded/landed_times.hpp"
#include "analysis/recorded/show_conflicts.hpp"
#include "analysis/recorded/tracks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

namespace beespace::analysis {
namespace {

// How closely curves are followed where those are searched that may be too close; what that leaves
// open is decided along the curves.
constexpr double kTolerance_m = 0.001;
constexpr TimeSpan kAlways{-kLargestInMotion, kLargestInMotion};

class PathVerification {
 public:
  PathVerification(const io::Recording& recording, const PathQuestion& question)
      : recording_(recording),
        question_(question),
        on_earth_(recording.frame == io::Frame::kWgs84),
        flights_(on_earth_ ? std::vector<Flight>(recording.bees.size())
                           : flights_of(recording, question.with_velocities, question.max_gap_s)) {}

  Result<PathVerdict> operator()(const std::function<void(double)>& progress) {
    const bool as_replayed = on_earth_ || question_.vertical || says_who_has_landed(recording_);
    if (auto error = as_replayed ? replay_pairs() : check_pairs()) return *std::move(error);
    if (question_.ignore_below_m) {
      verdict_.low = leave_out_low(recording_, *question_.ignore_below_m, verdict_.losses);
      leave_out_too(verdict_.low, verdict_.with_standing);
    } else {
      verdict_.low.would_leave_out =
          would_leave_out_low(recording_, question_.threshold_m, verdict_.losses);
    }
    for (PointId bee = 0; bee < flights_.size(); ++bee) {
      if (question_.stop.stop_requested()) {
        return Error{ErrorCode::kStopped, "a stop was requested", {}};
      }
      if (auto error = on_earth_ ? check_bee_on_earth(bee) : check_bee(bee))
        return of_bee(*std::move(error), recording_.bees[bee]);
      if (progress) progress(static_cast<double>(bee + 1) / static_cast<double>(flights_.size()));
    }
    std::stable_sort(
        verdict_.breaches.begin(), verdict_.breaches.end(),
        [](const PathBreach& a, const PathBreach& b) { return a.excess.limit < b.excess.limit; });
    if (recording_.show) {
      if (auto error = check_beside()) return *std::move(error);
    }
    return std::move(verdict_);
  }

 private:
  // As `beespace replay` decides them.
  std::optional<Error> replay_pairs() {
    const Geometry geometry = geometry_for(recording_, question_.vertical);
    auto tracks = analysis::tracks_of(recording_, geometry, kTolerance_m);
    if (!tracks) return std::move(tracks).error();
    keep_paths_whole(recording_, question_.max_gap_s, *tracks);
    ConflictOptions options{
        .threshold_m = question_.threshold_m,
        .vertical_m = vertical_in(geometry, question_.vertical, recording_.height_unit),
        .max_gap_s = question_.max_gap_s,
        .threads = question_.threads,
        .stop = question_.stop};
    options.height_unit_m = height_unit_m(geometry, recording_.height_unit);
    auto found = all_conflicts(recording_, *tracks, geometry, options, !question_.with_velocities);
    if (!found) return std::move(found).error();
    const auto in_space = analysis::tracks_of(recording_, Geometry::kSpace, kTolerance_m);
    if (!in_space) return in_space.error();
    verdict_.encounters = has_encounters(*found, recording_, *in_space, options);
    verdict_.gaps = std::move(found->recorded.gaps);
    verdict_.losses = std::move(found->recorded.conflicts);
    verdict_.with_standing = std::move(found->with_standing);
    verdict_.closest = found->closest;
    verdict_.standing_count = found->standing_count;
    const auto& standing = verdict_.with_standing;
    const bool stands =
        found->closest &&
        (std::find(standing.begin(), standing.end(), *found->closest) != standing.end() ||
         (verdict_.losses.empty() && both_stand(recording_, *found->closest)));
    verdict_.closest_in_the_air = stands ? found->closest_in_the_air : found->closest;
    verdict_.lines = *std::move(tracks);
    verdict_.curves = std::move(found->curves);
    verdict_.arcs = std::move(found->arcs);
    return std::nullopt;
  }

  std::optional<Error> check_pairs() {
    const auto tracks = tracks_of(flights_, recording_, kTolerance_m);
    if (!tracks) return tracks.error();
    const ConflictOptions options{.threshold_m = question_.threshold_m,
                                  .max_gap_s = question_.max_gap_s,
                                  .threads = question_.threads,
                                  .stop = question_.stop};
    auto found = find_conflicts(*tracks, options);
    if (!found) return found.error();
    const auto standing = conflicts_with_standing(recording_, *tracks, options);
    if (!standing) return standing.error();
    verdict_.gaps = std::move(found->gaps);
    verdict_.losses = *standing;
    verdict_.with_standing = *standing;
    for (const Conflict& conflict : found->conflicts) {
      auto losses = along_curves(conflict, flights_[conflict.first], flights_[conflict.second],
                                 question_.threshold_m);
      if (!losses) return of_bee(std::move(losses).error(), recording_.bees[conflict.first]);
      verdict_.losses.insert(verdict_.losses.end(), losses->begin(), losses->end());
    }
    std::stable_sort(verdict_.losses.begin(), verdict_.losses.end(),
                     [](const Conflict& a, const Conflict& b) {
                       return std::tuple(a.first, a.second, a.begins_s) <
                              std::tuple(b.first, b.second, b.begins_s);
                     });
    auto closest =
        find_closest_encounter(*tracks, question_.max_gap_s, {question_.threads, question_.stop});
    if (!closest) return closest.error();
    if (*closest) {
      if (auto error = find_closeness(**closest)) return error;
      verdict_.closest = *closest;
    }
    take_closer(without(verdict_.losses, verdict_.with_standing));
    verdict_.closest_in_the_air = verdict_.closest;
    verdict_.encounters = verdict_.closest.has_value();
    take_closer(verdict_.with_standing);
    return std::nullopt;
  }

  void take_closer(const std::vector<Conflict>& losses) {
    for (const Conflict& loss : losses) {
      if (!verdict_.closest || loss.closest_m < verdict_.closest->closest_m) {
        verdict_.closest = loss;
      }
    }
  }

  // How close the two come along their curves.
  std::optional<Error> find_closeness(Conflict& conflict) const {
    const auto found = closest_of(flights_[conflict.first], flights_[conflict.second], kAlways,
                                  question_.threshold_m);
    if (!found) return of_bee(found.error(), recording_.bees[conflict.first]);
    // Straight lines that were followed exactly say the same.
    if (!*found) return std::nullopt;
    conflict.closest_m = (*found)->closest_m;
    conflict.closest_s = (*found)->closest_s;
    return std::nullopt;
  }

  void take_check(PointId bee, const PathCheck& checked) {
    for (const PathExcess& excess : checked.excesses) {
      verdict_.breaches.push_back({bee, excess, {}});
    }
    for (std::size_t k = 0; k < kPathLimits; ++k) {
      auto& peak = verdict_.peaks[k];
      if (!peak || checked.peaks[k].value > peak->peak.value) {
        peak = BeePeak{bee, checked.peaks[k]};
      }
    }
  }

  std::optional<Error> check_bee_on_earth(PointId bee) {
    if (recording_.bees[bee].fixes.empty()) return std::nullopt;
    const auto flight =
        earth_flight_of(recording_, bee, question_.with_velocities, question_.max_gap_s);
    if (!flight) return flight.error();
    const auto checked = check_earth_flight(*flight, question_.limits);
    if (!checked) return checked.error();
    take_check(bee, *checked);
    return std::nullopt;
  }

  std::optional<Error> check_bee(PointId bee) {
    for (const BezierPath& path : flights_[bee]) {
      const auto checked = check_path(path, question_.limits);
      if (!checked) return checked.error();
      take_check(bee, *checked);
      if (question_.obstacles == nullptr) continue;
      if (auto error = check_clearance(bee, path)) return error;
    }
    return std::nullopt;
  }

  [[nodiscard]] bool skips(const std::string& name) const {
    const auto& skipped = question_.skipped_limits;
    return std::find(skipped.begin(), skipped.end(), name) != skipped.end();
  }

  std::optional<Error> check_beside() {
    auto beside = check_limits_beside(recording_, flights_);
    if (!beside) return beside.error();
    for (AccelerationCheck& check : beside->accelerations) {
      if (skips(check.declared.name)) {
        if (!check.excesses.empty()) verdict_.not_looked_at.push_back(check.declared.name);
        continue;
      }
      for (const BeeExcess& broken : check.excesses) {
        verdict_.breaches.push_back({broken.bee, broken.excess, verdict_.accelerations.size()});
      }
      verdict_.accelerations.push_back(std::move(check));
    }
    for (NavigationCheck& check : beside->navigation) {
      if (!skips(check.name)) verdict_.navigation.push_back(std::move(check));
    }
    for (const std::string& name : beside->not_known) {
      verdict_.not_looked_at.push_back(name);
      if (!skips(name)) verdict_.undecided.push_back(name);
    }
    return std::nullopt;
  }

  // Piece by piece, since velocities may jump in between.
  std::optional<Error> check_clearance(PointId bee, const BezierPath& path) {
    for (std::size_t i = 0; i < path.pieces.size(); ++i) {
      VerifyOptions options;
      options.threshold_m = question_.threshold_m;
      options.obstacles = question_.obstacles;
      options.clearance_m = question_.clearance_m;
      Verifier verifier(options);
      for (const auto& [time_s, mover] : ends_of(path, i)) {
        const std::vector<Mover> movers{mover};
        if (const Status added = verifier.add(time_s, movers); !added) return added.error();
      }
      for (const ClearanceLoss& loss : verifier.verdict().first_clearance_losses) {
        verdict_.clearance_losses.push_back({bee, loss});
      }
    }
    return std::nullopt;
  }

  // Where and how fast a bee is at both ends of a piece, which makes the curve between.
  static std::array<std::pair<double, Mover>, 2> ends_of(const BezierPath& path, std::size_t i) {
    const BezierPiece& piece = path.pieces[i];
    const double begins_s = i == 0 ? path.begins_s : path.pieces[i - 1].ends_s;
    const Point& from = i == 0 ? path.begin : path.pieces[i - 1].end;
    const double scale = (piece.control_count + 1) / (piece.ends_s - begins_s);
    const auto velocity = [scale](const Point& a, const Point& b) {
      return Velocity{flushed((b.x - a.x) * scale), flushed((b.y - a.y) * scale),
                      flushed((b.z - a.z) * scale)};
    };
    const bool straight = piece.control_count == 0;
    const Point& behind = straight ? piece.end : piece.controls[0];
    const Point& before = straight ? from : piece.controls[piece.control_count - 1U];
    return {{{begins_s, {from, velocity(from, behind)}},
             {piece.ends_s, {piece.end, velocity(before, piece.end)}}}};
  }

  const io::Recording& recording_;
  const PathQuestion& question_;
  bool on_earth_;
  std::vector<Flight> flights_;  // of those in metres
  PathVerdict verdict_;
};

}  // namespace

std::optional<double> declared_limit(const io::ShowFacts& show, PathLimit limit) {
  switch (limit) {
    case PathLimit::kHorizontalSpeed:
      return show.limits.horizontal_mps;
    case PathLimit::kClimb:
      return show.limits.climb_mps;
    case PathLimit::kDescent:
      return show.limits.descent_mps;
    case PathLimit::kHeight:
      return show.limits.height_m;
    case PathLimit::kSpeed:
    case PathLimit::kAcceleration:
      break;
  }
  return std::nullopt;
}

bool PathQuestion::has_limits() const {
  return std::any_of(limits.most.begin(), limits.most.end(),
                     [](double most) { return std::isfinite(most); });
}

bool compares(const io::Recording& recording, const PathVerdict& verdict,
              const PathQuestion& question) {
  if (recording.bees.size() < 2) return question.has_limits() || question.obstacles != nullptr;
  return verdict.encounters || recording.show;
}

Result<PathVerdict> verify_paths(const io::Recording& recording, const PathQuestion& question,
                                 const std::function<void(double)>& progress) {
  return PathVerification(recording, question)(progress);
}

}  // namespace beespace::analysis
