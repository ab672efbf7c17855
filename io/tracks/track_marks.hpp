// What columns, or keys of JSON, say of a whole record: that its place is none, or wrong.
#pragma once

#include "io/problems/left_out.hpp"
#include "io/tracks/track_layout.hpp"

#include <beespace/result.hpp>

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

namespace beespace::io {

// What the record says in a slot (TrackSlot), as a table would; empty where it says nothing.
using TextInSlot = std::function<std::string(std::size_t)>;

// That it is an outlier, had no fix, or does not know where it is; null where it says no such
// thing.
const LeftOutReason* reason_by_marks(const TrackLayout& layout, const TextInSlot& text_in);

// In words that are not known: no guess is made. With the column.
std::optional<Error> unclear_mark(const TrackLayout& layout, const TextInSlot& text_in);

}  // namespace beespace::io
