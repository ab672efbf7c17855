#include "cli/recorded/verify_steps.hpp"

#include "analysis/recorded/common_times.hpp"

#include <cstddef>

namespace beespace::cli {
namespace {

// The library counts movers; here they have names.
Error of_bee(Error error, const io::Recording& recording) {
  if (!error.location.record || *error.location.record >= recording.bees.size()) return error;
  error.message.insert(0, "bee '" + recording.bees[*error.location.record].id + "': ");
  error.location.record.reset();
  return error;
}

}  // namespace

std::vector<Gap> gaps_of_all(const io::Recording& recording, const std::vector<double>& times_s,
                             double max_gap_s) {
  std::vector<Gap> gaps;
  for (std::size_t bee = 0; bee < recording.bees.size(); ++bee) {
    for (std::size_t fix = 1; fix < times_s.size(); ++fix) {
      if (times_s[fix] - times_s[fix - 1] <= max_gap_s) continue;
      gaps.push_back({static_cast<PointId>(bee), times_s[fix - 1], times_s[fix]});
    }
  }
  return gaps;
}

Result<Verdict> verify_steps(const io::Recording& recording, const std::vector<double>& times_s,
                             const VerifyOptions& options, double max_gap_s,
                             ProgressBar& progress) {
  Verifier verifier(options);
  for (std::size_t fix = 0; fix < times_s.size(); ++fix) {
    if (fix > 0 && times_s[fix] - times_s[fix - 1] > max_gap_s) verifier.skip();
    const auto movers = analysis::movers_at(recording, fix);
    if (!movers) return movers.error();
    const Status good = verifier.add(times_s[fix], *movers);
    if (!good) return of_bee(good.error(), recording);
    progress.set_share(static_cast<double>(fix + 1) / static_cast<double>(times_s.size()));
  }
  return verifier.verdict();
}

}  // namespace beespace::cli
