#include "cli/bench/bench_check.hpp"
#include "cli/bench/bench_result.hpp"
#include "io/bytes/number_text.hpp"

#include <beespace/version.hpp>

#include <algorithm>

namespace beespace::cli {
namespace {

constexpr std::size_t kNameWidth = 20;
constexpr std::size_t kQuestionWidth = 11;
constexpr std::size_t kTimeWidth = 10;
constexpr std::size_t kFloorWidth = 8;

std::string left(const std::string& text, std::size_t width) {
  return text + std::string(width - std::min(width, text.size()), ' ');
}

std::string right(const std::string& text, std::size_t width) {
  return std::string(width - std::min(width, text.size()), ' ') + text;
}

// The time of one point, and how many times the floor that is.
std::string columns(const std::optional<double>& seconds, double floor_s, std::size_t points) {
  if (!seconds) return right("-", kTimeWidth) + right("-", kFloorWidth);
  const double ns = *seconds * 1e9 / static_cast<double>(points);
  return right(io::grouped(ns, 1), kTimeWidth) +
         right(io::grouped(*seconds / floor_s, 1), kFloorWidth);
}

}  // namespace

std::string bench_head(const BenchRun& run) {
  const std::size_t both = kTimeWidth + kFloorWidth;
  const std::string indent(2 + kNameWidth + kQuestionWidth, ' ');
  const bool many = run.threads > 1;
  std::string out = "beespace " + std::string(version()) + ", " +
                    io::grouped(std::uint64_t{run.points}) + " points a scene\n\n";
  out += indent + right("one thread", both);
  if (many) out += right(std::to_string(run.threads) + " threads", both);
  out += "\n  " + left("scene", kNameWidth) + left("question", kQuestionWidth);
  for (int i = 0; i < (many ? 2 : 1); ++i) {
    out += right("ns/point", kTimeWidth) + right("x floor", kFloorWidth);
  }
  return out + '\n';
}

std::string bench_rows(const BenchRun& run, const BenchSceneResult& result) {
  std::string out;
  std::string name = result.scene->name;
  for (const BenchFigure& figure : result.figures) {
    out += "  " + left(name, kNameWidth) + left(figure.question, kQuestionWidth);
    out += columns(figure.one_thread_s, result.read_floor_s, run.points);
    if (run.threads > 1) out += columns(figure.all_threads_s, result.read_floor_s, run.points);
    out += '\n';
    name.clear();
  }
  return out;
}

std::string bench_foot() {
  return "\nThe floor is reading all coordinates in order, on one thread, as a search finds the "
         "points:\nbetween its repetitions. Each figure is the median of several runs of one "
         "Engine; before\nthem " +
         std::to_string(kBeesChecked) +
         " bees of every answer were compared with brute force.\n"
         "A dash: the answer would hold hundreds of pairs for every bee.\n";
}

}  // namespace beespace::cli
