// PX4 logs (ULog), written by the description of the format with code that the reader does not
// share. tests/io/px4/check-with-pyulog says that PX4's own reader finds the same in them.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

namespace beespace::io {

// A message's body, field after field, in the byte order of drones.
class UlogBody {
 public:
  UlogBody& u8(unsigned value) { return put(value, 1); }
  UlogBody& u16(unsigned value) { return put(value, 2); }
  UlogBody& u32(std::uint32_t value) { return put(value, 4); }
  UlogBody& i32(std::int32_t value) { return put(static_cast<std::uint32_t>(value), 4); }
  UlogBody& u64(std::uint64_t value) { return put(value, 8); }
  UlogBody& f32(double value) {
    return put(std::bit_cast<std::uint32_t>(static_cast<float>(value)), 4);
  }
  UlogBody& f64(double value) { return put(std::bit_cast<std::uint64_t>(value), 8); }
  UlogBody& text(std::string_view value) {
    bytes_ += value;
    return *this;
  }
  [[nodiscard]] const std::string& bytes() const { return bytes_; }

 private:
  UlogBody& put(std::uint64_t value, int bytes) {
    for (int i = 0; i < bytes; ++i) bytes_ += static_cast<char>(value >> 8 * i & 0xFF);
    return *this;
  }

  std::string bytes_;
};

inline std::string ulog_message(char type, std::string_view body) {
  std::string message = UlogBody().u16(static_cast<unsigned>(body.size())).bytes();
  return (message += type).append(body);
}

// A log grows at its end: definitions, subscriptions, data.
class UlogMaking {
 public:
  explicit UlogMaking(unsigned version = 1) {
    bytes_ = "ULog\x01\x12\x35" + UlogBody().u8(version).u64(1'000'000).bytes();
  }

  UlogMaking& message(char type, std::string_view body) {
    bytes_ += ulog_message(type, body);
    return *this;
  }
  UlogMaking& flags(unsigned incompatible, std::uint64_t appended_at = 0) {
    UlogBody body;
    body.u64(0).u64(incompatible).u64(appended_at).u64(0).u64(0);
    return message('B', body.bytes());
  }
  UlogMaking& format(std::string_view definition) { return message('F', definition); }
  UlogMaking& subscribe(unsigned number, std::string_view topic, unsigned instance = 0) {
    return message('A', UlogBody().u8(instance).u16(number).text(topic).bytes());
  }
  UlogMaking& data(unsigned number, const UlogBody& body) {
    return message('D', UlogBody().u16(number).text(body.bytes()).bytes());
  }
  UlogMaking& sync() { return message('S', "\x2F\x73\x13\x20\x25\x0C\xBB\x12"); }
  UlogMaking& dropout(unsigned milliseconds) {
    return message('O', UlogBody().u16(milliseconds).bytes());
  }
  UlogMaking& raw(std::string_view bytes) {
    bytes_ += bytes;
    return *this;
  }

