#include "io/tracks/echoed_messages.hpp"

#include <string>
#include <string_view>
#include <utility>

namespace beespace::io {
namespace {

// PoseStamped, Odometry, PoseWithCovarianceStamped, PointStamped, transforms and NavSatFix, of ROS
// 1 and 2.
constexpr std::string_view kOfYaml =
    "make a table of it (pip install pyyaml): python3 -c \"import yaml; docs = [m for m in "
    "yaml.load_all(open('FILE'), getattr(yaml, 'CSafeLoader', yaml.SafeLoader)) if m]; place = "
    "lambda v: next((place(v[k]) for k in ('pose', 'transform', 'position', 'point', "
    "'translation') if k in v), v); ns = lambda t: t.get('sec', t.get('secs')) * 10**9 + "
    "t.get('nanosec', t.get('nsecs')); gps = 'latitude' in docs[0]; tf = 'transforms' in "
    "docs[0]; print(('id,' if tf else '') + 'time_ns,' + ('lon,lat,height_ellipsoid_m' if gps "
    "else 'header.frame_id,x,y,z')); [print(*([s['child_frame_id']] if tf else []), "
    "ns(s['header']['stamp']), *((p['longitude'], p['latitude'], p['altitude']) if gps else "
    "(s['header']['frame_id'], p['x'], p['y'], p['z'])), sep=',') for m in docs for s in "
    "m.get('transforms', [m]) for p in [place(s)] if not gps or p['status']['status'] >= 0]\" > "
    "NAME.csv, and read that, with those of the other robots; or record it as one, as by ros2 "
    "topic echo --csv TOPIC > NAME.csv, or make one of the bag, which says how when it is named";

// What is 0 is not printed; links of several models have the same names.
constexpr std::string_view kOfGazebo =
    "make a table of them: python3 -c \"import re; find = lambda p, t, e: (re.search(p, t, re.S) "
    "or [0, e])[1]; print('id,time_ns,x,y,z'); [print(n, int(find(r'\\bsec: (\\d+)', h, 0)) * "
    "10**9 + int(find(r'nsec: (\\d+)', h, 0)), *(find(a + r': (\\S+)', find(r'position {(.*?)}', "
    "b, ''), 0) for a in 'xyz'), sep=',') for m in re.split(r'(?m)^header {', "
    "open('FILE').read())[1:] for h in [m.split('\\n}')[0]] for bs in [re.findall(r'(?ms)^pose "
    "{\\n(.*?)^}', m)] for ns in [[find(r'name: .([^\\x22]*)', b, '') for b in bs]] for b, n in "
    "zip(bs, ns) if ns.count(n) == 1 and n != 'ground_plane']\" > poses.csv; names that several "
    "have, as links of models do, are left out, and so is the ground: what else stands for no "
    "vehicle (buildings, markers) is to be left out, too, as by grep -E '^(id|x500)' poses.csv > "
    "vehicles.csv; live, make it JSON with "
    "gz topic -e --json-output, which 'beespace watch' says how to read";

}  // namespace

std::optional<Error> echoed_messages(const TableLayout& table) {
  const auto& names = table.names;
  // "header:", the first line of most messages, or that of a list of transforms.
  if (names.size() == 1 && table.columns == 1 && names.front().ends_with(':')) {
    std::string text = "this is what 'ros2 topic echo' writes for reading, '";
    text.append(names.front()).append("' and lines below it, which is not read; ").append(kOfYaml);
    return Error{ErrorCode::kMissingColumn, std::move(text), {}};
  }
  if (names.size() == 2 && names[0] == "header" && names[1] == "{") {
    std::string text = "these are poses as 'gz topic -e' prints them, which are not read; ";
    text.append(kOfGazebo);
    return Error{ErrorCode::kMissingColumn, std::move(text), {}};
  }
  return std::nullopt;
}

}  // namespace beespace::io
