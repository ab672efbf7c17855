#include "analysis/live/bee_clocks.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace beespace::analysis {
namespace {

// The clock of the reports counts as going on while it is heard of so often.
constexpr double kPause_s = 1.0;
// A clock that is named already is named again so often at most.
constexpr double kNamedAgain_s = 10.0;
// How often it must be found right again.
constexpr std::uint32_t kTimesRight = 3;
// A report may be late, and several bees may have one at once: a bee is behind when so many in a
// row say so.
constexpr std::uint32_t kTimesBehind = 3;
// Bees that have not been heard of for so many max_age_s have no vote.
constexpr double kPeriodInAges = 4.0;

}  // namespace

BeeClocks::Bee& BeeClocks::bee_of(AgentId id) {
  if (id >= bees_.size()) bees_.resize(std::max<std::size_t>(id + 1, 2 * bees_.size()));
  return bees_[id];
}

double BeeClocks::reference(double wall_s) const {
  const double waited_s = wall_s - now_wall_s_;
  return waited_s < kPause_s ? now_s_ : now_s_ + waited_s;
}

BeeClocks::Place BeeClocks::place_of(double lead_s) const {
  if (lead_s > limits_.max_skew_s) return Place::kAhead;
  return lead_s < -limits_.max_skew_s ? Place::kBehind : Place::kNear;
}

void BeeClocks::vote(Bee& bee, Place place) {
  if (bee.period == period_) {
    --votes_[static_cast<std::size_t>(bee.voted)];
  } else if (bee.period > 0 && bee.period + 1 == period_) {
    --votes_before_;
  }
  const bool may_be_late = place == Place::kBehind && !bee.named && bee.times < kTimesBehind;
  bee.period = period_;
  bee.place = place;
  bee.voted = may_be_late ? Place::kNear : place;
  ++votes_[static_cast<std::size_t>(bee.voted)];
}

bool BeeClocks::most_are(Place place) const {
  const std::uint64_t all = votes_before_ + votes_[0] + votes_[1] + votes_[2];
  return 2 * votes_[static_cast<std::size_t>(place)] > all;
}

// Of all that have a vote, the lower one of two: where most are ahead it is ahead too.
double BeeClocks::median_lead() const {
  std::vector<double> leads;
  for (const Bee& bee : bees_) {
    if (bee.period > 0 && bee.period + 1 >= period_) leads.push_back(bee.lead_s);
  }
  const auto middle = leads.begin() + static_cast<std::ptrdiff_t>((leads.size() - 1) / 2);
  std::nth_element(leads.begin(), middle, leads.end());
  return *middle;
}

void BeeClocks::advance_to(double time_s, double wall_s) {
  if (time_s <= now_s_) return;
  now_s_ = time_s;
  now_wall_s_ = wall_s;
  if (now_s_ - period_began_s_ < kPeriodInAges * limits_.max_age_s) return;
  ++period_;
  period_began_s_ = now_s_;
  votes_before_ = votes_[0] + votes_[1] + votes_[2];
  votes_ = {};
}

bool BeeClocks::take(const PositionReport& report, double wall_s, std::vector<Step>& steps) {
  const double time_s = report.time_s;
  if (!std::isfinite(time_s)) return true;  // which is said of it elsewhere
  Bee& bee = bee_of(report.id);
  ++takes_;
  if (!started_) {
    started_ = true;
    now_s_ = period_began_s_ = time_s;
    now_wall_s_ = wall_s;
  }
  // The same again says nothing of its clock.
  if (time_s == bee.last_s && !bee.broken) {
    if (bee.kept == 0 && !bee.off) return true;
    if (bee.off) {
      pass(report, bee, time_s - bee.offset_s, steps);
    } else {
      keep(report, bee);
    }
    return false;
  }
  bee.lead_s = time_s - reference(wall_s);
  const double lasts_s = time_s - std::exchange(bee.last_s, time_s);
  if (place_of(bee.lead_s) != Place::kNear) {
    take_elsewhere(report, bee, lasts_s, wall_s, steps);
    return false;
  }
  const bool went_on = bee.place == Place::kNear && std::isfinite(lasts_s) && lasts_s > 0.0;
  if (went_on) bee.interval_s = lasts_s;
  vote(bee, Place::kNear);
  if (bee.named || bee.kept > 0 || bee.broken) {
    take_near(report, bee, wall_s, steps);
    return false;
  }
  if (time_s > now_s_) ++nears_;
  advance_to(time_s, wall_s);
  return true;
}

