// How much slower than an even swarm the hostile ones are: for each question, layouts of points
// that have made searches quadratic, here or elsewhere.
//
// Prints a table: what a point costs, over what it costs in an even swarm of as many points, asked
// the same question in the same run. One thread, by the processor's time. A layout is asked for
// with more and more points, up to as many as are wanted (200,000, or the first argument); one that
// takes too long before that is given up there. The second argument names the layouts wanted, by a
// part of their names.
#include <beespace/beespace.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace {

using beespace::Engine;
using beespace::Point;
using Points = std::vector<Point>;

constexpr std::size_t kFirstSize = 3'125;
constexpr double kTooLong_s = 0.7;

enum class Question : std::uint8_t {
  kAtRisk,
  kAtRiskBetween,
  kCounts,
  kGroups,
  kNearest,
  kNearestBetween,
  kClosestPairBetween
};

const char* name_of(Question question) {
  switch (question) {
    case Question::kAtRisk:
      return "at risk";
    case Question::kAtRiskBetween:
      return "at risk of two sets";
    case Question::kCounts:
      return "counts";
    case Question::kGroups:
      return "groups";
    case Question::kNearest:
      return "nearest";
    case Question::kNearestBetween:
      return "nearest of two sets";
    case Question::kClosestPairBetween:
      return "closest pair of two sets";
  }
  return "";
}

struct Scene {
  Points points;
  Points others;  // of the questions about two sets
  double threshold_m = 1.0;
};

// Draws the coordinates of a layout, the same on every machine.
class Draw {
 public:
  explicit Draw(std::uint64_t seed) : random_(seed) {}

  double below(double limit) { return static_cast<double>(random_() >> 11U) * 0x1p-53 * limit; }
  double between(double low, double high) { return low + below(high - low); }
  int whole(int low, int high) {
    return low + static_cast<int>(below(static_cast<double>(high - low + 1)));
  }
  double power_of_two(int low, int high) {
    return std::ldexp(below(1.0) < 0.5 ? -1.0 : 1.0, whole(low, high));
  }
  Point in_box(double side) { return {below(side), below(side), below(side)}; }
  Point direction() {
    const double z = between(-1.0, 1.0);
    const double turn = below(2.0 * std::numbers::pi);
    const double across = std::sqrt(1.0 - z * z);
    return {across * std::cos(turn), across * std::sin(turn), z};
  }

 private:
  std::mt19937_64 random_;
};

Point times(const Point& p, double factor) {
  return {p.x * factor, p.y * factor, p.z * factor};
}
Point moved(const Point& p, double x) {
  return {p.x + x, p.y, p.z};
}

template <class Make>
Points drawn(std::size_t size, std::uint64_t seed, Make make) {
  Draw draw(seed);
  Points points(size);
  for (std::size_t i = 0; i < size; ++i) points[i] = make(draw, i);
  return points;
}

Points box(std::size_t size, double side, std::uint64_t seed = 1, double x = 0.0) {
  return drawn(size, seed, [&](Draw& draw, std::size_t) { return moved(draw.in_box(side), x); });
}

Points sphere(std::size_t size, double radius, std::uint64_t seed = 2) {
  return drawn(size, seed,
               [&](Draw& draw, std::size_t) { return times(draw.direction(), radius); });
}

// Half of the points in one box, half in another around the origin.
Points two_boxes(std::size_t size, double small, double large) {
  return drawn(size, 3,
               [&](Draw& draw, std::size_t i) { return draw.in_box(i % 2 == 0 ? small : large); });
}

Points radii(std::size_t size, double lowest_decade, double highest_decade) {
  return drawn(size, 4, [&](Draw& draw, std::size_t) {
    return times(draw.direction(), std::pow(10.0, draw.between(lowest_decade, highest_decade)));
  });
}

Points powers_of_two(std::size_t size, int low, int high) {
  return drawn(size, 5, [&](Draw& draw, std::size_t) {
    return Point{draw.power_of_two(low, high), draw.power_of_two(low, high),
                 draw.power_of_two(low, high)};
  });
}

Points radii_powers_of_two(std::size_t size) {
  return drawn(size, 6, [&](Draw& draw, std::size_t) {
    return times(draw.direction(), std::ldexp(1.0, draw.whole(-30, 30)));
  });
}

Points lattice(std::size_t size, double step) {
  const auto side = static_cast<std::size_t>(std::ceil(std::cbrt(static_cast<double>(size))));
  return drawn(size, 7, [&](Draw&, std::size_t i) {
    return Point{step * static_cast<double>(i % side), step * static_cast<double>(i / side % side),
                 step * static_cast<double>(i / (side * side))};
  });
}

