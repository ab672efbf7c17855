// MAVLink frames and logs, written by the protocol's description with independent code.
#pragma once

#include <bit>
#include <cstdint>
#include <string>
#include <string_view>

namespace beespace::io {

inline std::string little_endian(std::uint32_t value, int bytes) {
  std::string text;
  for (int i = 0; i < bytes; ++i) text += static_cast<char>(value >> 8 * i & 0xFF);
  return text;
}

// One bit after the other, where the reader takes eight: X.25, reflected, not inverted at the end.
inline std::uint32_t crc_bit_by_bit(std::string_view bytes) {
  std::uint32_t crc = 0xFFFF;
  for (const char c : bytes) {
    crc ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit) crc = (crc & 1) != 0 ? crc >> 1 ^ 0x8408 : crc >> 1;
  }
  return crc;
}

inline char crc_extra(std::uint32_t message) {
  switch (message) {
    case 0:
      return static_cast<char>(50);
    case 2:
      return static_cast<char>(137);
    case 24:
      return static_cast<char>(24);
    case 32:
    case 109:
      return static_cast<char>(185);
    case 33:
      return static_cast<char>(104);
    case 230:
      return static_cast<char>(163);
    case 245:
      return static_cast<char>(130);
    case 12901:
      return static_cast<char>(254);
    default:
      return 1;
  }
}

inline std::string frame_v1(int system, std::uint32_t message, std::string_view payload,
                            int component = 1) {
  std::string frame = "\xFE";
  frame += static_cast<char>(payload.size());
  frame += '\x05';  // sequence
  frame += static_cast<char>(system);
  frame += static_cast<char>(component);
  frame += static_cast<char>(message);
  frame += payload;
  const std::string checked = frame.substr(1) + crc_extra(message);
  return frame + little_endian(crc_bit_by_bit(checked), 2);
}

inline std::string frame_v2(int system, std::uint32_t message, std::string_view payload,
                            int component = 1, bool is_signed = false) {
  while (payload.size() > 1 && payload.back() == '\0') payload.remove_suffix(1);
  std::string frame = "\xFD";
  frame += static_cast<char>(payload.size());
  frame += is_signed ? '\x01' : '\0';
  frame += '\0';
  frame += '\x05';  // sequence
  frame += static_cast<char>(system);
  frame += static_cast<char>(component);
  frame += little_endian(message, 3);
  frame += payload;
  const std::string checked = frame.substr(1) + crc_extra(message);
  frame += little_endian(crc_bit_by_bit(checked), 2);
  return is_signed ? frame + "thirteenbytes" : frame;
}

// Message 33: 1e-7 degrees, millimetres, cm/s north, east, down.
inline std::string global_payload(std::int32_t lat, std::int32_t lon, std::int32_t alt, int vn,
                                  int ve, int vd, std::uint32_t boot_ms = 123'456,
                                  std::int32_t above_mm = 0) {
  const auto unsigned_of = [](std::int32_t value) { return static_cast<std::uint32_t>(value); };
  return little_endian(boot_ms, 4) + little_endian(unsigned_of(lat), 4) +
         little_endian(unsigned_of(lon), 4) + little_endian(unsigned_of(alt), 4) +
         little_endian(unsigned_of(above_mm), 4) + little_endian(unsigned_of(vn), 2) +
         little_endian(unsigned_of(ve), 2) + little_endian(unsigned_of(vd), 2) +
         little_endian(0, 2);
}

inline std::string somewhere() {
  return global_payload(470'000'000, 80'000'000, 500'000, 100, 200, 300);
}

// Message 2: microseconds since 1970, and milliseconds since the start.
inline std::string system_time(std::uint64_t unix_us, std::uint32_t boot_ms) {
  return little_endian(static_cast<std::uint32_t>(unix_us), 4) +
         little_endian(static_cast<std::uint32_t>(unix_us >> 32), 4) + little_endian(boot_ms, 4);
}

// Message 0: what the sender is, whether it is armed (128 in its mode), and its state.
inline std::string heartbeat(int type, int autopilot = 3, int mode = 0, int state = 0) {
  return little_endian(0, 4) + static_cast<char>(type) + static_cast<char>(autopilot) +
         static_cast<char>(mode) + static_cast<char>(state) + '\x03';
}

// Message 245: MAV_LANDED_STATE, 1 on the ground, 2 in the air.
inline std::string landed_state(int state) {
  return std::string(1, '\0') + static_cast<char>(state);
}

// Message 32: metres and m/s north, east, down.
inline std::string local_payload(float n, float e, float d, float vn, float ve, float vd) {
  std::string payload = little_endian(123'456, 4);
  for (const float value : {n, e, d, vn, ve, vd}) {
    payload += little_endian(std::bit_cast<std::uint32_t>(value), 4);
  }
  return payload;
}

// The frame behind the time at which it came, as a log holds it.
inline std::string logged(std::uint64_t micros, const std::string& frame) {
  std::string text;
  for (int byte = 7; byte >= 0; --byte) text += static_cast<char>(micros >> 8 * byte & 0xFF);
  return text + frame;
}

}  // namespace beespace::io
