#include "io/recording/ros_frames.hpp"

#include "io/bytes/characters.hpp"
#include "io/problems/excerpt.hpp"
#include "io/recording/local_topics.hpp"

#include <algorithm>
#include <cctype>

namespace beespace::io {
namespace {

// REP 105: an odometry frame is fixed, but begins anywhere. One with the name of a robot before it,
// as "uav1/odom", is that robot's.
bool is_odometry(std::string_view frame) {
  if (frame.starts_with('/')) frame.remove_prefix(1);
  const std::string name = lower_case(frame);
  return name == "odom" || name == "odom_combined" || name == "odometry";
}

// How to take those of one frame out of a table, as of all transforms; empty where its name does
// not mean itself there.
std::string those_of(std::string_view frame) {
  const bool means_itself =
      !frame.empty() && std::all_of(frame.begin(), frame.end(), [](unsigned char c) {
        return std::isalnum(c) != 0 || c == '_';
      });
  if (!means_itself) return {};
  const std::string name(frame);
  return ", or, of a table, read those of " + name + " alone, as by awk 'NR==1||/[,;\\t]" + name +
         "[,;\\t]/' FILE > " + name + ".csv";
}

}  // namespace

std::optional<Error> RosFrames::agree(std::string_view frame, std::string_view bee,
                                      const std::string& input, Frame asked) {
  if (!frame_) {
    frame_ = frame;
    input_ = input;
    bee_ = bee;
  }
  if (*frame_ != frame) {
    const std::string as_in = input_.empty() ? "" : ", as in " + input_ + ",";
    return Error{ErrorCode::kUnknownFrame,
                 "this position is in the frame " + excerpt(frame) + " of ROS, but others" + as_in +
                     " are in " + excerpt(*frame_) +
                     ": they cannot be compared; bring all into one, as by the transforms of /tf" +
                     (input_ == input ? those_of(*frame_) : std::string()),
                 {}};
  }
  const bool local = is_local_to_its_vehicle(bee) || is_local_to_its_vehicle(bee_);
  if (bee_ == bee || asked != Frame::kAuto || !(is_odometry(frame) || local)) return std::nullopt;
  return Error{ErrorCode::kUnknownFrame,
               "this position of " + excerpt(bee) + " and those of " + excerpt(bee_) +
                   (input_.empty() ? "" : " in " + input_) + " are in a frame " + excerpt(frame) +
                   " of ROS, which " + (local ? "autopilots (MAVROS, PX4) begin" : "begins") +
                   " where each robot was switched on: if these have one "
                   "origin and direction, say so with --crs metres; else bring all into one, "
                   "such as 'map', by the transforms of /tf",
               {}};
}

}  // namespace beespace::io
