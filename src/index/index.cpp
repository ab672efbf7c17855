#include <beespace/index.hpp>

#include "base/bounds.hpp"
#include "base/crew_size.hpp"
#include "base/kept_crew.hpp"
#include "base/stopping.hpp"
#include "exact/validate.hpp"
#include "index/index_levels.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <utility>

namespace beespace {

namespace {

PointsView view_of(const Point& point) {
  return std::span(&point, 1);
}

// The error for a place or point that is given alone.
std::optional<Error> check_place(const Point& place) {
  auto error = core::check_points(view_of(place), 0, 1);
  if (error) error->location = {};
  return error;
}

// The box of points or places, which are named so; or what is wrong with them.
Result<core::Bounds> measure(const PointsView& points, const char* name,
                             const core::Resources& with) {
  if (auto error = core::check_no_heights(points, name)) return *std::move(error);
  if (auto error = core::check_size(points)) {
    error->location.array = name;
    return *std::move(error);
  }
  Result<core::Bounds> bounds = core::measure(points, with);
  if (!bounds) bounds.error().location.array = name;
  return bounds;
}

// What is wrong with one radius for each place.
std::optional<Error> check_radii(const PointsView& places, std::span<const double> radii_m,
                                 const AroundOptions& options) {
  if (!std::isnan(options.radius_m)) {
    return Error{ErrorCode::kInvalidArgument,
                 "there is a radius for each place and one for all: give either",
                 {}};
  }
  if (radii_m.size() != places.size()) {
    Error error{ErrorCode::kInvalidArgument,
                "there are " + std::to_string(radii_m.size()) + " radii for " +
                    std::to_string(places.size()) + " places; give one for each",
                {}};
    error.location.array = "radii";
    return error;
  }
  for (std::size_t i = 0; i < radii_m.size(); ++i) {
    if (auto error = search::check_radius(radii_m[i])) {
      error->location.array = "radii";
      error->location.record = i;
      return error;
    }
  }
  return std::nullopt;
}

// The points around all places, whose radii are checked.
Result<IdRows> answer_around(const search::IndexLevels& levels, Crew* lent,
                             const PointsView& places, std::span<const double> radii_m,
                             const AroundOptions& options) {
  core::KeptCrew crew(lent);
  core::StoppableCrew stoppable(crew.of(options.threads, places.size()), options.stop);
  core::Memory memory;
  return core::unless_stopped([&]() -> Result<IdRows> {
    const Result<core::Bounds> bounds = measure(places, core::kPlacesName, {stoppable, memory});
    if (!bounds) return bounds.error();
    return search::find_around_all(levels, places, radii_m, *bounds, options, stoppable);
  });
}

Error no_such_point(PointId id) {
  return {ErrorCode::kInvalidArgument,
          "the index holds no point with id " + std::to_string(id) +
              "; give one that was built in or inserted, and not removed since",
          {}};
}

}  // namespace

Index::Index(std::unique_ptr<Levels> levels) : levels_(std::move(levels)) {
}
Index::Index(Index&&) noexcept = default;
Index& Index::operator=(Index&&) noexcept = default;
Index::~Index() = default;

Index::Index() {
  Crew alone;
  levels_ = std::make_unique<Levels>(search::ChangingPoints({}, {}, alone));
}

Result<Index> Index::build(const PointsView& points, const RunOptions& run) {
  ThreadCrew crew(cpu::crew_size(run.threads, points.size()));
  Result<Index> built = build(points, crew, run.stop);
  if (built) built->levels_->lent = nullptr;
  return built;
}

Result<Index> Index::build(const PointsView& points, Crew& crew, const std::stop_token& stop) {
  core::StoppableCrew stoppable(crew, stop);
  core::Memory memory;
  return core::unless_stopped([&]() -> Result<Index> {
    const Result<core::Bounds> bounds = measure(points, core::kPointsName, {stoppable, memory});
    if (!bounds) return bounds.error();
    Index index(std::make_unique<Levels>(search::ChangingPoints(points, *bounds, stoppable)));
    index.levels_->lent = &crew;
    return index;
  });
}

std::size_t Index::size() const {
  return levels_->points.size();
}

bool Index::contains(PointId id) const {
  return levels_->points.contains(id);
}

Result<Point> Index::point(PointId id) const {
  if (!contains(id)) return no_such_point(id);
  return levels_->points.point(id);
}

Status Index::find_around(const Point& place, double radius_m, bool inclusive,
                          std::vector<PointId>& found) const {
  found.clear();
  if (auto error = search::check_radius(radius_m)) return *std::move(error);
  if (auto error = check_place(place)) return *std::move(error);
  levels_->find_around({place, radius_m, inclusive}, found);
  return std::monostate{};
}

Result<std::vector<PointId>> Index::find_around(const Point& place, double radius_m,
                                                bool inclusive) const {
  std::vector<PointId> found;
  const Status status = find_around(place, radius_m, inclusive, found);
  if (!status) return status.error();
  return found;
}

Status Index::k_nearest(const Point& place, std::size_t k, std::vector<Nearest>& nearest) const {
  nearest.clear();
  if (auto error = check_place(place)) return *std::move(error);
  nearest.resize(std::min(k, size()));
  if (nearest.empty()) return std::monostate{};
  core::NearestList list;
  list.start(place, nearest.size(), std::numeric_limits<double>::infinity());
  levels_->find_nearest(place, list);
  list.write(nearest.data());
  return std::monostate{};
}

Result<std::vector<Nearest>> Index::k_nearest(const Point& place, std::size_t k) const {
  std::vector<Nearest> nearest;
  const Status status = k_nearest(place, k, nearest);
  if (!status) return status.error();
  return nearest;
}

Status Index::k_nearest_of(PointId id, std::size_t k, std::vector<Nearest>& nearest) const {
  nearest.clear();
  if (!contains(id)) return no_such_point(id);
  if (k == 0) return std::monostate{};
  // One more, for the point itself. Where as many others lie at its position, it may be none of
  // them; then the last is one too many.
  const std::size_t others = std::min(k, size() - 1);
  if (Status found = k_nearest(levels_->points.point(id), others + 1, nearest); !found) {
    return found;
  }
  std::erase_if(nearest, [&](const Nearest& near) { return near.id == id; });
  nearest.resize(others);
  return std::monostate{};
}

Result<std::vector<Nearest>> Index::k_nearest_of(PointId id, std::size_t k) const {
  std::vector<Nearest> nearest;
  const Status status = k_nearest_of(id, k, nearest);
  if (!status) return status.error();
  return nearest;
}

Result<IdRows> Index::find_around(const PointsView& places, const AroundOptions& options) const {
  if (std::isnan(options.radius_m)) return core::threshold_not_given();
  if (auto error = search::check_radius(options.radius_m)) return *std::move(error);
  return answer_around(*levels_, levels_->lent, places, {}, options);
}

Result<IdRows> Index::find_around(const PointsView& places, std::span<const double> radii_m,
                                  const AroundOptions& options) const {
  if (auto error = check_radii(places, radii_m, options)) return *std::move(error);
  return answer_around(*levels_, levels_->lent, places, radii_m, options);
}

Result<NearestRows> Index::k_nearest(const PointsView& places, std::size_t k,
                                     const RunOptions& run) const {
  core::KeptCrew crew(levels_->lent);
  core::StoppableCrew stoppable(crew.of(run.threads, places.size()), run.stop);
  core::Memory memory;
  return core::unless_stopped([&]() -> Result<NearestRows> {
    const Result<core::Bounds> bounds = measure(places, core::kPlacesName, {stoppable, memory});
    if (!bounds) return bounds.error();
    return search::find_nearest_of_all(*levels_, places, *bounds, std::min(k, size()), stoppable);
  });
}

Result<PointId> Index::insert(const Point& point) {
  if (auto error = check_place(point)) return *std::move(error);
  if (auto error = core::check_size(levels_->points.ids() + 1)) return *std::move(error);
  return levels_->points.insert(point);
}

Status Index::move(PointId id, const Point& point) {
  if (!contains(id)) return no_such_point(id);
  if (auto error = check_place(point)) return *std::move(error);
  levels_->points.move(id, point);
  return std::monostate{};
}

Status Index::remove(PointId id) {
  if (!contains(id)) return no_such_point(id);
  levels_->points.remove(id);
  return std::monostate{};
}

void Index::rebuild(unsigned threads) {
  core::KeptCrew crew(levels_->lent);
  levels_->points.rebuild(crew.of(threads, size()));
}

}  // namespace beespace
