#include "io/tracks/track_layout.hpp"

#include "io/bytes/characters.hpp"
#include "io/bytes/number.hpp"
#include "io/points/record_reading.hpp"
#include "io/recording/unit_doubts.hpp"
#include "io/table/column_choice.hpp"
#include "io/table/column_names.hpp"
#include "io/table/column_overrides.hpp"
#include "io/table/fields.hpp"
#include "io/table/header_words.hpp"
#include "io/table/record_problems.hpp"
#include "io/table/record_walk.hpp"
#include "io/table/unit_choice.hpp"
#include "io/tracks/airsim_table.hpp"
#include "io/tracks/clover_table.hpp"
#include "io/tracks/joined_place.hpp"
#include "io/tracks/known_tables.hpp"
#include "io/tracks/local_positions.hpp"
#include "io/tracks/long_poses.hpp"
#include "io/tracks/mavlogdump.hpp"
#include "io/tracks/motion_capture.hpp"
#include "io/tracks/planar_poses.hpp"
#include "io/tracks/record_numbers.hpp"
#include "io/tracks/ros_table.hpp"
#include "io/tracks/scaled_degrees.hpp"
#include "io/tracks/several_vehicles.hpp"
#include "io/tracks/track_accuracy.hpp"
#include "io/tracks/track_aircraft.hpp"
#include "io/tracks/track_animals.hpp"
#include "io/tracks/track_columns.hpp"
#include "io/tracks/track_numbers.hpp"
#include "io/tracks/track_sets.hpp"
#include "io/tracks/track_time.hpp"
#include "io/tracks/track_velocity.hpp"
#include "io/tracks/unclear_id.hpp"
#include "io/tracks/unnamed_position.hpp"
#include "io/tracks/unread_times.hpp"
#include "io/tracks/utm_zone.hpp"
#include "io/tracks/video_units.hpp"
#include "io/tracks/wall_times.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace beespace::io {
namespace {

// ---- Whose record it is --------------------------------------------------------------------

std::optional<std::size_t> choose_id(const Header& header, std::vector<std::string>& notes) {
  std::vector<std::size_t> found = header.columns(Role::kId);
  if (header.override_of(Role::kId)) return header.override_of(Role::kId);
  if (found.empty()) return std::nullopt;
  const TableLayout& table = header.table();
  const auto is_scene = [&table](std::size_t column) { return names_scene(table.names[column]); };
  if (!std::all_of(found.begin(), found.end(), is_scene)) std::erase_if(found, is_scene);
  const std::size_t chosen = io::choose_id(table, found);
  for (const std::size_t other : found) {
    if (other == chosen || names_flight(table.names[other])) continue;
    notes.push_back("ids are read from " + column_text(table, chosen) + ", not from " +
                    column_text(table, other) + "; --columns id=" + std::to_string(other + 1) +
                    " would change that");
  }
  return chosen;
}

// ---- Position ------------------------------------------------------------------------------

// Whether the header is that of a Skybrush CSV, which some write without the colours: "Time
// [msec],x [m],y [m],z [m]", or "Time_msec,x_m,y_m,z_m".
bool has_header_of_skybrush(const TableLayout& table) {
  using Header = std::array<std::string_view, 4>;
  constexpr std::array<Header, 2> kHeaders = {Header{"time [msec]", "x [m]", "y [m]", "z [m]"},
                                              Header{"time_msec", "x_m", "y_m", "z_m"}};
  return std::any_of(kHeaders.begin(), kHeaders.end(), [&table](const Header& header) {
    return table.names.size() >= header.size() &&
           std::equal(header.begin(), header.end(), table.names.begin(),
                      [](std::string_view word, const std::string& name) {
                        return lower_case(name) == word;
                      });
  });
}

std::string position_note(const TableLayout& table, const ColumnChoice& choice, Frame frame) {
  const bool geographic = frame == Frame::kWgs84;
  std::string text = geographic ? "longitude, latitude" : "x, y";
  if (choice.dimensions == 3) text += geographic ? ", height" : ", z";
  text += " are read from";
  for (std::size_t axis = 0; axis < choice.dimensions; ++axis) {
    if (axis > 0 && choice.axes[axis] == choice.axes[axis - 1]) continue;  // a joined place
    text.append(axis == 0 ? " " : ", ").append(column_text(table, choice.axes[axis]));
  }
  if (choice.dimensions == 3) return text;
  return text + (geographic ? "; there is no height: distances are of the ground, at height 0"
                            : "; there is no z: distances are within the plane");
}

// Whether that coordinate is known in no record.
bool is_empty_throughout(std::string_view text, const TableLayout& table, std::size_t axis) {
  const ColumnChoice& choice = table.choice;
  const std::size_t column = choice.axes[axis];
  if (axis >= choice.dimensions || column >= table.contents.size()) return false;
  if (!words_of_aviation(table.names).empty()) return false;  // aircraft have heights, said or not
  if (table.contents[column] != ColumnContent::kUnknown) return false;
  RecordWalk walk(text, table.data_offset, table);
  while (walk.next()) {
    const Field field = field_at(walk.record(), table.delimiter, column);
    if (!is_unknown(without_padding(field.text))) return false;
  }
  return true;
}

void leave_out_heights(ColumnChoice& choice) {
  choice.dimensions = 2;
  choice.units[2] = Unit::kMetre;
  choice.datum = HeightDatum::kUnstated;
  choice.units_taken.clear();
}

// ---- All together --------------------------------------------------------------------------

// The columns that are read for something else than the id.
ColumnsByRole columns_read(const TrackLayout& layout) {
  ColumnsByRole columns = {};
  const ColumnChoice& position = layout.table.choice;
  for (std::size_t i = 0; i < position.dimensions; ++i) {
    if (layout.joined_place && i == 1) continue;  // with the first
    columns[index_of(part_of(Role::kX, i))] = position.axes[i];
  }
  if (layout.time) columns[index_of(Role::kTime)] = layout.time->column;
  if (layout.time && layout.time->date) columns[index_of(Role::kDate)] = layout.time->date;
  for (std::size_t i = 0; layout.velocity && i < layout.velocity->dimensions; ++i) {
    columns[index_of(part_of(Role::kVelocityX, i))] = layout.velocity->columns[i];
  }
  return columns;
}

// The same in one column, as "#ff8000": paths of a show have one clock.
bool names_one_colour(const TableLayout& table) {
  return std::any_of(table.names.begin(), table.names.end(), [](const std::string& name) {
    return is_one_of("color colour rgb", lower_case(name));
  });
}

// Where drones took off is read, where that is told.
void settle_take_off(TrackLayout& layout) {
  if (!layout.time || layout.show || layout.of_animals || tells_of_aircraft(layout)) return;
  layout.take_off = find_take_off_columns(layout.table);
  const auto column = layout.take_off.above ? layout.take_off.above : layout.take_off.standing;
  if (!column) return;
  layout.notes.push_back("from which height each took off is read from " +
                         column_text(layout.table, *column));
}

// How fast nothing like that moves, where the unit of positions is but the usual one.
std::optional<double> doubted_above(const TrackLayout& layout) {
  const auto& units = layout.table.choice.units_taken;
  const bool usual = std::any_of(units.begin(), units.end(), [](const UnitTaken& taken) {
    return taken.evidence == UnitEvidence::kUsual;
  });
  if (!usual || !layout.time || layout.frame == Frame::kWgs84) return std::nullopt;
  if (layout.show || names_one_colour(layout.table)) return kFastestShow_mps;
  return layout.time->form == TimeForm::kFrames ? kFastestFilmed_mps : kFastestUsual_mps;
}

}  // namespace