  [[nodiscard]] const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

// The topics as PX4 1.13 defines them, in the order of its fields, with nested definitions, arrays
// and padding; those that nothing reads are left out where that changes no layout.
inline constexpr std::string_view kGlobalFormat =
    "vehicle_global_position:uint64_t timestamp;uint64_t timestamp_sample;double lat;double lon;"
    "float alt;float alt_ellipsoid;float delta_alt;float eph;float epv;float terrain_alt;"
    "uint8_t lat_lon_reset_counter;uint8_t alt_reset_counter;bool terrain_alt_valid;"
    "bool dead_reckoning;uint8_t[4] _padding0;";
inline constexpr std::string_view kLocalFormat =
    "vehicle_local_position:uint64_t timestamp;uint64_t timestamp_sample;uint64_t ref_timestamp;"
    "double ref_lat;double ref_lon;float x;float y;float z;float[2] delta_xy;float delta_z;"
    "float vx;float vy;float vz;float z_deriv;float ref_alt;heading_of heading;bool xy_valid;"
    "bool z_valid;bool v_xy_valid;bool v_z_valid;bool xy_global;bool z_global;uint8_t[2] "
    "_padding0;";
inline constexpr std::string_view kHeadingFormat = "heading_of:float heading;float delta_heading;";
inline constexpr std::string_view kGpsFormat =
    "vehicle_gps_position:uint64_t timestamp;uint64_t time_utc_usec;int32_t lat;int32_t lon;"
    "int32_t alt;int32_t timestamp_time_relative;uint8_t fix_type;uint8_t[7] _padding0;";

inline constexpr unsigned kGlobalNumber = 3;
inline constexpr unsigned kLocalNumber = 7;
inline constexpr unsigned kGpsNumber = 12;

// All definitions and subscriptions, and what else logs begin with.
inline UlogMaking px4_log() {
  UlogMaking log;
  log.flags(0);
  log.message('I',
              "\x10"
              "char[4] sys_namePX4 ");
  log.format(kGlobalFormat).format(kLocalFormat).format(kHeadingFormat).format(kGpsFormat);
  log.format("battery:float voltage;uint8_t cells;");
  log.message('P', std::string("\x12int32_t MAV_SYS_ID", 19) + UlogBody().i32(3).bytes());
  log.subscribe(kGlobalNumber, "vehicle_global_position");
  log.subscribe(kLocalNumber, "vehicle_local_position");
  log.subscribe(kGpsNumber, "vehicle_gps_position");
  log.subscribe(99, "battery");
  return log;
}

struct GlobalMessage {
  std::uint64_t micros = 0;
  double lat = 47.25;
  double lon = 8.5;
  double alt = 512.0;
  double alt_ellipsoid = 560.0;
  std::uint64_t sample = 0;  // 0: as micros
};

// Without the padding at the end, which PX4 does not write.
inline UlogBody global_message(const GlobalMessage& at) {
  UlogBody body;
  body.u64(at.micros).u64(at.sample != 0 ? at.sample : at.micros).f64(at.lat).f64(at.lon);
  body.f32(at.alt).f32(at.alt_ellipsoid).f32(0).f32(0.5).f32(0.75).f32(0);
  return body.u8(0).u8(0).u8(0).u8(0);
}

struct LocalMessage {
  std::uint64_t micros = 0;
  double x = 0.0;  // north, east, down
  double y = 0.0;
  double z = 0.0;
  double vx = 0.0;
  double vy = 0.0;
  double vz = 0.0;
  bool valid = true;
  bool z_valid = true;
  bool v_valid = true;
  bool global = true;
  double ref_lat = 47.25;
  double ref_lon = 8.5;
  double ref_alt = 500.0;
  std::uint64_t sample = 0;  // 0: as micros
};

inline UlogBody local_message(const LocalMessage& at) {
  UlogBody body;
  body.u64(at.micros).u64(at.sample != 0 ? at.sample : at.micros).u64(17);
  body.f64(at.ref_lat).f64(at.ref_lon).f32(at.x).f32(at.y).f32(at.z);
  body.f32(0).f32(0).f32(0).f32(at.vx).f32(at.vy).f32(at.vz).f32(0).f32(at.ref_alt);
  body.f32(1.5).f32(0).u8(at.valid ? 1 : 0).u8(at.z_valid ? 1 : 0);
  body.u8(at.v_valid ? 1 : 0).u8(at.v_valid ? 1 : 0);
  return body.u8(at.global ? 1 : 0).u8(at.global ? 1 : 0);
}

inline UlogBody gps_message(std::uint64_t micros, std::uint64_t utc, std::int32_t relative = 0) {
  UlogBody body;
  body.u64(micros).u64(utc).i32(472'500'000).i32(85'000'000).i32(512'000);
  return body.i32(relative).u8(3);
}

inline constexpr std::uint64_t kNoon_us = 1714564800'000'000;
inline constexpr double kNoon_s = 1714564800.0;

// Two places and a time of GPS.
inline UlogMaking small_log() {
  UlogMaking log = px4_log();
  log.data(kGpsNumber, gps_message(5'000'000, kNoon_us + 5'000'000));
  log.data(kGlobalNumber, global_message({.micros = 5'000'000}));
  log.data(kGlobalNumber, global_message({.micros = 5'500'000, .lat = 47.2500001}));
  return log;
}

}  // namespace beespace::io
