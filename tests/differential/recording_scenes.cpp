#include "tests/differential/recording_scenes.hpp"

#include "tests/differential/boundary.hpp"
#include "tests/differential/described.hpp"
#include "tests/differential/recording_oracle.hpp"

#include <beespace/mover.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace beespace::differential {

namespace {

double in_domain(double value) {
  if (std::abs(value) < kSmallestInMotion) return std::copysign(0.0, value);
  return std::clamp(value, -kLargestInMotion, kLargestInMotion);
}

class RecordingMaker {
 public:
  explicit RecordingMaker(Random& random) : random_(random) {}

  RecordingScene make() {
    choose_scale();
    const std::size_t count = 2 + random_.below(random_.once_in(8) ? 20 : 5);
    for (std::size_t i = 0; i < count; ++i) add_track();
    for (Track& track : scene_.tracks) move_away(track);
    const std::size_t times = random_.below(count);
    for (std::size_t i = 0; i < times; ++i) {
      const std::size_t chosen = random_.below(count);
      const std::size_t other = random_.below(count);
      if (chosen != other) tempt(scene_.tracks[chosen], scene_.tracks[other]);
    }
    if (scene_.options.vertical_m && random_.once_in(5)) keep_heights_apart();
    choose_gap();
    return std::move(scene_);
  }

 private:
  void choose_scale() {
    ConflictOptions& o = scene_.options;
    o.threshold_m =
        random_.coin() ? std::ldexp(1.0, random_.whole(-10, 10)) : random_.magnitude(-20, 20);
    if (random_.coin()) {
      o.vertical_m =
          random_.coin() ? o.threshold_m * random_.magnitude(-4, 2) : random_.magnitude(-20, 20);
      if (random_.coin()) o.vertical_m = std::ldexp(1.0, random_.whole(-10, 10));
    }
    o.inclusive = random_.coin();
    lattice_ = random_.coin();
    scene_.name = lattice_ ? "lattice" : "box";
    second_ = random_.coin() ? 1.0 : random_.magnitude(-20, 10);
    if (random_.coin())
      began_ = random_.coin() ? 1.7e9 : random_.sign() * random_.magnitude(-10, 40);
    // A few doubles of time from fix to fix.
    if (began_ != 0.0 && random_.once_in(6))
      second_ = ulps_up(std::abs(began_), 1) - std::abs(began_);
    step_ = o.threshold_m * (lattice_ ? 1.0 / random_.whole(1, 2) : random_.magnitude(-2, 6));
    rise_ = o.vertical_m ? *o.vertical_m * step_ / o.threshold_m : step_;
    if (random_.once_in(3)) return;
    const double far = random_.once_in(4) ? 6.37e6 : random_.magnitude(-10, 50);
    away_ =
        random_.coin() ? Point{0.0, 0.0, far} : Point{far, random_.between(-far, far), far * 0.75};
    if (random_.once_in(16)) go_to_the_ends();
  }

  // Of the motion domain.
  void go_to_the_ends() {
    ConflictOptions& o = scene_.options;
    const auto near_end = [&](bool low) {
      const double off = random_.magnitude(-2, 30);
      return std::clamp(low ? kSmallestInMotion * off : kLargestInMotion / off, kSmallestInMotion,
                        kLargestInMotion);
    };
    const bool small = random_.coin();
    o.threshold_m = near_end(small);
    if (o.vertical_m) o.vertical_m = near_end(random_.once_in(4) ? !small : small);
    step_ = o.threshold_m;
    rise_ = o.vertical_m.value_or(step_);
    second_ = near_end(random_.coin());
    began_ = 0.0;
    away_.z = random_.coin() ? 0.0 : near_end(random_.coin());
  }

  double coordinate(double step) {
    return lattice_ ? step * random_.whole(-3, 3) : random_.between(-3.0 * step, 3.0 * step);
  }

  void add_track() {
    Track track;
    const std::size_t fixes = random_.once_in(16) ? random_.below(2) : 1 + random_.below(5);
    double time = lattice_ ? random_.whole(0, 3) : random_.between(0.0, 3.0);
    for (std::size_t i = 0; i < fixes; ++i) {
      time += lattice_ ? random_.whole(1, 3) : random_.magnitude(-8, 1);
      const double at = in_domain(began_ + time * second_);
      const bool stays = i > 0 && random_.once_in(5);
      const Point p = stays ? track.fixes.back().position
                            : Point{coordinate(step_), coordinate(step_), coordinate(rise_)};
      if (track.fixes.empty() || at > track.fixes.back().time_s) track.fixes.push_back({at, p});
    }
    scene_.tracks.push_back(std::move(track));
  }

