// Checks the input of queries about moving bees against the motion domain of mover.hpp.
#pragma once

#include <beespace/closest_approach.hpp>
#include <beespace/find_conflicts.hpp>
#include <beespace/mover.hpp>
#include <beespace/result.hpp>
#include <beespace/track.hpp>

#include <optional>
#include <span>

namespace beespace::motion {

bool in_motion_domain(double value);

std::optional<Error> check_separation(double threshold_m, const std::optional<double>& vertical_m);
// Checks that heights apart from positions exist for a vertical threshold.
std::optional<Error> check_heights(bool given, const std::optional<double>& vertical_m);
std::optional<Error> check_height_unit(double height_unit_m);
std::optional<Error> check_options(const PredictOptions& options);
std::optional<Error> check_options(const ConflictOptions& options);

// `record` is the mover whose position or time is checked.
std::optional<Error> check_position(const Point& position, std::size_t record);
std::optional<Error> check_height(double height_m, double climb_mps, std::size_t record);
std::optional<Error> check_time(double time_s, std::size_t record);
std::optional<Error> check_mover(const Mover& mover, std::size_t record);
// Checks that all arrays are equally long, and their length: before any element is read.
std::optional<Error> check_size(const MoversView& movers);
std::optional<Error> check_tracks(std::span<const Track> tracks);
std::optional<Error> check_movers(const MoversView& movers);

}  // namespace beespace::motion
