#include "io/problems/foreign_containers.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <system_error>

namespace beespace::io {
namespace {

// What to type, with FILE for the name of the file.
constexpr std::string_view kUnknownHdf5 =
    "an HDF5 file (also .mat of MATLAB 7.3), which is not read; see what it has: pip install h5py, "
    "then python3 -c \"import h5py; h5py.File('FILE').visititems(print)\"; docs/recipes/matlab.md "
    "has the lines that ask about arrays";
constexpr std::string_view kDeepLabCut =
    "an HDF5 file of DeepLabCut, which is not read; the .csv that it writes beside it is, or make "
    "one: pip install pandas tables, then python3 -c \"import pandas; "
    "pandas.read_hdf('FILE').to_csv('poses.csv')\"";
constexpr std::string_view kPandasHdf5 =
    "an HDF5 file of pandas, which is not read; make CSV of it: pip install pandas tables, then "
    "python3 -c \"import pandas; pandas.read_hdf('FILE').to_csv('bees.csv', index=False)\"";
constexpr std::string_view kSleap =
    "a file of SLEAP (HDF5), which is not read; make a table of it: sleap-convert --format "
    "analysis.csv FILE";
constexpr std::string_view kSleapAnalysis =
    "an analysis file of SLEAP (HDF5), which is not read; make a table of it: pip install "
    "sleap-io, "
    "then python3 -c \"import sleap_io; sleap_io.save_csv(sleap_io.load_analysis_h5('FILE'), "
    "'poses.csv', format='sleap')\"";
constexpr std::string_view kIdtracker =
    "a file of idtracker.ai (HDF5), which is not read; make CSV of its trajectories: "
    "idtrackerai_csv FOLDER, with the folder of the session";
constexpr std::string_view kNpz =
    "an archive of arrays of NumPy (.npz), which is not read; see what it has: python3 -c \"import "
    "numpy; [print(name, array.shape) for name, array in numpy.load('FILE').items()]\"; an array "
    "of places alone is read by 'beespace detect': python3 -c \"import numpy; "
    "numpy.save('bees.npy', numpy.load('FILE')['NAME'])\"; docs/recipes/matlab.md has the lines "
    "that ask about arrays of tracks";
constexpr std::string_view kTRexNpz =
    "a file of TRex (.npz), which is not read; let TRex write CSV (output_format csv), or make it "
    "of each: pip install numpy pandas, then python3 -c \"import numpy, pandas, sys; "
    "[pandas.DataFrame({k + ('' if '(' in k else ' (cm)' if k[0] in 'XY' else ' (cm/s)' if k[:2] "
    "in "
    "('VX', 'VY', 'SP') else ''): f[k] for k in f if f[k].shape == f['time'].shape}).to_csv(n[:-3] "
    "+ 'csv', "
    "index=False) for n in sys.argv[1:] for f in [numpy.load(n)]]\" FILE, with the names of the "
    "others behind the first one";
constexpr std::string_view kExcel =
    "an Excel workbook (.xlsx), which is not read; save each of its sheets as CSV (File, Save As, "
    "CSV UTF-8) in one folder, or make them: pip install pandas openpyxl, then python3 -c "
    "\"import pathlib, pandas; folder = pathlib.Path('FILE.sheets'); folder.mkdir(exist_ok=True); "
    "[table.to_csv(folder / (name + '.csv'), index=False, header=False) for name, table in "
    "pandas.read_excel('FILE', sheet_name=None, header=None).items() if len(table)]\", and read "
    "the folder 'FILE.sheets'";
constexpr std::string_view kOpenSheet =
    "a spreadsheet of LibreOffice (.ods), which is not read; save each of its sheets as CSV (File, "
    "Save As, Text CSV)";
constexpr std::string_view kTrackMate =
    "a file of TrackMate (XML), which is not read; open it in TrackMate (Load a TrackMate file), "
    "and in its last panel choose Spots, then Export to CSV: that table is read";
// In three pieces: what each spot says of its time stands between them.
constexpr std::string_view kTrackMateTracks =
    "an XML file of tracks that TrackMate exported, which is not read; make a table of it: python3 "
    "-c \"import xml.etree.ElementTree as E; print('";
constexpr std::string_view kTrackMateSpots =
    ", *map(d.get, 'xyz'), sep=',') for i, p in enumerate(E.parse('FILE').iter('particle')) for d "
    "in p.iter('detection')]\" > tracks.csv";

constexpr std::string_view kGpx =
    "a track of a GPS receiver (GPX), which is not read; make a table of it, and of all that are "
    "of one recording: python3 -c \"import sys, xml.etree.ElementTree as E; "
    "print('id,time,lon,lat,height_m'); [print(f, p.findtext('{*}time'), p.get('lon'), "
    "p.get('lat'), p.findtext('{*}ele', ''), sep=',') for f in sys.argv[1:] for p in "
    "E.parse(f).iterfind('.//{*}trkpt')]\" FILE > "
    "tracks.csv, with the names of the others behind the first one";

// Whether a name is there, near the beginning or the end: such files have their names there, and
// their numbers between.
bool has_name(std::string_view bytes, std::string_view name) {
  constexpr std::size_t kLookedAt = std::size_t{1} << 22;
  const std::string_view begins = bytes.substr(0, kLookedAt);
  const std::string_view ends = bytes.substr(bytes.size() - std::min(bytes.size(), kLookedAt));
  return begins.find(name) != std::string_view::npos || ends.find(name) != std::string_view::npos;
}

// What comes first in a zip archive, as its local header has it; nothing of other bytes.
std::string_view first_name(std::string_view bytes) {
  constexpr std::size_t kNameSize = 26;  // where a local header has the size of the name
  constexpr std::size_t kName = 30;
  if (!bytes.starts_with("PK\x03\x04") || bytes.size() < kName) return {};
  const auto byte = [bytes](std::size_t at) {
    return static_cast<std::size_t>(static_cast<unsigned char>(bytes[at]));
  };
  return bytes.substr(kName, byte(kNameSize) + (byte(kNameSize + 1) << 8U));
}

// What an element says of itself by that name; nothing where it does not.
std::string_view attribute(std::string_view head, std::string_view name) {
  const std::size_t at = head.find(name);
  if (at == std::string_view::npos || at + name.size() + 2 > head.size()) return {};
  const std::string_view rest = head.substr(at + name.size());
  if (rest[0] != '=' || (rest[1] != '"' && rest[1] != '\'')) return {};
  return rest.substr(2, rest.find(rest[1], 2) - 2);
}

// How names of columns call that unit; nothing of pixels, and of what is not known.
std::string_view column_unit(std::string_view unit) {
  struct Named {
    std::string_view name;
    std::string_view unit;
  };
  constexpr std::array kNamed = {
      Named{"micron", "um"}, Named{"microns", "um"},    Named{"micrometer", "um"},
      Named{"um", "um"},     Named{"\xC2\xB5m", "um"},  Named{"\xCE\xBCm", "um"},
      Named{"mm", "mm"},     Named{"millimeter", "mm"}, Named{"cm", "cm"},
      Named{"m", "m"},       Named{"sec", "s"},         Named{"s", "s"},
      Named{"second", "s"},  Named{"seconds", "s"},     Named{"ms", "ms"},
      Named{"msec", "ms"},   Named{"min", "min"}};
  const auto* const found = std::find_if(kNamed.begin(), kNamed.end(),
                                         [unit](const Named& named) { return named.name == unit; });
  return found == kNamed.end() ? std::string_view() : found->unit;
}

bool is_positive_number(std::string_view text) {
  double number = 0.0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
  return read.ec == std::errc() && read.ptr == text.data() + text.size() && number > 0.0;
}

// Places and times are in the units that the file names: these are not left to be guessed.
std::string words_of_tracks(std::string_view head) {
  const std::string_view length = column_unit(attribute(head, " spaceUnits"));
  const std::string_view interval = attribute(head, " frameInterval");
  const std::string_view time = column_unit(attribute(head, " timeUnits"));
  const bool timed = (time == "s" || time == "ms") && is_positive_number(interval);
  std::string words(kTrackMateTracks);
  words += timed ? "id,time_" : "id,frame";
  if (timed) words += time;
  for (const std::string_view axis : {",x", ",y", ",z"}) {
    words += axis;
    if (!length.empty()) words.append("_").append(length);
  }
  words += "'); [print(i, ";
  if (timed) words.append("float(d.get('t')) * ").append(interval);
  words += timed ? "" : "d.get('t')";
  words += kTrackMateSpots;
  const std::string_view unit = attribute(head, " spaceUnits");
  if (length.empty()) {
    words += ", which is read with --scale (how long one ";
    words += unit.empty() ? "unit" : unit;
    words += timed ? " is)" : " is) and --fps";
  } else if (!timed) {
    words += ", which is read with --fps";
  }
  return words;
}

}  // namespace

std::string words_of_hdf5(std::string_view bytes) {
  const bool pandas = has_name(bytes, "pandas_type");
  if (pandas) return std::string(has_name(bytes, "bodyparts") ? kDeepLabCut : kPandasHdf5);
  const bool labels = has_name(bytes, "pred_points") && has_name(bytes, "instances");
  if (labels) return std::string(kSleap);
  if (has_name(bytes, "track_occupancy")) return std::string(kSleapAnalysis);
  if (has_name(bytes, "id_probabilities")) return std::string(kIdtracker);
  return std::string(kUnknownHdf5);
}

std::string words_of_npz(std::string_view bytes) {
  if (!first_name(bytes).ends_with(".npy")) return {};
  return std::string(has_name(bytes, "#wcentroid") ? kTRexNpz : kNpz);
}

std::string words_of_workbook(std::string_view bytes) {
  const std::string_view name = first_name(bytes);
  constexpr std::string_view kOds = "mimetypeapplication/vnd.oasis.opendocument.spreadsheet";
  constexpr std::size_t kHead = 200;
  if (name == "mimetype" && has_name(bytes.substr(0, kHead), kOds)) return std::string(kOpenSheet);
  // An archive of tables may hold a workbook, too, but then its name comes first.
  const bool of_office = name == "[Content_Types].xml" || name.starts_with("docProps/") ||
                         name.starts_with("_rels/") || name.starts_with("xl/");
  const bool sheets = has_name(bytes, "xl/worksheets/") || has_name(bytes, "xl/workbook.") ||
                      has_name(bytes, "xl/theme/") || has_name(bytes, "xl/styles.");
  return std::string(of_office && sheets ? kExcel : "");
}

std::string words_of_xml(std::string_view bytes) {
  constexpr std::size_t kHead = 1024;
  const std::string_view head = bytes.substr(0, kHead);
  if (head.find("<TrackMate") != std::string_view::npos) return std::string(kTrackMate);
  if (head.find("<Tracks ") != std::string_view::npos) return words_of_tracks(head);
  if (head.find("<gpx") != std::string_view::npos) return std::string(kGpx);
  return {};
}

}  // namespace beespace::io
