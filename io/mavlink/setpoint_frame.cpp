#include "io/mavlink/setpoint_frame.hpp"

#include "io/mavlink/mavlink_frame.hpp"

#include <bit>
#include <cstddef>

namespace beespace::io {
namespace {

constexpr std::uint32_t kSetPositionTargetLocalNed = 84;
constexpr char kExtra = static_cast<char>(143);  // what its meaning adds to the checksum
// A planner on the ground, as mavlink.io proposes.
constexpr std::uint8_t kSystem = 255;
constexpr std::uint8_t kComponent = 190;
constexpr std::uint8_t kAutopilot = 1;
constexpr std::uint8_t kLocalNed = 1;
// What the receiver leaves out of account.
constexpr std::uint16_t kNoPosition = 0x0007;
constexpr std::uint16_t kNoAccelerationNorYaw = 0x0DC0;

// Lowest byte first.
void append_number(std::string& out, std::uint32_t value, int bytes) {
  for (int i = 0; i < bytes; ++i) {
    out += static_cast<char>(value & 0xFFu);
    value >>= 8u;
  }
}

void append_float(std::string& out, double value) {
  append_number(out, std::bit_cast<std::uint32_t>(static_cast<float>(value)), 4);
}

std::string payload_of(const SetpointFrame& frame) {
  const Point& p = frame.setpoint.position;
  const Velocity& v = frame.setpoint.velocity;
  std::string payload;
  append_number(payload, frame.time_boot_ms, 4);
  for (const double value : {p.y, p.x, -p.z}) {
    append_float(payload, frame.velocity_only ? 0.0 : value);
  }
  for (const double value : {v.y, v.x, -v.z}) append_float(payload, value);
  for (int i = 0; i < 5; ++i) append_float(payload, 0.0);  // acceleration, yaw, its rate
  append_number(payload, kNoAccelerationNorYaw | (frame.velocity_only ? kNoPosition : 0u), 2);
  append_number(payload, frame.target_system, 1);
  append_number(payload, kAutopilot, 1);
  append_number(payload, kLocalNed, 1);
  return payload;
}

}  // namespace

// The payload ends with a byte that is not zero, so that none is cut off.
void append_setpoint_frame(std::string& out, const SetpointFrame& frame) {
  const std::string payload = payload_of(frame);
  const std::size_t begin = out.size();
  out += static_cast<char>(kMavlink2);
  append_number(out, static_cast<std::uint32_t>(payload.size()), 1);
  append_number(out, 0, 2);  // no flags
  append_number(out, frame.sequence, 1);
  append_number(out, kSystem, 1);
  append_number(out, kComponent, 1);
  append_number(out, kSetPositionTargetLocalNed, 3);
  out += payload;
  const std::uint16_t crc = mavlink_checksum(std::string_view(out).substr(begin + 1));
  append_number(out, mavlink_checksum({&kExtra, 1}, crc), 2);
}

}  // namespace beespace::io