// Few far away, most near the middle, on every axis.
Points cauchy(std::size_t size) {
  return drawn(size, 8, [](Draw& draw, std::size_t) {
    const auto tail = [&] { return std::tan(std::numbers::pi * (draw.below(1.0) - 0.5)); };
    return Point{tail(), tail(), tail()};
  });
}

// On each axis the middle thirds are empty, and the middle thirds of what is left, and so on.
Points cantor_dust(std::size_t size) {
  return drawn(size, 9, [](Draw& draw, std::size_t) {
    const auto coordinate = [&] {
      double value = 0.0;
      double digit = 2.0 / 3.0;
      for (int i = 0; i < 30; ++i, digit /= 3.0) value += draw.below(1.0) < 0.5 ? 0.0 : digit;
      return value;
    };
    return Point{coordinate(), coordinate(), coordinate()};
  });
}

// Clumps of a hundred, each a millionth of the distance to the next.
Points clumps(std::size_t size) {
  const Points centres = box(size / 100 + 1, 1e6, 10);
  return drawn(size, 11, [&](Draw& draw, std::size_t i) {
    const Point& centre = centres[i / 100];
    const Point p = draw.in_box(0.01);
    return Point{centre.x + p.x, centre.y + p.y, centre.z + p.z};
  });
}

// Every point but one in a clump of its own, each a thousandth of the last: 20 clumps.
Points nested_clumps(std::size_t size) {
  return drawn(size, 12, [](Draw& draw, std::size_t i) {
    return draw.in_box(std::pow(10.0, 9.0 - static_cast<double>(i % 20)));
  });
}

