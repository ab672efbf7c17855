// From coordinates as they were read to metres: ranges checked, degrees turned into ECEF.
#pragma once

#include "io/frames/coordinate_frame.hpp"
#include "io/frames/frame_decision.hpp"
#include "io/problems/skipped_records.hpp"

#include <beespace/point.hpp>
#include <beespace/result.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace beespace::io {

struct RangeProblem {
  std::size_t index = 0;  // of the point
  std::size_t axis = 0;   // 0, 1 or 2
  ErrorCode code = ErrorCode::kInvalidLatitude;
};

// Whether the box can be told to hold no point that is out of range.
bool surely_in_range(const Extent& extent, Frame frame);

// The first point from index `from` on that is no position in that frame.
std::optional<RangeProblem> find_out_of_range(std::span<const Point> points, std::size_t from,
                                              Frame frame);

// What is wrong with it, in a sentence; `shown` is the number as the input has it, in `unit` where
// it is a length.
Error range_error(const RangeProblem& problem, const Point& point, const std::string& shown,
                  std::string_view unit = "m");

// Takes all points out of range out of `points` and puts them on the list; `explain(row, point,
// problem)` gives the error of those that are listed in full.
using Explain = std::function<Error(std::uint64_t, const Point&, const RangeProblem&)>;
void skip_out_of_range(std::vector<Point>& points, Frame frame, SkippedRecords& skipped,
                       const Explain& explain);

// In place, over so many threads; all points must be in range.
Status convert_to_metres(std::span<Point> points, Frame frame, unsigned threads);

}  // namespace beespace::io
