#include "io/units/iso_time.hpp"

#include <array>
#include <cctype>
#include <charconv>
#include <chrono>
#include <cstddef>
#include <cstdint>

namespace beespace::io {
namespace {

constexpr std::int64_t kNanosPerSecond = 1'000'000'000;
constexpr std::int64_t kSecondsPerDay = 86'400;
constexpr std::string_view kForm = "write it as 2024-05-01T12:00:00.25Z";

constexpr std::string_view kOtherDate =
    "which of its numbers is the day and which the month is not said; write dates with the year "
    "first, as in 2024-05-01 (pandas: pd.to_datetime(column, dayfirst=True))";
constexpr std::string_view kShortYear =
    "the year has two digits; write it with four, as in 2024-05-01";
constexpr std::string_view kNotDayFirst =
    "there is no such month: dates with points, or of this table, have the day first, then the "
    "month; correct it, or say --dates month-first for all";
constexpr std::string_view kNotMonthFirst =
    "there is no such month: dates of this table have the month first, then the day; correct it, "
    "or say --dates day-first for all";

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

// How many digits the three numbers of a date have; zeros where it is none: "9/10/15".
using DateDigits = std::array<std::size_t, 3>;

DateDigits date_digits(std::string_view text) {
  DateDigits digits = {};
  char between = '\0';
  for (std::size_t part = 0; part < digits.size(); ++part) {
    if (part > 0) {
      const bool one = !text.empty() && std::string_view("./-").find(text.front()) < 3;
      if (!one || (part == 2 && text.front() != between)) return {};
      between = text.front();
      text.remove_prefix(1);
    }
    for (; !text.empty() && is_digit(text.front()); text.remove_prefix(1)) ++digits[part];
  }
  return digits;
}

bool is_short(std::size_t digits) {
  return digits == 1 || digits == 2;
}

bool ends_with_year(const DateDigits& digits) {
  return is_short(digits[0]) && is_short(digits[1]) && (digits[2] == 2 || digits[2] == 4);
}

// The months as English has them, by their first letters.
constexpr std::array<std::string_view, 12> kMonths = {"JAN", "FEB", "MAR", "APR", "MAY", "JUN",
                                                      "JUL", "AUG", "SEP", "OCT", "NOV", "DEC"};

// Takes things off the front of a text.
class Front {
 public:
  explicit Front(std::string_view text) : text_(text) {}

  // Exactly `count` digits.
  bool number(std::size_t count, int& value) {
    if (text_.size() < count) return false;
    value = 0;
    for (std::size_t i = 0; i < count; ++i) {
      if (!is_digit(text_[i])) return false;
      value = value * 10 + (text_[i] - '0');
    }
    text_.remove_prefix(count);
    return true;
  }

  // One digit or two.
  bool short_number(int& value) {
    const bool two = text_.size() > 1 && is_digit(text_[1]);
    return number(two ? 2 : 1, value);
  }

  // One of these characters.
  bool any_of(std::string_view characters) {
    if (text_.empty() || characters.find(text_.front()) == std::string_view::npos) return false;
    text_.remove_prefix(1);
    return true;
  }

  // This word, in capitals or not.
  bool word(std::string_view wanted) {
    if (text_.size() < wanted.size()) return false;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      if (text_[i] != wanted[i] && text_[i] != wanted[i] - 'A' + 'a') return false;
    }
    text_.remove_prefix(wanted.size());
    return true;
  }

  // "Jan", and what may be left of "January".
  bool month(int& value) {
    for (std::size_t i = 0; i < kMonths.size(); ++i) {
      if (!word(kMonths[i])) continue;
      value = static_cast<int>(i) + 1;
      while (!text_.empty() && std::isalpha(static_cast<unsigned char>(text_.front())) != 0) {
        text_.remove_prefix(1);
      }
      return true;
    }
    return false;
  }

