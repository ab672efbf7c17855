#include "index/changing_points.hpp"

#include <utility>

namespace beespace::search {

ChangingPoints::ChangingPoints(const PointsView& points, const core::Bounds& bounds, Crew& crew)
    : level_(points.size(), 0), place_(points.size()), size_(points.size()) {
  if (points.empty()) return;
  trees_.emplace_back(points, nullptr, bounds, crew);
  kept_ = points.size();
  crew.split(kept_, [&](std::size_t begin, std::size_t end, unsigned) {
    for (std::size_t slot = begin; slot < end; ++slot) {
      const auto place = static_cast<std::uint32_t>(slot);
      place_[trees_[0].id(place)] = place;
    }
  });
}

const Point& ChangingPoints::point(PointId id) const {
  const Level level = level_[id];
  return level == kRecent ? recent_[place_[id]].point : trees_[level].point(place_[id]);
}

PointId ChangingPoints::insert(const Point& point) {
  const auto id = static_cast<PointId>(ids());
  level_.push_back(kGone);
  place_.push_back(0);
  put_among_recent(id, point);
  ++size_;
  return id;
}

void ChangingPoints::move(PointId id, const Point& point) {
  if (level_[id] == kRecent) {
    recent_[place_[id]].point = point;
    return;
  }
  take_out(id);
  put_among_recent(id, point);
}

void ChangingPoints::remove(PointId id) {
  take_out(id);
  --size_;
  Crew alone;
  if (kept_ > kMostRecent && kept_ > 2 * size_) rebuild(alone);
}

void ChangingPoints::rebuild(Crew& crew) {
  merge_from(0, crew);
}

void ChangingPoints::put_among_recent(PointId id, const Point& point) {
  if (recent_.size() == kMostRecent) {
    std::size_t together = recent_.size();
    std::size_t first = trees_.size();
    while (first > 0 && trees_[first - 1].size() < kShrink * together) {
      together += trees_[--first].size();
    }
    if (kept_ > 2 * size_) first = 0;
    Crew alone;
    merge_from(first, alone);
  }
  level_[id] = kRecent;
  place_[id] = static_cast<std::uint32_t>(recent_.size());
  recent_.push_back({point, id});
}

void ChangingPoints::take_out(PointId id) {
  const std::uint32_t place = place_[id];
  if (level_[id] == kRecent) {
    recent_[place] = recent_.back();
    place_[recent_[place].id] = place;
    recent_.pop_back();
  } else {
    trees_[level_[id]].discard(place);
  }
  level_[id] = kGone;
}

void ChangingPoints::merge_from(std::size_t first, Crew& crew) {
  std::vector<Point> points;
  std::vector<PointId> ids;
  const auto add = [&](const Point& point, PointId id) {
    points.push_back(point);
    ids.push_back(id);
  };
  for (std::size_t tree = first; tree < trees_.size(); ++tree) {
    for (std::uint32_t slot = 0; slot < trees_[tree].size(); ++slot) {
      const PointId id = trees_[tree].id(slot);
      if (level_[id] == tree && place_[id] == slot) add(trees_[tree].point(slot), id);
    }
  }
  for (const Recent& recent : recent_) add(recent.point, recent.id);
  std::vector<core::PointTree> merged;  // first, so that nothing is lost when memory is
  if (!points.empty()) {
    core::Memory memory;
    merged.emplace_back(points, ids.data(), *core::measure(points, {crew, memory}), crew);
    trees_.reserve(first + 1);
  }
  for (std::size_t tree = first; tree < trees_.size(); ++tree) kept_ -= trees_[tree].size();
  trees_.erase(trees_.begin() + static_cast<std::ptrdiff_t>(first), trees_.end());
  recent_.clear();
  if (merged.empty()) return;
  trees_.push_back(std::move(merged.front()));
  kept_ += points.size();
  note_places(first);
}

void ChangingPoints::note_places(std::size_t tree) {
  for (std::uint32_t slot = 0; slot < trees_[tree].size(); ++slot) {
    const PointId id = trees_[tree].id(slot);
    level_[id] = static_cast<Level>(tree);
    place_[id] = slot;
  }
}

}  // namespace beespace::search
