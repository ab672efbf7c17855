// Minima that are usual in aviation, by name: --separation enroute stands for --threshold 5NM and
// --vertical 1000ft.
#pragma once

#include "io/units/heights.hpp"
#include "io/units/stated_length.hpp"
#include "io/units/unit_overrides.hpp"

#include <beespace/result.hpp>

#include <optional>
#include <span>
#include <string>

namespace beespace::cli {

class Command;

// In conflict are two that are horizontally and vertically closer.
struct UsualSeparation {
  const char* name;
  double threshold;
  io::Unit threshold_unit;
  double vertical_ft;
  const char* source;  // the document that says so
  bool by_pressure;    // its heights are those of altimeters
};

std::span<const UsualSeparation> usual_separations();

// --separation, among the options of the heading in use.
void add_usual_separation_option(Command& command, const UsualSeparation*& into);

// Puts what a name stands for where --threshold and --vertical are read into; where there is no
// name, nothing. Errors: kInvalidArgument where one of these is given too.
Status settle_separation(const char* command, const UsualSeparation* usual,
                         std::optional<io::StatedLength>& threshold,
                         std::optional<io::StatedLength>& vertical);

// What of these speaks of aviation: "--separation enroute", "--threshold in NM"; or nothing.
std::string spoken_of_aviation(const UsualSeparation* usual,
                               const std::optional<io::StatedLength>& threshold);

// Heights by pressure, where the input has them, for minima that are of these and for a vertical
// threshold in feet, as aircraft keep apart by them; unless heights are chosen.
void take_heights_of(const UsualSeparation* usual, const std::optional<io::StatedLength>& vertical,
                     io::HeightSource& heights);

// Whether distances are told in nautical miles and feet too: where the thresholds or the heights of
// the input are, or --units says so.
bool in_aviation(io::UnitConvention said, io::Unit height_unit,
                 const std::optional<io::StatedLength>& threshold,
                 const std::optional<io::StatedLength>& vertical);

// ", which is enroute (ICAO Doc 4444)"; empty without a name.
std::string usual_text(const UsualSeparation* usual);

}  // namespace beespace::cli