std::vector<std::uint8_t> slots_of(const TrackLayout& layout) {
  std::vector<std::uint8_t> slots(layout.table.columns, TrackSlot::kNothing);
  const auto fill = [&slots](std::size_t column, std::size_t slot) {
    if (column < slots.size()) slots[column] = static_cast<std::uint8_t>(slot);
  };
  const ColumnChoice& choice = layout.table.choice;
  if (layout.take_off.above) fill(*layout.take_off.above, TrackSlot::kAboveTakeOff);
  if (layout.take_off.standing) fill(*layout.take_off.standing, TrackSlot::kStanding);
  if (layout.label) fill(*layout.label, TrackSlot::kLabel);
  if (layout.other_height) fill(*layout.other_height, TrackSlot::kOtherHeight);
  if (layout.on_ground) fill(*layout.on_ground, TrackSlot::kOnGround);
  if (layout.axes_name) fill(*layout.axes_name, TrackSlot::kAxesName);
  if (layout.quality) fill(layout.quality->column, TrackSlot::kQuality);
  if (layout.place_known) fill(*layout.place_known, TrackSlot::kPlaceKnown);
  if (layout.height_known) fill(*layout.height_known, TrackSlot::kHeightKnown);
  if (layout.not_seen) fill(*layout.not_seen, TrackSlot::kNotSeen);
  if (layout.lost) fill(*layout.lost, TrackSlot::kLost);
  for (std::size_t i = 0; i < layout.off_m.size(); ++i) {
    if (layout.off_m[i]) fill(*layout.off_m[i], TrackSlot::kOff + i);
  }
  if (layout.sensor) fill(*layout.sensor, TrackSlot::kSensor);
  if (layout.accuracy) fill(layout.accuracy->column, TrackSlot::kAccuracy);
  if (layout.zone) fill(*layout.zone, TrackSlot::kZone);
  for (std::size_t i = 0; i < layout.sides.size(); ++i) {
    if (layout.sides[i]) fill(*layout.sides[i], TrackSlot::kSide + i);
  }
  if (layout.age) fill(*layout.age, TrackSlot::kAge);
  if (layout.clock_zone) fill(*layout.clock_zone, TrackSlot::kClockZone);
  if (layout.no_height_yet) fill(*layout.no_height_yet, TrackSlot::kLateHeight);
  for (std::size_t i = 0; layout.velocity && i < layout.velocity->dimensions; ++i) {
    fill(layout.velocity->columns[i], TrackSlot::kVelocity + i);
  }
  for (std::size_t i = 0; i < choice.dimensions; ++i) {
    fill(choice.axes[i], TrackSlot::kPosition + i);
  }
  if (layout.joined_place) fill(*layout.joined_place, TrackSlot::kJoinedPlace);
  for (std::size_t i = 0; i < layout.scenes.size(); ++i) {
    fill(layout.scenes[i], TrackSlot::kScenes + i);
  }
  for (std::size_t i = 0; i < layout.sets.size(); ++i) fill(layout.sets[i], TrackSlot::kSets + i);
  if (layout.visible) fill(*layout.visible, TrackSlot::kVisible);
  for (std::size_t i = 0; i < layout.marked.size(); ++i) {
    fill(layout.marked[i], TrackSlot::kMarked + i);
  }
  if (layout.marked_valid) fill(*layout.marked_valid, TrackSlot::kValid);
  if (layout.tag) fill(*layout.tag, TrackSlot::kTag);
  if (layout.time && layout.time->date) fill(*layout.time->date, TrackSlot::kDate);
  if (layout.time) fill(layout.time->column, TrackSlot::kTime);
  if (layout.time && layout.time->due) fill(*layout.time->due, TrackSlot::kDue);
  if (layout.time && layout.time->nanoseconds) {
    fill(*layout.time->nanoseconds, TrackSlot::kNanoseconds);
  }
  if (choice.id) fill(*choice.id, TrackSlot::kId);
  return slots;
}

