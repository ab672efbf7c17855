#include "io/units/zone_rule.hpp"

#include <chrono>

namespace beespace::io {
namespace {

class RuleText {
 public:
  explicit RuleText(std::string_view text) : text_(text) {}

  [[nodiscard]] bool empty() const { return text_.empty(); }

  bool take(char c) {
    if (text_.empty() || text_.front() != c) return false;
    text_.remove_prefix(1);
    return true;
  }

  static bool is_digit(char c) { return c >= '0' && c <= '9'; }

  bool number(int least, int most, int& value) {
    constexpr std::size_t kMostDigits = 3;
    std::size_t digits = 0;
    for (value = 0; digits < text_.size() && is_digit(text_[digits]); ++digits) {
      if (digits == kMostDigits) return false;
      value = value * 10 + (text_[digits] - '0');
    }
    text_.remove_prefix(digits);
    return digits > 0 && value >= least && value <= most;
  }

  // "CET", "<+0330>".
  bool name() {
    std::size_t size = 0;
    if (take('<')) {
      size = text_.find('>');
      if (size == std::string_view::npos || size == 0) return false;
      text_.remove_prefix(size + 1);
      return true;
    }
    while (size < text_.size() && ((text_[size] >= 'A' && text_[size] <= 'Z') ||
                                   (text_[size] >= 'a' && text_[size] <= 'z'))) {
      ++size;
    }
    text_.remove_prefix(size);
    return size >= 3;
  }

  // "[+-]hh[:mm[:ss]]"
  bool time(int most_hours, std::int64_t& seconds) {
    const bool negative = take('-');
    if (!negative) static_cast<void>(take('+'));
    int hours = 0;
    int minutes = 0;
    int rest = 0;
    if (!number(0, most_hours, hours)) return false;
    if (take(':') && !number(0, 59, minutes)) return false;
    if (take(':') && !number(0, 59, rest)) return false;
    seconds = (std::int64_t{hours} * 60 + minutes) * 60 + rest;
    if (negative) seconds = -seconds;
    return true;
  }

  bool day(YearlyDay& day) {
    if (take('M')) {
      day.kind = YearlyDay::Kind::kWeekday;
      if (!number(1, 12, day.month) || !take('.') || !number(1, 5, day.week) || !take('.') ||
          !number(0, 6, day.day)) {
        return false;
      }
    } else if (take('J')) {
      day.kind = YearlyDay::Kind::kDayOfPlainYear;
      if (!number(1, 365, day.day)) return false;
    } else {
      day.kind = YearlyDay::Kind::kDayOfYear;
      if (!number(0, 365, day.day)) return false;
    }
    return !take('/') || time(167, day.time_s);
  }

 private:
  std::string_view text_;
};

constexpr int kMostOffsetHours = 24;

}  // namespace

std::int64_t YearlyDay::in_year(int year) const {
  using std::chrono::sys_days;
  const std::chrono::year of{year};
  sys_days date = of / 1 / 1;
  if (kind == Kind::kDayOfYear) {
    date += std::chrono::days(day);
  } else if (kind == Kind::kDayOfPlainYear) {
    constexpr int kFebruaryEnds = 59;
    date += std::chrono::days(day - 1 + (of.is_leap() && day > kFebruaryEnds ? 1 : 0));
  } else {
    const std::chrono::weekday on{static_cast<unsigned>(day)};
    const auto in = of / std::chrono::month(static_cast<unsigned>(month));
    date = week == 5 ? sys_days(in / on[std::chrono::last])
                     : sys_days(in / on[static_cast<unsigned>(week)]);
  }
  return std::int64_t{date.time_since_epoch().count()} * 86'400 + time_s;
}

std::optional<ZoneRule> parse_zone_rule(std::string_view text) {
  RuleText front(text);
  ZoneRule rule;
  // POSIX counts hours that clocks are behind.
  if (!front.name() || !front.time(kMostOffsetHours, rule.offset_s)) return std::nullopt;
  rule.offset_s = -rule.offset_s;
  if (front.empty()) return rule;
  ZoneRule::Summer summer;
  if (!front.name()) return std::nullopt;
  summer.offset_s = rule.offset_s + 3600;
  if (!front.take(',')) {
    if (!front.time(kMostOffsetHours, summer.offset_s)) return std::nullopt;
    summer.offset_s = -summer.offset_s;
    // Without days it is up to the system which they are.
    if (!front.take(',')) return std::nullopt;
  }
  if (!front.day(summer.begins) || !front.take(',') || !front.day(summer.ends)) {
    return std::nullopt;
  }
  if (!front.empty()) return std::nullopt;
  rule.summer = summer;
  return rule;
}

}  // namespace beespace::io
