// The questions that `beespace bench` asks, and their answers about one scene.
#pragma once

#include "cli/bench/bench_scene.hpp"

#include <beespace/engine.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace beespace::cli {

struct BenchAnswers {
  std::vector<PointId> at_risk;
  std::vector<Pair> pairs;
  std::vector<std::uint32_t> counts;
  std::vector<Nearest> nearest;
  IdRows groups;
};

struct BenchQuestion {
  const char* name;
  bool makes_pairs;
  Status (*ask)(Engine& engine, const std::vector<Point>& points, double threshold_m,
                BenchAnswers& answers);
};

std::span<const BenchQuestion> bench_questions();

// Whether the question's answer about the scene fits into memory.
inline bool is_asked(const BenchQuestion& question, const BenchScene& scene) {
  return scene.pairs_fit || !question.makes_pairs;
}

}  // namespace beespace::cli
