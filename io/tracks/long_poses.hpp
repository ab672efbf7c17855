// Tables of poses with a row for each place of a body ("frame,individual,bodypart,x,y").
#pragma once

#include "io/recording/recording_options.hpp"
#include "io/table/table_layout.hpp"

#include <beespace/result.hpp>

#include <optional>
#include <string_view>

namespace beespace::io {

// Where a column names several places of a body, of which one is to be where the animal is: how to
// take it. Errors: kInvalidArgument.
std::optional<Error> which_place_of_body(std::string_view text, const TableLayout& table,
                                         const RecordingOptions& options);

}  // namespace beespace::io
