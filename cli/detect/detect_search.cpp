#include "cli/detect/detect_search.hpp"

#include "analysis/geometry/apart.hpp"
#include "analysis/geometry/ground_places.hpp"
#include "analysis/snapshot/closest_in_conflict.hpp"
#include "io/bytes/number_text.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>

namespace beespace::cli {
namespace {

using Closest = std::optional<ClosestPair>;

// With a vertical threshold: who is closest of all may keep apart in height. Mostly it does not.
Result<bool> is_in_conflict(Engine& engine, const PointsView& places, const SearchOptions& options,
                            const ClosestPair& pair) {
  const std::vector<Point> both{places[pair.first], places[pair.second]};
  std::vector<double> heights_m;
  if (places.has_heights()) {
    heights_m = {places.heights_m()[pair.first], places.heights_m()[pair.second]};
  }
  std::vector<PointId> at_risk;
  const PointsView of_both = PointsView(both).with_heights(heights_m);
  if (Status found = engine.find_at_risk(of_both, options, at_risk); !found) {
    return std::move(found).error();
  }
  return !at_risk.empty();
}

// Looks at every pair.
Result<Closest> closest_pair_in_conflict(Engine& engine, const PointsView& places,
                                         const std::vector<Point>& points,
                                         const SearchOptions& options,
                                         const std::vector<PointId>& at_risk) {
  const auto closest = analysis::closest_in_conflict(engine, places, points, options, at_risk);
  if (!closest) return closest.error();
  const auto best = std::min_element(
      closest->begin(), closest->end(),
      [](const Nearest& a, const Nearest& b) { return a.distance_m < b.distance_m; });
  return Closest(
      {at_risk[static_cast<std::size_t>(best - closest->begin())], best->id, best->distance_m});
}

// The closest pair of all. When bees are at risk, both of the pair are (with others: the first
// is), so that it is enough to look among these; their order is that of all, so that ties are
// decided alike.
Result<Closest> closest_pair(Engine& engine, const Inputs& inputs,
                             const std::vector<PointId>& at_risk, const SearchOptions& options) {
  const unsigned threads = options.threads;
  const std::vector<Point>& points = inputs.ours.points;
  const auto find = [&](const std::vector<Point>& among) {
    return inputs.others ? engine.find_closest_pair_between(among, inputs.others->points, threads)
                         : engine.find_closest_pair(among, threads);
  };
  if (at_risk.empty() || at_risk.size() > points.size() / 2) return find(points);
  std::vector<Point> some;
  some.reserve(at_risk.size());
  for (const PointId id : at_risk) some.push_back(points[id]);
  auto found = find(some);
  if (!found || !*found) return found;
  ClosestPair pair = **found;
  pair.first = at_risk[pair.first];
  if (!inputs.others) pair.second = at_risk[pair.second];
  return Closest(pair);
}

// Of a bee and another of the others: both in the cylinder, and by its straight line.
Result<Closest> closest_pair_between(Engine& engine, const PointsView& points,
                                     const PointsView& others, const SearchOptions& options) {
  std::vector<Nearest> nearest;
  if (Status found = engine.find_nearest_within_between(points, others, options, nearest); !found) {
    return std::move(found).error();
  }
  const auto best = std::min_element(
      nearest.begin(), nearest.end(),
      [](const Nearest& a, const Nearest& b) { return a.distance_m < b.distance_m; });
  return Closest({static_cast<PointId>(best - nearest.begin()), best->id, best->distance_m});
}

// With a vertical threshold, how far apart the pairs are in what it compares.
void tell_apart(PairTable& table, const Question& question, const DetectRequest& request,
                io::Unit height_unit) {
  if (!request.vertical) return;
  table.fields = {true, in_aviation(request.load.units.convention, height_unit, request.threshold,
                                    request.vertical)};
  const PointsView& ours = question.points;
  const PointsView& theirs = question.others != nullptr ? *question.others : question.points;
  const double unit_m = io::in_metric(1.0, io::compared_in(request.vertical, height_unit));
  table.apart.reserve(table.pairs.size());
  for (const Pair& pair : table.pairs) {
    const Point a = ours[pair.first];
    const Point b = theirs[pair.second];
    table.apart.push_back(ours.has_heights()
                              ? analysis::apart(a, ours.heights_m()[pair.first], b,
                                                theirs.heights_m()[pair.second], unit_m)
                              : analysis::apart(a, b));
  }
}

// The library speaks to those who call it.
Error in_words_of_the_command(const Error& error, const DetectRequest& request) {
  return error.code == ErrorCode::kTooManyResults ? too_many_results(request) : error;
}

// The closest pair that is told: of all; with a vertical threshold, where some are at risk, of
// those in conflict.
Result<Closest> told_pair(const Question& question, const Inputs& inputs,
                          const DetectRequest& request, const std::vector<PointId>& at_risk) {
  const SearchOptions search = question.search.without_limit();
  auto closest = closest_pair(question.engine, inputs, at_risk, search);
  if (!closest || !request.vertical || at_risk.empty()) return closest;
  if (question.others != nullptr) {
    closest = closest_pair_between(question.engine, question.points, *question.others, search);
    if (!closest) return closest;
    // What is shown is the distance in space, as elsewhere.
    ClosestPair& pair = **closest;
    pair.distance_m = distance(inputs.ours.points[pair.first], inputs.others->points[pair.second]);
    return closest;
  }
  const auto conflict = is_in_conflict(question.engine, question.points, search, **closest);
  if (!conflict) return conflict.error();
  if (*conflict) return closest;
  return closest_pair_in_conflict(question.engine, question.points, inputs.ours.points, search,
                                  at_risk);
}

}  // namespace

Error too_many_results(const DetectRequest& request) {
  const bool pairs = std::string_view(request.report->name) == "pairs";
  return {ErrorCode::kTooManyResults,
          "there are more than " + io::grouped(request.search.max_results) +
              (pairs ? " pairs" : " neighbours") + "; raise --max-results, or lower the threshold",
          {}};
}

Result<Detection> search(const Inputs& inputs, const DetectRequest& request) {
  Engine engine;
  Detection detection;
  const io::Unit height_unit = inputs.height_unit();
  const analysis::GroundPlaces places =
      analysis::ground_places(inputs.ours, request.vertical, height_unit);
  const analysis::GroundPlaces other_places =
      inputs.others ? analysis::ground_places(*inputs.others, request.vertical, height_unit)
                    : analysis::GroundPlaces();
  PairOptions options = request.search;
  options.vertical_m = places.vertical_m;
  const PointsView points = places.view(inputs.ours.points);
  PointsView of_others;
  if (inputs.others) of_others = other_places.view(inputs.others->points);
  const PointsView* const others = inputs.others ? &of_others : nullptr;
  const Question question{engine, points, others, options, request.at_risk_only};
  const bool is_closest_pair = request.report->find == nullptr;
  std::optional<std::vector<PointId>> at_risk;
  if (!is_closest_pair) {
    auto found = request.report->find(question);
    if (!found) return in_words_of_the_command(found.error(), request);
    detection.table = std::move(found->table);
    at_risk = std::move(found->at_risk);
    if (auto* pairs = std::get_if<PairTable>(&detection.table.rows)) {
      tell_apart(*pairs, question, request, height_unit);
    }
  }
  const bool is_told = !request.quiet || request.form.form == Form::kJson;
  // Who is at risk follows from most answers.
  if (at_risk) {
    detection.at_risk = *std::move(at_risk);
  } else if (is_told || request.fail_on_risk) {
    if (Status found = find_at_risk(question, detection.at_risk); !found) return found.error();
  }
  if (is_told || is_closest_pair) {
    auto closest = told_pair(question, inputs, request, detection.at_risk);
    if (!closest) return std::move(closest).error();
    detection.closest = *closest;
  }
  if (is_closest_pair) {
    PairTable pair;
    if (detection.closest)
      pair.pairs.push_back({detection.closest->first, detection.closest->second});
    detection.table = Table{std::move(pair)};
  }
  return detection;
}

}  // namespace beespace::cli
