#include "tree/nearest_list.hpp"

#include "exact/exact_distance.hpp"

#include <algorithm>
#include <cmath>

namespace beespace::core {

namespace {

constexpr double kMore = 1.0 + 0x1p-49;  // as in is_surely_nearer

}  // namespace

void NearestList::start(const Point& place, std::size_t count, double reach_within_m) {
  place_ = place;
  most = count;
  is_full = false;
  found_.clear();
  found_.reserve(std::min(most, kMostSorted));
  // A point within reach has a squared_distance of at most its square, 5 u more for that and one
  // for each of these products.
  largest_squared = reach_within_m * reach_within_m * kMore;
}

bool NearestList::is_before(const Candidate& a, const Candidate& b) const {
  if (is_surely_nearer(a.squared, b.squared)) return true;
  if (is_surely_nearer(b.squared, a.squared)) return false;
  if (*a.point == *b.point) return a.id < b.id;
  const int order = compare_distances(*a.point, place_, *b.point, place_);
  return order != 0 ? order < 0 : a.id < b.id;
}

// Points as near as the last one have a true square of at most 5 u more than the last one's rounded
// square, and a rounded one of at most 10 u more.
void NearestList::limit() {
  largest_squared = last().squared * kMore;
}

double NearestList::reach_m() const {
  return std::sqrt(largest_squared) * (1.0 + 0x1p-52);
}

void NearestList::insert(const Candidate& candidate) {
  if (!is_full) found_.push_back(candidate);
  std::size_t at = found_.size() - 1;
  for (; at > 0 && is_before(candidate, found_[at - 1]); --at) found_[at] = found_[at - 1];
  found_[at] = candidate;
}

void NearestList::push(const Candidate& candidate) {
  const auto before = [this](const Candidate& a, const Candidate& b) { return is_before(a, b); };
  if (is_full) {
    std::pop_heap(found_.begin(), found_.end(), before);
    found_.back() = candidate;
    std::push_heap(found_.begin(), found_.end(), before);
    return;
  }
  found_.push_back(candidate);
  if (found_.size() == most) std::make_heap(found_.begin(), found_.end(), before);
}

void NearestList::offer(const Point& point, PointId id, double squared) {
  const Candidate candidate{squared, &point, id};
  if (is_full && !is_before(candidate, last())) return;
  if (is_sorted()) {
    insert(candidate);
  } else {
    push(candidate);
  }
  is_full = found_.size() == most;
  if (is_full) limit();
}

bool NearestList::would_take(const Point& point, PointId id) const {
  if (!is_full) return true;
  return is_before({squared_distance(point, place_), &point, id}, last());
}

std::size_t NearestList::write(Nearest* nearest) {
  const std::size_t count = found_.size();
  if (!is_sorted()) {
    std::sort(found_.begin(), found_.end(),
              [this](const Candidate& a, const Candidate& b) { return is_before(a, b); });
  }
  for (std::size_t i = 0; i < count; ++i) {
    nearest[i] = {found_[i].id, distance(*found_[i].point, place_)};
  }
  found_.clear();
  return count;
}

}  // namespace beespace::core
