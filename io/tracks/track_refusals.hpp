// What is wrong with a record of a table of fixes beside those before it.
#pragma once

#include "io/tracks/track_layout.hpp"
#include "io/tracks/track_record.hpp"

#include <beespace/result.hpp>

#include <cstddef>
#include <optional>
#include <string_view>

namespace beespace::io {

// Times of day go back, as if another day had begun.
Error goes_back(const TrackRecord& record, const TimeChoice& time);
// Dates go back by so long, as where clocks are set back at night.
Error set_back(const TrackRecord& record, double back_s, const TimeChoice& time);

// The first record behind a header that came again, as where tables were joined: what they would be
// asked about each for itself.
std::optional<Error> joined_problem(const TrackRecord& record, const TrackLayout& layout);

// Two vehicles of one table were switched on at moments of their own.
Error own_zeros(std::string_view one, std::string_view other, const TrackLayout& layout);

// What came before was read as if there were no heights.
Error height_after_all(std::string_view text, std::size_t column);

}  // namespace beespace::io
