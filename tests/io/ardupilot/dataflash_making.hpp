// DataFlash logs of ArduPilot, written by the description of the format with code that the reader
// does not share. tests/cli/robotics/make-files --check-dataflash says what pymavlink finds in
// them.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

namespace beespace::io {

// What a message says, field after field, in the byte order of drones.
class DataflashBody {
 public:
  DataflashBody& u8(unsigned value) { return put(value, 1); }
  DataflashBody& u16(unsigned value) { return put(value, 2); }
  DataflashBody& u32(std::uint32_t value) { return put(value, 4); }
  DataflashBody& i32(double value) {
    return put(static_cast<std::uint32_t>(static_cast<std::int32_t>(std::lround(value))), 4);
  }
  DataflashBody& u64(std::uint64_t value) { return put(value, 8); }
  DataflashBody& f32(double value) {
    return put(std::bit_cast<std::uint32_t>(static_cast<float>(value)), 4);
  }
  DataflashBody& text(std::string_view value, std::size_t width) {
    bytes_ += value;
    bytes_.append(width - value.size(), '\0');
    return *this;
  }
  [[nodiscard]] const std::string& bytes() const { return bytes_; }

 private:
  DataflashBody& put(std::uint64_t value, int bytes) {
    for (int i = 0; i < bytes; ++i) bytes_ += static_cast<char>(value >> 8 * i & 0xFF);
    return *this;
  }

  std::string bytes_;
};

inline constexpr unsigned kPos = 10;
inline constexpr unsigned kGps = 11;
inline constexpr unsigned kEv = 12;
inline constexpr unsigned kXkf4 = 13;
inline constexpr unsigned kMsg = 14;
inline constexpr unsigned kStat = 15;
inline constexpr unsigned kOther = 16;
inline constexpr unsigned kXkf1 = 17;

struct GpsMotion {
  double speed = 0.0;
  double course_deg = 0.0;
  double down = 0.0;
};

// A log grows at its end.
class DataflashMaking {
 public:
  DataflashMaking() { define(128, 89, "FMT", "BBnNZ", "Type,Length,Name,Format,Columns"); }

  DataflashMaking& define(unsigned type, unsigned length, std::string_view name,
                          std::string_view letters, std::string_view labels) {
    DataflashBody body;
    body.u8(type).u8(length).text(name, 4).text(letters, 16).text(labels, 64);
    return data(128, body);
  }
  DataflashMaking& data(unsigned type, const DataflashBody& body) {
    bytes_ += "\xA3\x95";
    bytes_ += static_cast<char>(type);
    bytes_ += body.bytes();
    return *this;
  }
  DataflashMaking& raw(std::string_view bytes) {
    bytes_ += bytes;
    return *this;
  }
  [[nodiscard]] const std::string& bytes() const { return bytes_; }

  // At that many microseconds since the vehicle was switched on.
  DataflashMaking& pos(std::uint64_t micros, double lat = 47.25, double lon = 8.5,
                       double alt = 512.0, double above_home = 12.0) {
    DataflashBody body;
    body.u64(micros).i32(lat * 1e7).i32(lon * 1e7).f32(alt).f32(above_home).f32(above_home);
    return data(kPos, body);
  }
  DataflashMaking& gps(std::uint64_t micros, unsigned week, std::uint32_t week_ms,
                       unsigned status = 3, unsigned receiver = 0, const GpsMotion& motion = {}) {
    DataflashBody body;
    body.u64(micros).u8(receiver).u8(status).u32(week_ms).u16(week).u8(14).u16(80);
    body.i32(47.25e7).i32(8.5e7).i32(51'200);
    body.f32(motion.speed).f32(motion.course_deg).f32(motion.down).f32(0).u8(1);
    return data(kGps, body);
  }
  DataflashMaking& event(std::uint64_t micros, unsigned number) {
    return data(kEv, DataflashBody().u64(micros).u8(number));
  }
  // `flags` of the solution.
  DataflashMaking& status(std::uint64_t micros, unsigned flags, unsigned core = 0,
                          unsigned primary = 0) {
    return data(kXkf4, DataflashBody().u64(micros).u8(core).u32(flags).u8(primary));
  }
  DataflashMaking& velocity(std::uint64_t micros, double north, double east, double down,
                            unsigned core = 0) {
    return data(kXkf1, DataflashBody().u64(micros).u8(core).f32(north).f32(east).f32(down));
  }
  DataflashMaking& says(std::string_view text) {
    return data(kMsg, DataflashBody().u64(1).text(text, 64));
  }
  DataflashMaking& flying(std::uint64_t micros, bool flies) {
    return data(kStat, DataflashBody().u64(micros).u8(flies ? 1 : 0));
  }

 private:
  std::string bytes_;
};

// All definitions, as ArduPilot 4.5 writes them where more than names and times is read of them.
inline DataflashMaking ardupilot_log(std::string_view vehicle = "ArduCopter V4.5.7 (2a3dc4b7)") {
  DataflashMaking log;
  log.define(kPos, 31, "POS", "QLLfff", "TimeUS,Lat,Lng,Alt,RelHomeAlt,RelOriginAlt");
  log.define(kGps, 51, "GPS", "QBBIHBcLLeffffB",
             "TimeUS,I,Status,GMS,GWk,NSats,HDop,Lat,Lng,Alt,Spd,GCrs,VZ,Yaw,U");
  log.define(kEv, 12, "EV", "QB", "TimeUS,Id");
  log.define(kXkf4, 17, "XKF4", "QBIB", "TimeUS,C,SS,PI");
  log.define(kXkf1, 24, "XKF1", "QBfff", "TimeUS,C,VN,VE,VD");
  log.define(kMsg, 75, "MSG", "QZ", "TimeUS,Message");
  log.define(kStat, 12, "STAT", "QB", "TimeUS,isFlying");
  log.define(kOther, 77, "ISBD", "QBaB", "TimeUS,N,x,y");
  return log.says(vehicle);
}

// 2026-03-01T14:00:00Z: GPS is 18 s ahead of UTC.
inline constexpr unsigned kWeek = 2408;
inline constexpr std::uint32_t kWeekMs = 50'418'000;
inline constexpr double kStarted_s = 1'772'373'600.0;

// Two places and a time of GPS: it was switched on 5 s before.
inline DataflashMaking small_dataflash_log() {
  DataflashMaking log = ardupilot_log();
  log.gps(5'000'000, kWeek, kWeekMs);
  return log.pos(5'000'000).pos(5'500'000, 47.2500001);
}

}  // namespace beespace::io
