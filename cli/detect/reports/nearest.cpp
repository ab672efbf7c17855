#include "cli/analysis/number_text.hpp"
#include "cli/detect/reports/report.hpp"

#include <algorithm>
#include <cstddef>
#include <memory>

namespace beespace::cli {
namespace {

using NearestList = std::vector<Nearest>;

Status find(const Question& question, NearestList& nearest) {
  Engine& engine = question.engine;
  const SearchOptions search = question.search.without_limit();
  // With a vertical threshold the nearest are those in the cylinder.
  const bool within = question.at_risk_only || search.vertical_m;
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
    if (one.id != Nearest::kNobody) distances.push_back(one.distance_m);
  }
  if (distances.empty()) return "nobody";
  const double middle = median(distances);
  return length(middle) + " is the median, " +
         length(*std::max_element(distances.begin(), distances.end())) + " the farthest";
}

}  // namespace

Result<Table> report_nearest(const Question& question) {
  const auto nearest = std::make_shared<NearestList>();
  const Status found = find(question, *nearest);
  if (!found) return found.error();
  const auto who = [nearest](PointId bee) -> Cell { return BeeCell{(*nearest)[bee].id}; };
  const auto how_far = [nearest](PointId bee) -> Cell {
    return DistanceCell{(*nearest)[bee].distance_m};
  };
  return Table{
      BeeTable{question.listed_bees(), {{"nearest", true, who}, {"distance_m", false, how_far}}},
      finding(*nearest)};
}

}  // namespace beespace::cli
