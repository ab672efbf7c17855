#include "analysis/recorded/velocity_curves.hpp"

#include "analysis/recorded/flights.hpp"
#include "analysis/recorded/tracks.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <tuple>
#include <utility>

namespace beespace::analysis {
namespace {

// A curve that is cut into n pieces of the same length leaves these by a square of n less: its
// second derivative is at most kBend of how far it leaves the whole line, over a time of 1, and a
// chord is off by an eighth of that.
constexpr double kBend = 27.0;
// Curves are followed to within a hundredth of a threshold where that takes no more than so many
// lines each, on average, and otherwise less closely.
constexpr double kFinest = 0.01;
constexpr double kMostLines = 16.0;
constexpr double kFewLines = 1e6;

// How far a curve leaves its straight line at most: what the threshold compares, and the height.
struct Off {
  double across = 0.0;
  double up = 0.0;
};

// The curve between two fixes, in the units of the geometry.
struct Piece {
  double begins_s = 0.0;
  double ends_s = 0.0;
  InMetres from;
  InMetres to;
  bool curved = false;

  [[nodiscard]] double lasts_s() const { return ends_s - begins_s; }
};

double cubic(double from, double from_speed, double to, double to_speed, double lasts,
             double share) {
  const double left = 1.0 - share;
  return left * left * (from + share * (2.0 * from + lasts * from_speed)) +
         share * share * (to + left * (2.0 * to - lasts * to_speed));
}

// The straight line has the mean velocity c. Of a velocity v at one end v - c leads away from it,
// by s (1 - s)^2 of what it makes in all the time, which is 4 / 27 at most.
double off_by(double from, double to, double lasts) {
  constexpr double kMost = 4.0 / 27.0;
  return kMost * lasts * (from + to);
}

Off off_of(const Piece& piece, bool cylinders, bool heights_apart) {
  if (!piece.curved) return {};
  const double lasts = piece.lasts_s();
  const Point& p = piece.from.position;
  const Point& q = piece.to.position;
  const Velocity mean{(q.x - p.x) / lasts, (q.y - p.y) / lasts, (q.z - p.z) / lasts};
  const bool flat = cylinders && !heights_apart;
  const auto across = [&](const Velocity& v) {
    return std::hypot(v.x - mean.x, v.y - mean.y, flat ? 0.0 : v.z - mean.z);
  };
  const Velocity& v = *piece.from.velocity;
  const Velocity& w = *piece.to.velocity;
  Off off{off_by(across(v), across(w), lasts), 0.0};
  if (flat) off.up = off_by(std::abs(v.z - mean.z), std::abs(w.z - mean.z), lasts);
  if (heights_apart) {
    const double climb = (piece.to.height_m - piece.from.height_m) / lasts;
    off.up =
        off_by(std::abs(piece.from.climb_mps - climb), std::abs(piece.to.climb_mps - climb), lasts);
  }
  return off;
}

BezierPiece curve_of(const Piece& piece) {
  const Point& end = piece.to.position;
  if (!piece.curved) return {piece.ends_s, end, {}, 0};
  return piece_to({piece.begins_s, piece.from.position}, *piece.from.velocity, {piece.ends_s, end},
                  *piece.to.velocity);
}

class Following {
 public:
  Following(const io::Recording& recording, Geometry geometry, const ConflictOptions& options)
      : recording_(recording),
        geometry_(geometry),
        options_(options),
        apart_(heights_apart(geometry)) {
    options_.threshold_m *= kCloserThan;
    if (options_.vertical_m) *options_.vertical_m *= kCloserInHeight;
    // Of those that may be conflicts most are none, or known.
    options_.max_results = ConflictOptions{}.max_results;
  }

  Result<VelocityCurves> operator()(const std::vector<Conflict>& along_lines) {
    if (auto error = measure()) return *std::move(error);
    if (!found_.given || !may_matter()) return std::move(found_);
    found_.followed = std::isfinite(found_.most_off_m);
    if (!found_.followed) return std::move(found_);
    along_lines_ = &along_lines;
    auto error = options_.vertical_m ? look_in_height() : look_in_space();
    if (error) return *std::move(error);
    for (Conflict& conflict : found_.conflicts) conflict.certain = false;
    return std::move(found_);
  }

 private:
  [[nodiscard]] bool cylinders() const { return options_.vertical_m.has_value(); }

