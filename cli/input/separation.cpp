#include "cli/input/separation.hpp"

#include "cli/command_line/command.hpp"
#include "cli/command_line/option_values.hpp"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace beespace::cli {
namespace {

// ICAO Doc 4444 (PANS-ATM): 5.0 NM in 8.7.3.1, 3.0 NM where it is prescribed in 8.7.3.2, 1,000 ft
// in 5.3.2. ASTM F3442: the volume in which a small unmanned aircraft is not well clear. RTCA
// DO-365: the near mid-air collision, as studies of TCAS and ACAS count it.
constexpr std::array<UsualSeparation, 4> kUsual = {{
    {"enroute", 5, io::Unit::kNauticalMile, 1000, "ICAO Doc 4444", true},
    {"terminal", 3, io::Unit::kNauticalMile, 1000, "ICAO Doc 4444", true},
    {"well-clear-suas", 2000, io::Unit::kFoot, 250, "ASTM F3442", false},
    {"nmac", 500, io::Unit::kFoot, 100, "RTCA DO-365", true},
}};

// Well clear without saying of whom: the volume of small ones would find less of others.
bool is_well_clear(std::string_view given) {
  return given == "well-clear" || given == "wellclear" || given == "well_clear" || given == "dwc";
}
constexpr std::string_view kWellClears =
    "well clear is of two kinds: of small unmanned aircraft --separation well-clear-suas (2000 ft, "
    "250 ft, ASTM F3442), of others --threshold 4000ft --vertical 450ft (RTCA DO-365, without its "
    "time of 35 s, the modified tau, which is not looked at)";

io::StatedLength stated(double value, io::Unit unit) {
  return {io::in_metric(value, unit), value, unit};
}

}  // namespace

std::span<const UsualSeparation> usual_separations() {
  return kUsual;
}

void add_usual_separation_option(Command& command, const UsualSeparation*& into) {
  std::vector<Word<const UsualSeparation*>> words;
  words.reserve(kUsual.size());
  for (const UsualSeparation& usual : kUsual) words.push_back({usual.name, &usual});
  Option& option = command.choice(
      "--separation", into, words,
      "Both of these by name: enroute (5 NM, 1000 ft) and\nterminal (3 NM, 1000 ft) "
      "of ICAO Doc 4444,\nwell-clear-suas (2000 ft, 250 ft) of ASTM F3442,\nnmac (500 "
      "ft, 100 ft) of RTCA DO-365",
      "NAME");
  option.problem = [otherwise = option.problem](const std::string& given) {
    return is_well_clear(given) ? std::string(kWellClears) : otherwise(given);
  };
}

Status settle_separation(const char* command, const UsualSeparation* usual,
                         std::optional<io::StatedLength>& threshold,
                         std::optional<io::StatedLength>& vertical) {
  if (usual == nullptr) return std::monostate{};
  const io::StatedLength across = stated(usual->threshold, usual->threshold_unit);
  const io::StatedLength up = stated(usual->vertical_ft, io::Unit::kFoot);
  if (threshold || vertical) {
    return usage_error(command, std::string("--separation ") + usual->name + " is --threshold '" +
                                    text_of(across) + "' and --vertical '" + text_of(up) +
                                    "', but " + (threshold ? "--threshold" : "--vertical") +
                                    " is given too; leave one of the two out");
  }
  threshold = across;
  vertical = up;
  return std::monostate{};
}

std::string spoken_of_aviation(const UsualSeparation* usual,
                               const std::optional<io::StatedLength>& threshold) {
  if (usual != nullptr) return std::string("--separation ") + usual->name;
  return threshold && threshold->unit == io::Unit::kNauticalMile ? "--threshold in NM" : "";
}

void take_heights_of(const UsualSeparation* usual, const std::optional<io::StatedLength>& vertical,
                     io::HeightSource& heights) {
  const bool by_pressure = usual != nullptr
                               ? usual->by_pressure
                               : vertical && (vertical->unit == io::Unit::kFoot ||
                                              vertical->unit == io::Unit::kFlightLevel);
  if (!by_pressure || heights != io::HeightSource::kAuto) return;
  heights = io::HeightSource::kRatherPressure;
}

bool in_aviation(io::UnitConvention said, io::Unit height_unit,
                 const std::optional<io::StatedLength>& threshold,
                 const std::optional<io::StatedLength>& vertical) {
  const auto is_of_aviation = [](io::Unit unit) {
    return unit == io::Unit::kNauticalMile || unit == io::Unit::kFoot ||
           unit == io::Unit::kFlightLevel;
  };
  if (said != io::UnitConvention::kNone) return said == io::UnitConvention::kAviation;
  return is_of_aviation(height_unit) || (threshold && is_of_aviation(threshold->unit)) ||
         (vertical && is_of_aviation(vertical->unit));
}

std::string usual_text(const UsualSeparation* usual) {
  if (usual == nullptr) return {};
  return std::string(", which is ") + usual->name + " (" + usual->source + ")";
}

}  // namespace beespace::cli
