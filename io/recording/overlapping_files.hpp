// One id in several files at the same time. Two logs of one vehicle say the same twice; two trials,
// or two animals, do not: their fixes come in turn, and each is far from where the fixes of the
// other file before and after it lead.
#pragma once

#include "io/frames/coordinate_frame.hpp"

#include <beespace/track.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>

namespace beespace::io {

struct FilesContradict {
  std::size_t before = 0;  // the fix of another file before
  std::size_t fix = 0;     // the one that does not go with it
};

// Of the fixes of one bee, in the order of time, and by index of which file each is: the first that
// does not go with those of another file, if half of those in turn do not. Nothing where there is
// none.
std::optional<FilesContradict> find_contradiction(
    std::span<const Fix> fixes, const std::function<std::uint32_t(std::size_t)>& file_of,
    Frame frame);

}  // namespace beespace::io