  // Where an aircraft tells how it goes over ground and not how it climbs, its heights do. (The
  // speeds of animals are those of a moment, and say little of the minutes between two fixes.)
  [[nodiscard]] std::optional<Velocity> velocity_at(std::size_t bee, std::size_t i) const {
    const io::RecordedBee& of = recording_.bees[bee];
    if (i >= of.velocities.size()) return std::nullopt;
    Velocity velocity = of.velocities[i];
    if (!recording_.of_aircraft || !std::isnan(velocity.z) || std::isnan(velocity.x) ||
        std::isnan(velocity.y)) {
      return velocity;
    }
    const Fix& before = of.fixes[i > 0 ? i - 1 : i];
    const Fix& behind = of.fixes[std::min(i + 1, of.fixes.size() - 1)];
    if (!(before.time_s < behind.time_s)) return velocity;
    velocity.z = flushed((behind.position.z - before.position.z) / (behind.time_s - before.time_s));
    return velocity;
  }

  // Calls take(piece) for all pieces between fixes that are not too far apart in time.
  template <class Take>
  std::optional<Error> visit(std::size_t bee, const Take& take) {
    const std::vector<Fix>& fixes = recording_.bees[bee].fixes;
    Piece piece;
    for (std::size_t i = 0; i < fixes.size(); ++i) {
      auto at = in_metres(fixes[i].position, velocity_at(bee, i), recording_.frame, geometry_,
                          stated_height(recording_, recording_.bees[bee], i));
      if (!at) return of_bee(std::move(at).error(), recording_.bees[bee]);
      piece.begins_s = std::exchange(piece.ends_s, fixes[i].time_s);
      piece.from = std::exchange(piece.to, *at);
      const bool goes_on = i > 0 && piece.lasts_s() <= options_.max_gap_s;
      piece.curved = goes_on && piece.from.velocity && piece.to.velocity;
      take(piece, goes_on);
    }
    return std::nullopt;
  }

  std::optional<Error> measure() {
    for (PointId bee = 0; bee < recording_.bees.size(); ++bee) {
      if (recording_.bees[bee].velocities.empty()) continue;
      auto error = visit(bee, [&](const Piece& piece, bool /*goes_on*/) {
        if (!piece.curved) return;
        const Off off = off_of(piece, cylinders(), apart_);
        found_.given = true;
        most_up_ = std::max(most_up_, off.up);
        if (off.across <= found_.most_off_m) return;
        found_.most_off_m = off.across;
        found_.bee = bee;
        found_.span = {piece.begins_s, piece.ends_s};
      });
      if (error) return error;
    }
    return std::nullopt;
  }

  // Both of a pair may leave their lines. So far two are from the threshold along these at least.
  [[nodiscard]] bool may_matter() const {
    const double spare_m = options_.threshold_m * (1.0 / kCloserThan - 1.0);
    if (2.0 * found_.most_off_m > spare_m) return true;
    return cylinders() && 2.0 * most_up_ > *options_.vertical_m * (1.0 / kCloserInHeight - 1.0);
  }

  [[nodiscard]] double lines_for(const Off& off, double share) const {
    double parts = off.across / (share * options_.threshold_m);
    if (cylinders()) parts = std::max(parts, off.up / (share * *options_.vertical_m));
    return std::max(1.0, std::ceil(std::sqrt(parts * kBend / 8.0)));
  }

  // The closest share of the thresholds, up to `most`, to which all curves can be followed.
  std::optional<double> share_within(double most) {
    constexpr double kCoarser = 4.0;
    double share = kFinest;
    while (share <= most) {
      double lines = 0.0;
      double fixes = 0.0;
      for (std::size_t bee = 0; bee < recording_.bees.size(); ++bee) {
        fixes += static_cast<double>(recording_.bees[bee].fixes.size());
        const auto failed = visit(bee, [&](const Piece& piece, bool goes_on) {
          if (goes_on) lines += lines_for(off_of(piece, cylinders(), apart_), share);
        });
        if (failed) return std::nullopt;
      }
      if (lines <= kMostLines * fixes + kFewLines) return share;
      share *= kCoarser;
    }
    return std::nullopt;
  }

  std::optional<Error> look_in_space() {
    std::vector<Flight> flights(recording_.bees.size());
    for (std::size_t bee = 0; bee < flights.size(); ++bee) {
      auto error = visit(bee, [&](const Piece& piece, bool goes_on) {
        if (goes_on) {
          flights[bee].back().pieces.push_back(curve_of(piece));
        } else {
          flights[bee].push_back({piece.ends_s, piece.to.position, {}});
        }
      });
      if (error) return error;
    }
    const auto share = share_within(1.0);
    found_.followed = share.has_value();
    if (!share) return std::nullopt;
    const auto tracks = tracks_of(flights, recording_, *share * options_.threshold_m);
    // Velocities that lead out of all bounds, or times that are too coarse for them.
    found_.followed = tracks.has_value();
    if (!tracks) return std::nullopt;
    auto recorded = find_conflicts(*tracks, options_);
    if (!recorded) return std::move(recorded).error();
    for (Conflict conflict : recorded->conflicts) {
      if (is_known(conflict)) continue;
      const auto is_one = settle(conflict, flights);
      if (!is_one) return is_one.error();
      if (*is_one) found_.conflicts.push_back(conflict);
    }
    return std::nullopt;
  }