  // All digits that are there, as billionths; false when there is none.
  bool fraction(std::int64_t& nanos) {
    std::int64_t unit = kNanosPerSecond / 10;
    nanos = 0;
    const std::size_t before = text_.size();
    for (; !text_.empty() && is_digit(text_.front()); text_.remove_prefix(1), unit /= 10) {
      nanos += unit * (text_.front() - '0');
    }
    return text_.size() < before;
  }

  [[nodiscard]] std::string_view rest() const { return text_; }

 private:
  std::string_view text_;
};

struct Clock {
  int hour = 0;
  int minute = 0;
  int second = 0;
  std::int64_t nanos = 0;
};

// "AM" or "PM" behind the hours of half a day.
std::string_view parse_half_day(Front& front, Clock& clock) {
  constexpr int kHalfDay = 12;
  Front behind = front;
  while (behind.any_of(" ")) {
  }
  const bool before_noon = behind.word("AM");
  if (!before_noon && !behind.word("PM")) return {};
  if (clock.hour < 1 || clock.hour > kHalfDay) return "there is no such time of day; correct it";
  clock.hour = clock.hour % kHalfDay + (before_noon ? 0 : kHalfDay);
  front = behind;
  return {};
}

// Hours, minutes, and seconds unless those are not told.
std::string_view parse_clock(Front& front, Clock& clock) {
  if (!front.short_number(clock.hour) || !front.any_of(":") || !front.number(2, clock.minute)) {
    return kForm;
  }
  if (front.any_of(":")) {
    if (!front.number(2, clock.second)) return kForm;
    if (front.any_of(".,") && !front.fraction(clock.nanos)) return kForm;
  }
  if (clock.second == 60) return "leap seconds are not read; a minute has the seconds 00 to 59";
  if (clock.hour > 23 || clock.minute > 59 || clock.second > 59) {
    return "there is no such time of day; correct it";
  }
  return parse_half_day(front, clock);
}

// Minutes east of Greenwich, perhaps behind a blank; nothing where nothing is there.
std::string_view parse_zone(Front& front, std::optional<int>& minutes) {
  while (front.any_of(" ")) {
  }
  if (front.rest().empty()) return {};
  if (front.word("UTC") || front.word("GMT") || front.any_of("Zz")) {
    minutes = 0;
    return {};
  }
  const bool west = front.rest().front() == '-';
  int hour = 0;
  int minute = 0;
  if (!front.any_of("+-") || !front.number(2, hour)) return kForm;
  if (front.any_of(":") ? !front.number(2, minute)
                        : !front.rest().empty() && !front.number(2, minute)) {
    return kForm;
  }
  if (hour > 23 || minute > 59) return "there is no such offset from UTC; correct it";
  minutes = (west ? -1 : 1) * (hour * 60 + minute);
  return {};
}

std::string_view days_of(int year, int month, int day, std::int64_t& days) {
  const std::chrono::year_month_day date(std::chrono::year(year),
                                         std::chrono::month(static_cast<unsigned>(month)),
                                         std::chrono::day(static_cast<unsigned>(day)));
  if (!date.ok()) return "there is no such day; correct it";
  days = std::chrono::sys_days(date).time_since_epoch().count();
  return {};
}

// "15-Jan-2024", which leaves no doubt. Whether it is that is the first answer; `problem` says what
// is wrong with it then.
bool takes_named_month(Front& front, std::int64_t& days, std::string_view& problem) {
  Front ahead = front;
  int day = 0;
  int month = 0;
  int year = 0;
  if (!ahead.short_number(day)) return false;
  const std::string_view between = ahead.rest().substr(0, 1);
  if (!ahead.any_of("-/ ") || !ahead.month(month) || !ahead.any_of(between)) return false;
  if (!ahead.number(4, year)) {
    problem = kShortYear;
    return true;
  }
  front = ahead;
  problem = days_of(year, month, day, days);
  return true;
}

// "27/10/2024".
std::string_view parse_year_last(Front& front, DateOrder order, std::int64_t& days) {
  int first = 0;
  int second = 0;
  int year = 0;
  if (!front.short_number(first)) return kForm;
  const std::string_view between = front.rest().substr(0, 1);
  if (!front.any_of("./-") || !front.short_number(second) || !front.any_of(between)) return kForm;
  const bool short_year = !front.number(4, year);
  if (short_year && !front.number(2, year)) return kForm;
  if (order == DateOrder::kUnsaid) return kOtherDate;
  if (short_year) return kShortYear;
  const bool day_first = order == DateOrder::kDayFirst;
  const int month = day_first ? second : first;
  if (month > 12) return day_first ? kNotDayFirst : kNotMonthFirst;
  return days_of(year, month, day_first ? first : second, days);
}

std::string_view parse_date(Front& front, DateOrder order, std::int64_t& days) {
  int year = 0;
  int month = 0;
  int day = 0;
  std::string_view problem;
  if (takes_named_month(front, days, problem)) return problem;
  if (!front.number(4, year)) return parse_year_last(front, order, days);
  const std::string_view between = front.rest().substr(0, 1);
  if (!front.any_of("-/.") || !front.number(2, month) || !front.any_of(between) ||
      !front.number(2, day)) {
    return kForm;
  }
  return days_of(year, month, day, days);
}

std::int64_t seconds_of(const Clock& clock) {
  return (std::int64_t{clock.hour} * 60 + clock.minute) * 60 + clock.second;
}

// `whole` + `nanos` billionths, rounded once.
double nearest_double(std::int64_t whole, std::int64_t nanos) {
  const bool negative = whole < 0;
  if (negative) {
    whole = -whole;
    if (nanos > 0) {
      whole -= 1;
      nanos = kNanosPerSecond - nanos;
    }
  }
  std::array<char, 40> text = {};
  char* at = std::to_chars(text.data(), text.data() + 24, whole).ptr;
  *at++ = '.';
  for (std::int64_t unit = kNanosPerSecond / 10; unit > 0; unit /= 10) {
    *at++ = static_cast<char>('0' + nanos / unit % 10);
  }
  double value = 0.0;
  std::from_chars(text.data(), at, value);
  return negative ? -value : value;
}

}  // namespace

