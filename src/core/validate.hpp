// Whether a search may start: the options make sense and every point lies in the domain.
#pragma once

#include <beespace/points_view.hpp>
#include <beespace/result.hpp>
#include <beespace/search_options.hpp>

#include <optional>

namespace beespace::core {

std::optional<Error> check_options(const SearchOptions& options);
std::optional<Error> check_size(std::size_t size);

// The coordinate domain of point.hpp.
bool in_domain(double coordinate);

// The error for the first point of the range that is outside the domain, if any is.
std::optional<Error> check_points(const PointsView& points, std::size_t begin, std::size_t end);

}  // namespace beespace::core
