// A recording: two drones with their own clocks, and a gap in which one of them is unknown.
#include <beespace/beespace.hpp>

#include <cstdio>
#include <vector>

int main() {
  // The fixes of the two are at different times; between two fixes a drone moves straight.
  const std::vector<beespace::Track> tracks{
      {.fixes = {{0.0, {0.0, 0.0, 20.0}}, {10.0, {50.0, 0.0, 20.0}}, {20.0, {100.0, 0.0, 20.0}}}},
      {.fixes = {
           {1.0, {26.0, -20.0, 21.0}}, {9.0, {26.0, 20.0, 21.0}}, {19.5, {26.0, 80.0, 21.0}}}}};

  beespace::ConflictOptions options;
  options.threshold_m = 3.0;
  options.max_gap_s = 10.0;  // longer than this without a fix: unknown
  const auto found = beespace::find_conflicts(tracks, options);
  if (!found) {
    std::fprintf(stderr, "%s\n", to_string(found.error()).c_str());
    return 1;
  }
  for (const beespace::Conflict& conflict : found->conflicts) {
    std::printf("%u and %u: closer than 3 m from %.3f s to %.3f s, %.3f m at %.3f s\n",
                conflict.first, conflict.second, conflict.begins_s, conflict.ends_s,
                conflict.closest_m, conflict.closest_s);
  }
  for (const beespace::Gap& gap : found->gaps) {
    std::printf("%u is unknown from %.1f s to %.1f s\n", gap.track, gap.begins_s, gap.ends_s);
  }
}
