// The frames of ROS that positions are in: those of one frame can be compared, and of a frame that
// begins where each robot was switched on, only those of one robot; by the topic, too, as that of
// MAVROS.
#pragma once

#include "io/frames/coordinate_frame.hpp"

#include <beespace/result.hpp>

#include <optional>
#include <string>
#include <string_view>

namespace beespace::io {

class RosFrames {
 public:
  // Of a position of that bee, in an input of that name, or none. An error where it cannot be
  // compared with those before; who says that all are in metres of one frame (`asked`) says that
  // robots have one origin.
  std::optional<Error> agree(std::string_view frame, std::string_view bee, const std::string& input,
                             Frame asked);

 private:
  std::optional<std::string> frame_;
  std::string input_;  // which said so first,
  std::string bee_;    // and of whom
};

}  // namespace beespace::io
