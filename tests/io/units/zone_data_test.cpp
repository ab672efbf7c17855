// Zone data as files have them: many changes listed ("fat"), or few and a rule ("slim"). What
// clocks show is compared with localtime() of the C library, which reads the same files.
#include "io/units/zone_data.hpp"

#include <gtest/gtest.h>

#include <stdlib.h>
#include <time.h>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "io/units/time_zone.hpp"
#include "io/units/zone_rule.hpp"

namespace beespace::io {
namespace {

constexpr std::int64_t kDay_s = 86'400;

std::int64_t begin_of(int year) {
  const std::chrono::sys_days day = std::chrono::year(year) / 1 / 1;
  return std::int64_t{day.time_since_epoch().count()} * kDay_s;
}

void append_number(std::string& out, std::int64_t value, int bytes) {
  for (int i = bytes - 1; i >= 0; --i) out += static_cast<char>(value >> (8 * i) & 0xFF);
}

// One half of a file: changes to types, which are offsets.
std::string half(const std::vector<std::pair<std::int64_t, int>>& changes,
                 const std::vector<std::int64_t>& types, int time_bytes) {
  std::string out = "TZif2" + std::string(15, '\0');
  const std::vector<std::size_t> counts = {0, 0, 0, changes.size(), types.size(), 4};
  for (const std::size_t count : counts) append_number(out, static_cast<std::int64_t>(count), 4);
  for (const auto& change : changes) append_number(out, change.first, time_bytes);
  for (const auto& change : changes) out += static_cast<char>(change.second);
  for (const std::int64_t offset_s : types) {
    append_number(out, offset_s, 4);
    out += std::string(2, '\0');
  }
  return out + std::string("ABC\0", 4);
}

std::string zone_file(const std::vector<std::pair<std::int64_t, int>>& changes,
                      const std::vector<std::int64_t>& types, const std::string& footer) {
  return half({}, {0}, 4) + half(changes, types, 8) + "\n" + footer + "\n";
}

// The last Sunday of a month.
std::int64_t last_sunday(int year, unsigned month) {
  const std::chrono::sys_days day =
      std::chrono::year(year) / std::chrono::month(month) / std::chrono::Sunday[std::chrono::last];
  return std::int64_t{day.time_since_epoch().count()} * kDay_s;
}

// A folder of zone data that this process looks into.
class ZoneFolder {
 public:
  ZoneFolder() : folder_(testing::TempDir() + "beespace_zones") {
    std::filesystem::create_directories(folder_ + "/Made");
    setenv("TZDIR", folder_.c_str(), 1);
  }
  ~ZoneFolder() {
    unsetenv("TZDIR");
    unsetenv("TZ");
    tzset();
    std::filesystem::remove_all(folder_);
  }
  ZoneFolder(const ZoneFolder&) = delete;
  ZoneFolder& operator=(const ZoneFolder&) = delete;

  void write(const std::string& name, const std::string& bytes) const {
    std::ofstream(folder_ + "/" + name, std::ios::binary) << bytes;
  }

