#include "analysis/scene/place_on_earth.hpp"

#include "io/bytes/number_text.hpp"

#include <cmath>
#include <numbers>
#include <string>

namespace beespace::analysis {
namespace {

// Sines and cosines of whole quarters have no rounding in them.
class Turn {
 public:
  explicit Turn(const report::Placement& placement) : up_m_(placement.origin.height_m) {
    const double degrees = std::remainder(placement.heading_deg, 360.0);
    const double quarters = degrees / 90.0;
    if (quarters == std::round(quarters)) {
      const int quarter = (static_cast<int>(quarters) + 4) % 4;
      sine_ = quarter == 1 ? 1.0 : quarter == 3 ? -1.0 : 0.0;
      cosine_ = quarter == 0 ? 1.0 : quarter == 2 ? -1.0 : 0.0;
    } else {
      sine_ = std::sin(degrees * std::numbers::pi / 180.0);
      cosine_ = std::cos(degrees * std::numbers::pi / 180.0);
    }
    side_ = placement.y_to_the_right ? 1.0 : -1.0;
  }

  // x points along the heading, y a quarter to its left, or to its right.
  [[nodiscard]] Point operator()(const Point& p) const {
    return {p.x * sine_ + side_ * p.y * cosine_, p.x * cosine_ - side_ * p.y * sine_, p.z + up_m_};
  }

 private:
  double sine_ = 0.0;
  double cosine_ = 1.0;
  double side_ = -1.0;
  double up_m_ = 0.0;
};

bool is_near(const Point& p) {
  return std::abs(p.x) <= kFarthestPlaced_m && std::abs(p.y) <= kFarthestPlaced_m &&
         p.z >= kLowestHeight_m && p.z <= kGreatestHeight_m;
}

template <class Visit>
void for_each_place(report::SnapshotFacts& facts, Visit visit) {
  for (Point& place : facts.positions) visit(place);
}
template <class Visit>
void for_each_place(report::RecordingFacts& facts, Visit visit) {
  for (Track& track : facts.tracks) {
    for (Fix& fix : track.fixes) visit(fix.position);
  }
}

std::string words_of(const report::Placement& placement) {
  return "placed on the Earth at longitude " + io::exact(placement.origin.longitude_deg) +
         ", latitude " + io::exact(placement.origin.latitude_deg) + ", height " +
         io::exact(placement.origin.height_m) + " m, with x towards " +
         io::exact(placement.heading_deg) + " degrees from north and y to its " +
         (placement.y_to_the_right ? "right" : "left") + placement.words;
}

}  // namespace

Status place_on_earth(Scene& scene, const report::Placement& placement) {
  if (swarm_of(scene).origin) {
    return Error{ErrorCode::kInvalidArgument,
                 "positions are in degrees, and so are on the Earth already; leave --origin out",
                 {}};
  }
  if (const auto ecef = to_ecef(placement.origin); !ecef) return ecef.error();
  const Turn turn(placement);
  bool near = true;
  std::visit(
      [&](auto& facts) {
        for_each_place(facts, [&](Point& place) {
          place = turn(place);
          near = near && is_near(place);
        });
        facts.swarm.origin = placement.origin;
        facts.swarm.origin->height_m = 0.0;
        facts.swarm.notes.push_back(words_of(placement));
      },
      scene);
  if (near) return std::monostate{};
  return Error{ErrorCode::kOutsideDomain,
               "a place is farther than 100 km from the origin, or no height that there is; "
               "positions on a map must be metres around --origin",
               {}};
}

}  // namespace beespace::analysis
