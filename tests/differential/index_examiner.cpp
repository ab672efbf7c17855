// An Index under insertions, moves and removals, compared with the definition.
#include "tests/differential/described.hpp"
#include "tests/differential/examiner.hpp"
#include "tests/differential/snapshot_scenes.hpp"
#include "tests/differential/whole_numbers.hpp"

#include <beespace/index.hpp>
#include <beespace/nearest.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace beespace::differential {

namespace {

using Points = std::map<PointId, Point>;  // what the index should hold

// Points by their squared distances from a place, in whole numbers.
class Around {
 public:
  Around(const Points& points, const Point& place, double radius) {
    Unit unit;
    const auto include = [&](const Point& p) {
      for (const double value : {p.x, p.y, p.z}) unit.include(value);
    };
    for (const auto& [id, p] : points) include(p);
    include(place);
    unit.include(radius);
    const int u = unit.exponent();
    for (const auto& [id, p] : points) {
      const Whole far = squared(whole(p.x, u) - whole(place.x, u)) +
                        squared(whole(p.y, u) - whole(place.y, u)) +
                        squared(whole(p.z, u) - whole(place.z, u));
      by_distance_.emplace_back(far, id);
    }
    std::sort(by_distance_.begin(), by_distance_.end());
    limit_ = squared(whole(radius, u));
  }

  [[nodiscard]] std::vector<PointId> within(bool inclusive) const {
    std::vector<PointId> ids;
    for (const auto& [far, id] : by_distance_) {
      if (far < limit_ || (inclusive && far == limit_)) ids.push_back(id);
    }
    std::sort(ids.begin(), ids.end());
    return ids;
  }
  [[nodiscard]] std::vector<PointId> nearest(std::size_t k) const {
    std::vector<PointId> ids;
    for (const auto& [far, id] : by_distance_) {
      if (ids.size() < k) ids.push_back(id);
    }
    return ids;
  }

 private:
  std::vector<std::pair<Whole, PointId>> by_distance_;
  Whole limit_;
};

class IndexExamination {
 public:
  IndexExamination(Random& random, Tally& tally)
      : random_(random), tally_(tally), scene_(random_snapshot(random, false)) {
    if (scene_.subject.points.size() > 400) scene_.subject.points.resize(400);
    places_ = scene_.subject.points;
    places_.insert(places_.end(), scene_.subject.others.begin(), scene_.subject.others.end());
    places_.push_back({});
  }

  std::optional<std::string> examine() {
    tally_.scene();
    const auto& points = scene_.subject.points;
    auto built = Index::build(points, random_.coin() ? 1 : 3);
    if (!built) return to_string(built.error());
    for (PointId id = 0; id < points.size(); ++id) points_[id] = points[id];
    next_ = static_cast<PointId>(points.size());
    Index index = *std::move(built);
    for (std::size_t round = 0; round < 4 && fault_.empty(); ++round) {
      for (int i = 0; i < 4 && fault_.empty(); ++i) ask(index);
      const std::size_t changes = random_.below(random_.once_in(6) ? 300 : 20);
      for (std::size_t i = 0; i < changes && fault_.empty(); ++i) change(index);
    }
    if (fault_.empty()) return std::nullopt;
    return "Index, " + scene_.subject.name + ": " + fault_;
  }

 private:
  const Point& some_place() { return random_.one_of(places_); }
  PointId some_id() {
    return random_.once_in(20) || next_ == 0 ? next_ + 3
                                             : static_cast<PointId>(random_.below(next_));
  }

  void change(Index& index) {
    const std::size_t what = random_.below(40);
    if (what == 0) {
      index.rebuild();
    } else if (what < 14) {
      const Point p = some_place();
      const auto id = index.insert(p);
      if (!id || *id != next_) fault_ = "insert gives another id";
      points_[next_++] = p;
    } else if (what < 28) {
      const PointId id = some_id();
      const Point p = some_place();
      const bool known = points_.count(id) > 0;
      if (index.move(id, p).has_value() != known) fault_ = "move knows another point";
      if (known) points_[id] = p;
    } else {
      const PointId id = some_id();
      if (index.remove(id).has_value() != (points_.erase(id) > 0)) {
        fault_ = "remove knows another point";
      }
    }
    if (index.size() != points_.size()) fault_ = "it has another size";
  }

  void ask(const Index& index) {
    const PairOptions options = random_.one_of(scene_.options);
    const std::size_t k = random_.once_in(4) ? points_.size() + 1 : random_.below(6);
    const std::vector<Point> asked = {some_place(), some_place(), some_place()};
    const auto rows = index.find_around(
        asked, {options.threshold_m, options.inclusive, options.threads, options.max_results});
    const auto nearest_rows = index.k_nearest(asked, k, random_.coin() ? 1 : 3);
    if (!rows || !nearest_rows) {
      fault_ = to_string(rows ? nearest_rows.error() : rows.error());
      return;
    }
    for (std::size_t r = 0; r < asked.size(); ++r) {
      const Around around(points_, asked[r], options.threshold_m);
      tally_.answer("around");
      tally_.answer("k nearest");
      const std::vector<PointId> within = around.within(options.inclusive);
      const auto one = index.find_around(asked[r], options.threshold_m, options.inclusive);
      const auto row = (*rows)[r];
      if (!one || *one != within ||
          !std::equal(row.begin(), row.end(), within.begin(), within.end())) {
        tell("around", asked[r], options, k);
      }
      const std::vector<PointId> nearest = around.nearest(k);
      const auto some = index.k_nearest(asked[r], k);
      if (!some || !is(*some, nearest, asked[r])) tell("k nearest", asked[r], options, k);
      if (nearest_rows->length == 0) continue;
      const auto nearest_row = (*nearest_rows)[r];
      if (!is({nearest_row.begin(), nearest_row.end()}, nearest, asked[r])) {
        tell("rows of k nearest", asked[r], options, k);
      }
    }
    const Around around(points_, asked[0], 0.0);
    const auto exactly = index.find_around(asked[0], 0.0, true);
    if (!exactly || *exactly != around.within(true)) tell("at the place", asked[0], options, k);
  }

  [[nodiscard]] bool is(const std::vector<Nearest>& got, const std::vector<PointId>& expected,
                        const Point& place) const {
    if (got.size() != expected.size()) return false;
    for (std::size_t i = 0; i < got.size(); ++i) {
      const Point& p = points_.at(expected[i]);
      const double x = p.x - place.x;
      const double y = p.y - place.y;
      const double z = p.z - place.z;
      const double far = std::sqrt(x * x + y * y + z * z);
      if (got[i].id != expected[i] || got[i].distance_m != far) return false;
    }
    return true;
  }

  void tell(const std::string& what, const Point& place, const PairOptions& options,
            std::size_t k) {
    fault_ = what + " of " + described(place) + ", radius " + hex(options.threshold_m) +
             (options.inclusive ? ", inclusive" : ", strict") + ", k " + std::to_string(k) + "\n";
    for (const auto& [id, p] : points_) {
      fault_.append("    ")
          .append(std::to_string(id))
          .append(" ")
          .append(described(p))
          .append("\n");
    }
  }

  Random& random_;
  Tally& tally_;
  SnapshotScene scene_;
  std::vector<Point> places_;
  Points points_;
  PointId next_ = 0;
  std::string fault_;
};

}  // namespace

Examiner index_examiner() {
  return {"indexes",
          [](Random& random, Tally& tally) { return IndexExamination(random, tally).examine(); }};
}

}  // namespace beespace::differential