// After it was elsewhere.
void BeeClocks::take_near(const PositionReport& report, Bee& bee, double wall_s,
                          std::vector<Step>& steps) {
  drop_kept(report.id, bee);
  if (bee.named) {
    if (++bee.times < kTimesRight) {
      if (bee.off) return correct(report, bee, wall_s, steps);
      return pass(report, bee, report.time_s, steps);
    }
    if (std::exchange(bee.off, false)) bee.broken = true;
    bee.named = false;
    steps.push_back({Step::Kind::kRight, report, now_s_, bee.lead_s, false});
  }
  bee.times = 0;
  if (report.time_s > now_s_) ++nears_;
  advance_to(report.time_s, wall_s);
  pass(report, bee, report.time_s, steps);
}

// `lasts_s`: since its last report, by its own clock.
void BeeClocks::take_elsewhere(const PositionReport& report, Bee& bee, double lasts_s,
                               double wall_s, std::vector<Step>& steps) {
  const Place place = place_of(bee.lead_s);
  const bool first = bee.place != place;
  const bool opposed = !first && nears_ != bee.nears;
  if (first) {
    bee.since_s = now_s_;
    bee.stepped = lasts_s < 0.0;
  }
  if (first || opposed || lasts_s < 0.0) {
    bee.unopposed_s = 0.0;
  } else {
    bee.unopposed_s += bee.interval_s > 0.0 ? std::min(lasts_s, bee.interval_s) : lasts_s;
  }
  bee.times = bee.named ? 0 : (first ? 1 : bee.times + 1);
  bee.nears = nears_;
  vote(bee, place);
  if (most_are(place) && takes_ >= next_vote_) {
    keep(report, bee);
    const double from_s = go_to(reference(wall_s) + median_lead(), wall_s, steps);
    return release(from_s, wall_s, steps);
  }
  if (bee.off) return correct(report, bee, wall_s, steps);
  const bool may_be_late = place == Place::kBehind && !bee.named && bee.times < kTimesBehind;
  if (bee.unopposed_s >= limits_.max_age_s && !may_be_late) {
    keep(report, bee);
    const double from_s = go_to(first_kept_s(report), wall_s, steps);
    return release(from_s, wall_s, steps);
  }
  const bool far = place == Place::kAhead || bee.lead_s < -limits_.max_age_s;
  const bool wrong =
      place == Place::kAhead
          ? opposed
          : bee.named || (bee.times >= kTimesBehind && now_s_ - bee.since_s >= limits_.max_age_s);
  if (wrong && !bee.named) name(report, bee, steps);
  if (!wrong) return far ? keep(report, bee) : pass(report, bee, report.time_s, steps);
  bee.off = bee.broken = true;
  bee.offset_s = bee.lead_s;
  correct(report, bee, wall_s, steps);
}

void BeeClocks::correct(const PositionReport& report, Bee& bee, double wall_s,
                        std::vector<Step>& steps) {
  drop_kept(report.id, bee);
  const double reference_s = reference(wall_s);
  const bool others_silent = bee.unopposed_s >= limits_.max_age_s;
  double time_s = report.time_s - bee.offset_s;
  if (!others_silent && place_of(time_s - reference_s) != Place::kNear) {
    bee.offset_s = bee.lead_s;
    bee.broken = true;
    time_s = reference_s;
  }
  // Then time goes on by its clock.
  if (others_silent) advance_to(time_s, wall_s);
  if (bee.place != Place::kNear && std::abs(bee.lead_s - bee.told_s) > limits_.max_skew_s &&
      now_s_ - bee.told_at_s >= kNamedAgain_s) {
    name(report, bee, steps);
  }
  pass(report, bee, time_s, steps);
}

void BeeClocks::name(const PositionReport& report, Bee& bee, std::vector<Step>& steps) {
  if (!bee.named) ++named_;
  bee.named = true;
  bee.times = 0;
  bee.told_s = bee.lead_s;
  bee.told_at_s = now_s_;
  steps.push_back({Step::Kind::kOff, report, now_s_, bee.lead_s, false});
}

void BeeClocks::pass(const PositionReport& report, Bee& bee, double time_s,
                     std::vector<Step>& steps) const {
  if (std::exchange(bee.broken, false)) {
    steps.push_back({Step::Kind::kLost, report, now_s_, 0.0, false});
  }
  Step step{Step::Kind::kReport, report, now_s_, 0.0, false};
  step.report.time_s = time_s;
  steps.push_back(step);
}