namespace {

// Whether --columns says where the position is.
bool names_place(const RecordingOptions& options) {
  const auto said = read_column_overrides(track_columns(), options.columns, options.frame);
  return !said || std::any_of(said->begin(), said->end(), [](const ColumnOverride& one) {
    return one.role >= Role::kLongitude && one.role <= Role::kZ;
  });
}

// "px,py,pz" are a place beside "vx", as states in robotics have them; two of them alone may be
// pixels. What to say of them with --columns; nothing where others are named, or asked for.
std::optional<std::string> columns_of_p_axes(const RecordingOptions& options,
                                             const TableLayout& table) {
  if (names_place(options)) return std::nullopt;
  std::array<std::optional<std::size_t>, 3> axes;
  for (std::size_t column = 0; column < table.names.size(); ++column) {
    const std::string name = plain_name(table.names[column]);
    if (is_one_of("x y z lon lat longitude latitude", name)) return std::nullopt;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (name == std::array{"px", "py", "pz"}[axis]) axes[axis] = column;
    }
  }
  if (!axes[0] || !axes[1] || !axes[2]) return std::nullopt;
  return "x=" + std::to_string(*axes[0] + 1) + ",y=" + std::to_string(*axes[1] + 1) +
         ",z=" + std::to_string(*axes[2] + 1) + (options.columns.empty() ? "" : ",") +
         options.columns;
}

}  // namespace

