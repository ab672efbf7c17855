#include "tests/differential/snapshot_scenes.hpp"

#include "tests/differential/boundary.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>

namespace beespace::differential {

namespace {

// Zero, or as near to the value as the coordinate domain allows.
double in_domain(double value) {
  if (std::abs(value) < kSmallestCoordinate_m) return std::copysign(0.0, value);
  return std::clamp(value, -kLargestCoordinate_m, kLargestCoordinate_m);
}

class SnapshotMaker {
 public:
  SnapshotMaker(Random& random, bool upright) : random_(random), upright_(upright) {}

  SnapshotScene make() {
    choose_scale();
    choose_size();
    constexpr std::array kLayouts = {
        &SnapshotMaker::box,      &SnapshotMaker::lattice, &SnapshotMaker::clumps,
        &SnapshotMaker::shell,    &SnapshotMaker::row,     &SnapshotMaker::mixed_scales,
        &SnapshotMaker::far_sets, &SnapshotMaker::seams,
    };
    constexpr std::array kNames = {"box", "lattice",      "clumps",   "shell",
                                   "row", "mixed scales", "far sets", "seams"};
    const std::size_t layout = random_.below(kLayouts.size());
    (this->*kLayouts[layout])();
    std::string name = kNames[layout];
    move_away();
    repeat_some();
    tempt();
    scene_.subject.name = name;
    for (Point& p : points_) p = {in_domain(p.x), in_domain(p.y), in_domain(p.z)};
    split();
    keep_heights_apart();
    choose_options();
    return std::move(scene_);
  }

 private:
  void choose_scale() {
    threshold_ = random_.magnitude(-20, 20);
    if (random_.once_in(3)) threshold_ = std::round(random_.magnitude(0, 9));
    if (random_.once_in(3)) threshold_ = std::ldexp(1.0, random_.whole(-20, 20));
    vertical_ = random_.coin() ? threshold_ * random_.magnitude(-4, 2) : random_.magnitude(-20, 20);
    far_ = random_.magnitude(-20, 50);
    if (random_.once_in(3)) far_ = 0.0;
    if (random_.once_in(24)) go_to_the_ends();
  }

  // Of the coordinate domain.
  void go_to_the_ends() {
    const bool small = random_.coin();
    const double end = small ? kSmallestCoordinate_m : kLargestCoordinate_m;
    const auto near_end = [&] {
      const double off = random_.magnitude(-3, 40);
      return std::clamp(small ? end * off : end / off, kSmallestCoordinate_m, kLargestCoordinate_m);
    };
    threshold_ = near_end();
    vertical_ = random_.once_in(4) ? random_.magnitude(-400, 399) : near_end();
    far_ = random_.coin() ? 0.0 : near_end();
  }

  void choose_size() {
    count_ = static_cast<std::size_t>(random_.magnitude(1, 6));
    if (random_.once_in(6)) count_ = random_.below(4);
    if (random_.once_in(30)) count_ = 200 + random_.below(400);
    if (random_.once_in(800)) count_ = 2000 + random_.below(1500);
  }

  Point anywhere(double low, double high) {
    return {random_.between(low, high), random_.between(low, high), random_.between(low, high)};
  }
  [[nodiscard]] double up() const { return upright_ ? vertical_ / threshold_ : 1.0; }
  Point scaled(const Point& p) const {
    return {p.x * threshold_, p.y * threshold_, p.z * threshold_ * up()};
  }

  void box() {
    const double side = std::cbrt(static_cast<double>(count_ + 1) * 4.0 / random_.magnitude(-4, 4));
    const bool flat = random_.once_in(4);
    for (std::size_t i = 0; i < count_; ++i) {
      Point p = anywhere(0.0, side);
      if (flat) p.z = 0.0;
      points_.push_back(scaled(p));
    }
  }

  // With a step that divides the threshold into a whole number, or nearly.
  void lattice() {
    const int side = std::max(2, static_cast<int>(std::cbrt(static_cast<double>(count_)) + 1.0));
    const double step = 1.0 / random_.whole(1, 3);
    const bool jitter = random_.coin();
    for (std::size_t i = 0; i < count_; ++i) {
      Point p = scaled({random_.whole(0, side) * step, random_.whole(0, side) * step,
                        random_.whole(0, side) * step});
      if (jitter) p = {nudged(p.x), nudged(p.y), nudged(p.z)};
      points_.push_back(p);
    }
  }

