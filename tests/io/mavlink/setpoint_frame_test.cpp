// Setpoints as frames, read by the reader of logs, and byte by byte from the published layout.
#include "io/mavlink/setpoint_frame.hpp"

#include "io/mavlink/mavlink_frame.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <string>
#include <string_view>

namespace beespace::io {
namespace {

std::uint32_t number_at(std::string_view bytes, std::size_t at, std::size_t size) {
  std::uint32_t value = 0;
  for (std::size_t i = size; i-- > 0;) {
    value = value << 8u | static_cast<unsigned char>(bytes[at + i]);
  }
  return value;
}

float float_at(std::string_view bytes, std::size_t at) {
  return std::bit_cast<float>(number_at(bytes, at, 4));
}

TEST(SetpointFrame, IsWhatIsPublished) {
  SetpointFrame setpoint;
  setpoint.sequence = 7;
  setpoint.target_system = 42;
  setpoint.time_boot_ms = 123456;
  setpoint.setpoint = {{1.5, 2.5, 30.0}, {0.25, -0.5, 1.0}};
  std::string bytes = "before";
  append_setpoint_frame(bytes, setpoint);
  const auto frame = read_mavlink_frame(std::string_view(bytes).substr(6));
  ASSERT_TRUE(frame);
  EXPECT_EQ(frame->message, 84u);
  EXPECT_EQ(frame->size, bytes.size() - 6);
  const std::string_view payload = frame->payload;
  ASSERT_EQ(payload.size(), 53u);
  EXPECT_EQ(number_at(payload, 0, 4), 123456u);
  const float expected[] = {2.5f, 1.5f, -30.0f, -0.5f, 0.25f, -1.0f};
  for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(float_at(payload, 4 + 4 * i), expected[i]) << i;
  EXPECT_EQ(number_at(payload, 48, 2), 0x0DC0u);
  EXPECT_EQ(number_at(payload, 50, 1), 42u);
  EXPECT_EQ(number_at(payload, 51, 1), 1u);
  EXPECT_EQ(number_at(payload, 52, 1), 1u);
  const char extra = static_cast<char>(143);
  const std::string_view whole = std::string_view(bytes).substr(6);
  const std::uint16_t crc =
      mavlink_checksum({&extra, 1}, mavlink_checksum(whole.substr(1, whole.size() - 3)));
  EXPECT_EQ(number_at(whole, whole.size() - 2, 2), crc);
}

TEST(SetpointFrame, OfVelocitiesAlone) {
  SetpointFrame setpoint;
  setpoint.setpoint = {{1, 2, 3}, {4, 5, 6}};
  setpoint.velocity_only = true;
  std::string bytes;
  append_setpoint_frame(bytes, setpoint);
  const auto frame = read_mavlink_frame(bytes);
  ASSERT_TRUE(frame);
  EXPECT_EQ(number_at(frame->payload, 48, 2), 0x0DC7u);
  EXPECT_EQ(float_at(frame->payload, 16), 5.0f);
}

}  // namespace
}  // namespace beespace::io