Result<TrackLayout> choose_track_layout(TableLayout table, std::string_view text,
                                        const RecordingOptions& options, SeenRecords seen) {
  TrackLayout layout;
  layout.table = std::move(table);
  if (auto columns = columns_of_p_axes(options, layout.table)) {
    RecordingOptions named = options;
    named.columns = *std::move(columns);
    return choose_track_layout(std::move(layout.table), text, named, seen);
  }
  const auto overrides = find_overrides(track_columns(), options, layout.table);
  if (!overrides) return overrides.error();
  const Header header(track_columns(), options, layout.table, *overrides);
  const bool said = header.override_of(Role::kX) || header.override_of(Role::kLongitude);
  if (!header.override_of(Role::kId)) {
    if (auto problem = mixed_vehicles(text, layout.table)) return *std::move(problem);
  }
  if (!said && header.source() == nullptr) {
    if (auto problem = several_vehicles(layout.table)) return *std::move(problem);
    if (!header.has(Role::kZ) && !header.has(Role::kHeight)) {
      if (auto problem = downward(layout.table)) return *std::move(problem);
    }
  }
  if (auto problem = which_place_of_body(text, layout.table, options)) return *std::move(problem);
  auto time = choose_time(text, header, options);
  if (!time) return with_position_problem(std::move(time).error(), text, header);
  layout.time = time.value();
  const bool known = header.source() != nullptr;
  if (layout.time && known) layout.time->unit_is_asked = false;
  if (layout.time && !options.one_clock && !layout.time->since_1970) {
    layout.time->since_start =
        header.source() != nullptr
            ? header.source()->since_start && !header.override_of(Role::kTime)
            : counts_from_start(layout.table, *layout.time);
  }
  auto id = choose_id(header, layout.notes);
  if (!id) id = track_numbers(text, header, layout.time, layout.notes);
  layout.joined_place = joined_place_of(header);
  layout.ground_at_zero =
      layout.joined_place || (header.source() != nullptr && header.source()->ground_at_zero);
  if (!layout.joined_place) {
    if (auto problem = nameless_position(text, header)) return *std::move(problem);
  }
  auto position = layout.joined_place ? choose_joined_place(header, *layout.joined_place)
                                      : choose_position(header);
  if (!position) {
    Error problem = with_millimetres(std::move(position).error(), text, header);
    return layout.time ? with_frames(std::move(problem), layout.table, *layout.time) : problem;
  }
  layout.table.choice = std::move(position).value();
  ColumnChoice& choice = layout.table.choice;
  choice.id = id;
  const FrameDecision frame = frame_before_values(options.frame, {choice.evidence, choice.reason});
  layout.frame = frame.frame;
  layout.frame_reason = frame.reason;
  if (choice.naming == Naming::kBareAxes && names_planar_poses(layout.table)) {
    choice.naming = Naming::kSure;
  }
  if (layout.frame == Frame::kMetres) {
    auto problem = scaled_degrees_as_metres(text, layout.table, choice);
    if (problem) return *std::move(problem);
  } else if (layout.frame == Frame::kWgs84 && are_scaled_degrees(text, layout.table, choice)) {
    layout.scaled_degrees = true;
    layout.notes.emplace_back(kScaledDegreesNote);
    if (auto problem = settle_heights_beside(text, layout.table, choice))
      return *std::move(problem);
  }
  if (seen != SeenRecords::kSome && layout.time && layout.frame == Frame::kWgs84 &&
      !header.override_of(Role::kHeight) && is_empty_throughout(text, layout.table, 2)) {
    layout.notes.push_back(column_text(layout.table, choice.axes[2]) + " is empty throughout");
    if (seen == SeenRecords::kBeginning) layout.no_height_yet = choice.axes[2];
    leave_out_heights(choice);
  }
  if (layout.frame == Frame::kWgs84 && choice.dimensions == 3 &&
      choice.datum == HeightDatum::kUnstated && is_altitude_of_fix(layout.table, choice.axes[2])) {
    choice.datum = HeightDatum::kEllipsoid;
  }
  layout.units = choice.units_taken;
  UnitChoice units(layout.table.names, options.units);
  auto velocity = choose_velocity({header, choice, layout.frame, units, options.velocities_needed},
                                  layout.notes, layout.units);
  if (!velocity) return velocity.error();
  layout.velocity = *velocity;
  if (!layout.time && !layout.velocity) {
    if (auto problem = pandas_timedeltas(text, layout.table)) return *std::move(problem);
    return missing_column(no_time_text(text, header));
  }
  if (layout.time) {
    if (auto error = frames_problem(layout.table, *layout.time, choice, options)) {
      return *std::move(error);
    }
  }
  if (auto error = doubly_used(track_columns(), columns_read(layout))) return *std::move(error);
  settle_aircraft(header, options, layout);
  settle_animals(header, layout);
  settle_accuracy(header, layout);
  settle_sets(header, layout);
  settle_scenes(header, options, layout);
  layout.quality = find_fix_quality(text, layout.table);
  if (layout.quality) {
    layout.notes.push_back("whether there was a fix is read from " +
                           column_text(layout.table, layout.quality->column));
  }
  settle_known_places(layout);
  if (layout.frame != Frame::kWgs84) {
    layout.axes_name = find_axes_name(layout.table);
    const bool is_id = layout.axes_name && layout.axes_name == choice.id;
    if (is_id && options.frame == Frame::kMetres) layout.axes_name = std::nullopt;
  }
  if (layout.frame != Frame::kWgs84) layout.zone = find_utm_zone(text, layout.table);
  if (layout.frame == Frame::kWgs84) layout.sides = find_sides(text, layout.table);
  for (const auto& side : layout.sides) {
    if (!side) continue;
    layout.notes.push_back("on which side of " +
                           std::string(side == layout.sides[0] ? "Greenwich" : "the equator") +
                           " places are is read from " + column_text(layout.table, *side));
  }
  if (layout.time && layout.time->clock) layout.clock_zone = find_clock_zone(layout.table);
  if (!said) {
    if (auto problem = settle_airsim(text, options, layout)) return *std::move(problem);
  }
  if (!said || choice.id) {
    if (auto problem = unclear_id(text, header, layout)) return *std::move(problem);
  }
  if (auto problem = numbered_records(text, header, layout)) {
    if (seen == SeenRecords::kWhole) return *std::move(problem);
    layout.perhaps_numbers = std::move(problem);
  }
  layout.show = layout.time && layout.frame != Frame::kWgs84 &&
                (names_colours(layout.table) || has_header_of_skybrush(layout.table));
  layout.doubted_above_mps = doubted_above(layout);
  settle_take_off(layout);
  if (layout.time) {
    if (seen != SeenRecords::kWhole) layout.time->bare_midnights = false;
    const bool colours = names_one_colour(layout.table) || names_colours(layout.table);
    layout.time->zero_unsaid = layout.time->form == TimeForm::kNumbers &&
                               !layout.time->since_1970 && !options.one_clock && !known &&
                               !layout.show && !colours;
    layout.time->begins_at_zero = !options.one_clock && !known && !layout.show && !colours &&
                                  times_begin_at_zero(text, layout.table, *layout.time);
    // Animations, as of shows, have heights, and one clock.
    layout.time->of_video = layout.time->form == TimeForm::kFrames && !options.one_clock &&
                            !known && (choice.dimensions == 2 || options.pixel.has_value());
    layout.time->is_small = layout.time->unit_is_asked && !options.one_clock && !layout.show &&
                            !colours && times_are_small(text, layout.table, *layout.time);
    layout.notes.push_back(
        time_note(layout.table, *layout.time, options.time_unit != Unit::kUnstated));
  }
  layout.notes.push_back(position_note(layout.table, choice, layout.frame));
  return layout;
}