// It is the time of the swarm that was wrong. Returns where time goes on from.
double BeeClocks::go_to(double now_s, double wall_s, std::vector<Step>& steps) {
  // Counting takes as long as there are bees, so a new count waits for a part of them.
  next_vote_ = takes_ + bees_.size() / 16;
  const double shift_s = now_s - reference(wall_s);
  std::uint64_t behind = 0;
  std::uint64_t stepped = 0;
  votes_ = {};
  for (AgentId id = 0; id < bees_.size(); ++id) {
    Bee& bee = bees_[id];
    if (bee.period == 0 || bee.period + 1 < period_) continue;
    if (bee.voted == Place::kBehind) {
      ++behind;
      if (bee.stepped) ++stepped;
    }
    bee.lead_s -= shift_s;
    bee.place = bee.voted = place_of(bee.lead_s);
    if (bee.period == period_) ++votes_[static_cast<std::size_t>(bee.voted)];
    bee.times = 0;
    bee.unopposed_s = 0.0;
    if (bee.off && bee.place == Place::kNear) {
      bee.off = false;
      bee.broken = true;
    }
    if (!bee.named || bee.place != Place::kNear) continue;
    bee.named = false;
    PositionReport of;
    of.id = id;
    of.time_s = now_s;
    steps.push_back({Step::Kind::kRight, of, now_s, bee.lead_s, false});
  }
  const bool back = now_s < now_s_;
  double from_s = std::min(now_s_, now_s);
  now_s_ = now_s;
  now_wall_s_ = wall_s;
  period_began_s_ = now_s;
  if (!back) return from_s;
  // To the first of those that said so.
  for (const Kept& kept : kept_) {
    if (place_of(kept.report.time_s - now_s) != Place::kNear) continue;
    from_s = std::min(from_s, kept.report.time_s);
  }
  steps.push_back({Step::Kind::kBack, {}, from_s, 0.0, 2 * stepped > behind});
  return from_s;
}

void BeeClocks::keep(const PositionReport& report, Bee& bee) {
  // One of each bee must find place, as all may go on after a pause.
  if (kept_.size() >= kMostKept + 2 * bees_.size()) {
    Bee& first = bees_[kept_.front().report.id];
    --first.kept;
    first.broken = true;
    kept_.pop_front();
    ++left_out_;
  }
  kept_.push_back({report, report.time_s > now_s_});
  ++bee.kept;
}

double BeeClocks::first_kept_s(const PositionReport& report) const {
  const auto first = std::find_if(kept_.begin(), kept_.end(),
                                  [&](const Kept& kept) { return kept.report.id == report.id; });
  return first == kept_.end() ? report.time_s : first->report.time_s;
}

void BeeClocks::drop_kept(AgentId id, Bee& bee) {
  if (bee.kept == 0) return;
  left_out_ += std::exchange(bee.kept, 0);
  bee.broken = true;
  std::erase_if(kept_, [id](const Kept& kept) { return kept.report.id == id; });
}

// Those that were kept back and need not be any more, in the order in which they came: the time of
// the swarm goes on with them from `from_s`, where it was, to where it is.
void BeeClocks::release(double from_s, double wall_s, std::vector<Step>& steps) {
  bool again = true;
  while (again) {
    const std::size_t before = kept_.size();
    std::erase_if(kept_, [&](const Kept& kept) {
      const Place place = place_of(kept.report.time_s - now_s_);
      if (place != Place::kNear && !(kept.ahead && place == Place::kBehind)) return false;
      Bee& bee = bees_[kept.report.id];
      --bee.kept;
      if (kept.report.time_s == bee.last_s) {
        bee.lead_s = kept.report.time_s - now_s_;
        bee.times = 0;
        vote(bee, place);
      }
      advance_to(kept.report.time_s, wall_s);
      from_s = std::min(now_s_, std::max(from_s, kept.report.time_s));
      pass(kept.report, bee, kept.report.time_s, steps);
      steps.back().now_s = from_s;
      return true;
    });
    again = kept_.size() < before && !kept_.empty();
  }
}

void BeeClocks::finish(std::vector<Step>& steps) {
  // Whether these are late only will not be known any more.
  for (AgentId id = 0; id < bees_.size(); ++id) {
    Bee& bee = bees_[id];
    const bool behind = bee.place == Place::kBehind && bee.times >= kTimesBehind;
    if (bee.named || !behind || bee.period == 0) continue;
    PositionReport of;
    of.id = id;
    of.time_s = bee.last_s;
    name(of, bee, steps);
  }
  for (const Kept& kept : kept_) {
    Bee& bee = bees_[kept.report.id];
    bee.kept = 0;
    advance_to(kept.report.time_s, now_wall_s_);
    pass(kept.report, bee, kept.report.time_s, steps);
  }
  kept_.clear();
}

void BeeClocks::forget(AgentId id) {
  if (id >= bees_.size()) return;
  Bee& bee = bees_[id];
  drop_kept(id, bee);
  if (bee.period == period_) {
    --votes_[static_cast<std::size_t>(bee.voted)];
  } else if (bee.period > 0 && bee.period + 1 == period_) {
    --votes_before_;
  }
  bee = {};
}

}  // namespace beespace::analysis
