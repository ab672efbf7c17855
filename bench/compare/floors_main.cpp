// The machine's lower limits for a file of points, and for writing an answer of so many pairs.
//
//   compare_floors POINTS PAIRS
#include "bench/compare/fail.hpp"
#include "bench/compare/machine_floors.hpp"
#include "bench/compare/point_file.hpp"

#include <cstdio>
#include <cstdlib>

int main(int argc, char** argv) {
  using namespace beespace::compare;
  if (argc != 3) fail("usage: compare_floors POINTS PAIRS");
  const auto points = read_points(argv[1]);
  const std::uint64_t pairs = std::strtoull(argv[2], nullptr, 10);
  std::printf(
      "{\"points\": %zu, \"warm_read_ms\": %.4f, \"copy_ms\": %.4f, \"write_pairs_ms\": %.4f}\n",
      points.size(), warm_read_floor_ms(points), copy_floor_ms(points),
      write_pairs_floor_ms(pairs));
  return 0;
}
