#include "io/recording/zero_runs.hpp"

#include "io/frames/coordinate_frame.hpp"
#include "io/recording/flat_distance.hpp"

#include <algorithm>
#include <cstddef>

namespace beespace::io {
namespace {

constexpr double kTimesFaster = 3.0;
constexpr std::size_t kFewestOthers = 10;  // steps between places that are none of these
constexpr std::size_t kFewestAtAnEnd = 3;  // where one step alone leads there

// 0, 0, 0; and -1, -1 or -999, -999 or 9999, 9999, 9999, in whatever unit: where no place is known
// one number is written for all coordinates, or beside a height of 0.
bool is_written_for_none(const Fix& fix) {
  const auto& [x, y, z] = fix.position;
  return x == y && (z == x || z == 0.0);
}

bool is_again(const Fix& fix, const Fix& before) {
  return fix.position == before.position;
}

double speed_mps(const Fix& from, const Fix& to) {
  return flat_distance_m(from.position, to.position, Frame::kMetres) / (to.time_s - from.time_s);
}

}  // namespace

std::vector<bool> zero_runs(const std::vector<Fix>& fixes) {
  if (std::none_of(fixes.begin(), fixes.end(), is_written_for_none)) return {};
  double fastest_mps = 0.0;
  std::size_t others = 0;
  for (std::size_t i = 1; i < fixes.size(); ++i) {
    // Who moves along such places is no less there.
    if (is_written_for_none(fixes[i - 1]) != is_written_for_none(fixes[i])) continue;
    if (is_written_for_none(fixes[i]) && is_again(fixes[i], fixes[i - 1])) continue;
    ++others;
    fastest_mps = std::max(fastest_mps, speed_mps(fixes[i - 1], fixes[i]));
  }
  if (others < kFewestOthers) return {};
  std::vector<bool> none(fixes.size(), false);
  bool any = false;
  for (std::size_t begin = 0; begin < fixes.size(); ++begin) {
    if (!is_written_for_none(fixes[begin])) continue;
    std::size_t end = begin;
    while (end < fixes.size() && is_again(fixes[end], fixes[begin])) ++end;
    const auto jumps = [&](std::size_t to) {
      return speed_mps(fixes[to - 1], fixes[to]) > kTimesFaster * fastest_mps;
    };
    const bool comes = begin > 0;
    const bool goes = end < fixes.size();
    if ((!comes || jumps(begin)) && (!goes || jumps(end)) &&
        ((comes && goes) || end - begin >= kFewestAtAnEnd)) {
      std::fill(none.begin() + static_cast<std::ptrdiff_t>(begin),
                none.begin() + static_cast<std::ptrdiff_t>(end), true);
      any = true;
    }
    begin = end - 1;
  }
  return any ? none : std::vector<bool>();
}

bool ZeroRunFilter::is_none(const Fix& fix) {
  if (last_ && !(last_->time_s < fix.time_s)) return run_ && is_again(fix, *run_);
  if (run_ && is_again(fix, *run_)) return true;
  const bool jumps = is_written_for_none(fix) && last_ && others_ >= kFewestOthers &&
                     speed_mps(*last_, fix) > kTimesFaster * fastest_mps_;
  if (jumps) {
    run_ = fix;
    return true;
  }
  // The step over a run says as little as those to and from such a place.
  if (last_ && !run_ && is_written_for_none(*last_) == is_written_for_none(fix) &&
      !(is_written_for_none(fix) && is_again(fix, *last_))) {
    ++others_;
    fastest_mps_ = std::max(fastest_mps_, speed_mps(*last_, fix));
  }
  run_.reset();
  last_ = fix;
  return false;
}

void ZeroRunWatch::take(const Fix& fix, std::uint64_t number) {
  if (last_ && !(last_->time_s < fix.time_s)) return;
  const bool none = is_written_for_none(fix);
  const bool again = last_ && is_again(fix, *last_);
  const std::optional<double> step_mps =
      last_ ? std::optional(speed_mps(*last_, fix)) : std::nullopt;
  if (run_ && !again) {
    if (none) {
      ++others_;
      fastest_mps_ = std::max(fastest_mps_, *step_mps);
    }
    end(*run_, step_mps);
    run_.reset();
    if (none) run_ = Run{number, 0, step_mps};
  } else if (!none && step_mps) {
    ++others_;
    fastest_mps_ = std::max(fastest_mps_, *step_mps);
  } else if (none && !run_) {
    run_ = Run{number, 0, step_mps};
  }
  if (none && run_) ++run_->fixes;
  last_ = fix;
}

void ZeroRunWatch::end(const Run& run, std::optional<double> left_mps) {
  const bool both = run.came_mps && left_mps;
  if (!both && run.fixes < kFewestAtAnEnd) return;
  if (!run.came_mps && !left_mps) return;
  const double slower_mps = std::min(run.came_mps.value_or(left_mps.value_or(0.0)),
                                     left_mps.value_or(run.came_mps.value_or(0.0)));
  if (slower_mps <= slowest_jump_mps_) return;
  slowest_jump_mps_ = slower_mps;
  first_ = run.first;
}

std::optional<std::uint64_t> ZeroRunWatch::found() const {
  ZeroRunWatch all = *this;
  if (all.run_) all.end(*all.run_, std::nullopt);
  if (all.others_ < kFewestOthers) return std::nullopt;
  if (!(all.slowest_jump_mps_ > kTimesFaster * all.fastest_mps_)) return std::nullopt;
  return all.first_;
}

}  // namespace beespace::io