bool looks_like_iso_time(std::string_view text) {
  Front front(text);
  int number = 0;
  if (!front.number(4, number)) return false;
  if (front.any_of("-/")) return true;
  // "2024.08.01"; not the number 2024.08
  return front.any_of(".") && front.number(2, number) && front.any_of(".");
}

bool looks_like_named_month(std::string_view text) {
  Front front(text);
  std::int64_t days = 0;
  std::string_view problem;
  if (takes_named_month(front, days, problem)) return true;
  Clock clock;
  front = Front(text);
  return parse_clock(front, clock).empty() && front.any_of(" ") &&
         takes_named_month(front, days, problem);
}

bool looks_like_other_date(std::string_view text) {
  const DateDigits digits = date_digits(text);
  const bool year_first = digits[0] == 4 && is_short(digits[1]) && is_short(digits[2]);
  return year_first || ends_with_year(digits);
}

bool looks_like_clock(std::string_view text) {
  int number = 0;
  Front front(text);
  return front.short_number(number) && front.any_of(":") && front.number(2, number) &&
         front.any_of(":");
}

bool looks_like_hours_and_minutes(std::string_view text) {
  int number = 0;
  Front front(text);
  if (!front.short_number(number) || !front.any_of(":") || !front.number(2, number)) return false;
  Clock half;
  half.hour = 1;
  return parse_half_day(front, half).empty() && front.rest().empty();
}

std::optional<DateOrder> order_told_by(std::string_view text) {
  if (!ends_with_year(date_digits(text))) return std::nullopt;
  Front front(text);
  int first = 0;
  int second = 0;
  if (!front.short_number(first)) return std::nullopt;
  if (front.any_of(".")) return DateOrder::kDayFirst;
  if (!front.any_of("/-") || !front.short_number(second)) return std::nullopt;
  const bool day_first = first > 12 && first <= 31 && second <= 12;
  const bool month_first = second > 12 && second <= 31 && first <= 12;
  if (day_first == month_first) return DateOrder::kUnsaid;
  return day_first ? DateOrder::kDayFirst : DateOrder::kMonthFirst;
}

