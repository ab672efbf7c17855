#include "cli/recorded/verify_steps.hpp"

#include "analysis/recorded/common_times.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

namespace beespace::cli {
namespace {

template <class Item>
void append_first(std::vector<Item>& all, const std::vector<Item>& more) {
  const std::size_t room = Verdict::kMostShown - std::min(Verdict::kMostShown, all.size());
  const auto end = more.begin() + static_cast<std::ptrdiff_t>(std::min(room, more.size()));
  all.insert(all.end(), more.begin(), end);
}

// What was found in later steps, to what was found before.
void add(Verdict& all, const Verdict& later) {
  all.steps += later.steps;
  all.losses += later.losses;
  all.clearance_losses += later.clearance_losses;
  all.breaches += later.breaches;
  append_first(all.first_losses, later.first_losses);
  append_first(all.first_clearance_losses, later.first_clearance_losses);
  append_first(all.first_breaches, later.first_breaches);
  if (later.closest_m && (!all.closest_m || *later.closest_m < *all.closest_m)) {
    all.closest_m = later.closest_m;
    all.closest_pair = later.closest_pair;
    all.closest_step_s = later.closest_step_s;
  }
  all.peak_speed_mps = std::max(all.peak_speed_mps, later.peak_speed_mps);
  all.peak_acceleration_mps2 = std::max(all.peak_acceleration_mps2, later.peak_acceleration_mps2);
}

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
  Verdict all;
  std::optional<Verifier> verifier(options);
  for (std::size_t fix = 0; fix < times_s.size(); ++fix) {
    if (fix > 0 && times_s[fix] - times_s[fix - 1] > max_gap_s) {
      add(all, verifier->verdict());
      verifier.emplace(options);
    }
    const auto movers = analysis::movers_at(recording, fix);
    if (!movers) return movers.error();
    const Status good = verifier->add(times_s[fix], *movers);
    if (!good) return of_bee(good.error(), recording);
    progress.set_share(static_cast<double>(fix + 1) / static_cast<double>(times_s.size()));
  }
  add(all, verifier->verdict());
  return all;
}

}  // namespace beespace::cli
