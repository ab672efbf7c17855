#include "cli/detect/out_of_core/large_search.hpp"

#include "cli/detect/detect_search.hpp"
#include "cli/detect/reports/neighbor_finding.hpp"
#include "io/bytes/number_text.hpp"
#include "io/bytes/worker_threads.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <functional>
#include <limits>
#include <string_view>
#include <utility>

namespace beespace::cli {
namespace {

OutOfCoreOptions options_of(const DetectRequest& request, const std::string& folder,
                            const LargeMemory& memory, ProgressBar& bar,
                            const std::stop_source& stop) {
  OutOfCoreOptions options;
  options.memory_bytes = memory.search;
  options.folder = folder;
  options.threads = request.search.threads;
  options.stop = stop.get_token();
  options.progress = [&bar](const OutOfCoreProgress& progress) {
    const bool first = progress.phase == OutOfCoreProgress::Phase::kDistributing;
    bar.enter_stage(first ? "distributing" : "searching");
    bar.set_share(static_cast<double>(progress.done) / static_cast<double>(progress.of));
  };
  return options;
}

}  // namespace

LargeMemory LargeMemory::of(const DetectRequest& request) {
  const std::uint64_t memory_bytes = *request.memory_bytes;
  constexpr std::size_t kLeastBlock = std::size_t{1} << 18U;
  constexpr std::size_t kMostBlock = std::size_t{1} << 25U;
  // What OutOfCore needs; below that it says so.
  const std::uint64_t least = (std::uint64_t{16} << 20U) * io::thread_count(request.search.threads);
  // The nearest take more than other questions; and several questions keep what each of them took.
  const bool takes_more =
      request.form.form == Form::kJson || std::string_view(request.report->name) == "nearest";
  LargeMemory memory{};
  memory.search = std::max(std::min(memory_bytes, least),
                           takes_more ? memory_bytes / 2 : memory_bytes - memory_bytes / 4);
  memory.rows = static_cast<std::size_t>(memory_bytes / 8);
  memory.texts = static_cast<std::size_t>(memory_bytes / 16);
  memory.block = std::clamp(static_cast<std::size_t>(memory_bytes / 64), kLeastBlock, kMostBlock);
  return memory;
}

LargeSearch::LargeSearch(const DetectRequest& request, const std::string& folder,
                         const LargeMemory& memory, ProgressBar& bar)
    : request_(request),
      options_(request.search.without_limit()),
      bar_(bar),
      points_(std::in_place, options_of(request, folder, memory, bar, stop_)),
      rows_(folder, memory.rows) {
}

void LargeSearch::set_heights(io::Unit height_unit, bool apart, TextStore* places) {
  heights_apart_ = apart;
  const io::Unit compared = io::compared_in(request_.vertical, height_unit);
  if (compared != io::Unit::kMetre) {
    options_.vertical_m = exactly_in(*request_.vertical, compared);
    height_unit_m_ = io::in_metric(1.0, compared);
  }
  places_ = places;
  fields_ = {places != nullptr, in_aviation(request_.load.units.convention, height_unit,
                                            request_.threshold, request_.vertical)};
}

bool LargeSearch::is(const char* report) const {
  return std::string_view(request_.report->name) == report;
}

Status LargeSearch::find() {
  at_risk_.resize(size());
  Status status = std::monostate{};
  if (is("pairs") || is("neighbors")) status = find_pairs(is("neighbors"));
  if (is("counts")) status = find_counts();
  if (is("nearest")) status = find_nearest();
  if (is("closest-pair")) status = find_closest();
  const bool in_json = request_.form.form == Form::kJson;
  const bool asks_risk =
      is("at-risk") || in_json || request_.fail_on_risk || (is("nearest") && request_.at_risk_only);
  if (status && asks_risk && !knows_at_risk_) status = find_at_risk();
  if (status && in_json && !knows_closest_) status = find_closest();
  return status;
}

// There is no use in searching on.
void LargeSearch::stop_on_failure() {
  if (is_beyond_limit_ || !rows_.status()) stop_.request_stop();
}

Status LargeSearch::ended(Status status) const {
  if (is_beyond_limit_) return too_many_results(request_);
  if (!rows_.status()) return rows_.status();
  return status;
}

Status LargeSearch::find_at_risk() {
  knows_at_risk_ = true;
  return points_->find_at_risk(options_, [&](std::span<const LargeId> ids) {
    for (const LargeId id : ids) at_risk_.set(id);
  });
}

Status LargeSearch::find_pairs(bool both_ways) {
  knows_at_risk_ = true;
  return ended(points_->visit_pairs(
      options_, [&](std::span<const LargePair> pairs, std::span<const double> distances_m) {
        pairs_ += pairs.size();
        neighbors_ += 2 * pairs.size();
        is_beyond_limit_ = (both_ways ? neighbors_ : pairs_) > request_.search.max_results;
        for (std::size_t at = 0; at < pairs.size() && !is_beyond_limit_; ++at) {
          const auto [first, second] = pairs[at];
          at_risk_.set(first);
          at_risk_.set(second);
          rows_.add({first, second, distances_m[at]});
          if (both_ways) rows_.add({second, first, distances_m[at]});
        }
        stop_on_failure();
      }));
}

Status LargeSearch::find_counts() {
  knows_at_risk_ = true;
  return ended(points_->count_neighbors(
      options_, [&](std::span<const LargeId> ids, std::span<const std::uint64_t> counts) {
        for (std::size_t at = 0; at < ids.size(); ++at) {
          if (counts[at] == 0) continue;
          at_risk_.set(ids[at]);
          rows_.add({ids[at], counts[at], 0.0});
          neighbors_ += counts[at];
          most_neighbors_ = std::max(most_neighbors_, counts[at]);
        }
        stop_on_failure();
      }));
}

Status LargeSearch::find_nearest() {
  return ended(points_->find_k_nearest(
      1, [&](std::span<const LargeId> ids, std::span<const LargeNearest> nearest) {
        for (std::size_t at = 0; at < ids.size(); ++at) {
          rows_.add({ids[at], nearest[at].id, nearest[at].distance_m});
          farthest_m_ = std::max(farthest_m_, nearest[at].distance_m);
        }
        stop_on_failure();
      }));
}

Status LargeSearch::find_closest() {
  const auto closest = points_->find_closest_pair();
  if (!closest) return closest.error();
  closest_ = *closest;
  knows_closest_ = true;
  return std::monostate{};
}

void LargeSearch::release() {
  size_ = points_->size();
  facts_ = points_->facts();
  points_.reset();
}

std::string LargeSearch::finding() const {
  if (is("pairs")) return pairs_ == 0 ? "none" : io::grouped(pairs_);
  if (is("neighbors") || is("counts")) {
    return neighbor_finding(neighbors_, size(), most_neighbors_);
  }
  if (is("nearest")) {
    return rows_.size() == 0 ? "none" : io::length(farthest_m_) + " the farthest";
  }
  return {};
}

// With a vertical threshold the search knows no straight line between the two.
LargeSearch::LargeDistance LargeSearch::distance_of(const LargeRow& pair) {
  if (places_ == nullptr) return {pair.distance_m};
  std::array<LargePlace, 2> places;
  for (std::size_t at = 0; at < 2; ++at) {
    const std::string_view bytes = places_->text(at == 0 ? pair.first : pair.second);
    if (bytes.size() != sizeof(LargePlace)) return {};  // said by its status
    std::memcpy(&places[at], bytes.data(), sizeof(LargePlace));
  }
  const auto& [a, b] = places;
  return {distance(a.place, b.place),
          heights_apart_ ? analysis::apart(a.ground, a.height, b.ground, b.height, height_unit_m_)
                         : analysis::apart(a.place, b.place)};
}

// Rows come by their first point.
void LargeSearch::show_share(LargeId id) {
  if (++shown_ % 4096 == 0) bar_.set_share(static_cast<double>(id) / static_cast<double>(size()));
}

void LargeSearch::for_each_row(const std::function<void(const LargeRow&)>& visit) {
  rows_.for_each([&](const LargeRow& row) {
    show_share(row.first);
    visit(row);
  });
}

Status LargeSearch::write(LargeTable& table) {
  if (is("at-risk")) {
    table.begin_bees({});
    at_risk_.for_each([&](LargeId id) {
      show_share(id);
      table.bee(id, {});
    });
  } else if (is("pairs")) {
    table.begin_pairs(fields_);
    for_each_row([&](const LargeRow& row) {
      const LargeDistance far = distance_of(row);
      table.pair({row.first, row.second}, far.distance_m, far.apart);
    });
  } else if (is("closest-pair")) {
    table.begin_pairs({});
    if (closest_) table.pair(closest_->pair, closest_->distance_m, {});
  } else if (is("counts")) {
    write_counts(table);
  } else if (is("neighbors")) {
    write_neighbors(table);
  } else {
    write_nearest(table);
  }
  table.end();
  return rows_.status();
}

void LargeSearch::write_lonely(LargeTable& table, LargeId& next, LargeId end,
                               std::span<const LargeCell> cells) const {
  for (; next < end && !request_.at_risk_only; ++next) table.bee(next, cells);
  next = end + 1;
}

void LargeSearch::write_counts(LargeTable& table) {
  table.begin_bees({{"neighbor_count", false}});
  const std::array<LargeCell, 1> none = {std::uint64_t{0}};
  LargeId next = 0;
  for_each_row([&](const LargeRow& row) {
    write_lonely(table, next, row.first, none);
    table.bee(row.first, std::array<LargeCell, 1>{row.second});
  });
  write_lonely(table, next, size(), none);
}

void LargeSearch::write_neighbors(LargeTable& table) {
  table.begin_bees({{"neighbor_count", false}, {"neighbors", true}});
  const std::array<LargeCell, 2> none = {std::uint64_t{0}, std::span<const LargeId>()};
  LargeId next = 0;
  LargeId bee = 0;
  std::vector<LargeId> neighbors;  // of it
  const auto write_bee = [&] {
    if (neighbors.empty()) return;
    write_lonely(table, next, bee, none);
    table.bee(bee, std::array<LargeCell, 2>{std::uint64_t{neighbors.size()},
                                            std::span<const LargeId>(neighbors)});
    most_neighbors_ = std::max<std::uint64_t>(most_neighbors_, neighbors.size());
    neighbors.clear();
  };
  for_each_row([&](const LargeRow& row) {
    if (row.first != bee) write_bee();
    bee = row.first;
    neighbors.push_back(row.second);
  });
  write_bee();
  write_lonely(table, next, size(), none);
}

void LargeSearch::write_nearest(LargeTable& table) {
  table.begin_bees({{"nearest", true}, {"distance_m", false}});
  for_each_row([&](const LargeRow& row) {
    if (request_.at_risk_only && !at_risk_[row.first]) return;
    table.bee(row.first,
              std::array<LargeCell, 2>{LargeBeeCell{row.second}, DistanceCell{row.distance_m}});
  });
  if (size() > 1 || request_.at_risk_only) return;
  // A bee that is alone.
  table.bee(0, std::array<LargeCell, 2>{LargeBeeCell{},
                                        DistanceCell{std::numeric_limits<double>::infinity()}});
}

}  // namespace beespace::cli
