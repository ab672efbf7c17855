// Checks the input of a search: the options are valid and every point lies in the domain.
#pragma once

#include <beespace/points_view.hpp>
#include <beespace/result.hpp>
#include <beespace/search_options.hpp>

#include <cstddef>
#include <optional>
#include <string>

namespace beespace::core {

// A number as messages show it: with all its digits.
std::string shown(double value);

// Of options whose threshold is kNotGiven.
Error threshold_not_given();

std::optional<Error> check_options(const PairOptions& options);
// The vertical threshold and heights, if any, of a search of one swarm, or between two; and that
// there are no heights.
std::optional<Error> check_vertical(const PairOptions& options, const PointsView& points);
std::optional<Error> check_vertical(const PairOptions& options, const PointsView& points,
                                    const PointsView& others);
std::optional<Error> check_no_heights(const PointsView& points, const char* name);
// The same of so many points that are not in memory, or come part by part.
std::optional<Error> check_vertical(const PairOptions& options, std::size_t points, bool apart);
std::optional<Error> check_no_heights(bool apart, const char* name);
// That of points with heights each has one; and that these lie in the domain, too.
std::optional<Error> check_height_count(const PointsView& points);
std::optional<Error> check_heights(const PointsView& points);
std::optional<Error> check_size(std::size_t size);
// Checks that its arrays fit together, and their size: before any element is read.
std::optional<Error> check_size(const PointsView& points);

// The coordinate domain of point.hpp.
bool in_domain(double coordinate);

// The names in location.array of errors about one of two sets.
inline constexpr const char* kPointsName = "points";
inline constexpr const char* kOthersName = "others";
inline constexpr const char* kPlacesName = "places";

// The error for a set with too many points, or with one outside the domain; `name` goes into
// location.array.
std::optional<Error> check_set(const PointsView& points, const char* name);

Error too_many_results(std::uint64_t most);

// The error for the first point of the range that is outside the domain, if any is.
std::optional<Error> check_points(const PointsView& points, std::size_t begin, std::size_t end);

}  // namespace beespace::core
