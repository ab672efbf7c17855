#include "cli/detect/reports/report.hpp"
#include "io/bytes/number_text.hpp"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>

namespace beespace::cli {
namespace {

using NearestList = std::vector<Nearest>;

// Whether the nearest are those too close only: with a vertical threshold, those in the cylinder.
bool is_within(const Question& question) {
  return question.at_risk_only || question.search.vertical_m;
}

Status find(const Question& question, NearestList& nearest) {
  Engine& engine = question.engine;
  const SearchOptions search = question.search.without_limit();
  const bool within = is_within(question);
  if (question.others == nullptr) {
    return within ? engine.find_nearest_within(question.points, search, nearest)
                  : engine.find_nearest(question.points, nearest, search.threads);
  }
  return within ? engine.find_nearest_within_between(question.points, *question.others, search,
                                                     nearest)
                : engine.find_nearest_between(question.points, *question.others, nearest,
                                              search.threads);
}

// Of an even number the mean of the two in the middle. Reorders the numbers, of which there are
// some.
double median(std::vector<double>& numbers) {
  const auto middle = numbers.begin() + static_cast<std::ptrdiff_t>(numbers.size() / 2);
  std::nth_element(numbers.begin(), middle, numbers.end());
  if (numbers.size() % 2 == 1) return *middle;
  return (*std::max_element(numbers.begin(), middle) + *middle) / 2.0;
}

std::string finding(const NearestList& nearest) {
  std::vector<double> distances;
  for (const Nearest& one : nearest) {
    if (one.id != Nearest::kNone) distances.push_back(one.distance_m);
  }
  if (distances.empty()) return "none";
  const double middle = median(distances);
  return io::length(middle) + " is the median, " +
         io::length(*std::max_element(distances.begin(), distances.end())) + " the farthest";
}

}  // namespace

Result<ReportFound> report_nearest(const Question& question) {
  const auto nearest = std::make_shared<NearestList>();
  const Status found = find(question, *nearest);
  if (!found) return found.error();
  const auto who = [nearest](PointId bee) -> Cell { return BeeCell{(*nearest)[bee].id}; };
  const auto how_far = [nearest](PointId bee) -> Cell {
    return DistanceCell{(*nearest)[bee].distance_m};
  };
  std::optional<std::vector<PointId>> at_risk;
  if (is_within(question)) {
    at_risk = bees_that(nearest->size(),
                        [&](std::size_t bee) { return (*nearest)[bee].id != Nearest::kNone; });
  }
  std::vector<PointId> listed = question.listed_bees(at_risk.value_or(std::vector<PointId>()));
  return ReportFound{
      Table{BeeTable{std::move(listed), {{"nearest", true, who}, {"distance_m", false, how_far}}},
            finding(*nearest)},
      std::move(at_risk)};
}

}  // namespace beespace::cli
