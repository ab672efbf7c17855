// What `beespace bench` found out, and how it is shown.
#pragma once

#include "cli/bench/bench_scene.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace beespace::cli {

struct BenchFigure {
  const char* question;
  // Nothing where the answer would not fit into memory, or there is one thread only.
  std::optional<double> one_thread_s;
  std::optional<double> all_threads_s;
};

struct BenchSceneResult {
  const BenchScene* scene;
  double read_floor_s = 0.0;
  std::vector<BenchFigure> figures;
};

struct BenchRun {
  std::size_t points = 0;
  unsigned threads = 1;
};

// A table for people, in pieces, so that it grows while they watch.
std::string bench_head(const BenchRun& run);
std::string bench_rows(const BenchRun& run, const BenchSceneResult& result);
std::string bench_foot();

std::string bench_json(const BenchRun& run, const std::vector<BenchSceneResult>& results);

}  // namespace beespace::cli
