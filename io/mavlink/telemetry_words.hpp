// What is said of telemetry, recorded and live: which places are taken, and what is left out.
#pragma once

#include "io/problems/left_out.hpp"

#include <cstdint>
#include <string>
#include <string_view>

namespace beespace::io {

inline constexpr LeftOutReason kNoSatellites = {
    "of drones that know no position yet (0, 0, or no fix with a height)"};
inline constexpr LeftOutReason kNotYetOnGround = {
    "of drones that know no position yet (0, 0, or no fix with a height), and stand on the ground "
    "once they do",
    {},
    true};
inline constexpr LeftOutReason kOtherComponent = {
    "of another component of the same system", {}, true};
inline constexpr LeftOutReason kOtherFrame = {
    "of drones that tell local positions only, beside others that tell longitude and latitude",
    "--crs metres takes local positions"};
inline constexpr LeftOutReason kNotLocal = {
    "of drones that tell no local positions (--crs metres)"};
// Of systems that are vehicles by their heartbeat, or may be.
inline constexpr LeftOutReason kNoPlaceRead = {
    "of vehicles that tell no position that is read (messages 33, 340, 24, 32)"};
inline constexpr LeftOutReason kRemoteDrone = {
    "of drones that are heard by their remote identification only (message 12901)"};
inline constexpr LeftOutReason kHandedOn = {
    "of another drone, whose position a system hands on (message 340)"};
inline constexpr LeftOutReason kHeardAgain = {
    "of aircraft that were not heard anew (message 246)", {}, true};

inline constexpr std::string_view kGlobalNote =
    "positions are those of MAVLink message 33 (GLOBAL_POSITION_INT), heights above mean sea level";
inline constexpr std::string_view kLocalNote =
    "positions are those of MAVLink message 32 (LOCAL_POSITION_NED), metres east, north and up of "
    "each drone's own origin: they can be compared only if all drones have the same one";
inline constexpr std::string_view kOwnClockNote =
    "times are those of each drone's own clock, set to that of the log by its fastest message";
inline constexpr std::string_view kArrivalNote =
    "times are those at which the log was written, as the drones tell none of their own";
inline constexpr std::string_view kNoClockNote =
    "of drones whose own clock does not go on as that of the log (it stands still, goes at another "
    "speed, or is that of two drones), times are those at which the log was written: ";
inline constexpr std::string_view kSatelliteTimeNote =
    "the time of satellites (message 2) tells how much later one link always is than another";
inline constexpr std::string_view kSatelliteTimesDifferNote =
    "the times of satellites that drones tell (message 2) are more than a minute apart and are not "
    "used";
inline constexpr std::string_view kNoSatelliteTimeNote =
    "of drones that do not tell the time of satellites (message 2), it is not known how late they "
    "always are, as others are late: ";
inline constexpr std::string_view kNoClockOfLogNote =
    "it is not known how the clock of the log goes with that of other inputs, as no drone in it "
    "tells the time of satellites (message 2): ";
inline constexpr std::string_view kStationNote =
    "the own position of a ground station or antenna tracker, which its HEARTBEAT says that it is, "
    "is left out: ";
inline constexpr std::string_view kReportedNote =
    "aircraft that a receiver of ADS-B tells (message 246) are bees, named by their address: their "
    "heights are by pressure or by satellites, tens of metres from those of the drones";

// "3.2 s"
inline std::string seconds_text(std::int64_t micros) {
  constexpr std::int64_t kTenth = 100'000;
  const std::int64_t tenths = (micros + kTenth / 2) / kTenth;
  return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10) + " s";
}

}  // namespace beespace::io
