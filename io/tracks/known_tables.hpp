// Tables of which it is known what their columns are, though no names, or more than names, say it:
// Skybrush's CSV, topics of ROS, trajectories as the TUM RGB-D benchmark has them.
#pragma once

#include "io/recording/recording_options.hpp"
#include "io/table/table_layout.hpp"
#include "io/tracks/ros_table.hpp"
#include "io/tracks/track_layout.hpp"

#include <beespace/result.hpp>

#include <string_view>

namespace beespace::io {

bool is_path_with_colours(std::string_view text, const TableLayout& table);

// t [ms], x, y, z, and perhaps red, green and blue. Errors: kInvalidArgument where the unit of time
// must be said.
Result<TrackLayout> skybrush_layout(TableLayout table, std::string_view text,
                                    const RecordingOptions& options);

// Whether --columns names nothing but what a table of ROS has: the time, x, y, z, or the id. What
// it does not name is told by the table.
bool names_columns_of_ros(const RecordingOptions& options);
// Whether it names x.
bool names_position(const RecordingOptions& options);

Result<TrackLayout> ros_layout(const RosTable& ros, TableLayout table, std::string_view text,
                               RecordingOptions options, SeenRecords seen);

bool is_trajectory_of_poses(std::string_view text, const TableLayout& table);

Result<TrackLayout> layout_of_poses(TableLayout table, std::string_view text,
                                    RecordingOptions options, SeenRecords seen);

}  // namespace beespace::io
