// Working memory is bounded by the number of points: at most 48 bytes a point beyond the input,
// the answer included. Measured as the peak of the process's resident memory.
#include <beespace/at_risk.hpp>
#include <beespace/nearest.hpp>

#include "scenes/swarm_scenes.hpp"

#include <gtest/gtest.h>

#include <malloc.h>

#include <cstdint>
#include <fstream>
#include <optional>
#include <string>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define BEESPACE_TEST_SANITIZED 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define BEESPACE_TEST_SANITIZED 1
#endif
#endif

namespace beespace {
namespace {

std::optional<std::uint64_t> status_bytes(const std::string& field) {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    if (word != field) continue;
    std::uint64_t kibibytes = 0;
    status >> kibibytes;
    return kibibytes * 1024;
  }
  return std::nullopt;
}

bool reset_peak() {
  std::ofstream clear("/proc/self/clear_refs");
  clear << "5" << std::flush;
  return clear.good() && status_bytes("VmHWM:").has_value();
}

struct Scene {
  const char* name;
  std::vector<Point> points;
  double threshold_m;
};

TEST(WorkingMemory, IsAtMost48BytesAPoint) {
#if defined(BEESPACE_TEST_SANITIZED)
  GTEST_SKIP() << "a sanitizer's shadow memory would be measured";
#endif
  if (!reset_peak()) GTEST_SKIP() << "this system does not tell the peak of resident memory";
  constexpr std::size_t kSize = 2'000'000;
  const Scene scenes[] = {
      {"uniform, two neighbours", scenes::uniform_box(kSize, {16'127, 16'127, 16'127}, 1), 100.0},
      {"dense", scenes::uniform_box(kSize, {3'300, 2'300, 480}, 1), 100.0},
      {"sparse: every point in a row of its own", scenes::uniform_box(kSize, {1e6, 1e6, 1e6}, 1),
       100.0},
      {"clusters", scenes::gaussian_clusters(kSize, 1'000, 200.0, 100'000.0, 1), 20.0},
  };
  for (const Scene& scene : scenes) {
    for (const unsigned threads : {1U, 2U}) {
      malloc_trim(0);  // or memory kept from the run before would be used again, unseen
      ASSERT_TRUE(reset_peak());
      const std::uint64_t before = *status_bytes("VmRSS:");
      const auto at_risk = find_at_risk(scene.points, {scene.threshold_m, false, threads});
      ASSERT_TRUE(at_risk.has_value());
      const std::uint64_t peak = *status_bytes("VmHWM:");
      ASSERT_GE(peak, before);
      EXPECT_LE(static_cast<double>(peak - before) / kSize, 48.0)
          << scene.name << ", threads: " << threads;
      EXPECT_GE(static_cast<double>(peak - before) / kSize, 4.0) << "nothing was measured";
    }
  }
}

}  // namespace
}  // namespace beespace