 private:
  std::string folder_;
};

// The oracle: of the zone in TZ.
std::int64_t offset_by_c(std::int64_t since_1970_s) {
  const auto at = static_cast<time_t>(since_1970_s);
  tm there = {};
  EXPECT_NE(localtime_r(&at, &there), nullptr);
  return there.tm_gmtoff;
}

void expect_same_clock(std::int64_t at_s, const ZoneData& zone, const std::string& name) {
  const std::int64_t offset_s = offset_by_c(at_s);
  ASSERT_EQ(offset_at(zone, at_s), offset_s) << name << " at " << at_s;
  const LocalTime there = local_time(zone, at_s + offset_s);
  if (there.shown == LocalTime::Shown::kOnce) {
    ASSERT_EQ(there.offset_s, offset_s) << name << " at " << at_s;
    return;
  }
  ASSERT_EQ(there.shown, LocalTime::Shown::kTwice) << name << " at " << at_s;
  ASSERT_TRUE(there.offset_s == offset_s || there.later_s == offset_s) << name << " at " << at_s;
  ASSERT_GT(there.offset_s, there.later_s);
  for (const std::int64_t each_s : {there.offset_s, there.later_s}) {
    ASSERT_EQ(offset_by_c(at_s + offset_s - each_s), each_s) << name << " at " << at_s;
  }
}

// From the first year to the last, and at each change of both.
void expect_same_clocks(const std::string& name, const std::string& bytes, int first, int last) {
  setenv("TZ", (":" + name).c_str(), 1);
  tzset();
  const auto zone = parse_zone_data(bytes);
  ASSERT_TRUE(zone) << name;
  for (std::int64_t at_s = begin_of(first); at_s < begin_of(last); at_s += 5 * kDay_s + 3'601) {
    expect_same_clock(at_s, *zone, name);
  }
  for (const ZoneData::Change& change : zone->changes) {
    if (change.at_s < begin_of(first) || change.at_s > begin_of(last)) continue;
    for (const std::int64_t by_s : {-7'201, -3'600, -1, 0, 1, 3'600, 7'201}) {
      expect_same_clock(change.at_s + by_s, *zone, name);
    }
  }
  if (testing::Test::HasFatalFailure()) return;
}

// Spain, of which a slim file lists the changes before 1996 only.
TEST(ZoneData, ASlimFileAndAFatOneSayTheSame) {
  const std::string rule = "CET-1CEST,M3.5.0,M10.5.0/3";
  std::vector<std::pair<std::int64_t, int>> changes;
  for (int year = 1996; year <= 2037; ++year) {
    changes.emplace_back(last_sunday(year, 3) + 3600, 1);
    changes.emplace_back(last_sunday(year, 10) + 3600, 0);
  }
  const ZoneFolder folder;
  const std::string fat = zone_file(changes, {3600, 7200}, rule);
  const std::string slim = zone_file({changes[0], changes[1]}, {3600, 7200}, rule);
  folder.write("Made/Fat", fat);
  folder.write("Made/Slim", slim);
  expect_same_clocks("Made/Fat", fat, 1990, 2460);
  expect_same_clocks("Made/Slim", slim, 1990, 2460);
  const auto by_fat = parse_zone_data(fat);
  const auto by_slim = parse_zone_data(slim);
  for (std::int64_t at_s = begin_of(1990); at_s < begin_of(9999); at_s += 31 * kDay_s + 1) {
    ASSERT_EQ(offset_at(*by_fat, at_s), offset_at(*by_slim, at_s)) << at_s;
  }
  const auto zone = TimeZone::find("Made/Slim");
  ASSERT_TRUE(zone) << zone.error().message;
  EXPECT_EQ(zone->offset_at(begin_of(2045) + 200 * kDay_s), 7200);
}

// Rules as zones of the north and of the south have them, and every way to write a day.
TEST(ZoneData, RulesGoOnForEver) {
  const ZoneFolder folder;
  const std::int64_t listed = begin_of(1990) + 40 * kDay_s;
  const std::vector<std::pair<std::string, std::int64_t>> rules = {
      {"AEST-10AEDT,M10.1.0,M4.1.0/3", 39'600},          // Sydney, at the beginning of a year
      {"NZST-12NZDT,M9.5.0,M4.1.0/3", 46'800},           // Auckland
      {"<-04>4<-03>,M9.1.6/24,M4.1.6/24", -10'800},      // Santiago
      {"EST5EDT,M3.2.0,M11.1.0", -18'000},               // New York
      {"IST-1GMT0,M10.5.0,M3.5.0/1", 0},                 // Dublin: summer is the standard
      {"<-02>2<-01>,M3.5.0/-1,M10.5.0/0", -7'200},       // Nuuk
      {"IST-2IDT,M3.4.4/26,M10.5.0", 7'200},             // Jerusalem
      {"<+1030>-10:30<+11>-11,M10.1.0,M4.1.0", 39'600},  // Lord Howe: half an hour
      {"<+0530>-5:30", 19'800},                          // no summer
      {"AAA3BBB,J60/2,J300/2", -10'800},
      {"AAA3BBB,59/2,299/2", -10'800}};
  for (const auto& [rule, then_s] : rules) {
    const std::string bytes = zone_file({{listed, 0}}, {then_s}, rule);
    folder.write("Made/Ruled", bytes);
    setenv("TZ", ":Made/Other", 1);
    tzset();
    expect_same_clocks("Made/Ruled", bytes, 1991, 2110);
    if (HasFatalFailure()) FAIL() << rule;
  }
}

TEST(ZoneData, TheSystemsZonesAreThoseOfTheCLibrary) {
  for (const std::string name : {"Europe/Madrid", "Australia/Sydney", "America/New_York", "UTC",
                                 "Europe/Dublin", "Africa/Casablanca", "Asia/Kolkata"}) {
    std::ifstream file("/usr/share/zoneinfo/" + name, std::ios::binary);
    if (!file) GTEST_SKIP() << "no zone data of " << name;
    const std::string bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    expect_same_clocks(name, bytes, 1920, 2110);
  }
  unsetenv("TZ");
  tzset();
}

// Clocks are turned forward over the whole hour: no instant shows it.
TEST(ZoneData, WhatIsNeverShownIsKnownByTheRule) {
  const auto zone = parse_zone_data(zone_file({}, {3600}, "CET-1CEST,M3.5.0,M10.5.0/3"));
  ASSERT_TRUE(zone);
  for (const int year : {1970, 2045, 2850}) {
    const std::int64_t night_s = last_sunday(year, 3);
    EXPECT_EQ(local_time(*zone, night_s + 7199).shown, LocalTime::Shown::kOnce);
    for (const std::int64_t by_s : {7200, 10'799}) {
      const LocalTime there = local_time(*zone, night_s + by_s);
      EXPECT_EQ(there.shown, LocalTime::Shown::kNever) << year;
      EXPECT_EQ(there.offset_s, 3600);
      EXPECT_EQ(there.later_s, 7200);
    }
    EXPECT_EQ(local_time(*zone, night_s + 10'800).offset_s, 7200);
  }
}

TEST(ZoneData, SummerMayNeverEnd) {
  const auto zone = parse_zone_data(zone_file({}, {0}, "XXX3EDT4,0/0,J365/23"));
  ASSERT_TRUE(zone);
  for (std::int64_t at_s = begin_of(2000); at_s < begin_of(2030); at_s += kDay_s / 2) {
    ASSERT_EQ(offset_at(*zone, at_s), -14'400);
  }
}

// Nothing says how clocks go on behind the last change.
TEST(ZoneData, WithoutARuleItEndsWithItsLastChange) {
  const ZoneFolder folder;
  const std::int64_t changed_s = begin_of(2000);
  folder.write("Made/Ended", zone_file({{changed_s, 1}}, {3600, 7200}, ""));
  const auto zone = TimeZone::find("Made/Ended");
  ASSERT_TRUE(zone) << zone.error().message;
  std::int64_t offset_s = 0;
  EXPECT_EQ(zone->offset_of_local(changed_s, offset_s), "");
  EXPECT_EQ(offset_s, 3600);
  EXPECT_NE(zone->offset_of_local(changed_s + 2 * 3600, offset_s).find("is not known"),
            std::string::npos);
}

TEST(ZoneData, DamagedFilesAndNamesThatLeadOutAreRefused) {
  const std::string good = zone_file({{0, 0}, {10, 1}}, {3600, 7200}, "CET-1");
  ASSERT_TRUE(parse_zone_data(good));
  const std::size_t data = half({}, {0}, 4).size() + 44;
  for (std::size_t size = 0; size < data + 2 * 9 + 2 * 6 + 4; ++size) {
    EXPECT_FALSE(parse_zone_data(good.substr(0, size))) << size;
  }
  std::string other_type = good;
  other_type[data + 16] = '\2';
  EXPECT_FALSE(parse_zone_data(other_type));
  EXPECT_FALSE(parse_zone_data(zone_file({{10, 0}, {10, 1}}, {3600, 7200}, "CET-1")));
  EXPECT_FALSE(parse_zone_data(zone_file({}, {200'000}, "CET-1")));
  std::string leaping = good;
  leaping[half({}, {0}, 4).size() + 20 + 11] = '\1';
  EXPECT_FALSE(parse_zone_data(leaping));
  EXPECT_FALSE(TimeZone::find("../../../etc/passwd"));
  EXPECT_FALSE(TimeZone::find("/usr/share/zoneinfo/Europe/Madrid"));
  EXPECT_FALSE(TimeZone::find("zone.tab"));
  EXPECT_FALSE(TimeZone::find("Europe"));
}

TEST(ZoneData, WhatIsNoRuleIsNone) {
  for (const char* const text :
       {"", "CET", "CE-1", "CET-1CEST", "CET-25", "CET-1CEST,M3.5.0", "CET-1CEST,M13.5.0,M10.5.0",
        "CET-1CEST,M3.6.0,M10.5.0", "CET-1CEST,M3.5.7,M10.5.0", "CET-1CEST,J0,J10",
        "CET-1CEST,366,1", "CET-1CEST,M3.5.0/168,M10.5.0", "CET-1CEST,M3.5.0,M10.5.0/3,", "<CET-1",
        "<>-1", "CET-1:60", "CET-1CEST,M3.5.0,M10.5.0 "}) {
    EXPECT_FALSE(parse_zone_rule(text)) << text;
  }
  EXPECT_EQ(parse_zone_rule("<+0545>-5:45:30")->offset_s, 20'730);
}

}  // namespace
}  // namespace beespace::io
