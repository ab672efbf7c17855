#include "tests/differential/recording_oracle.hpp"

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace beespace::differential {

PairOracle::PairOracle(const Track& first, const Track& second, const ConflictOptions& options)
    : first_(first),
      second_(second),
      options_(options),
      apart_(!first.heights_m.empty() || !second.heights_m.empty()) {
  for (const Track* track : {&first, &second}) {
    for (const Fix& fix : track->fixes) cuts_.push_back(fix.time_s);
  }
  std::sort(cuts_.begin(), cuts_.end());
  cuts_.erase(std::unique(cuts_.begin(), cuts_.end()), cuts_.end());
  choose_slack();
  choose_units();
}

void PairOracle::choose_units() {
  Unit lengths;
  Unit times;
  for (const Track* track : {&first_, &second_}) {
    for (const Fix& fix : track->fixes) {
      const Point& p = fix.position;
      for (const double value : {p.x, p.y, p.z}) lengths.include(value);
      times.include(fix.time_s);
    }
    for (const double height : track->heights_m) lengths.include(height);
  }
  lengths.include(options_.threshold_m);
  lengths.include(options_.vertical_m.value_or(0.0));
  lengths.include(slack_m_);
  metre_ = lengths.exponent();
  second_s_ = times.exponent();
}

void PairOracle::choose_slack() {
  double farthest = options_.threshold_m + options_.vertical_m.value_or(0.0);
  double fastest = 0.0;
  for (const Track* track : {&first_, &second_}) {
    for (std::size_t i = 0; i < track->fixes.size(); ++i) {
      const Point& p = track->fixes[i].position;
      const double height = track->heights_m.empty() ? 0.0 : track->heights_m[i];
      farthest =
          std::max({farthest, std::abs(p.x), std::abs(p.y), std::abs(p.z), std::abs(height)});
      if (i == 0) continue;
      const Point& q = track->fixes[i - 1].position;
      const double before = track->heights_m.empty() ? 0.0 : track->heights_m[i - 1];
      const double moved = std::abs(p.x - q.x) + std::abs(p.y - q.y) + std::abs(p.z - q.z) +
                           std::abs(height - before);
      fastest = std::max(fastest, moved / (track->fixes[i].time_s - track->fixes[i - 1].time_s));
    }
  }
  const double latest =
      cuts_.empty() ? 0.0 : std::max(std::abs(cuts_.front()), std::abs(cuts_.back()));
  slack_m_ = 0x1p-44 * farthest + 0x1p-50 * fastest * latest;
}

Fraction PairOracle::time_of(double seconds) const {
  const Parts parts = parts_of(seconds);
  if (parts.mantissa == 0) return {0, 1};
  if (parts.exponent >= second_s_)
    return {Whole(parts.mantissa) << (parts.exponent - second_s_), 1};
  return {parts.mantissa, Whole(1) << (second_s_ - parts.exponent)};
}

Axes PairOracle::place_of(const Track& track, std::size_t fix) const {
  const Point& p = track.fixes[fix].position;
  const double height = track.heights_m.empty() ? 0.0 : track.heights_m[fix];
  return {whole(p.x, metre_), whole(p.y, metre_), whole(p.z, metre_), whole(height, metre_)};
}

// The straight line on which the track is at a time, or the place of the fix.
std::optional<PairOracle::Line> PairOracle::line_at(const Track& track,
                                                    const Fraction& time) const {
  for (std::size_t i = 0; i < track.fixes.size(); ++i) {
    const Fraction at = time_of(track.fixes[i].time_s);
    if (at == time) return Line{place_of(track, i), {}, 1};
    if (i + 1 == track.fixes.size() || time < at) continue;
    const Fraction next = time_of(track.fixes[i + 1].time_s);
    if (next <= time) continue;
    if (track.fixes[i + 1].time_s - track.fixes[i].time_s > options_.max_gap_s) return std::nullopt;
    const Axes p = place_of(track, i);
    const Axes q = place_of(track, i + 1);
    Line line;
    line.scale = next.numerator - at.numerator;
    for (std::size_t axis = 0; axis < 4; ++axis) {
      line.at[axis] = p[axis] * next.numerator - q[axis] * at.numerator;
      line.per_time[axis] = q[axis] - p[axis];
    }
    return line;
  }
  return std::nullopt;
}

std::optional<PairOracle::Window> PairOracle::window_at(const Fraction& time,
                                                        double wider_m) const {
  const auto one = line_at(first_, time);
  const auto other = line_at(second_, time);
  if (!one || !other) return std::nullopt;
  Axes r;
  Axes w;
  for (std::size_t axis = 0; axis < 4; ++axis) {
    r[axis] = other->at[axis] * one->scale - one->at[axis] * other->scale;
    w[axis] = other->per_time[axis] * one->scale - one->per_time[axis] * other->scale;
  }
  const Whole scale = one->scale * other->scale;
  const Whole wider = whole(wider_m, metre_);
  Limits limits{(whole(options_.threshold_m, metre_) + wider) * scale,
                {},
                options_.inclusive || wider_m != 0.0,
                apart_ ? 3U : 2U};
  if (options_.vertical_m) {
    limits.vertical = (whole(*options_.vertical_m, metre_) + wider) * scale;
  }
  if (limits.threshold < 0) return std::nullopt;
  return Window{Passage(r, w, limits), scale};
}

std::optional<PairOracle::Window> PairOracle::window_after(std::size_t cut) const {
  const Whole begin = time_of(cuts_[cut]).numerator;
  const Whole end = time_of(cuts_[cut + 1]).numerator;
  return window_at({begin + end, 2});
}

bool PairOracle::in_conflict_at(const Fraction& time, double wider_m) const {
  const auto window = window_at(time, wider_m);
  return window && window->passage.in_conflict_at(time);
}

std::vector<Stretch> PairOracle::stretches() const {
  std::vector<Stretch> found;
  std::optional<Stretch> open;
  const auto close = [&](bool cut_off) {
    if (open) found.push_back({open->first_cut, open->last_cut, cut_off});
    open.reset();
  };
  for (std::size_t cut = 0; cut < cuts_.size(); ++cut) {
    const Fraction begin = time_of(cuts_[cut]);
    const bool here = in_conflict_at(begin);
    if (!here) close(false);
    if (here && !open) open = Stretch{cut, cut};
    if (here) open->last_cut = cut;
    const bool last = cut + 1 == cuts_.size();
    const auto window = last ? std::nullopt : window_after(cut);
    if (!window) {
      close(here);
    } else if (!window->passage.in_conflict_between(begin, time_of(cuts_[cut + 1]))) {
      close(false);
    } else {
      if (!open) open = Stretch{cut, cut + 1};
      open->last_cut = cut + 1;
    }
  }
  close(false);
  return found;
}

double PairOracle::root_of(const Fraction& squared_length, const Whole& scale) const {
  using Wide = boost::multiprecision::cpp_bin_float_100;
  const Wide ratio = Wide(squared_length.numerator) / Wide(squared_length.denominator);
  return ldexp(sqrt(ratio) / Wide(scale), metre_).convert_to<double>();
}

double PairOracle::distance_at(const Fraction& time) const {
  const auto window = window_at(time);
  if (!window) return std::numeric_limits<double>::infinity();
  return root_of(window->passage.squared_distance_at(time), window->scale);
}

std::optional<double> PairOracle::closest_m() const {
  std::optional<double> least;
  const auto look_at = [&](const Fraction& time) {
    const double here = distance_at(time);
    if (std::isfinite(here)) least = std::min(least.value_or(here), here);
  };
  for (std::size_t cut = 0; cut < cuts_.size(); ++cut) {
    look_at(time_of(cuts_[cut]));
    if (cut + 1 == cuts_.size()) break;
    const auto window = window_after(cut);
    if (!window) continue;
    look_at(window->passage.closest_within(time_of(cuts_[cut]), time_of(cuts_[cut + 1])));
  }
  return least;
}

std::string PairOracle::fault_of(const Conflict& c, const Stretch& s) const {
  if (!(c.begins_s <= c.closest_s && c.closest_s <= c.ends_s)) return "its times are out of order";
  for (const double time : {c.begins_s, c.closest_s, c.ends_s}) {
    if (!in_conflict_at(time_of(time), slack_m_))
      return "not in conflict at " + std::to_string(time);
  }
  const double apart = distance_at(time_of(c.closest_s));
  // Roots of what nearly cancels, for heights apart, are judged as lengths as well.
  if (!apart_ && std::abs(apart - c.closest_m) > slack_m_) return "not so close";
  // An instant deep in the conflict lies in its time, and is no closer.
  const Fraction begins = time_of(c.begins_s);
  const Fraction ends = time_of(c.ends_s);
  for (std::size_t cut = s.first_cut; cut < s.last_cut; ++cut) {
    const auto window = window_after(cut);
    if (!window) continue;
    const Fraction from = time_of(cuts_[cut]);
    const Fraction to = time_of(cuts_[cut + 1]);
    for (const Fraction& time : {from, window->passage.closest_within(from, to), to}) {
      if (!in_conflict_at(time, -slack_m_)) continue;
      if (time < begins || ends < time) return "in conflict at other times as well";
      if (distance_at(time) < c.closest_m - slack_m_) return "once closer";
    }
  }
  if (!c.certain) return "without tolerances it is certain";
  return "";
}

std::string PairOracle::fault_at(double time_s, double distance_m) const {
  if (!in_conflict_at(time_of(time_s), slack_m_)) {
    return "not near at " + std::to_string(time_s);
  }
  if (apart_ || std::abs(distance_at(time_of(time_s)) - distance_m) <= slack_m_) return "";
  return "not so far apart at " + std::to_string(time_s);
}

}  // namespace beespace::differential
