#include "cli/bench/bench_question.hpp"

#include <array>

namespace beespace::cli {
namespace {

using Points = std::vector<Point>;

SearchOptions closer_than(double threshold_m) {
  SearchOptions options;
  options.threshold_m = threshold_m;
  return options;
}

Status at_risk(Engine& engine, const Points& points, double threshold_m, BenchAnswers& answers) {
  return engine.find_at_risk(points, closer_than(threshold_m), answers.at_risk);
}

Status pairs(Engine& engine, const Points& points, double threshold_m, BenchAnswers& answers) {
  return engine.find_pairs(points, closer_than(threshold_m), answers.pairs);
}

Status counts(Engine& engine, const Points& points, double threshold_m, BenchAnswers& answers) {
  return engine.count_neighbors(points, closer_than(threshold_m), answers.counts);
}

Status nearest(Engine& engine, const Points& points, double /*threshold_m*/,
               BenchAnswers& answers) {
  return engine.find_nearest(points, answers.nearest);
}

Status groups(Engine& engine, const Points& points, double threshold_m, BenchAnswers& answers) {
  return engine.find_conflict_groups(points, closer_than(threshold_m), answers.groups);
}

}  // namespace

std::span<const BenchQuestion> bench_questions() {
  static constexpr std::array kQuestions = {
      BenchQuestion{"at-risk", false, at_risk}, BenchQuestion{"pairs", true, pairs},
      BenchQuestion{"counts", false, counts},   BenchQuestion{"nearest", false, nearest},
      BenchQuestion{"groups", false, groups},
  };
  return kQuestions;
}

}  // namespace beespace::cli
