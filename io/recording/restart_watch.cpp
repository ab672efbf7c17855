#include "io/recording/restart_watch.hpp"

#include <algorithm>
#include <utility>

namespace beespace::io {

void RestartWatch::Run::add(const Fix& fix) {
  constexpr std::size_t kMostSteps = 16;
  const Step step{fixes == 0 ? fix : last, fix};
  if (fixes == 0) begins = fix;
  latest[fixes % latest.size()] = step;
  if (fixes % every == 0) {
    if (steps.size() == kMostSteps) {
      for (std::size_t i = 0; 2 * i < steps.size(); ++i) steps[i] = steps[2 * i];
      steps.resize(kMostSteps / 2);
      every *= 2;
    }
    if (fixes % every == 0) steps.push_back(step);
  }
  last = fix;
  ++fixes;
}

bool RestartWatch::Run::spans(double time_s) const {
  return begins.time_s <= time_s && time_s <= last.time_s;
}

std::size_t RestartWatch::Run::latest_size() const {
  return static_cast<std::size_t>(std::min<std::uint64_t>(fixes, latest.size()));
}

const RestartWatch::Step* RestartWatch::Run::at(double time_s) const {
  const auto is_then = [time_s](const Step& step) {
    return (step.from.time_s < time_s && time_s <= step.to.time_s) || step.from.time_s == time_s;
  };
  const auto found = std::find_if(steps.begin(), steps.end(), is_then);
  if (found != steps.end()) return &*found;
  const auto* const end = latest.data() + latest_size();
  const auto* const late = std::find_if(latest.data(), end, is_then);
  return late != end ? late : nullptr;
}

std::uint64_t RestartWatch::Run::between(double from_s, double until_s) const {
  const auto is_between = [=](const Step& step) {
    return from_s <= step.to.time_s && step.to.time_s <= until_s;
  };
  const auto spread = std::count_if(steps.begin(), steps.end(), is_between);
  const auto late = std::count_if(latest.data(), latest.data() + latest_size(), is_between);
  return std::max(every * static_cast<std::uint64_t>(spread), static_cast<std::uint64_t>(late));
}

void RestartWatch::take(const Fix& fix, Origin origin, Frame frame) {
  if (all_.fixes == 0) all_.first = origin;
  if (all_.fixes > 0 && fix.time_s < run_.last.time_s) {
    ++times_back_;
    if (!all_.cut) all_.cut = cut_of_runs();
    if (all_.cut) {
      before_.reset();
    } else {
      before_ = std::exchange(run_, {});
      between_ = {all_.last, origin, before_->last.time_s, fix.time_s, false, false};
      compared_ = {};
    }
    run_ = {};
  }
  run_.add(fix);
  if (before_) compare(fix, frame);
  all_.last = origin;
  ++all_.fixes;
}

void RestartWatch::compare(const Fix& fix, Frame frame) {
  if (!before_->spans(fix.time_s)) return;
  ++compared_.in_both;
  const Step* step = before_->at(fix.time_s);
  if (step == nullptr) return;
  ++compared_.fixes;
  if (step->from == fix) {
    ++compared_.same;
    return;
  }
  const GoesWithRun goes = goes_with(step->from, step->to, fix, frame);
  if (goes == GoesWithRun::kIsTheSame) ++compared_.same;
  if (goes == GoesWithRun::kIsApart) ++compared_.apart;
}

// Where nothing could be compared, it is not known whether they are the same.
std::optional<ClockCut> RestartWatch::cut_of_runs() const {
  if (!before_ || compared_.in_both < kFewestOfBothRuns) return std::nullopt;
  const double from_s = std::max(before_->begins.time_s, run_.begins.time_s);
  const double until_s = std::min(before_->last.time_s, run_.last.time_s);
  if (!(from_s < until_s)) return std::nullopt;
  if (before_->between(from_s, until_s) < kFewestOfBothRuns) return std::nullopt;
  ClockCut cut = between_;
  cut.repeated = 2 * compared_.same > compared_.fixes;
  cut.apart = !cut.repeated && 2 * compared_.apart >= compared_.fixes;
  return cut;
}

BeeClock RestartWatch::clock() const {
  BeeClock clock = all_;
  if (!clock.cut) clock.cut = cut_of_runs();
  if (kLongRuns * times_back_ > clock.fixes) clock.cut.reset();
  return clock;
}

}  // namespace beespace::io
