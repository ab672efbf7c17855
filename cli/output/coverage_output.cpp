#include "cli/output/coverage_output.hpp"

#include "analysis/recorded/airborne.hpp"
#include "analysis/recorded/begins_in_air.hpp"

#include "cli/console/summary_line.hpp"
#include "cli/console/terminal.hpp"
#include "io/bytes/number_text.hpp"
#include "io/problems/excerpt.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace beespace::cli {
namespace {

// The first ids of so many.
std::string first_ids(const std::vector<std::string>& ids, std::uint64_t count) {
  std::string text;
  for (const std::string& id : ids) text += (text.empty() ? "" : ", ") + id;
  if (count > ids.size()) text += ", ...";
  return text;
}

std::string coarse_text(const analysis::Coverage& coverage) {
  std::string text = red(io::counted(coverage.coarse, "bee has", "bees have"));
  if (coverage.coarse_by.empty()) {
    return text + " places written with few decimals, in steps of up to " +
           io::length(coverage.coarse_m) +
           ": two may be closer than the threshold; read places with all their decimals, or ask "
           "about a greater threshold";
  }
  return text + " places of which half or more are off by up to " + io::length(coverage.coarse_m) +
         " by " + io::excerpt(coverage.coarse_by) +
         ": two may be closer than the threshold; ask about a greater one";
}

}  // namespace

void append_coverage(std::string& out, const analysis::Coverage& coverage,
                     const io::Recording& recording) {
  if (coverage.max_gap.typical_s || coverage.max_gap.asked) {
    append_summary_line(out, "max gap", analysis::max_gap_text(coverage.max_gap));
  }
  if (coverage.bridged) {
    append_summary_line(out, "bridged",
                        "gaps up to that, by straight lines; the longest: " +
                            printable(analysis::bridged_text(coverage, recording)));
  }
  if (coverage.gaps > 0) {
    append_summary_line(out, "unknown",
                        red(io::counted(coverage.bees_with_gaps, "bee", "bees")) + " in " +
                            io::grouped(coverage.gaps) + (coverage.gaps == 1 ? " gap" : " gaps") +
                            " between two fixes, for " + io::time_span(coverage.in_gaps_s) +
                            " in all");
  }
  for (const Gap& gap : coverage.longest) {
    append_summary_line(out, "", printable(analysis::gap_text(gap, recording)));
  }
  if (coverage.gaps > coverage.longest.size()) {
    append_summary_line(out, "", "and shorter ones");
  }
  if (const std::string slow = analysis::slow_text(coverage, recording); !slow.empty()) {
    append_summary_line(out, "", printable(slow));
  }
  if (coverage.sector && coverage.bees_partly > 0) {
    append_summary_line(out, "sector",
                        io::counted(coverage.bees_partly, "bee", "bees") +
                            " before the first or after the last fix, for " +
                            io::time_span(coverage.outside_s) +
                            " in all: outside, and not asked about (--sector)");
  } else if (coverage.bees_partly > 0) {
    append_summary_line(
        out, coverage.gaps > 0 ? "" : "unknown",
        io::counted(coverage.bees_partly, "bee", "bees") +
            " before the first or after the last fix, for " + io::time_span(coverage.outside_s) +
            " in all" +
            (coverage.bees_cut_off == 0 ? ""
                                        : "; " + red(io::grouped(coverage.bees_cut_off)) +
                                              (coverage.in_a_plane ? " of them on their way then"
                                                                   : " of them in the air then")) +
            (coverage.bees_unplaced == 0 ? ""
                                         : "; " + red(io::grouped(coverage.bees_unplaced)) +
                                               " of them there then, in records without a place") +
            (coverage.unseen.empty()
                 ? ""
                 : "; " + red(io::grouped(coverage.unseen.size())) +
                       " of them on the ground by all its records, while others fly"));
    for (const Gap& gap : coverage.longest_outside) {
      append_summary_line(out, "", printable(analysis::gap_text(gap, recording)));
    }
    if (recording.of_aircraft && coverage.bees_cut_off > 0) {
      append_summary_line(out, "",
                          "of a cut of a sector, which aircraft enter and leave: --sector asks for "
                          "nothing before the first and after the last fix");
    }
  }
  if (const std::string alone = printable(analysis::alone_text(coverage, recording));
      !alone.empty()) {
    if (coverage.compared_with_none()) {
      const bool zone =
          coverage.alone_begins_s && analysis::zones_apart_s(*coverage.alone_begins_s);
      append_summary_line(
          out, "alone",
          red(alone) + (zone ? "" : "; is it of another day, or is a clock wrong? Leave it out"));
    } else if (!recording.of_aircraft && recording.frame == io::Frame::kWgs84) {
      append_summary_line(out, "note", alone);
    }
  }
  append_missing(out, coverage.missing);
  if (coverage.coarse > 0) append_summary_line(out, "coarse", coarse_text(coverage));
  append_note(out, analysis::begins_in_air_text(coverage.begins_in_air));
  if (!coverage.whole_seconds.empty()) {
    append_summary_line(out, "note", coverage.whole_seconds);
  }
}