  // Along the curves; of straight lines it is known.
  Result<bool> settle(Conflict& conflict, const std::vector<Flight>& flights) const {
    const auto closest = closest_of(flights[conflict.first], flights[conflict.second],
                                    {conflict.begins_s, conflict.ends_s}, options_.threshold_m);
    if (!closest) return of_bee(closest.error(), recording_.bees[conflict.first]);
    if (!*closest) return conflict.certain;
    conflict.closest_m = (*closest)->closest_m;
    conflict.closest_s = (*closest)->closest_s;
    return (*closest)->closer;
  }

  std::optional<Error> look_in_height() {
    const auto share = share_within(kFinest);
    found_.followed = share.has_value();
    if (!share) return std::nullopt;
    found_.tracks.resize(recording_.bees.size());
    for (std::size_t bee = 0; bee < found_.tracks.size(); ++bee) {
      Track& track = found_.tracks[bee];
      auto error = visit(bee, [&](const Piece& piece, bool /*goes_on*/) {
        if (piece.curved) cut(piece, *share, track);
        track.fixes.push_back({piece.ends_s, piece.to.position});
        if (apart_) track.heights_m.push_back(piece.to.height_m);
      });
      if (error) return error;
    }
    auto recorded = find_conflicts(found_.tracks, options_);
    // The same: places that are not of the motion domain.
    found_.followed = recorded.has_value();
    if (!recorded) {
      const ErrorCode code = recorded.error().code;
      const bool beyond = code == ErrorCode::kOutsideDomain || code == ErrorCode::kNotFinite ||
                          code == ErrorCode::kTimeOrder;
      return beyond ? std::nullopt : std::optional<Error>(std::move(recorded).error());
    }
    found_.conflicts = std::move(recorded->conflicts);
    std::erase_if(found_.conflicts, [this](const Conflict& each) { return is_known(each); });
    return std::nullopt;
  }

  // All but its ends, on the curve.
  void cut(const Piece& piece, double share, Track& track) const {
    const double lines = lines_for(off_of(piece, cylinders(), apart_), share);
    const Point& p = piece.from.position;
    const Point& q = piece.to.position;
    const Velocity& v = *piece.from.velocity;
    const Velocity& w = *piece.to.velocity;
    const double lasts = piece.lasts_s();
    for (std::uint32_t k = 1; k < static_cast<std::uint32_t>(lines); ++k) {
      const double part = k / lines;
      track.fixes.push_back({piece.begins_s + lasts * part,
                             {flushed(cubic(p.x, v.x, q.x, w.x, lasts, part)),
                              flushed(cubic(p.y, v.y, q.y, w.y, lasts, part)),
                              flushed(cubic(p.z, v.z, q.z, w.z, lasts, part))}});
      if (!apart_) continue;
      track.heights_m.push_back(flushed(cubic(piece.from.height_m, piece.from.climb_mps,
                                              piece.to.height_m, piece.to.climb_mps, lasts, part)));
    }
  }

  // Whether the pair is in conflict along straight lines at some instant of it.
  [[nodiscard]] bool is_known(const Conflict& conflict) const {
    const auto of_pair = [](const Conflict& a, const Conflict& b) {
      return std::tuple(a.first, a.second) < std::tuple(b.first, b.second);
    };
    const auto [from, to] =
        std::equal_range(along_lines_->begin(), along_lines_->end(), conflict, of_pair);
    return std::any_of(from, to, [&](const Conflict& known) {
      return known.begins_s <= conflict.ends_s && known.ends_s >= conflict.begins_s;
    });
  }

  const io::Recording& recording_;
  Geometry geometry_;
  ConflictOptions options_;
  bool apart_;
  const std::vector<Conflict>* along_lines_ = nullptr;
  double most_up_ = 0.0;
  VelocityCurves found_;
};

}  // namespace

Result<VelocityCurves> follow_velocities(const io::Recording& recording, Geometry geometry,
                                         const ConflictOptions& options,
                                         const std::vector<Conflict>& along_lines) {
  const bool paths = std::any_of(recording.bees.begin(), recording.bees.end(),
                                 [](const io::RecordedBee& bee) { return bee.path.has_value(); });
  if (paths || recording.show) return VelocityCurves{};
  auto found = Following(recording, geometry, options)(along_lines);
  if (!found) return found;
  if (found->conflicts.size() + along_lines.size() <= options.max_results) return found;
  return Error{ErrorCode::kTooManyResults, "there are too many conflicts", {}};
}

}  // namespace beespace::analysis