std::string_view parse_wall_time(std::string_view text, WallTime& time, DateOrder order) {
  Front front(text);
  std::int64_t days = 0;
  Clock clock;
  // "00:00:00 15-Jan-2024"
  if (Front ahead = front; parse_clock(ahead, clock).empty() && ahead.any_of(" ")) {
    std::string_view problem;
    if (takes_named_month(ahead, days, problem)) {
      if (problem.empty() && !ahead.rest().empty()) problem = kForm;
      if (!problem.empty()) return problem;
      time.seconds = days * kSecondsPerDay + seconds_of(clock);
      time.nanos = clock.nanos;
      time.offset_s.reset();
      return {};
    }
  }
  clock = {};
  if (const auto problem = parse_date(front, order, days); !problem.empty()) return problem;
  if (front.rest().empty()) return "it is a day without a time; write it as 2024-05-01T12:00:00Z";
  front.any_of(",");
  if (!front.any_of("Tt ")) return kForm;
  while (front.any_of(" ")) {
  }
  if (const auto problem = parse_clock(front, clock); !problem.empty()) return problem;
  std::optional<int> minutes;
  if (const auto problem = parse_zone(front, minutes); !problem.empty()) return problem;
  if (!front.rest().empty()) return kForm;
  time.seconds = days * kSecondsPerDay + seconds_of(clock);
  time.nanos = clock.nanos;
  time.offset_s.reset();
  if (minutes) time.offset_s = std::int64_t{*minutes} * 60;
  return {};
}

std::string_view parse_clock(std::string_view text, WallTime& time) {
  constexpr std::string_view kClockForm = "write it as 07:00:00, or 07:00:00.25";
  Front front(text);
  Clock clock;
  if (const auto problem = parse_clock(front, clock); !problem.empty()) {
    return problem == kForm ? kClockForm : problem;
  }
  std::optional<int> minutes;
  if (!parse_zone(front, minutes).empty() || !front.rest().empty()) return kClockForm;
  time.seconds = seconds_of(clock);
  time.nanos = clock.nanos;
  time.offset_s.reset();
  if (minutes) time.offset_s = std::int64_t{*minutes} * 60;
  return {};
}

namespace {

// Of what stands behind a day: nothing, or " 00:00:00".
bool is_midnight(std::string_view behind) {
  if (behind.empty()) return true;
  if (behind.front() != ' ' && behind.front() != 'T') return false;
  const std::string_view time = behind.substr(1);
  return time == "00:00:00" || time == "00:00" || time == "0:00" || time == "0:00:00" ||
         time == "00:00:00.000";
}

}  // namespace

std::string_view parse_day(std::string_view text, std::int64_t& seconds, DateOrder order) {
  Front front(text);
  std::int64_t days = 0;
  const auto problem = parse_date(front, order, days);
  if (problem == kForm) return "write the day as 2024-05-01";
  // Excel and pandas write a day as its midnight.
  if (problem.empty() && !is_midnight(front.rest())) return "write the day as 2024-05-01";
  seconds = days * kSecondsPerDay;
  return problem;
}

std::string_view parse_offset(std::string_view text, int& minutes) {
  Front front(text);
  std::optional<int> found;
  if (const auto problem = parse_zone(front, found); !problem.empty()) return problem;
  if (!found || !front.rest().empty()) return kForm;
  minutes = *found;
  return {};
}

double seconds_after(const WallTime& time, std::int64_t from_s) {
  return nearest_double(time.seconds - from_s, time.nanos);
}

std::string_view parse_iso_time(std::string_view text, double& seconds) {
  WallTime time;
  if (const auto problem = parse_wall_time(text, time); !problem.empty()) return problem;
  if (!time.offset_s) {
    return "it has no time zone; write Z for UTC behind it, or an offset such as +02:00";
  }
  seconds = seconds_after(time, *time.offset_s);
  return {};
}

}  // namespace beespace::io
