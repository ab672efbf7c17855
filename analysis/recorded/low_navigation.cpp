#include "analysis/recorded/low_navigation.hpp"

#include "io/bytes/number_text.hpp"

#include <beespace/bezier_path.hpp>
#include <beespace/track.hpp>

#include <algorithm>
#include <cmath>

namespace beespace::analysis {
namespace {

constexpr double kFollowedWithin_m = 0.001;

double sideways_m(const Point& from, const Point& to) {
  return std::hypot(to.x - from.x, to.y - from.y);
}

// Where on the way from one fix to the next that height is.
Fix at_height(const Fix& from, const Fix& to, double height_m) {
  const double share = (height_m - from.position.z) / (to.position.z - from.position.z);
  const auto between = [share](double a, double b) { return a + share * (b - a); };
  return {
      between(from.time_s, to.time_s),
      {between(from.position.x, to.position.x), between(from.position.y, to.position.y), height_m}};
}

// The stretches of a flight below a height, each as its fixes.
class LowStretches {
 public:
  LowStretches(PointId bee, double height_m) : height_m_(height_m) { move_.bee = bee; }

  void take(const Fix& fix) {
    const bool low = fix.position.z < height_m_;
    if (any_ && low != (before_.position.z < height_m_)) {
      add(at_height(before_, fix, height_m_));
      if (!low) goes_on_ = false;
    }
    if (low) add(fix);
    before_ = fix;
    any_ = true;
  }

  [[nodiscard]] const LowMove& farthest() const { return farthest_; }

 private:
  void add(const Fix& fix) {
    if (!goes_on_) {
      goes_on_ = true;
      begin_ = last_ = fix;
      move_.moved_m = move_.fastest_mps = 0.0;
      return;
    }
    const double lasts_s = fix.time_s - last_.time_s;
    if (lasts_s > 0.0) {
      move_.fastest_mps =
          std::max(move_.fastest_mps, sideways_m(last_.position, fix.position) / lasts_s);
    }
    last_ = fix;
    const double moved_m = sideways_m(begin_.position, fix.position);
    if (moved_m > move_.moved_m) {
      move_.moved_m = moved_m;
      move_.at_s = fix.time_s;
    }
    if (move_.moved_m >= farthest_.moved_m) farthest_ = move_;
  }

  double height_m_;
  LowMove move_ = {};  // of the stretch that goes on
  LowMove farthest_ = {};
  bool goes_on_ = false;
  Fix begin_ = {};
  Fix last_ = {};
  bool any_ = false;
  Fix before_ = {};
};

}  // namespace

Result<NavigationCheck> check_navigation(const std::string& name, double height_m,
                                         const std::vector<Flight>& flights) {
  NavigationCheck check{name, height_m};
  for (std::size_t bee = 0; bee < flights.size(); ++bee) {
    LowMove farthest;
    for (const BezierPath& path : flights[bee]) {
      const auto track = to_track(path, kFollowedWithin_m);
      if (!track) return track.error();
      LowStretches stretches(static_cast<PointId>(bee), height_m);
      for (const Fix& fix : track->fixes) stretches.take(fix);
      if (stretches.farthest().moved_m > farthest.moved_m) farthest = stretches.farthest();
    }
    if (farthest.moved_m <= kSidewaysAtMost_m) continue;
    ++check.bees;
    if (!check.worst || farthest.moved_m > check.worst->moved_m) check.worst = farthest;
  }
  return check;
}

std::string low_move_text(const NavigationCheck& check) {
  if (!check.worst) return {};
  return io::counted(check.bees, "drone moves", "drones move") + " sideways below " + check.name +
         " " + io::exact(check.height_m) + " m, the worst " + io::grouped(check.worst->moved_m, 2) +
         " m, at up to " + io::grouped(check.worst->fastest_mps, 2) + " m/s";
}

}  // namespace beespace::analysis
