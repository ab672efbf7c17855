#include "io/tracks/scaled_degrees.hpp"

#include "io/bytes/number.hpp"
#include "io/table/record_problems.hpp"
#include "io/tracks/first_fields.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

namespace beespace::io {
namespace {

// The greatest of the first numbers; nothing where one of them is not whole.
std::optional<double> greatest_whole(std::string_view text, const TableLayout& table,
                                     std::size_t column) {
  const FirstFields fields = first_fields(text, table, column);
  if (fields.empty()) return std::nullopt;
  double greatest = 0.0;
  for (const std::string_view field : fields.texts) {
    double value = 0.0;
    if (parse_number(field, value) != NumberKind::kNumber || value != std::floor(value)) {
      return std::nullopt;
    }
    greatest = std::max(greatest, std::abs(value));
  }
  return greatest;
}

}  // namespace

bool are_scaled_degrees(std::string_view text, const TableLayout& table,
                        const ColumnChoice& position) {
  constexpr double kBeyondDegrees = 10'000.0;
  const auto longitude = greatest_whole(text, table, position.axes[0]);
  const auto latitude = greatest_whole(text, table, position.axes[1]);
  return longitude && latitude && std::max(*longitude, *latitude) > kBeyondDegrees &&
         *longitude <= 360.0 * kScaledPerDegree && *latitude <= 90.0 * kScaledPerDegree;
}

std::optional<Error> scaled_degrees_as_metres(std::string_view text, const Header& header,
                                              const ColumnChoice& position) {
  if (header.size() == 0) return std::nullopt;
  const Role role = header.meaning(position.axes[0]).role;
  const bool named = role == Role::kLongitude || role == Role::kLatitude;
  if (!named || !are_scaled_degrees(text, header.table(), position)) return std::nullopt;
  return Error{ErrorCode::kUnknownFrame,
               column_text(header.table(), position.axes[0]) +
                   " is no coordinate in metres: its name and its size say that it has whole "
                   "numbers of 1e-7 degrees; leave --crs metres, x and y out",
               {}};
}

}  // namespace beespace::io
