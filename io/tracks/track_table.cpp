#include "io/tracks/track_table.hpp"

#include "io/bytes/characters.hpp"
#include "io/problems/excerpt.hpp"
#include "io/problems/skipped_records.hpp"
#include "io/problems/text_check.hpp"
#include "io/problems/unplaced.hpp"
#include "io/recording/unit_doubts.hpp"
#include "io/table/column_names.hpp"
#include "io/table/column_overrides.hpp"
#include "io/table/fields.hpp"
#include "io/table/record_problems.hpp"
#include "io/table/record_walk.hpp"
#include "io/tracks/local_positions.hpp"
#include "io/tracks/time_shift_line.hpp"
#include "io/tracks/track_aircraft.hpp"
#include "io/tracks/track_layout.hpp"
#include "io/tracks/track_record.hpp"
#include "io/tracks/track_refusals.hpp"
#include "io/tracks/track_sets.hpp"
#include "io/tracks/unnamed_position.hpp"
#include "io/tracks/utm_zone.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

namespace beespace::io {
namespace {

// TRex writes a table an animal, "guppies_fish0.csv": what is before the last "_" is of the video.
std::string_view video_of_trex(std::string_view source) {
  const std::size_t animal = source.rfind('_');
  return animal != std::string_view::npos && animal > 0 ? source.substr(0, animal) : source;
}

// The column of an error by the name of its key.
void place(Error& error, std::uint64_t line, std::uint64_t row, RecordPlace how,
           const TrackLayout& layout) {
  if (how != RecordPlace::kRecordAndName) error.location.line = line;
  error.location.record = row;
  if (how == RecordPlace::kLineAndColumn || !error.location.column) return;
  const std::size_t column = *error.location.column - 1;
  if (column < layout.table.names.size()) {
    error.message.insert(0, excerpt(layout.table.names[column]) + ": ");
  }
  error.location.column.reset();
}

// Which of two times is meant that clocks show alike, as the order of the records tells.
std::optional<Error> settle_doubled(TrackRecord& record, RecordingAssembly& assembly) {
  DoubledHours& hours = assembly.doubled_hours();
  if (!record.doubled) return hours.take(record.id, record.time_s);
  Error& unclear = record.doubled->unclear;
  unclear.location.source = assembly.source_name();
  const auto time_s =
      hours.take_doubled(record.id, record.time_s, record.doubled->by_s, std::move(unclear));
  if (!time_s) return time_s.error();
  record.time_s = *time_s;
  return std::nullopt;
}

// Whether a column of ids is called so.
bool names_drones(const std::string& column) {
  constexpr std::string_view kNames =
      "drone drones drone_id drone_name drone_no drone_number droneid uav uav_id uav_name uavid "
      "quad "
      "quad_id";
  return is_one_of(kNames, plain_name(column));
}

}  // namespace

SourceFacts facts_of(const TrackLayout& layout, std::string description) {
  const ColumnChoice& choice = layout.table.choice;
  SourceFacts facts;
  facts.frame = layout.frame;
  facts.frame_reason = layout.frame_reason;
  facts.naming = choice.naming;
  facts.dimensions = choice.dimensions;
  facts.has_time = layout.time.has_value();
  facts.since_1970 = layout.time && layout.time->since_1970;
  if (layout.time) facts.clock = layout.time->clock;
  facts.own_origin = layout.own_origin;
  facts.axes = layout.first_axes;
  facts.stamps_ahead_s = layout.stamps_ahead_s;
  facts.since_start = layout.time && layout.time->since_start;
  facts.small_times = layout.time && layout.time->is_small;
  facts.begins_at_zero = layout.time && layout.time->begins_at_zero;
  facts.zero_unsaid = layout.time && layout.time->zero_unsaid;
  if (facts.zero_unsaid && description.starts_with("text")) facts.shift = time_shift_line(layout);
  facts.of_aircraft = tells_of_aircraft(layout);
  facts.of_animals = layout.of_animals;
  const bool ids_of_drones = choice.id && *choice.id < layout.table.names.size() &&
                             names_drones(layout.table.names[*choice.id]);
  facts.called_drones = !facts.of_aircraft && !facts.of_animals &&
                        (ids_of_drones || names_autopilot(layout.table) ||
                         (layout.frame == Frame::kWgs84 && names_colours(layout.table)));
  facts.heights_beside = heights_beside(layout.take_off, layout.table);
  facts.y_is_down = layout.y_is_down;
  facts.names_bees = choice.id.has_value();
  if (layout.time && layout.time->form == TimeForm::kNumbers) facts.time_unit = layout.time->unit;
  facts.trials.column = columns_of_trials(layout);
  facts.scenes.column = columns_of_scenes(layout);
  if (layout.tag && choice.id) {
    facts.tags = {
        column_text(layout.table, *layout.tag),
        "of two on one animal leave the records of one out; to take each tag for one, say "
        "--columns id=" +
            std::to_string(*layout.tag + 1) +
            ", or to mix them all the same, --columns id=" + std::to_string(*choice.id + 1)};
  }
  if (layout.time && layout.time->named && layout.time->form == TimeForm::kNumbers) {
    facts.named_time = layout.time->unit;
  }
  facts.doubted_above_mps = layout.doubted_above_mps;
  if (facts.doubted_above_mps && facts.called_drones) {
    facts.doubted_above_mps = std::min(*facts.doubted_above_mps, kFastestDrone_mps);
  }
  facts.heights = choice.datum;
  facts.height_unit = choice.height_unit();
  facts.units = layout.units;
  facts.height_columns = layout.height_columns;
  facts.description = std::move(description);
  return facts;
}

std::optional<Error> read_track_records(std::string_view text, const TrackLayout& layout,
                                        const std::string& stem, RecordPlace place_of,
                                        RecordsBefore& before, RecordingAssembly& assembly) {
  constexpr std::uint64_t kRowsPerReport = 4096;
  Progress* const progress = assembly.options().progress;
  const bool nameless_rows = !layout.table.choice.id && !layout.time;
  const Unit height_unit = layout.table.choice.height_unit();
  TrackRecordReader reader(layout);
  const bool times_of_day = layout.time && layout.time->clock && !layout.time->clock->dated;
  if (layout.time && layout.time->of_position) assembly.tracks().round_times(0.0);
  const bool dated = layout.time && layout.time->clock && layout.time->clock->dated;
  const bool turned = layout.time && layout.time->zone && layout.time->zone->is_turned() &&
                      !assembly.options().skip_bad;
  if (turned) reader.take_doubled();
  TrackRecord record;
  record.id = stem;
  std::string row_id;
  std::uint64_t rows = 0;
  const char* reported = text.data();
  std::uint64_t headers = 0;
  RecordWalk walk(text, 0, layout.table);
  while (walk.next()) {
    before.joined = before.joined || walk.headers() > headers;
    headers = walk.headers();
    const std::uint64_t line =
        layout.table.lines_before + walk.line() / layout.table.records_per_line + 1;
    const char* const here = walk.record().data();
    rows = walk.row() + 1;
    if (progress != nullptr && walk.row() % kRowsPerReport == 0) {
      progress->done += static_cast<std::uint64_t>(here - reported);
      reported = here;
    }
    if (layout.table.choice.id) {
      record.id = {};
    } else if (!layout.sets.empty()) {
      record.id = stem;
    }
    if (nameless_rows) {
      row_id = std::to_string(assembly.nameless() + walk.row());
      record.id = row_id;
    }
    auto problem = reader.read(walk.record(), record);
    if (layout.local_origin && !problem && record.left_out == nullptr) {
      bring_to_degrees(walk.record(), layout, record);
    }
    if (!record.late_height.empty()) {
      Error error = height_after_all(record.late_height, *layout.no_height_yet);
      place(error, line, before.rows + walk.row(), place_of, layout);
      return error;
    }
    if (!problem && record.left_out == nullptr && layout.time && layout.time->since_start &&
        layout.table.choice.id) {
      if (before.vehicle.empty()) before.vehicle = record.id;
      if (before.vehicle != record.id) {
        Error error = own_zeros(before.vehicle, record.id, layout);
        place(error, line, before.rows + walk.row(), place_of, layout);
        return error;
      }
    }
    if (!layout.sets.empty() && !record.id.empty()) {
      record.id = assembly.name_within_set(record.id, record.set);
    }
    if (layout.joined_place && record.id.empty()) record.id = stem;
    if (layout.ids_are_addresses) record.id = assembly.name_of_address(record.id);
    if (layout.ids_within_file && !(problem && record.id.empty())) {
      if (record.id.empty()) {
        record.id = stem;
      } else if (assembly.has_several()) {
        record.id = assembly.name_within_file(stem, record.id);
      }
    }
    if (problem) {
      if (auto other = other_header_problem(walk.record(), layout.table)) {
        place(*other, line, before.rows + walk.row(), place_of, layout);
        return other;
      }
      place(*problem, line, before.rows + walk.row(), place_of, layout);
      if (auto fatal = assembly.bad(*std::move(problem), record.id)) return fatal;
      if (record.is_timed) assembly.unplaced(record.id, record.time_s);
      continue;
    }
    if (record.left_out == &kOnGround && record.claim_is_placed && layout.time) {
      assembly.claims_ground(record.id, {record.time_s, record.position});
      continue;
    }
    if (record.left_out != nullptr) {
      assembly.leave_out(*record.left_out, record.id);
      // Who is nowhere else is known nowhere.
      const bool counts = !record.left_out->harmless;
      if (has_no_place(*record.left_out) && !counts) assembly.heard_of(kNeverPlaced, record.id);
      if (record.is_timed && record.left_out == &kNoPosition) {
        assembly.positionless(record.id, record.time_s);
      } else if (record.is_timed) {
        assembly.unplaced(record.id, record.time_s);
      }
      continue;
    }
    if (std::exchange(before.joined, false)) {
      if (auto error = joined_problem(record, layout)) {
        place(*error, line, before.rows + walk.row(), place_of, layout);
        return error;
      }
    }
    if (turned) {
      if (record.doubled)
        place(record.doubled->unclear, line, before.rows + walk.row(), place_of, layout);
      if (auto error = settle_doubled(record, assembly)) return error;
    }
    if (times_of_day && assembly.goes_back(record.id, record.time_s)) {
      Error error = goes_back(record, *layout.time);
      place(error, line, before.rows + walk.row(), place_of, layout);
      if (auto fatal = assembly.bad(std::move(error), record.id)) return fatal;
      continue;
    }
    if (dated) {
      if (const auto back_s = assembly.set_back_by(record.id, record.time_s)) {
        Error error = set_back(record, *back_s, *layout.time);
        place(error, line, before.rows + walk.row(), place_of, layout);
        if (auto fatal = assembly.bad(std::move(error), record.id)) return fatal;
        continue;
      }
    }
    if (layout.axes_name) {
      if (auto error = assembly.agree_on_axes(record.axes_name, record.id)) {
        if (layout.axes_name == layout.table.choice.id) {
          error->message +=
              "; if it is but a name, and all have one origin and direction, say so "
              "with --crs metres";
        }
        place(*error, line, before.rows + walk.row(), place_of, layout);
        return error;
      }
    }
    if (layout.zone) {
      if (auto error = assembly.agree_on_zone(record.zone, utm_zone_of(record.zone))) {
        place(*error, line, before.rows + walk.row(), place_of, layout);
        return error;
      }
    }
    if (layout.clock_zone) {
      if (auto error = assembly.agree_on_clock_zone(record.clock_zone)) {
        error->location.column = *layout.clock_zone + 1;
        place(*error, line, before.rows + walk.row(), place_of, layout);
        return error;
      }
    }
    if (record.is_rough) assembly.take_rough(record.id);
    if (record.off_m > 0.0) {
      assembly.take_accuracy(record.id, record.off_m, layout.table.names[layout.accuracy->column]);
    }
    if (layout.take_off.any()) {
      assembly.take_offs().take(record.id, record.time_s, record.take_off);
    }
    if (record.flies_on_ground) assembly.keep_in_flight();
    if (record.doubts_standing) assembly.doubt_standing();
    if (layout.on_ground && layout.time) {
      assembly.flies_at(record.id, {record.time_s, record.position});
    }
    Origin origin;
    origin.source = assembly.source() & 0xFF'FFFFu;
    origin.line = line & 0xFF'FFFF'FFFFu;
    if (record.is_bare_midnight) {
      assembly.bare_midnights().take(record.id, record.time_s, origin);
    } else if (record.is_midnight) {
      assembly.bare_midnights().take_written();
    }
    if (!layout.trials.empty()) assembly.take_trial(record.trial, record.time_s, origin);
    if (!layout.scenes.empty()) {
      assembly.take_scene(record.trial, record.scene, record.time_s, origin);
    }
    if (layout.time && layout.time->of_video) {
      assembly.take_picture(assembly.source_name(), record.time_s, origin);
    } else if (layout.not_seen && !assembly.options().one_clock) {
      assembly.take_picture(video_of_trex(assembly.source_name()), record.time_s, origin);
    }
    if (layout.tag && !is_unknown(record.tag)) {
      assembly.take_tag(record.id, record.tag, record.time_s, origin);
    }
    std::optional<double> stated_height;
    if (height_unit != Unit::kMetre) stated_height = record.stated_height;
    assembly.tracks().add(record.id, {record.time_s, record.position},
                          layout.velocity ? &record.velocity : nullptr, origin, stated_height);
    if (!record.label.empty()) {
      assembly.tracks().label(record.id, record.label, record.time_s);
    }
  }
  if (progress != nullptr) {
    progress->done += static_cast<std::uint64_t>(text.data() + text.size() - reported);
  }
  if (nameless_rows) assembly.add_nameless(rows);
  before.rows += rows;
  before.joined = before.joined || walk.headers() > headers;
  before.headers += walk.headers();
  return std::nullopt;
}

TrackTableReader::TrackTableReader(TrackLayout layout, std::string stem,
                                   RecordingAssembly& assembly)
    : layout_(std::make_unique<TrackLayout>(std::move(layout))),
      header_(std::make_unique<std::string>(layout_->table.header)),
      data_offset_(layout_->table.data_offset),
      stem_(std::move(stem)),
      assembly_(&assembly) {
  layout_->table.header = *header_;
}

Result<TrackTableReader> TrackTableReader::begin(const TrackTable& beginning,
                                                 RecordingAssembly& assembly) {
  if (auto problem = text_problem(beginning.bytes)) return *std::move(problem);
  const std::string_view text = without_byte_order_mark(beginning.bytes);
  auto layout =
      find_track_layout(text, assembly.options(), beginning.bare_skybrush, beginning.seen);
  if (!layout) return std::move(layout).error();
  settle_local_origin(assembly.options(), *layout);
  if (layout->time && layout->time->clock) {
    layout->time->clock = assembly.common_clock(*layout->time->clock);
  }
  std::string form = "text, " + std::string(delimiter_name(layout->table.delimiter)) + "-separated";
  SourceFacts facts = facts_of(*layout, std::move(form));
  facts.trials.advice = filter_of_trials(*layout);
  facts.scenes.advice = filter_of_scenes(*layout);
  if (auto error = assembly.agree(facts)) return *std::move(error);
  for (std::string& note : layout->notes) assembly.note(std::move(note));
  if (layout->show) assembly.declare_show({});
  if (!layout->table.choice.id) {
    assembly.note(layout->time ? "there is no id: each file is taken for one bee, named after it"
                               : "there is no id: bees are numbered in their order, from 0");
  }
  std::string stem = beginning.stem;
  if (is_named_after_file(*layout)) stem = assembly.name_of_source(std::move(stem));
  TrackTableReader reader(*std::move(layout), std::move(stem), assembly);
  reader.data_offset_ += beginning.bytes.size() - text.size();
  Progress* const progress = assembly.options().progress;
  if (progress != nullptr) progress->done += reader.data_offset_;
  return reader;
}

std::optional<Error> TrackTableReader::read(std::string_view lines) {
  const std::uint64_t headers = before_.headers;
  auto error =
      read_track_records(lines, *layout_, stem_, RecordPlace::kLineAndColumn, before_, *assembly_);
  if (before_.headers > headers && headers == 0) {
    assembly_->note("the header comes again in " + assembly_->source_name() +
                    ", as where tables were joined: those lines are passed over");
  }
  layout_->table.lines_before +=
      static_cast<std::uint64_t>(std::count(lines.begin(), lines.end(), layout_->table.line_end));
  return error;
}

std::optional<Error> read_track_table(const TrackTable& table, RecordingAssembly& assembly) {
  TrackTable all = table;
  all.seen = SeenRecords::kWhole;
  auto reader = TrackTableReader::begin(all, assembly);
  if (!reader) return std::move(reader).error();
  return reader->read(table.bytes.substr(reader->data_offset()));
}

}  // namespace beespace::io
