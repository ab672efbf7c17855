// Why a record becomes no fix without being a mistake, the same for all formats.
#pragma once

#include "io/problems/left_out.hpp"

namespace beespace::io {

inline constexpr LeftOutReason kNoPosition = {"without a position"};
// Of those who look for it in every picture: no more than if the record were not there.
inline constexpr LeftOutReason kUnknownPlace = {
    "without a place (empty, NA or NaN)",
    "a single one is passed over; where two or more follow each other the track is unknown from "
    "the fix before to the one behind, unless --max-gap says how long a gap is",
    true};
// The other half may contradict what is said of the others.
inline constexpr LeftOutReason kHalfPlace = {"with half a place (the rest is empty, NA or NaN)",
                                             "the bee may have been elsewhere then"};
inline constexpr LeftOutReason kNeverPlaced = {"of one that is known nowhere"};
inline constexpr LeftOutReason kUnknownHeight = {
    "without a height", "--columns with x and y, or lon and lat, only takes all as flat"};
inline constexpr LeftOutReason kOutlier = {
    "marked as outliers (visible=false, ...-marked-outlier=true)", {}, true};
// Of tags that write what they measure between their places in the same table.
inline constexpr LeftOutReason kSensorsOnly = {
    "of sensors alone (datatype SEN..., sensor-type acceleration), which never have a place",
    {},
    true};
// By StalePlaces.
inline constexpr LeftOutReason kStalePlace = {
    "whose place stays exactly the same for more than 3 s though their speed is more than 3 m/s",
    "where such a bee was is not known, as where the last place is said again after contact was "
    "lost"};
inline constexpr LeftOutReason kNoFix = {"of receivers that say that they had no fix"};
inline constexpr LeftOutReason kNoReference = {
    "that do not know from where on the Earth they count (ref_lat, xy_global)",
    "--crs metres takes all as counted from one place"};
// By a column that says so of each record: xy_valid, alt_valid.
inline constexpr LeftOutReason kDoubtedPlace = {
    "in which a drone says itself that it does not know its place"};
inline constexpr LeftOutReason kDoubtedHeight = {
    "in which a drone says itself that it does not know its height"};
// By dead_reckoning, eph and epv of PX4; ESTIMATOR_STATUS and GPS_RAW_INT of MAVLink.
inline constexpr LeftOutReason kGuessedPlace = {
    "in which a drone has lost its place (no fix of satellites any more, dead reckoning, or by its "
    "own word off by more than 10 m)",
    "where such a drone was is not known"};
// Whether the bee was there, but it is not known where.
inline bool has_no_place(const LeftOutReason& reason) {
  return &reason == &kUnknownPlace || &reason == &kHalfPlace || &reason == &kOutlier ||
         &reason == &kNoFix || &reason == &kNoReference || &reason == &kDoubtedPlace ||
         &reason == &kDoubtedHeight || &reason == &kGuessedPlace;
}
inline constexpr LeftOutReason kNoAnimal = {
    "whose id of an animal is empty (of tags that are on none)",
    "where a tag was on one, fill it in, or take the tag's with --columns id=..."};
inline constexpr double kOldPlace_s = 2.0;
inline constexpr LeftOutReason kOldPlace = {
    "whose place is more than 2 s old (seen_pos)",
    "aircraft.json of readsb is read with the time of each place"};
inline constexpr LeftOutReason kNoTrack = {"of spots that are on no track"};
inline constexpr LeftOutReason kNoTime = {"without the time of the position"};
inline constexpr LeftOutReason kOnGround = {"of aircraft on the ground",
                                            "--grounded keeps those that tell a height", true};
// No airport lies higher than 4,411 m (Daocheng Yading), and no aircraft on the ground rolls faster
// than it lands or takes off, or climbs there. Higher, faster or steeper, it flies.
inline constexpr double kHighestGround_m = 4'600.0;
inline constexpr double kFastestOnGround_mps = 110.0;
inline constexpr double kMostClimbOnGround_mps = 5.0;
// No aircraft with wings flies so slowly, and what is so much higher than nearly all airfields is
// not parked: a speed of 0 there is that of a helicopter, a balloon or a drone, or of no
// measurement.
inline constexpr double kSlowestFlight_mps = 1.0;
inline constexpr double kHighestParked_m = 750.0;
inline bool stands_in_air(double ground_speed_mps, double height_m) {
  return ground_speed_mps < kSlowestFlight_mps && height_m > kHighestParked_m;
}
inline constexpr LeftOutReason kOnGroundInFlight = {
    "of aircraft that say that they are on the ground, but are as high or as fast as none there",
    "--grounded keeps them"};
// By GroundClaims.
inline constexpr LeftOutReason kGroundInFlight = {
    "of aircraft that say that they are on the ground, but fly by what they report before and "
    "after",
    "--grounded keeps them"};
// At flight levels the two differ by hundreds of metres at most, on days far from the standard
// ones.
inline constexpr double kMostHeightsDiffer_m = 1'500.0;
inline constexpr LeftOutReason kHeightsContradict = {
    "whose heights by pressure and above the ellipsoid are more than 1,500 m apart",
    "correct them, or name one column with --columns"};
inline constexpr LeftOutReason kNoHeight = {"without a height"};
inline constexpr LeftOutReason kNoEllipsoidHeight = {
    "without a height above the ellipsoid",
    "--heights pressure takes heights by pressure instead, for all"};
inline constexpr LeftOutReason kNoPressureHeight = {"without a height by pressure"};

}  // namespace beespace::io