  void clumps() {
    const double apart = random_.magnitude(-1, 10);
    const double tight = random_.magnitude(-40, 1);
    std::vector<Point> centres;
    for (std::size_t i = 0; i < 1 + random_.below(4); ++i)
      centres.push_back(anywhere(-apart, apart));
    for (std::size_t i = 0; i < count_; ++i) {
      const Point& c = random_.one_of(centres);
      const Point d = anywhere(-tight, tight);
      points_.push_back(scaled({c.x + d.x, c.y + d.y, c.z + d.z}));
    }
  }

  // Around a centre, all exactly the threshold away, or nearly: of the whole squares that make one.
  void shell() {
    constexpr std::array<std::array<int, 4>, 8> kSquares = {{{1, 2, 2, 3},
                                                             {2, 3, 6, 7},
                                                             {1, 4, 8, 9},
                                                             {2, 6, 9, 11},
                                                             {3, 4, 0, 5},
                                                             {5, 12, 0, 13},
                                                             {3, 4, 12, 13},
                                                             {1, 0, 0, 1}}};
    points_.push_back({});
    const auto first = random_.below(kSquares.size());
    const double radius = kSquares[first][3];
    if (random_.coin()) threshold_ = radius * std::ldexp(1.0, random_.whole(-20, 20));
    const double scale = threshold_ / radius;
    for (std::size_t i = 1; i < count_; ++i) {
      std::array<int, 4> s = kSquares[random_.once_in(4) ? random_.below(kSquares.size()) : first];
      std::swap(s[0], s[random_.below(3)]);
      std::swap(s[1], s[random_.below(3)]);
      const double times = scale * radius / s[3];
      Point p{random_.sign() * times * s[0], random_.sign() * times * s[1],
              random_.sign() * times * s[2]};
      if (random_.once_in(8)) p = {nudged(p.x), nudged(p.y), nudged(p.z)};
      points_.push_back(p);
    }
  }

  // Neighbours that are all as far apart: every nearest is a tie.
  void row() {
    const double step = threshold_ * (random_.coin() ? 1.0 : random_.magnitude(-3, 3));
    const int axis = random_.whole(0, 2);
    for (std::size_t i = 0; i < count_; ++i) {
      const double at = step * static_cast<double>(i);
      points_.push_back({axis == 0 ? at : 0.0, axis == 1 ? at : 0.0, axis == 2 ? at : 0.0});
    }
    for (std::size_t i = 1; i < count_; ++i) std::swap(points_[i], points_[random_.below(i + 1)]);
  }

  void mixed_scales() {
    const int low = random_.whole(-40, 0);
    const int high = random_.whole(0, 40);
    const auto value = [&] { return random_.sign() * random_.magnitude(low, high); };
    for (std::size_t i = 0; i < count_; ++i) points_.push_back(scaled({value(), value(), value()}));
  }

  void far_sets() {
    clumps();
    const double gap = threshold_ * random_.magnitude(0, 40);
    for (std::size_t i = 0; i < points_.size(); i += 2) points_[i].x += gap;
  }

  // On multiples of the threshold, where searches draw their lines, and an ulp beside them.
  void seams() {
    const int side = 2 + static_cast<int>(std::cbrt(static_cast<double>(count_)));
    const auto value = [&](double unit) {
      return nudged(unit * (random_.whole(0, side) + (random_.once_in(3) ? random_.real() : 0.0)));
    };
    for (std::size_t i = 0; i < count_; ++i) {
      points_.push_back({value(threshold_), value(threshold_), value(threshold_ * up())});
    }
  }

  double nudged(double value) {
    if (value == 0.0 || random_.coin()) return value;
    return ulps_up(value, random_.whole(-2, 2));
  }

  void move_away() {
    if (random_.once_in(4)) far_ = 6.37e6;  // on Earth, from its middle
    const Point off = random_.coin() ? anywhere(-far_, far_) : Point{0.0, 0.0, far_};
    for (Point& p : points_) p = {p.x + off.x, p.y + off.y, p.z + off.z};
  }

  void repeat_some() {
    if (points_.empty() || !random_.once_in(3)) return;
    const std::size_t times = 1 + random_.below(points_.size());
    for (std::size_t i = 0; i < times; ++i) {
      Point& p = points_[random_.below(points_.size())];
      p = points_[random_.below(points_.size())];
      if (random_.coin() && p.x == 0.0) p.x = -p.x;
      if (random_.coin() && p.z == 0.0) p.z = -p.z;
    }
  }

  // Some go to where others are just about too close to them.
  void tempt() {
    if (points_.size() < 2) return;
    const std::size_t times = random_.below(points_.size() / 2 + 1) + random_.below(2);
    for (std::size_t i = 0; i < std::min<std::size_t>(times, 60); ++i) {
      const std::size_t chosen = random_.below(points_.size());
      points_[chosen] = at_boundary_of(points_[random_.below(points_.size())]);
    }
  }

