#include "io/units/zone_data.hpp"

#include "io/units/zone_rule.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <tuple>
#include <utility>

namespace beespace::io {
namespace {

constexpr std::int64_t kDay_s = 86'400;
// After so many years, a whole number of weeks, the calendar repeats itself.
constexpr int kCycleYears = 400;
constexpr std::int64_t kCycle_s = std::int64_t{146'097} * kDay_s;
// More than any clock is ahead of UTC or behind.
constexpr std::int64_t kFarthestOffset_s = std::int64_t{26} * 3600;

// ---- The file ------------------------------------------------------------------------------

std::int64_t big_endian(std::string_view bytes) {
  std::uint64_t value = 0;
  for (const char byte : bytes) value = value << 8U | static_cast<unsigned char>(byte);
  return bytes.size() == 4 ? static_cast<std::int32_t>(static_cast<std::uint32_t>(value))
                           : static_cast<std::int64_t>(value);
}

struct Header {
  char version = '\0';
  // Of marks of UTC and of standard time, leap seconds, changes, types, characters.
  std::array<std::uint64_t, 6> counts = {};

  [[nodiscard]] std::uint64_t leaps() const { return counts[2]; }
  [[nodiscard]] std::uint64_t changes() const { return counts[3]; }
  [[nodiscard]] std::uint64_t types() const { return counts[4]; }
  // Of what follows, with so many bytes for a time.
  [[nodiscard]] std::uint64_t size(std::uint64_t time_bytes) const {
    return counts[0] + counts[1] + leaps() * (time_bytes + 4) + changes() * (time_bytes + 1) +
           types() * 6 + counts[5];
  }
};

class ZoneFile {
 public:
  explicit ZoneFile(std::string_view file) : rest_(file) {}

  std::optional<ZoneData> read() {
    auto header = take_header();
    if (!header) return std::nullopt;
    std::uint64_t time_bytes = 4;
    if (header->version >= '2') {
      // The same follows with longer times.
      if (header->size(time_bytes) > rest_.size()) return std::nullopt;
      rest_.remove_prefix(header->size(time_bytes));
      header = take_header();
      if (!header) return std::nullopt;
      time_bytes = 8;
    }
    if (header->size(time_bytes) > rest_.size()) return std::nullopt;
    if (header->leaps() > 0 || header->types() == 0) return std::nullopt;
    auto data = take_changes(*header, time_bytes);
    if (!data) return std::nullopt;
    rest_.remove_prefix(header->size(time_bytes));
    footer_ = time_bytes == 8 ? rest_ : std::string_view();
    return data;
  }

  // The rule, if there is one.
  [[nodiscard]] std::optional<ZoneRule> rule() const {
    if (footer_.size() < 2 || footer_.front() != '\n') return std::nullopt;
    const std::size_t end = footer_.find('\n', 1);
    if (end == std::string_view::npos) return std::nullopt;
    return parse_zone_rule(footer_.substr(1, end - 1));
  }

 private:
  std::optional<Header> take_header() {
    constexpr std::size_t kSize = 44;
    if (rest_.size() < kSize || !rest_.starts_with("TZif")) return std::nullopt;
    Header header;
    header.version = rest_[4];
    for (std::size_t i = 0; i < header.counts.size(); ++i) {
      header.counts[i] = static_cast<std::uint32_t>(big_endian(rest_.substr(20 + 4 * i, 4)));
    }
    rest_.remove_prefix(kSize);
    return header;
  }

  [[nodiscard]] std::optional<ZoneData> take_changes(const Header& header,
                                                     std::uint64_t time_bytes) const {
    const auto count = static_cast<std::size_t>(header.changes());
    const std::string_view times = rest_.substr(0, count * time_bytes);
    const std::string_view indices = rest_.substr(times.size(), count);
    const std::string_view types =
        rest_.substr(times.size() + count, static_cast<std::size_t>(header.types()) * 6);
    const auto offset_of = [types](std::size_t type) {
      return big_endian(types.substr(type * 6, 4));
    };
    for (std::size_t type = 0; type < header.types(); ++type) {
      const std::int64_t offset_s = offset_of(type);
      if (offset_s < -kFarthestOffset_s || offset_s > kFarthestOffset_s) return std::nullopt;
    }
    ZoneData data;
    data.first_offset_s = offset_of(0);
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t type = static_cast<unsigned char>(indices[i]);
      const std::int64_t at_s = big_endian(times.substr(i * time_bytes, time_bytes));
      if (type >= header.types()) return std::nullopt;
      if (i > 0 && at_s <= data.changes.back().at_s) return std::nullopt;
      data.changes.push_back({at_s, offset_of(type)});
    }
    return data;
  }

  std::string_view rest_;
  std::string_view footer_;
};

// ---- The rule ------------------------------------------------------------------------------

int year_of(std::int64_t since_1970_s) {
  // Beyond all years that can be written, and well within those that can be computed with.
  constexpr std::int64_t kFarthest_s = 400'000'000'000;
  const std::int64_t near_s = std::clamp(since_1970_s, -kFarthest_s, kFarthest_s);
  const auto day =
      std::chrono::floor<std::chrono::days>(std::chrono::sys_seconds(std::chrono::seconds(near_s)));
  return static_cast<int>(std::chrono::year_month_day(day).year());
}

std::int64_t begin_of(int year) {
  const std::chrono::sys_days day = std::chrono::year(year) / 1 / 1;
  return std::int64_t{day.time_since_epoch().count()} * kDay_s;
}

// The changes behind those that are listed.
void follow(const ZoneRule& rule, ZoneData& data) {
  constexpr int kBeforeAllZones = 1800;
  const bool listed = !data.changes.empty();
  const std::int64_t after_s = listed ? data.changes.back().at_s : begin_of(kBeforeAllZones);
  if (!rule.summer) {
    if (!listed) data.first_offset_s = rule.offset_s;
    return;
  }
  if (!listed) data.first_offset_s = rule.offset_s;
  const int first = year_of(after_s);
  const int last = first + kCycleYears + 3;
  std::vector<std::pair<ZoneData::Change, bool>> turned;
  for (int year = first - 1; year <= last; ++year) {
    const ZoneRule::Summer& summer = *rule.summer;
    turned.push_back({{summer.begins.in_year(year) - rule.offset_s, summer.offset_s}, true});
    turned.push_back({{summer.ends.in_year(year) - summer.offset_s, rule.offset_s}, false});
  }
  // Where summer ends when it begins, it goes on.
  std::sort(turned.begin(), turned.end(), [](const auto& a, const auto& b) {
    return std::tie(a.first.at_s, a.second) < std::tie(b.first.at_s, b.second);
  });
  for (const auto& [change, begins] : turned) {
    if (change.at_s <= after_s) continue;
    if (!data.changes.empty() && data.changes.back().at_s == change.at_s) data.changes.pop_back();
    data.changes.push_back(change);
  }
  data.repeats_from_s = begin_of(first + kCycleYears + 2);
}

// The same instant, or time on a clock, of the years that changes are known of.
std::int64_t within_cycle(const ZoneData& zone, std::int64_t time_s) {
  if (!zone.repeats_from_s || time_s < *zone.repeats_from_s) return time_s;
  const std::int64_t beyond_s = time_s - *zone.repeats_from_s;
  return *zone.repeats_from_s - kCycle_s + beyond_s % kCycle_s;
}

// The last change that is not later; null where there is none.
const ZoneData::Change* change_before(const ZoneData& zone, std::int64_t at_s) {
  const auto later = std::upper_bound(
      zone.changes.begin(), zone.changes.end(), at_s,
      [](std::int64_t time_s, const ZoneData::Change& change) { return time_s < change.at_s; });
  return later == zone.changes.begin() ? nullptr : &*std::prev(later);
}

std::int64_t offset_within(const ZoneData& zone, std::int64_t at_s) {
  const ZoneData::Change* const change = change_before(zone, at_s);
  return change == nullptr ? zone.first_offset_s : change->offset_s;
}

}  // namespace

std::optional<ZoneData> parse_zone_data(std::string_view file) {
  ZoneFile reader(file);
  auto data = reader.read();
  if (!data) return std::nullopt;
  const auto rule = reader.rule();
  if (rule) {
    follow(*rule, *data);
  } else {
    data->ends = !data->changes.empty();
  }
  return data;
}

std::int64_t offset_at(const ZoneData& zone, std::int64_t since_1970_s) {
  return offset_within(zone, within_cycle(zone, since_1970_s));
}

LocalTime local_time(const ZoneData& zone, std::int64_t local_s) {
  using Shown = LocalTime::Shown;
  local_s = within_cycle(zone, local_s);
  // Every offset that clocks may have had when they showed it.
  const std::int64_t from_s = local_s - kFarthestOffset_s;
  std::int64_t before_s = offset_within(zone, from_s);
  std::optional<LocalTime> found;
  LocalTime never{Shown::kNever, before_s, before_s};
  const auto consider = [&](std::int64_t offset_s) {
    if (offset_within(zone, local_s - offset_s) != offset_s) return;
    if (!found) {
      found = LocalTime{Shown::kOnce, offset_s, offset_s};
    } else if (found->offset_s != offset_s && found->later_s != offset_s) {
      found->shown = Shown::kTwice;
      // Clocks that are farther ahead show it earlier.
      const std::int64_t most_s = std::max(found->offset_s, offset_s);
      found->later_s = std::min(found->later_s, offset_s);
      found->offset_s = most_s;
    }
  };
  consider(before_s);
  const ZoneData::Change* change = change_before(zone, from_s);
  const ZoneData::Change* const end = zone.changes.data() + zone.changes.size();
  change = change == nullptr ? zone.changes.data() : change + 1;
  for (; change != end && change->at_s <= local_s + kFarthestOffset_s; ++change) {
    consider(change->offset_s);
    if (change->at_s + before_s <= local_s && local_s < change->at_s + change->offset_s) {
      never = {Shown::kNever, before_s, change->offset_s};
    }
    before_s = change->offset_s;
  }
  const LocalTime shown = found.value_or(never);
  if (zone.ends && local_s - shown.later_s >= zone.changes.back().at_s) {
    return {Shown::kUnknown, shown.offset_s, shown.later_s};
  }
  return shown;
}

}  // namespace beespace::io
