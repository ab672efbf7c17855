#include "io/problems/signatures.hpp"

#include "io/problems/foreign_containers.hpp"

#include <array>
#include <cstddef>

namespace beespace::io {
namespace {

// What is read by this program, or once it is unpacked; and what is of other programs.
enum class Of : bool { kUs, kOthers };

struct Signature {
  std::string_view bytes;
  std::string_view what;
  std::string_view advice = {};
  Of of = Of::kUs;
};

// What to type, with FILE for the name of the file.
constexpr std::string_view kUtf16 = "; save it as UTF-8: iconv -f UTF-16 -t UTF-8 FILE > utf8.csv";
constexpr std::string_view kBag =
    ", which is not read; make a table of its poses: pip install rosbags, then python3 -c "
    "\"import operator, pathlib, sys; from rosbags.highlevel import AnyReader; bag = "
    "AnyReader([pathlib.Path('FILE')]); bag.open(); kinds = {'sensor_msgs/msg/NavSatFix': "
    "'status', 'px4_msgs/msg/VehicleGlobalPosition': 'lat', 'geometry_msgs/msg/PoseStamped': "
    "'pose.position', 'nav_msgs/msg/Odometry': 'pose.pose.position', "
    "'geometry_msgs/msg/PoseWithCovarianceStamped': 'pose.pose.position', "
    "'geometry_msgs/msg/TransformStamped': 'transform.translation', 'tf2_msgs/msg/TFMessage': "
    "'transform.translation'}; topics = {k: {c.topic for c in bag.connections if c.msgtype == k "
    "and not any(w in c.topic for w in ('/raw/', 'goal', 'setpoint', 'target', 'initial'))} for "
    "k in kinds}; frames = {}; [frames.setdefault(c.topic, bag.deserialize(raw, "
    "c.msgtype).header.frame_id) for c, _, raw in bag.messages() if c.msgtype in "
    "list(kinds)[2:6] and c.topic not in frames]; shared = {k: sum(not frames.get(t, "
    "'odom').endswith('odom') for t in topics[k]) for k in kinds}; kind = next((k for k in "
    "list(kinds)[:2] if len(topics[k]) > 1), max(kinds, key=lambda k: (shared[k] > 1 and "
    "shared[k], len(topics[k])))); taken = topics[kind]; taken or sys.exit('nothing is taken, as "
    "no topic has messages that this line knows: ' + ', '.join(sorted({c.topic + ' ' + c.msgtype "
    "for c in bag.connections}))); gps = 'NavSat' in kind; px4 = 'px4' in kind; robots = {w for "
    "t in taken for w in t.split('/')[1:-1]}; lost = {t for k in kinds for t in topics[k] - "
    "taken if 'TF' not in k and t.count('/') > 1 and not robots & set(t.split('/')[1:-1])}; "
    "print('taken:', kind, *sorted(taken), '- left out:', *sorted({c.topic + ' ' + c.msgtype for "
    "c in bag.connections if c.topic not in taken}), '- in the table without a place:', "
    "*sorted(lost), file=sys.stderr); print('id,time_ns,' + ('lon,lat,height_ellipsoid_m' if gps "
    "else 'lon,lat,height_msl_m' if px4 else 'header.frame_id,x,y,z')); when = lambda m, t: "
    "m.header.stamp.sec * 10**9 + m.header.stamp.nanosec if hasattr(m, 'header') else "
    "m.timestamp * 1000 if m.timestamp > 10**15 else t; fixed = lambda m: m.status.status >= 0 "
    "if gps else not px4 or getattr(m, 'lat_lon_valid', True) and getattr(m, 'alt_valid', True) "
    "and not getattr(m, 'dead_reckoning', False); [print(s.child_frame_id if s is not m else "
    "c.topic, when(s, t), *(('',) * (3 if gps or px4 else 4) if c.topic in lost else "
    "(m.longitude, m.latitude, m.altitude) if gps else (m.lon, m.lat, m.alt) if px4 else "
    "(s.header.frame_id, p.x, p.y, p.z)), sep=',') for c, t, raw in bag.messages() if c.topic in "
    "taken | lost for m in [bag.deserialize(raw, c.msgtype)] if c.topic in lost or fixed(m) for "
    "s in getattr(m, 'transforms', [m]) for p in [c.topic in lost or "
    "operator.attrgetter(kinds[kind])(s)]]\" > poses.csv; it says on the terminal which topics "
    "it leaves out, and docs/recipes/ros-bags.md of the source has other messages, and says what "
    "frames are";
constexpr std::string_view kDataFlash =
    ", which is not read; name the .bin that it was made of, or make a table of its positions: pip "
    "install pymavlink, then mavlogdump.py --format csv --types POS FILE > pos.csv, likewise a "
    "table of each other log, and name all of them: beespace replay pos.csv "
    "--columns time=timestamp,lon=Lng,lat=Lat,height=Alt --threshold YOUR_THRESHOLD (without "
    "a time of GPS it counts from when each drone was switched on: then logs of several have no "
    "common clock)";
constexpr std::string_view kMatlab =
    ", which is not read; see what it has: pip install scipy, then python3 -c \"import scipy.io; "
    "print(scipy.io.whosmat('FILE'))\"; docs/recipes/matlab.md has the lines that ask about it";
constexpr std::string_view kParquet =
    ", which is not read; make CSV of it: pip install pandas pyarrow, then python3 -c \"import "
    "pandas; pandas.read_parquet('FILE').to_csv('bees.csv', index=False)\"";
constexpr std::string_view kFeather =
    ", which is not read; make CSV of it: pip install pandas pyarrow, then python3 -c \"import "
    "pandas; pandas.read_feather('FILE').to_csv('bees.csv', index=False)\"";

constexpr std::string_view kPickle =
    ", which is not read; make CSV of it, if it is your own (to open one runs what is in it): pip "
    "install pandas, then python3 -c \"import pandas; "
    "pandas.read_pickle('FILE').to_csv('bees.csv', index=False)\"";
constexpr std::string_view kObjects =
    "a .npy file with objects of Python, which is not read; of trajectories of idtracker.ai make "
    "CSV: idtrackerai_csv FOLDER, with the folder of the session";

// Longer ones before those they begin with.
constexpr std::array<Signature, 34> kSignatures = {{
    {std::string_view("\xFF\xFE\0\0", 4), "UTF-32 text; save it as UTF-8"},
    {std::string_view("\0\0\xFE\xFF", 4), "UTF-32 text; save it as UTF-8"},
    {"\xFF\xFE", "UTF-16 text", kUtf16},
    {"\xFE\xFF", "UTF-16 text", kUtf16},
    {"PK\x03\x04",
     "a zip archive: a drone show is for 'beespace replay'; unpack or export anything else as CSV"},
    {"\x1F\x8B", "gzip-compressed data, which is not unpacked here; pipe it in: zcat FILE |"},
    {"\x28\xB5\x2F\xFD",
     "zstd-compressed data, which is not unpacked here; pipe it in: zstdcat FILE |"},
    {"BZh", "bzip2-compressed data; unpack it first: bzip2 -dk FILE"},
    {"\xFD"
     "7zXZ",
     "xz-compressed data; unpack it first: xz -dk FILE"},
    {"\x93NUMPY",
     "a .npy array, which holds positions and nothing else; 'beespace detect' reads it"},
    {"ULog\x01\x12\x35", "a PX4 log (ULog); 'beespace replay' and 'beespace predict' read it"},
    {"ULogEnc",
     "a PX4 log that is encrypted; decrypt it first, with the key of the drone",
     {},
     Of::kOthers},
    {"#ROSBAG V", "a bag of ROS 1", kBag, Of::kOthers},
    {"\x89MCAP0\r\n", "an MCAP file, as ROS 2 records", kBag, Of::kOthers},
    {"SQLite format 3", "an SQLite database, as ROS 2 records (.db3)", kBag, Of::kOthers},
    {"\xA3\x95\x80\x80\x59",
     "a DataFlash log of ArduPilot; 'beespace replay' and 'beespace predict' read it"},
    {"FMT, 128, 89, FMT,", "a DataFlash log of ArduPilot, as text (.log)", kDataFlash, Of::kOthers},
    {"MATLAB 5.0 MAT-file", "a file of MATLAB (.mat)", kMatlab, Of::kOthers},
    {"MATLAB 7.3 MAT-file", "a file of MATLAB 7.3 (.mat)", {}, Of::kOthers},
    {"\x89HDF\r\n\x1A\n", "an HDF5 file", {}, Of::kOthers},
    {"PAR1", "a Parquet file", kParquet, Of::kOthers},
    {"ARROW1", "a Feather file (Arrow)", kFeather, Of::kOthers},
    {"\x80\x04\x95", "a pickle of Python (pandas, traffic)", kPickle, Of::kOthers},
    {"\x80\x05\x95", "a pickle of Python (pandas, traffic)", kPickle, Of::kOthers},
    {"CDF\x01", "a NetCDF file; export the table as CSV", {}, Of::kOthers},
    {"CDF\x02", "a NetCDF file; export the table as CSV", {}, Of::kOthers},
    {"%PDF", "a PDF document; export the table as CSV", {}, Of::kOthers},
    {"\x89PNG", "a picture", {}, Of::kOthers},
    {"\xFF\xD8\xFF", "a picture", {}, Of::kOthers},
    {"\x7F"
     "ELF",
     "a program",
     {},
     Of::kOthers},
    {"\x89HDF", "an HDF5 file", {}, Of::kOthers},
    {"<?xml", "XML; export the table as CSV"},
    {"<kml", "KML, which is not read; export the table as CSV"},
    {"\xD0\xCF\x11\xE0",
     "a document of Office of old (.xls); export the table as CSV",
     {},
     Of::kOthers},
}};

const Signature* signature_of(std::string_view bytes) {
  for (const Signature& signature : kSignatures) {
    if (bytes.starts_with(signature.bytes)) return &signature;
  }
  return nullptr;
}

// It begins with a name, which is 0-terminated, as all of its header is.
bool is_tar(std::string_view bytes) {
  constexpr std::size_t kMagic = 257;
  return bytes.size() > kMagic && bytes.substr(kMagic).starts_with("ustar");
}

}  // namespace

std::string words_of_signature(std::string_view bytes) {
  constexpr std::size_t kHeader = 128;  // of a .npy file, where it is short
  if (bytes.starts_with("\x93NUMPY") && bytes.substr(0, kHeader).find("'|O'") < kHeader) {
    return std::string(kObjects);
  }
  if (is_tar(bytes)) {
    return "a tar archive, which is not read; unpack it, and name the folder: mkdir unpacked && "
           "tar xf FILE -C unpacked";
  }
  const Signature* const found = signature_of(bytes);
  if (found == nullptr) return {};
  const bool hdf5 = found->bytes.starts_with("\x89HDF") || found->bytes.starts_with("MATLAB 7.3");
  if (hdf5) return words_of_hdf5(bytes);
  if (std::string words = words_of_zip(bytes); !words.empty()) return words;
  if (found->bytes == "<?xml") {
    if (std::string words = words_of_xml(bytes); !words.empty()) return words;
  }
  return std::string(found->what).append(found->advice);
}

std::string words_of_zip(std::string_view bytes) {
  std::string words = words_of_npz(bytes);
  return words.empty() ? words_of_workbook(bytes) : words;
}

std::string words_of_bag_folder() {
  return std::string("a bag of ROS 2, a folder with metadata.yaml").append(kBag);
}

bool is_foreign_file(std::string_view bytes) {
  if (is_tar(bytes)) return true;
  const Signature* const found = signature_of(bytes);
  if (found == nullptr) return false;
  return found->of == Of::kOthers || !words_of_zip(bytes).empty() || !words_of_xml(bytes).empty();
}

}  // namespace beespace::io
