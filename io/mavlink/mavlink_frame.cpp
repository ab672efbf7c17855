#include "io/mavlink/mavlink_frame.hpp"

namespace beespace::io {
namespace {

constexpr unsigned kVersion1 = 0xFE;
constexpr std::size_t kHeader1 = 6;
constexpr std::size_t kHeader2 = 10;
constexpr std::size_t kChecksumSize = 2;
constexpr std::size_t kSignatureSize = 13;
constexpr unsigned kSigned = 0x01;  // of the flags, the only one that there is

unsigned byte_at(std::string_view bytes, std::size_t at) {
  return static_cast<unsigned char>(bytes[at]);
}

// What the meaning of the message adds to its checksum.
std::optional<char> extra_of(std::uint32_t message) {
  switch (message) {
    case kHeartbeat:
      return static_cast<char>(50);
    case kSystemTime:
      return static_cast<char>(137);
    case kGpsRawInt:
      return static_cast<char>(24);
    case kLocalPositionNed:
    case kRadioStatus:
      return static_cast<char>(185);
    case kGlobalPositionInt:
      return static_cast<char>(104);
    case kGps2Raw:
      return static_cast<char>(87);
    case kEstimatorStatus:
      return static_cast<char>(163);
    case kExtendedSysState:
      return static_cast<char>(130);
    case kAdsbVehicle:
      return static_cast<char>(184);
    case kUtmGlobalPosition:
      return static_cast<char>(99);
    case kRemoteIdLocation:
      return static_cast<char>(254);
    default:
      return std::nullopt;
  }
}

Checksum check(std::string_view bytes, std::size_t header, const MavlinkFrame& frame) {
  const auto extra = extra_of(frame.message);
  if (!extra) return Checksum::kUnknown;
  const std::size_t end = header + frame.payload.size();
  const std::uint16_t crc =
      mavlink_checksum({&*extra, 1}, mavlink_checksum(bytes.substr(1, end - 1)));
  const unsigned written = byte_at(bytes, end) | byte_at(bytes, end + 1) << 8u;
  return crc == written ? Checksum::kRight : Checksum::kWrong;
}

}  // namespace

bool is_mavlink_magic(char byte) {
  const auto value = static_cast<unsigned char>(byte);
  return value == kVersion1 || value == kMavlink2;
}

std::uint16_t mavlink_checksum(std::string_view bytes, std::uint16_t crc) {
  for (const char c : bytes) {
    unsigned part = static_cast<unsigned char>(c) ^ (crc & 0xFFu);
    part = (part ^ part << 4u) & 0xFFu;
    crc = static_cast<std::uint16_t>(crc >> 8u ^ part << 8u ^ part << 3u ^ part >> 4u);
  }
  return crc;
}

std::optional<MavlinkFrame> read_mavlink_frame(std::string_view bytes) {
  if (bytes.empty() || !is_mavlink_magic(bytes.front())) return std::nullopt;
  const bool second = byte_at(bytes, 0) == kMavlink2;
  const std::size_t header = second ? kHeader2 : kHeader1;
  if (bytes.size() < header) return std::nullopt;
  const std::size_t length = byte_at(bytes, 1);
  const unsigned flags = second ? byte_at(bytes, 2) : 0;
  // What other flags would change is not known, not even the size.
  if ((flags & ~kSigned) != 0) return std::nullopt;
  MavlinkFrame frame;
  frame.size =
      header + length + kChecksumSize + ((flags & kSigned) != 0 ? kSignatureSize : std::size_t{0});
  if (bytes.size() < frame.size) return std::nullopt;
  const std::size_t names = second ? 5 : 3;
  frame.system = static_cast<std::uint8_t>(byte_at(bytes, names));
  frame.component = static_cast<std::uint8_t>(byte_at(bytes, names + 1));
  frame.message = byte_at(bytes, names + 2);
  if (second) {
    frame.message |= byte_at(bytes, names + 3) << 8u | byte_at(bytes, names + 4) << 16u;
  }
  frame.payload = bytes.substr(header, length);
  frame.checksum = check(bytes, header, frame);
  return frame;
}

}  // namespace beespace::io