Points helix(std::size_t size, double pitch) {
  return drawn(size, 13, [&](Draw& draw, std::size_t) {
    const double turns = draw.below(1'000.0);
    const double angle = 2.0 * std::numbers::pi * turns;
    return Point{std::cos(angle), std::sin(angle), pitch * turns};
  });
}

Points plane(std::size_t size, double side, double height, std::uint64_t seed) {
  return drawn(size, seed, [&](Draw& draw, std::size_t) {
    return Point{draw.below(side), draw.below(side), height};
  });
}

Points joined(Points first, const Points& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

// The side of a box in which so many points have two neighbours each within 1 m.
double even_side(std::size_t size) {
  return std::cbrt(static_cast<double>(size) * 4.0 / 3.0 * std::numbers::pi / 2.0);
}

Scene even(std::size_t size) {
  const double side = even_side(size);
  return {box(size, side, 1), box(size, side, 14), 1.0};
}

struct Layout {
  Question question;
  const char* name;
  std::function<Scene(std::size_t)> make;
};

void add_of_two_sets(std::vector<Layout>& layouts, Question question) {
  const auto add = [&](const char* name, std::function<Scene(std::size_t)> make) {
    layouts.push_back({question, name, std::move(make)});
  };
  add("boxes of 100 m, 200 m apart", [](std::size_t n) -> Scene {
    return {box(n, 100.0), box(n, 100.0, 15, 300.0)};
  });
  add("boxes of 100 m, 10 km apart", [](std::size_t n) -> Scene {
    return {box(n, 100.0), box(n, 100.0, 15, 10'000.0)};
  });
  add("boxes of 100 m, 1,000 km apart", [](std::size_t n) -> Scene {
    return {box(n, 100.0), box(n, 100.0, 15, 1e6)};
  });
  add("the others all at one place", [](std::size_t n) -> Scene {
    return {box(n, 100.0), Points(n, Point{50.0, 50.0, 50.0})};
  });
  add("the others in a clump of 1e-9 m", [](std::size_t n) -> Scene {
    return {box(n, 100.0), box(n, 1e-9, 15, 50.0)};
  });
  add("asked on a sphere, the others in its middle", [](std::size_t n) -> Scene {
    return {sphere(n, 100.0), box(n, 1.0)};
  });
  add("asked in the middle, the others on a sphere", [](std::size_t n) -> Scene {
    return {box(n, 1.0), sphere(n, 100.0)};
  });
  add("two planes, 100 spacings apart", [](std::size_t n) -> Scene {
    const double side = std::sqrt(static_cast<double>(n));
    return {plane(n, side, 0.0, 16), plane(n, side, 100.0, 17)};
  });
}

void add_nearest(std::vector<Layout>& layouts) {
  const auto add = [&](const char* name, std::function<Points(std::size_t)> make) {
    layouts.push_back({Question::kNearest, name, [make = std::move(make)](std::size_t n) -> Scene {
                         return {make(n), {}};
                       }});
  };
  add("half within 1 m, half over 1e6 m", [](std::size_t n) { return two_boxes(n, 1.0, 1e6); });
  add("half within 1 m, half over 1e9 m", [](std::size_t n) { return two_boxes(n, 1.0, 1e9); });
  add("half in a clump of 1e-9 m in 1e6 m", [](std::size_t n) { return two_boxes(n, 1e-9, 1e6); });
  add("radii over 18 decades", [](std::size_t n) { return radii(n, -9.0, 9.0); });
  add("radii powers of two", radii_powers_of_two);
  add("coordinates powers of two", [](std::size_t n) { return powers_of_two(n, -100, 100); });
  add("a lattice", [](std::size_t n) { return lattice(n, 7.0); });
  add("Cauchy's tails", cauchy);
  add("Cantor's dust", cantor_dust);
  add("clumps of a hundred, 0.01 m in 1e6 m", clumps);
  add("20 nested clumps", nested_clumps);
  add("a helix", [](std::size_t n) { return helix(n, 0.01); });
  add("two planes, 100 spacings apart", [](std::size_t n) {
    const double side = std::sqrt(static_cast<double>(n));
    return joined(plane(n / 2, side, 0.0, 16), plane(n / 2, side, 100.0, 17));
  });
  add("a sphere and a clump in its middle",
      [](std::size_t n) { return joined(sphere(n / 2, 1.0), box(n / 2, 1e-9)); });
}

void add_at_risk(std::vector<Layout>& layouts) {
  const auto add = [&](const char* name, double threshold_m,
                       std::function<Points(std::size_t)> make) {
    layouts.push_back({Question::kAtRisk, name, [=](std::size_t n) -> Scene {
                         return {make(n), {}, threshold_m};
                       }});
  };
  add("radii over 18 decades", 1.0, [](std::size_t n) { return radii(n, -9.0, 9.0); });
  add("half at one place", 1.0, [](std::size_t n) {
    Points points = box(n, even_side(n));
    std::fill_n(points.begin(), n / 2, points.back());
    return points;
  });
  add("half in a clump of 1e-9 m in 1e6 m", 1e-11,
      [](std::size_t n) { return two_boxes(n, 1e-9, 1e6); });
  add("two clumps exactly the threshold apart", 1.0, [](std::size_t n) {
    return joined(Points(n / 2, Point{0.0, 0.0, 0.0}), Points(n / 2, Point{1.0, 0.0, 0.0}));
  });
  add("a lattice at the threshold", 7.0, [](std::size_t n) { return lattice(n, 7.0); });
  add("Cauchy's tails", 0.01, cauchy);
  add("Cantor's dust", 1e-4, cantor_dust);
  add("20 nested clumps", 1.0, nested_clumps);
}

void add_at_risk_between(std::vector<Layout>& layouts) {
  const auto add = [&](const char* name, std::function<Scene(std::size_t)> make) {
    layouts.push_back({Question::kAtRiskBetween, name, std::move(make)});
  };
  add("all exactly at the threshold", [](std::size_t n) -> Scene {
    return {Points(n, Point{0.0, 0.0, 0.0}), Points(n, Point{1.0, 0.0, 0.0})};
  });
  add("lines exactly the threshold apart", [](std::size_t n) -> Scene {
    const auto line = [n](double x) {
      return drawn(n, 18, [x](Draw&, std::size_t i) {
        return Point{x, 1e-12 * static_cast<double>(i), 0.0};
      });
    };
    return {line(0.0), line(1.0)};
  });
  add("a shell at T(1 + 1e-9), the others in its middle", [](std::size_t n) -> Scene {
    return {sphere(n, 1.0 + 1e-9), box(n, 1e-12)};
  });
  add("a clump, the others on a shell at T(1 + 1e-9)", [](std::size_t n) -> Scene {
    return {box(n, 1e-12), sphere(n, 1.0 + 1e-9)};
  });
}

void add_crowds(std::vector<Layout>& layouts, Question question) {
  const auto add = [&](const char* name, double threshold_m,
                       std::function<Points(std::size_t)> make) {
    layouts.push_back({question, name, [=](std::size_t n) -> Scene {
                         return {make(n), {}, threshold_m};
                       }});
  };
  add("a shell at the threshold and its centre", 1.0,
      [](std::size_t n) { return joined(sphere(n / 2, 1.0), box(n / 2, 1e-12)); });
  add("a shell at T(1 + 1e-9) and its centre", 1.0,
      [](std::size_t n) { return joined(sphere(n / 2, 1.0 + 1e-9), box(n / 2, 1e-12)); });
  add("two clumps of 1e-9 m, a threshold apart", 1.0,
      [](std::size_t n) { return joined(box(n / 2, 1e-9), box(n / 2, 1e-9, 19, 1.0)); });
  add("coordinates powers of two", 1.0, [](std::size_t n) { return powers_of_two(n, -100, 100); });
  add("radii over 18 decades", 1.0, [](std::size_t n) { return radii(n, -9.0, 9.0); });
  add("a lattice at the threshold", 7.0, [](std::size_t n) { return lattice(n, 7.0); });
  add("20 nested clumps", 1.0, nested_clumps);
  add("Cauchy's tails", 0.01, cauchy);
}

std::vector<Layout> all_layouts() {
  std::vector<Layout> layouts;
  add_of_two_sets(layouts, Question::kNearestBetween);
  add_of_two_sets(layouts, Question::kClosestPairBetween);
  add_nearest(layouts);
  add_at_risk(layouts);
  add_at_risk_between(layouts);
  add_crowds(layouts, Question::kCounts);
  add_crowds(layouts, Question::kGroups);
  return layouts;
}

template <class Status>
void require(const Status& status) {
  if (!status) {
    std::fprintf(stderr, "%s\n", status.error().message.c_str());
    std::exit(1);
  }
}

// Engine and answers, kept from one question to the next.
class Asker {
 public:
  // Seconds of the processor, the best of a few times.
  double time(Question question, const Scene& scene) {
    double best = ask(question, scene);
    for (int i = 0; i < 4 && best < kTooLong_s / 4; ++i) {
      best = std::min(best, ask(question, scene));
    }
    return best;
  }

 private:
  double ask(Question question, const Scene& scene) {
    const std::clock_t start = std::clock();
    switch (question) {
      case Question::kAtRisk:
        require(engine_.find_at_risk(scene.points, {scene.threshold_m}, ids_));
        break;
      case Question::kAtRiskBetween:
        require(
            engine_.find_at_risk_between(scene.points, scene.others, {scene.threshold_m}, ids_));
        break;
      case Question::kCounts:
        require(engine_.count_neighbors(scene.points, {scene.threshold_m}, ids_));
        break;
      case Question::kGroups:
        require(engine_.find_conflict_groups(scene.points, {scene.threshold_m}, groups_));
        break;
      case Question::kNearest:
        require(engine_.find_nearest(scene.points, nearest_));
        break;
      case Question::kNearestBetween:
        require(engine_.find_nearest_between(scene.points, scene.others, nearest_));
        break;
      case Question::kClosestPairBetween:
        require(engine_.find_closest_pair_between(scene.points, scene.others));
        break;
    }
    return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  }

  Engine engine_;
  std::vector<std::uint32_t> ids_;
  std::vector<beespace::Nearest> nearest_;
  beespace::IdRows groups_;
};

class Table {
 public:
  explicit Table(std::size_t wanted) : wanted_(wanted) {}

  void add(const Layout& layout) {
    std::size_t size = std::min(kFirstSize, wanted_);
    double took = asker_.time(layout.question, layout.make(size));
    while (size < wanted_ && took < kTooLong_s) {
      size = std::min(2 * size, wanted_);
      took = asker_.time(layout.question, layout.make(size));
    }
    // At once after it, as the machine may be busier at another time.
    const double usual = asker_.time(layout.question, even(size));
    const double ratio = took / usual;
    const auto points = static_cast<double>(size);
    std::printf("| %s | %s | %zu%s | %.0f | %.0f | %.1f |\n", name_of(layout.question), layout.name,
                size, size < wanted_ ? " (given up)" : "", took / points * 1e9,
                usual / points * 1e9, ratio);
    std::fflush(stdout);
    if (ratio > worst_) {
      worst_ = ratio;
      worst_name_ = std::string(name_of(layout.question)) + ", " + layout.name;
    }
  }

  void print_worst() const {
    std::printf("\nWorst ratio: %.1f (%s)\n", worst_, worst_name_.c_str());
  }

 private:
  std::size_t wanted_;
  Asker asker_;
  double worst_ = 0.0;
  std::string worst_name_;
};

}  // namespace

int main(int argc, char** argv) {
  const std::size_t wanted = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 200'000;
  const std::string part = argc > 2 ? argv[2] : "";
  if (wanted == 0 || argc > 3) {
    std::fprintf(stderr, "usage: cliff_benchmark [POINTS [PART OF THE NAME]]\n");
    return 2;
  }
  std::printf("| question | layout | points | ns a point | even swarm | ratio |\n");
  std::printf("|---|---|---|---|---|---|\n");
  Table table(wanted);
  for (const Layout& layout : all_layouts()) {
    const std::string name = std::string(name_of(layout.question)) + ", " + layout.name;
    if (name.find(part) != std::string::npos) table.add(layout);
  }
  table.print_worst();
  return 0;
}
