#include "out_of_core/questions.hpp"

#include "exact/exact_distance.hpp"

#include <algorithm>
#include <span>

namespace beespace::out_of_core {

namespace {

void append(PointMemory& to, const PointsView& points, std::size_t index) {
  to.points.push_back(points[index]);
  if (points.has_heights()) to.heights.push_back(points.heights_m()[index]);
}

void clear(PointMemory& memory) {
  memory.points.clear();
  memory.heights.clear();
}

PointsView view_of(const PointMemory& memory) {
  return PointsView(memory.points).with_heights(memory.heights);
}

}  // namespace

void AtRiskQuestion::tell() {
  if (!ids_.empty()) visit_(ids_);
  ids_.clear();
}

Status AtRiskQuestion::ask(const CellPoints& points, const Cells& /*cells*/) {
  if (auto status = engine_.find_at_risk(points.view(), options_, found_); !status) return status;
  for (const PointId point : found_) {
    if (points.is_home(point)) ids_.push_back(points.id(point));
  }
  tell();
  return std::monostate{};
}

Status AtRiskQuestion::ask_crowded(const CrowdedCell& cell, const Cells& /*cells*/) {
  engine_.release_memory();
  CellPoints points;
  open_.clear();
  clear(open_points_);
  for (std::size_t piece = 0; piece < cell.pieces(); ++piece) {
    if (auto status = cell.read(piece, points); !status) return status;
    if (auto status = engine_.find_at_risk(points.view(), options_, found_); !status) return status;
    auto next = found_.begin();
    for (std::size_t index = 0; index < points.size(); ++index) {
      const bool found = next != found_.end() && *next == index;
      if (found) ++next;
      if (!points.is_home(index)) continue;
      if (found) {
        ids_.push_back(points.id(index));
      } else {
        open_.push_back({points.id(index), piece});
        append(open_points_, points.view(), index);
      }
    }
    tell();
    // As many as a piece has are enough at a time.
    if (open_.size() < points.size() / 2 && piece + 1 < cell.pieces()) continue;
    points.release();
    if (auto status = ask_open(cell); !status) return status;
  }
  return std::monostate{};
}

Status AtRiskQuestion::ask_open(const CrowdedCell& cell) {
  CellPoints others;
  open_at_risk_.assign(open_.size(), false);
  std::vector<std::size_t> asked;
  PointMemory places;
  for (std::size_t piece = 0; piece < cell.pieces(); ++piece) {
    asked.clear();
    clear(places);
    for (std::size_t at = 0; at < open_.size(); ++at) {
      if (open_[at].piece == piece || open_at_risk_[at]) continue;
      asked.push_back(at);
      append(places, view_of(open_points_), at);
    }
    if (asked.empty()) continue;
    if (auto status = cell.read(piece, others); !status) return status;
    auto status = engine_.find_at_risk_between(view_of(places), others.view(), options_, found_);
    if (!status) return status;
    for (const PointId place : found_) open_at_risk_[asked[place]] = true;
  }
  for (std::size_t at = 0; at < open_.size(); ++at) {
    if (open_at_risk_[at]) ids_.push_back(open_[at].id);
  }
  tell();
  open_.clear();
  clear(open_points_);
  return std::monostate{};
}

Status CountQuestion::count(const CellPoints& points) {
  auto status = engine_.count_neighbors(points.view(), options_, counts_);
  sums_.assign(counts_.begin(), counts_.end());
  return status;
}

void CountQuestion::tell(const CellPoints& points) {
  ids_.clear();
  std::size_t kept = 0;
  for (std::size_t index = 0; index < points.size(); ++index) {
    if (!points.is_home(index)) continue;
    ids_.push_back(points.id(index));
    sums_[kept++] = sums_[index];
  }
  if (kept > 0) visit_(ids_, std::span(sums_).first(kept));
}

Status CountQuestion::ask(const CellPoints& points, const Cells& /*cells*/) {
  if (auto status = count(points); !status) return status;
  tell(points);
  return std::monostate{};
}

Status CountQuestion::ask_crowded(const CrowdedCell& cell, const Cells& /*cells*/) {
  engine_.release_memory();
  CellPoints points;
  CellPoints others;
  for (std::size_t piece = 0; piece < cell.pieces(); ++piece) {
    if (auto status = cell.read(piece, points); !status) return status;
    if (auto status = count(points); !status) return status;
    for (std::size_t other = 0; other < cell.pieces(); ++other) {
      if (other == piece) continue;
      if (auto status = cell.read(other, others); !status) return status;
      auto status =
          engine_.count_neighbors_between(points.view(), others.view(), options_, counts_);
      if (!status) return status;
      for (std::size_t index = 0; index < counts_.size(); ++index) sums_[index] += counts_[index];
    }
    tell(points);
  }
  return std::monostate{};
}

void PairsQuestion::keep(const CellPoints& points, std::size_t first, const CellPoints& others,
                         std::size_t second) {
  if (!points.is_home(first)) return;
  pairs_.push_back({points.id(first), others.id(second)});
  distances_m_.push_back(distance_of(points.view(), first, others.view(), second));
}

double PairsQuestion::distance_of(const PointsView& points, std::size_t first,
                                  const PointsView& others, std::size_t second) const {
  if (!points.has_heights()) return distance(points[first], others[second]);
  return line_.length(core::upright(points, true)[first], core::upright(others, true)[second]);
}

void PairsQuestion::tell() {
  if (!pairs_.empty()) visit_(pairs_, distances_m_);
  pairs_.clear();
  distances_m_.clear();
}

Status PairsQuestion::ask(const CellPoints& points, const Cells& /*cells*/) {
  // Ids ascend, so the first of a pair is that with the lower id.
  const auto done = engine_.visit_pairs(points.view(), options_, [&](std::span<const Pair> found) {
    for (const Pair& pair : found) keep(points, pair.first, points, pair.second);
    tell();
    return true;
  });
  if (!done) return done.error();
  return std::monostate{};
}

Status PairsQuestion::ask_crowded(const CrowdedCell& cell, const Cells& cells) {
  engine_.release_memory();
  CellPoints points;
  CellPoints others;
  for (std::size_t piece = 0; piece < cell.pieces(); ++piece) {
    if (auto status = cell.read(piece, points); !status) return status;
    if (auto status = ask(points, cells); !status) return status;
    for (std::size_t other = piece + 1; other < cell.pieces(); ++other) {
      if (auto status = cell.read(other, others); !status) return status;
      if (auto status = ask_some(points, 0, points.size(), others); !status) return status;
    }
  }
  return std::monostate{};
}

Status PairsQuestion::ask_some(const CellPoints& points, std::size_t begin, std::size_t end,
                               const CellPoints& others) {
  PairOptions options = options_;
  // Of a single point there are never more than others.
  if (end - begin > 1) options.max_results = most_;
  auto status = engine_.find_pairs_between(part_of(points.view(), begin, end - begin),
                                           others.view(), options, found_);
  if (!status) {
    if (status.error().code != ErrorCode::kTooManyResults) return status;
    const std::size_t middle = begin + (end - begin) / 2;
    if (auto first = ask_some(points, begin, middle, others); !first) return first;
    return ask_some(points, middle, end, others);
  }
  for (const Pair& pair : found_) keep(points, begin + pair.first, others, pair.second);
  tell();
  return std::monostate{};
}

Status ClosestPairQuestion::ask(const CellPoints& points, const Cells& /*cells*/) {
  // Ids ascend, so that of equally close pairs that with the lowest ids is found.
  const auto found = engine_.find_closest_pair(points.view(), run_);
  if (!found) return found.error();
  if (!*found) return std::monostate{};
  const auto& [first, second, distance_m] = **found;
  offer({{points.id(first), points.id(second)}, points.view()[first], points.view()[second]});
  return std::monostate{};
}

Status ClosestPairQuestion::ask_between(const CellPoints& points, const CellPoints& others) {
  const auto found = engine_.find_closest_pair_between(points.view(), others.view(), run_);
  if (!found) return found.error();
  const auto& [first, second, distance_m] = **found;
  offer({{points.id(first), others.id(second)}, points.view()[first], others.view()[second]});
  return std::monostate{};
}

Status ClosestPairQuestion::ask_crowded(const CrowdedCell& cell, const Cells& cells) {
  engine_.release_memory();
  CellPoints points;
  CellPoints others;
  for (std::size_t piece = 0; piece < cell.pieces(); ++piece) {
    if (auto status = cell.read(piece, points); !status) return status;
    if (auto status = ask(points, cells); !status) return status;
    for (std::size_t other = piece + 1; other < cell.pieces(); ++other) {
      if (auto status = cell.read(other, others); !status) return status;
      if (auto status = ask_between(points, others); !status) return status;
    }
  }
  return std::monostate{};
}

void ClosestPairQuestion::offer(const Candidate& candidate) {
  if (best_) {
    const int sign =
        core::compare_distances(candidate.first, candidate.second, best_->first, best_->second);
    if (sign > 0 || (sign == 0 && candidate.pair > best_->pair)) return;
  }
  best_ = candidate;
}

std::optional<LargeClosestPair> ClosestPairQuestion::closest() const {
  if (!best_) return std::nullopt;
  return LargeClosestPair{best_->pair, distance(best_->first, best_->second)};
}

}  // namespace beespace::out_of_core