Result<TrackLayout> find_track_layout(std::string_view text, const RecordingOptions& options,
                                      bool bare_skybrush, SeenRecords seen) {
  if (auto problem = motion_capture_problem(text)) return *std::move(problem);
  if (auto problem = dumped_text_problem(text)) return *std::move(problem);
  const bool free = options.columns.empty();
  const bool any_format = options.format == RecordingFormat::kAuto;
  const std::size_t clover = free && any_format && options.time_unit == Unit::kUnstated
                                 ? find_clover_records(text)
                                 : kNoCloverTable;
  const std::size_t begins = clover == kNoCloverTable ? 0 : clover;
  auto table = find_table(text.substr(begins), options.skip_bad);
  if (!table) return table.error();
  table->data_offset += begins;
  if (begins > 0) ++table->lines_before;
  if (auto error = no_record_problem(text, *table)) return *std::move(error);
  const bool skybrush = bare_skybrush || (any_format && is_path_with_colours(text, *table));
  const bool is_clover =
      clover != kNoCloverTable && (begins > 0 || !is_trajectory_of_poses(text, *table));
  const auto ros = !is_clover && names_columns_of_ros(options)
                       ? find_ros_table(text, *table, !names_position(options))
                       : std::nullopt;
  auto chosen = is_clover ? clover_layout(*table, text, options, seen)
                : skybrush && table->names.empty() && free ? skybrush_layout(*table, text, options)
                : ros ? ros_layout(*ros, *table, text, options, seen)
                : free && is_trajectory_of_poses(text, *table)
                    ? layout_of_poses(*table, text, options, seen)
                    : choose_track_layout(*table, text, options, seen);
  if (!chosen) return at_first_line(std::move(chosen).error(), *table);
  chosen->notes.insert(chosen->notes.begin(), table->notes.begin(), table->notes.end());
  return chosen;
}

}  // namespace beespace::io
