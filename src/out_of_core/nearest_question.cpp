#include "out_of_core/nearest_question.hpp"

#include "exact/exact_distance.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace beespace::out_of_core {

namespace {

// Distances and differences are rounded a few times: by less than this, relatively.
constexpr double kAllowance = 0x1p-40;

// Rows that are told at a time.
constexpr std::size_t kRowsAtOnce = 4096;

// Nothing in the box is nearer; of coordinates up to 2^400 no square overflows.
double least_distance(const Point& place, const Box& box) {
  const auto outside = [](double at, double low, double high) {
    return std::max({0.0, low - at, at - high});
  };
  const double x = outside(place.x, box.low[0], box.high[0]);
  const double y = outside(place.y, box.low[1], box.high[1]);
  const double z = outside(place.z, box.low[2], box.high[2]);
  return std::sqrt(x * x + y * y + z * z) * (1.0 - kAllowance);
}

}  // namespace

void NearestQuestion::offer(Open& open, const Candidate& candidate) const {
  if (candidate.id == open.id) return;
  const auto nearer = [&](const Candidate& a, const Candidate& b) {
    const int sign = core::compare_distances(open.place, a.place, open.place, b.place);
    return sign < 0 || (sign == 0 && a.id < b.id);
  };
  const auto at = std::lower_bound(open.nearest.begin(), open.nearest.end(), candidate, nearer);
  if (at != open.nearest.end() && at->id == candidate.id) return;
  if (at == open.nearest.end() && open.nearest.size() == setting_.length) return;
  open.nearest.insert(at, candidate);
  if (open.nearest.size() > setting_.length) open.nearest.pop_back();
}

bool NearestQuestion::is_within_reach(double distance_m) const {
  return distance_m <= setting_.reach * (1.0 - kAllowance);
}

bool NearestQuestion::is_settled(const Open& open) const {
  return open.nearest.size() == setting_.length &&
         is_within_reach(distance(open.place, open.nearest.back().place));
}

bool NearestQuestion::may_be_nearer(const Open& open, const Box& box) const {
  return open.nearest.size() < setting_.length ||
         least_distance(open.place, box) <= distance(open.place, open.nearest.back().place);
}

Status NearestQuestion::find(const CellPoints& points) {
  return engine_.find_k_nearest(points.view(), setting_.length, rows_, setting_.run);
}

NearestQuestion::Open NearestQuestion::found(const CellPoints& points, std::size_t index) const {
  const PointsView view = points.view();
  Open open{points.id(index), view[index], {}};
  if (rows_.empty()) return open;
  for (const Nearest& near : rows_[index]) {
    open.nearest.push_back({points.id(near.id), view[near.id]});
  }
  return open;
}

Status NearestQuestion::ask(const CellPoints& points, const Cells& cells) {
  if (auto status = find(points); !status) return status;
  std::vector<Open> open;
  for (std::size_t index = 0; index < points.size(); ++index) {
    if (!points.is_home(index)) continue;
    // Most are settled, and go out as they are.
    if (rows_.length < setting_.length || !is_within_reach(rows_[index].back().distance_m)) {
      open.push_back(found(points, index));
      continue;
    }
    ids_.push_back(points.id(index));
    for (const Nearest& near : rows_[index]) {
      entries_.push_back({points.id(near.id), near.distance_m});
    }
    if (ids_.size() >= kRowsAtOnce) tell();
  }
  return settle(open, cells);
}

Status NearestQuestion::compare(std::vector<Open>& open, const std::vector<std::size_t>& some,
                                const CellPoints& points) {
  if (some.empty()) return std::monostate{};
  engine_.release_memory();
  const PointsView view = points.view();
  const auto index = Index::build(view, setting_.run);
  if (!index) return index.error();
  std::vector<Point> places;
  places.reserve(some.size());
  for (const std::size_t at : some) places.push_back(open[at].place);
  // One more, as it may be among them itself.
  const auto rows = index->k_nearest(places, setting_.length + 1, setting_.run);
  if (!rows) return rows.error();
  for (std::size_t row = 0; row < rows->size(); ++row) {
    for (const Nearest& near : (*rows)[row]) {
      offer(open[some[row]], {points.id(near.id), view[near.id]});
    }
  }
  return std::monostate{};
}

Status NearestQuestion::ask_crowded(const CrowdedCell& cell, const Cells& cells) {
  engine_.release_memory();
  CellPoints points;
  CellPoints others;
  std::vector<Open> open;
  std::vector<std::size_t> all;
  for (std::size_t piece = 0; piece < cell.pieces(); ++piece) {
    if (auto status = cell.read(piece, points); !status) return status;
    if (auto status = find(points); !status) return status;
    open.clear();
    for (std::size_t index = 0; index < points.size(); ++index) {
      if (points.is_home(index)) open.push_back(found(points, index));
    }
    all.resize(open.size());
    for (std::size_t at = 0; at < all.size(); ++at) all[at] = at;
    for (std::size_t other = 0; other < cell.pieces(); ++other) {
      if (other == piece) continue;
      if (auto status = cell.read(other, others); !status) return status;
      if (auto status = compare(open, all, others); !status) return status;
    }
    points.release();
    others.release();
    if (auto status = settle(open, cells); !status) return status;
  }
  return std::monostate{};
}

Status NearestQuestion::settle(std::vector<Open>& open, const Cells& cells) {
  for (Open& one : open) {
    if (is_settled(one)) {
      put(one);
    } else {
      waiting_.push_back(std::move(one));
    }
    if (waiting_.size() < setting_.most_waiting) continue;
    if (auto status = compare_waiting(cells); !status) return status;
  }
  tell();
  return std::monostate{};
}

Status NearestQuestion::compare_waiting(const Cells& cells) {
  CellPoints points;
  std::vector<std::size_t> near;
  for (std::size_t cell = 0; cell < cells.size(); ++cell) {
    if (cells.home_count(cell) == 0) continue;
    near.clear();
    for (std::size_t at = 0; at < waiting_.size(); ++at) {
      if (may_be_nearer(waiting_[at], cells.box(cell))) near.push_back(at);
    }
    if (near.empty()) continue;
    const CrowdedCell pieces(cells, cell, setting_.most_points, setting_.run.stop);
    for (std::size_t piece = 0; piece < pieces.pieces(); ++piece) {
      if (auto status = pieces.read(piece, points); !status) return status;
      if (auto status = compare(waiting_, near, points); !status) return status;
    }
  }
  for (const Open& one : waiting_) put(one);
  waiting_.clear();
  tell();
  return std::monostate{};
}

void NearestQuestion::put(const Open& open) {
  ids_.push_back(open.id);
  for (const Candidate& candidate : open.nearest) {
    entries_.push_back({candidate.id, distance(open.place, candidate.place)});
  }
  if (ids_.size() >= kRowsAtOnce) tell();
}

void NearestQuestion::tell() {
  if (!ids_.empty()) visit_(ids_, entries_);
  ids_.clear();
  entries_.clear();
}

Status NearestQuestion::finish(const Cells& cells) {
  return compare_waiting(cells);
}

}  // namespace beespace::out_of_core
