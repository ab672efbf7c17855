// One frame of MAVLink, version 1 or 2: who sent which message, and whether it came whole.
//
//   v1: FE length sequence system component message(1) payload checksum(2)
//   v2: FD length flags flags sequence system component message(3) payload checksum(2)
//       signature(13, where the first flags say so)
//
// The checksum covers everything behind the first byte, and one byte that the meaning of the
// message gives (CRC_EXTRA). Signatures are passed over: their keys are not in a log.
// Source: mavlink.io, "Packet Serialization".
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace beespace::io {

inline constexpr std::uint32_t kHeartbeat = 0;
inline constexpr std::uint32_t kSystemTime = 2;
inline constexpr std::uint32_t kGpsRawInt = 24;
inline constexpr std::uint32_t kLocalPositionNed = 32;
inline constexpr std::uint32_t kGlobalPositionInt = 33;
inline constexpr std::uint32_t kRadioStatus = 109;
inline constexpr std::uint32_t kGps2Raw = 124;
inline constexpr std::uint32_t kEstimatorStatus = 230;
inline constexpr std::uint32_t kExtendedSysState = 245;
inline constexpr std::uint32_t kAdsbVehicle = 246;
inline constexpr std::uint32_t kUtmGlobalPosition = 340;
inline constexpr std::uint32_t kRemoteIdLocation = 12'901;  // OPEN_DRONE_ID_LOCATION

// The first byte of a frame of version 2.
inline constexpr std::uint8_t kMavlink2 = 0xFD;

enum class Checksum : std::uint8_t {
  kRight,
  kWrong,
  kUnknown,  // of a message whose CRC_EXTRA is not known here
};

struct MavlinkFrame {
  std::uint8_t system = 0;
  std::uint8_t component = 0;
  std::uint32_t message = 0;
  std::string_view payload = {};  // of version 2 without trailing zeros
  std::size_t size = 0;           // of all of it, in bytes
  Checksum checksum = Checksum::kUnknown;
};

bool is_mavlink_magic(char byte);

// The frame at the front of `bytes`; nothing where there is none, or not all of it.
std::optional<MavlinkFrame> read_mavlink_frame(std::string_view bytes);

// CRC-16/MCRF4XX of `bytes`, going on from `crc`.
std::uint16_t mavlink_checksum(std::string_view bytes, std::uint16_t crc = 0xFFFF);

}  // namespace beespace::io