void write_coverage(io::JsonWriter& json, const analysis::Coverage& coverage,
                    const io::Recording& recording) {
  json.begin_object(io::JsonLayout::kWrapped).member("complete", coverage.complete());
  json.member("max_gap_s", coverage.max_gap.seconds);
  json.member("typical_interval_s", coverage.max_gap.typical_s);
  json.member("gap_count", coverage.gaps).member("bees_with_gaps", coverage.bees_with_gaps);
  json.member("in_gaps_s", coverage.in_gaps_s).member("bees_partly_known", coverage.bees_partly);
  json.member("bees_cut_off_in_the_air", coverage.bees_cut_off);
  json.member("bees_there_without_a_place", coverage.bees_unplaced);
  json.member("bees_on_ground_only", coverage.unseen.size());
  json.member("bees_alone", coverage.alone.size());
  json.member("sector", coverage.sector);
  json.member("before_first_and_after_last_s", coverage.outside_s);
  json.new_line();
  write_missing(json, coverage.missing);
  json.member("coarse_places", coverage.coarse);
  json.member("begin_in_the_air", coverage.begins_in_air);
  json.new_line();
  json.begin_array("longest_gaps", io::JsonLayout::kRows);
  for (const Gap& gap : coverage.longest) {
    json.begin_object().member("id", recording.bees[gap.track].id);
    json.member("begins_s", gap.begins_s).member("ends_s", gap.ends_s);
    json.member("lasts_s", analysis::length_of(gap));
    json.end();
  }
  json.end();
  if (recording.reach) {  // with --memory it is not looked at
    json.end();
    return;
  }
  json.key("longest_bridged");
  if (coverage.bridged) {
    json.begin_object().member("id", recording.bees[coverage.bridged->track].id);
    json.member("begins_s", coverage.bridged->begins_s).member("ends_s", coverage.bridged->ends_s);
    json.member("lasts_s", analysis::length_of(*coverage.bridged));
    json.end();
  } else {
    json.null();
  }
  json.end();
}

void append_missing(std::string& out, const io::MissingRecords& missing) {
  if (missing.shared > 0) {
    append_summary_line(
        out, "two in one",
        red(printable(first_ids(missing.shared_ids, missing.shared))) + ": at two places in turn");
  }
  if (missing.jumping > 0) {
    append_summary_line(out, "jumps",
                        red(printable(first_ids(missing.jumping_ids, missing.jumping))) +
                            ": faster than anything that flies, than it says itself, or, there and "
                            "back, than it ever moves elsewhere");
  }
  if (missing.files > 0) {
    append_summary_line(out, "not read",
                        red(printable(first_ids(missing.file_names, missing.files))));
  }
  if (missing.swapped > 0) {
    append_summary_line(out, "swapped",
                        red(io::counted(missing.swapped, "bee", "bees")) +
                            " would be beside others with longitude and latitude the other way "
                            "round");
  }
  if (missing.untimed > 0) {
    append_summary_line(out, "clocks",
                        red(io::counted(missing.untimed, "vehicle's is", "vehicles' are")) +
                            " not known to go with those of the others (see the notes)");
  }
  if (missing.rough > 0) {
    append_summary_line(out, "rough",
                        red(io::counted(missing.rough, "bee has", "bees have")) +
                            " places by Argos' Doppler shifts, off by kilometres");
  }
  if (missing.count == 0) return;
  std::string text = red(io::counted(missing.count, "record", "records"));
  if (missing.without_id < missing.count) text += " of " + io::counted(missing.bees, "bee", "bees");
  if (missing.without_id > 0) {
    text += missing.without_id == missing.count
                ? " of unknown bees"
                : " and " + io::grouped(missing.without_id) + " of unknown ones";
  }
  const char* const why = missing.without_id == missing.count ? ": it is not said whose they are"
                          : missing.without_id > 0 ? ": place, height, time or id is missing or bad"
                                                   : ": place, height or time is missing or bad";
  append_summary_line(out, "left out", text + why);
  if (missing.nowhere == 0) return;
  append_summary_line(
      out, "", "known nowhere: " + printable(first_ids(missing.nowhere_ids, missing.nowhere)));
}

void write_missing(io::JsonWriter& json, const io::MissingRecords& missing) {
  json.member("left_out_records", missing.count).member("left_out_without_id", missing.without_id);
  json.member("left_out_bees", missing.bees).member("bees_known_nowhere", missing.nowhere);
  json.member("known_nowhere", missing.nowhere_ids);
  json.member("shared_id_count", missing.shared).member("shared_ids", missing.shared_ids);
  json.member("left_out_files", missing.files).member("left_out_file_names", missing.file_names);
  json.member("jumping_count", missing.jumping).member("jumping_ids", missing.jumping_ids);
  json.member("swapped_degrees", missing.swapped).member("untimed", missing.untimed);
  json.member("rough_places", missing.rough);
}

}  // namespace beespace::cli