  // Along any axis, often straight along it: across the lines that searches draw.
  Point at_boundary_of(Point p) {
    double Point::*const axes[] = {&Point::x, &Point::y, &Point::z};
    double Point::*const along = axes[random_.below(upright_ ? 2 : 3)];
    std::swap(p.x, p.*along);
    Point q = at_boundary_along_x(p);
    std::swap(q.x, q.*along);
    return q;
  }

  Point at_boundary_along_x(const Point& p) {
    const bool above = random_.coin();
    Point level_p = p;
    Point q = p;
    const double aside = threshold_ * (random_.coin() ? 0.0 : random_.between(-1.0, 1.0));
    q.y += aside;
    if (upright_) {
      level_p.z = q.z = 0.0;
    } else if (aside != 0.0 && random_.coin()) {
      q.z += std::sqrt(std::max(0.0, threshold_ * threshold_ - aside * aside)) *
             random_.between(-1.0, 1.0);
    }
    q.x = ulps_up(last_closer_x(level_p, q, threshold_, above), random_.whole(-1, 1));
    if (!upright_) return q;
    const double height =
        last_closer_x({p.z, 0.0, 0.0}, {p.z, 0.0, 0.0}, vertical_, random_.coin());
    q.z = random_.once_in(8) ? p.z : ulps_up(height, random_.whole(-1, 1));
    return q;
  }

  void keep_heights_apart() {
    if (!upright_ || !random_.once_in(4)) return;
    const auto keep_apart = [&](std::vector<Point>& points, std::vector<double>& heights) {
      for (Point& p : points) {
        heights.push_back(p.z);
        p.z = random_.coin() ? 0.0 : in_domain(p.z * 0x1p-3);
      }
    };
    keep_apart(scene_.subject.points, scene_.subject.heights);
    keep_apart(scene_.subject.others, scene_.subject.other_heights);
    height_unit_m_ = random_.coin() ? 0.3048 : 1.0;
    scene_.subject.name += ", heights apart";
  }

  void split() {
    scene_.subject.two_sets = random_.once_in(3);
    if (!scene_.subject.two_sets) {
      scene_.subject.points = std::move(points_);
      return;
    }
    const bool alternating = scene_.subject.name == "far sets" || random_.coin();
    const std::size_t ours = random_.below(points_.size() + 1);
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const bool theirs = alternating ? i % 2 == 1 : i >= ours;
      (theirs ? scene_.subject.others : scene_.subject.points).push_back(points_[i]);
    }
  }

  void choose_options() {
    std::vector<double> thresholds = {threshold_};
    std::vector<double> verticals = {vertical_};
    const auto& points = scene_.subject.points;
    const auto& others = scene_.subject.two_sets ? scene_.subject.others : points;
    for (int i = 0; i < 2 && !points.empty() && !others.empty(); ++i) {
      const std::size_t chosen = random_.below(points.size());
      const Point& p = points[chosen];
      const Point& q = random_.one_of(others);
      const double z = upright_ && scene_.subject.heights.empty() ? 0.0 : q.z - p.z;
      thresholds.push_back(beside(std::hypot(q.x - p.x, q.y - p.y, z)));
      verticals.push_back(beside(
          std::abs(scene_.subject.heights.empty()
                       ? q.z - p.z
                       : random_.one_of(scene_.subject.heights) - scene_.subject.heights[chosen])));
    }
    for (int i = 0; i < 3; ++i) {
      PairOptions options;
      options.threshold_m = i == 0 ? threshold_ : random_.one_of(thresholds);
      if (upright_) options.vertical_m = i == 0 ? vertical_ : random_.one_of(verticals);
      options.height_unit_m = height_unit_m_;
      options.inclusive = random_.coin();
      scene_.options.push_back(options);
    }
  }

  double beside(double threshold) {
    return std::clamp(ulps_up(threshold, random_.whole(-1, 1)), kSmallestCoordinate_m,
                      kLargestCoordinate_m);
  }

  Random& random_;
  bool upright_;
  double height_unit_m_ = 1.0;
  SnapshotScene scene_;
  std::vector<Point> points_;
  std::size_t count_ = 0;
  double threshold_ = 1.0;
  double vertical_ = 1.0;
  double far_ = 0.0;
};

}  // namespace

SnapshotScene random_snapshot(Random& random, bool upright) {
  return SnapshotMaker(random, upright).make();
}

}  // namespace beespace::differential
