// What tables of videos leave open: how many frames there are in a second, and how long a pixel is.
#pragma once

#include "io/recording/recording_options.hpp"
#include "io/table/column_choice.hpp"
#include "io/tracks/track_layout.hpp"

#include <beespace/result.hpp>

#include <optional>

namespace beespace::io {

// A question about pixels, and what else such a table lacks: how many frames there are in a second.
Error with_frames(Error problem, const TableLayout& table, const TimeChoice& time);

// Frames are chosen, but not how many there are in a second, or how long a pixel is: what to say.
// `position` is where they are.
std::optional<Error> frames_problem(const TableLayout& table, const TimeChoice& time,
                                    const ColumnChoice& position, const RecordingOptions& options);

// Lengths of an image: where neither the header nor the caller says a unit, they may be pixels.
std::optional<Error> lengths_problem(const TableLayout& table, const RecordingOptions& options);

}  // namespace beespace::io
