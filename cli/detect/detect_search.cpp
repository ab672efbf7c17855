#include "cli/detect/detect_search.hpp"

#include "cli/analysis/closest_in_conflict.hpp"
#include "cli/analysis/ground_places.hpp"
#include "cli/analysis/number_text.hpp"

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
  const auto closest = closest_in_conflict(engine, places, points, options, at_risk);
  if (!closest) return closest.error();
  const auto best = std::min_element(
      closest->begin(), closest->end(),
      [](const Nearest& a, const Nearest& b) { return a.distance_m < b.distance_m; });
  return Closest(
      {at_risk[static_cast<std::size_t>(best - closest->begin())], best->id, best->distance_m});
}

// The closest pair of all. When somebody is at risk, both of the pair are (with others: the first
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

Status find_at_risk(Engine& engine, const PointsView& points, const PointsView* others,
                    const SearchOptions& options, std::vector<PointId>& at_risk) {
  if (others == nullptr) return engine.find_at_risk(points, options, at_risk);
  return engine.find_at_risk_between(points, *others, options, at_risk);
}

// The library speaks to those who call it; here --max-results is what they can turn.
Error in_words_of_the_command(Error error, const DetectRequest& request) {
  if (error.code != ErrorCode::kTooManyResults) return error;
  const bool pairs = std::string_view(request.report->name) == "pairs";
  error.message = std::string("there are more than ") + grouped(request.search.max_results) +
                  (pairs ? " pairs" : " neighbours") +
                  "; raise --max-results, or lower the threshold";
  return error;
}

}  // namespace

Result<Detection> search(const Inputs& inputs, const DetectRequest& request) {
  Engine engine;
  Detection detection;
  const bool vertical = request.vertical.has_value();
  const io::Unit height_unit = inputs.height_unit();
  const GroundPlaces places = ground_places(inputs.ours, request.vertical, height_unit);
  const GroundPlaces other_places =
      inputs.others ? ground_places(*inputs.others, request.vertical, height_unit) : GroundPlaces();
  PairOptions limited = request.search;
  limited.vertical_m = places.vertical_m;
  const SearchOptions options = limited.without_limit();
  const PointsView points = places.view(inputs.ours.points);
  PointsView of_others;
  if (inputs.others) of_others = other_places.view(inputs.others->points);
  const PointsView* const others = inputs.others ? &of_others : nullptr;
  const Status at_risk = find_at_risk(engine, points, others, options, detection.at_risk);
  if (!at_risk) return at_risk.error();
  if (!request.quiet || request.form.form == Form::kJson || request.report->needs_closest) {
    auto closest = closest_pair(engine, inputs, detection.at_risk, options);
    if (!closest) return std::move(closest).error();
    if (vertical && others != nullptr && !detection.at_risk.empty()) {
      closest = closest_pair_between(engine, points, *others, options);
      if (!closest) return std::move(closest).error();
      // What is shown is the distance in space, as elsewhere.
      ClosestPair& pair = **closest;
      pair.distance_m =
          distance(inputs.ours.points[pair.first], inputs.others->points[pair.second]);
    } else if (vertical && !detection.at_risk.empty()) {
      const auto conflict = is_in_conflict(engine, points, options, **closest);
      if (!conflict) return conflict.error();
      if (!*conflict) {
        closest = closest_pair_in_conflict(engine, points, inputs.ours.points, options,
                                           detection.at_risk);
        if (!closest) return std::move(closest).error();
      }
    }
    detection.closest = *closest;
  }
  const Question question{
      engine, points, others, limited, request.at_risk_only, detection.at_risk, detection.closest};
  auto table = request.report->find(question);
  if (!table) return in_words_of_the_command(std::move(table).error(), request);
  detection.table = *std::move(table);
  return detection;
}

}  // namespace beespace::cli
