#include "io/tracks/video_units.hpp"

#include "io/table/coordinate_units.hpp"
#include "io/table/record_problems.hpp"

#include <string>
#include <utility>

namespace beespace::io {
namespace {

// Nothing is to be said of how long a pixel is.
bool lengths_are_known(const TableLayout& table, const ColumnChoice& position,
                       const RecordingOptions& options) {
  if (options.pixel || position.dimensions == 3 || table.names.empty()) return true;
  if (position.evidence == Frame::kWgs84 || options.frame == Frame::kWgs84) return true;
  for (const UnitTaken& taken : position.units_taken) {
    if (taken.evidence != UnitEvidence::kUsual) return true;
  }
  return false;
}

}  // namespace

Error with_frames(Error problem, const TableLayout& table, const TimeChoice& time) {
  const bool of_pixels = problem.message.find(kIsInPixels) != std::string::npos;
  if (!of_pixels || time.form != TimeForm::kFrames || time.frames_per_second > 0.0) return problem;
  problem.message += "; and " + column_text(table, time.column) +
                     " counts the frames of a video: say how many there are in a second, as in "
                     "--fps 25";
  return problem;
}

std::optional<Error> frames_problem(const TableLayout& table, const TimeChoice& time,
                                    const ColumnChoice& position, const RecordingOptions& options) {
  if (time.form != TimeForm::kFrames) return std::nullopt;
  const bool lengths = lengths_are_known(table, position, options);
  if (time.frames_per_second > 0.0 && lengths) return std::nullopt;
  std::string text;
  if (!(time.frames_per_second > 0.0)) {
    text = column_text(table, time.column) +
           " counts the frames of a video, but how many are there in a second? Say it, as in "
           "--fps 25";
  }
  if (!lengths) {
    text += (text.empty() ? "x and y are of a video, but in which unit? Of"
                          : "; and x and y, are they pixels? Of") +
            std::string(
                " pixels say how long one is, as in --scale 0.1mm (--scale 1 takes it for a "
                "metre); otherwise the unit, as in --units position=cm");
  }
  return at_column(ErrorCode::kInvalidArgument, std::move(text), time.column);
}

std::optional<Error> lengths_problem(const TableLayout& table, const RecordingOptions& options) {
  if (lengths_are_known(table, table.choice, options)) return std::nullopt;
  return Error{ErrorCode::kInvalidArgument,
               "x and y are of a video, but in which unit? Of pixels say how long one is, as in "
               "--scale 0.1mm (--scale 1 takes it for a metre); otherwise the unit, as in --units "
               "position=cm",
               {}};
}

}  // namespace beespace::io