  void move_away(Track& track) const {
    for (Fix& fix : track.fixes) {
      Point& p = fix.position;
      p = {in_domain(p.x + away_.x), in_domain(p.y + away_.y), in_domain(p.z + away_.z)};
    }
  }

  // One flies beside another, just about too close to it somewhere: moved along an axis to the last
  // double at which it still is.
  void tempt(Track& track, const Track& other) {
    if (other.fixes.empty()) return;
    const ConflictOptions& o = scene_.options;
    Track tempted = other;
    const double side = random_.between(0.5, 1.0);
    const double drift = random_.once_in(3) ? 0.0 : random_.magnitude(-10, 4) * o.threshold_m;
    const double rise = o.vertical_m ? *o.vertical_m * (1.0 - 0x1p-12) : 0.0;
    for (std::size_t i = 0; i < tempted.fixes.size(); ++i) {
      const double along = static_cast<double>(i) - 0.5;
      Point& p = tempted.fixes[i].position;
      p = {in_domain(p.x + side * o.threshold_m * 0.7), in_domain(p.y + along * drift),
           in_domain(p.z + rise)};
    }
    if (!meets(tempted, other)) return;
    Track last = tempted;
    for (double Point::*const axis : {&Point::x, &Point::z}) {
      std::int64_t near = rank_of(0.0);
      std::int64_t far = rank_of(in_domain(16.0 * (o.threshold_m + o.vertical_m.value_or(0.0))));
      const Track from = last;
      while (near + 1 < far) {
        const std::int64_t middle = std::midpoint(near, far);
        Track moved = from;
        for (Fix& fix : moved.fixes) {
          fix.position.*axis = in_domain(fix.position.*axis + double_of(middle));
        }
        if (meets(moved, other)) {
          near = middle;
          last = moved;
        } else {
          far = middle;
        }
      }
    }
    for (Fix& fix : last.fixes) {
      double& value = random_.coin() ? fix.position.x : fix.position.z;
      value = in_domain(ulps_up(value, random_.whole(-1, 1)));
    }
    track = last;
  }

  [[nodiscard]] bool meets(const Track& track, const Track& other) const {
    return !PairOracle(track, other, scene_.options).stretches().empty();
  }

  void keep_heights_apart() {
    for (Track& track : scene_.tracks) {
      for (Fix& fix : track.fixes) {
        track.heights_m.push_back(fix.position.z);
        fix.position.z = in_domain(fix.position.z * 0.125);
      }
    }
    scene_.name += ", heights apart";
  }

  // Between the gaps that there are: the double of a difference is not the question here.
  void choose_gap() {
    if (!random_.once_in(3)) return;
    std::vector<double> gaps;
    for (const Track& track : scene_.tracks) {
      for (std::size_t i = 1; i < track.fixes.size(); ++i) {
        gaps.push_back(track.fixes[i].time_s - track.fixes[i - 1].time_s);
      }
    }
    if (gaps.empty()) return;
    const double some = random_.one_of(gaps);
    scene_.options.max_gap_s = lattice_ && began_ == 0.0 ? some : some * (1.0 + 0x1p-20);
  }

  Random& random_;
  RecordingScene scene_;
  bool lattice_ = false;
  double began_ = 0.0;
  double second_ = 1.0;
  double step_ = 1.0;
  double rise_ = 1.0;
  Point away_{};
};

}  // namespace

RecordingScene random_recording(Random& random) {
  return RecordingMaker(random).make();
}

std::string text_of(const RecordingScene& scene) {
  const ConflictOptions& o = scene.options;
  std::string text = scene.name;
  text.append(": threshold ").append(hex(o.threshold_m));
  if (o.vertical_m) text.append(", vertical ").append(hex(*o.vertical_m));
  text.append(o.inclusive ? ", inclusive" : ", strict");
  text.append(", gaps over ").append(hex(o.max_gap_s)).append("\n");
  for (const Track& track : scene.tracks) {
    text.append("    track\n");
    for (std::size_t i = 0; i < track.fixes.size(); ++i) {
      text.append("      ").append(hex(track.fixes[i].time_s)).append(" s ");
      text.append(described(track.fixes[i].position));
      if (!track.heights_m.empty()) text.append(" height ").append(hex(track.heights_m[i]));
      text.append("\n");
    }
  }
  return text;
}

}  // namespace beespace::differential
