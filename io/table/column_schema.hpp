// What the columns of a kind of table may hold, as data: each role, the words that name it in
// headers and in --columns, and which roles belong together.
//
// Recognition (column_names.hpp), --columns (column_overrides.hpp), and what is said of columns in
// notes, errors and suggestions follow from it. Another community's words for a role are one more
// line of NameWords.
#pragma once

#include "io/frames/coordinate_frame.hpp"
#include "io/units/heights.hpp"
#include "io/units/units.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace beespace::io {

// What a column holds. Of what has three parts these follow each other, as kX, kY, kZ.
enum class Role : std::uint8_t {
  kNone,
  kLongitude,
  kLatitude,
  kHeight,
  kX,
  kY,
  kZ,
  kId,
  kTime,
  kVelocityX,
  kVelocityY,
  kVelocityZ,
  kVelocityEast,
  kVelocityNorth,
  kVelocityUp,
  kVelocityDown,
  kGroundSpeed,
  kTrack,  // the direction over ground, in degrees clockwise from true north
  kClimb,
  kGoalX,
  kGoalY,
  kGoalZ,
  kPreferredX,  // of the velocity that a bee would like to have
  kPreferredY,
  kPreferredZ,
  kMaxSpeed,
  kMaxAcceleration,
  kDate,          // the day to a time of day
  kFrame,         // which picture of a video
  kPositionTime,  // when the position of a record was measured
};

inline constexpr std::size_t kRoles = static_cast<std::size_t>(Role::kPositionTime) + 1;

constexpr std::size_t index_of(Role role) {
  return static_cast<std::size_t>(role);
}

// kX, 2 -> kZ
constexpr Role part_of(Role first, std::size_t part) {
  return static_cast<Role>(index_of(first) + part);
}

// Which of the parts that begin with `first`; nothing for other roles.
constexpr std::optional<std::size_t> part_within(Role first, Role role) {
  const std::size_t part = index_of(role) - index_of(first);
  if (role < first || part > 2) return std::nullopt;
  return part;
}

// What a word says in the name of a column; a word may say several of these.
struct Says {
  static constexpr unsigned kPart = 1;        // which role it is, or which part: once in a name
  static constexpr unsigned kNoun = 2;        // what is measured
  static constexpr unsigned kQualifier = 4;   // the other word that there must be: "max"
  static constexpr unsigned kConfirms = 8;    // nothing new beside its role, nonsense beside others
  static constexpr unsigned kDegrees = 16;    // that x and y are a longitude and a latitude
  static constexpr unsigned kLength = 32;     // that coordinates are lengths: "ecef"
  static constexpr unsigned kSince1970 = 64;  // of times
  static constexpr unsigned kForeign = 128;   // a unit that is not read
  static constexpr unsigned kBeside = 256;    // nothing: it may stand there
  static constexpr unsigned kOther = 512;     // that it is another quantity after all
  static constexpr unsigned kBeforeUnit = 1024;  // means that only where no unit stands before it
  static constexpr unsigned kJoined = 2048;      // may have its unit joined to it: "timems"
  static constexpr unsigned kNoUnit = 4096;      // is read in our unit alone
};

struct NameWords {
  unsigned says = 0;
  std::string_view words = {};                 // in lower case, blanks between; see is_one_of()
  Role role = Role::kNone;                     // which they name or confirm
  std::string_view community = "any";          // whose words they are
  HeightDatum datum = HeightDatum::kUnstated;  // what a height beside them is counted from
};

// Where a unit may stand in a name.
enum class UnitPlace : std::uint8_t { kNowhere, kLast, kAnywhere };

// One way in which names say a role. It fits a name if all its words are known here.
struct NamePattern {
  Role role = Role::kNone;  // where no word says another
  std::vector<NameWords> words = {};
  unsigned needed = Says::kPart;  // without which the name says nothing
  UnitPlace unit = UnitPlace::kNowhere;
  Quantity quantity = Quantity::kLength;  // of that unit
  bool unit_alone = false;  // a unit of more than two letters may be all of the name: "seconds"
  bool whole = false;       // `words` are whole names, with "-" between the words of each
  bool prefix = false;      // before it any word may say whose it is: "uav_lat"
  bool anything = false;    // any word may stand beside it
  bool course = false;      // a coordinate of a bee, as in the course files: in degrees
  bool intended = false;    // one of the schema's intents may stand beside it
};

// A word that makes of a place or a velocity one that is meant to be: "goal_x", "want_vx".
struct Intent {
  std::string_view words = {};
  Role place = Role::kNone;     // what kX becomes; kNone: that has no meaning
  Role velocity = Role::kNone;  // the same of kVelocityX
};

// How --columns calls a role; it may have two names.
struct RoleFacts {
  Role role = Role::kNone;
  std::string_view name = {};
  // What a name that is not understood may still have in it: such a column is offered.
  std::string_view resembling = {};
};

// Roles that belong together. Two groups of the same thing exclude each other.
struct RoleGroup {
  std::string_view what = {};  // "position"
  std::array<Role, 3> roles = {};
  Frame frame = Frame::kAuto;   // in which such positions are
  std::string_view needs = {};  // what to say where --columns names too few of them; or nothing
};

struct ColumnSchema {
  std::vector<RoleFacts> roles = {};    // those that --columns may name, in the order of its help
  std::vector<RoleGroup> groups = {};   // of three roles each, of which the third may be missing
  std::vector<NamePattern> names = {};  // the first that fits a name is taken
  std::vector<Intent> intents = {};
  std::string_view hints = {};  // words that have to do with a position, without saying a role
  bool strict = false;  // each coordinate comes once, and none is that of another, as in "uav_x"

  // The facts of a role, or by its name in --columns; null where the schema has none.
  [[nodiscard]] const RoleFacts* find(Role role) const;
  [[nodiscard]] const RoleFacts* find(std::string_view name) const;
  // Whether header names may say it.
  [[nodiscard]] bool reads(Role role) const;
  // The first name of a role; empty where the schema has none.
  [[nodiscard]] std::string_view name_of(Role role) const {
    const RoleFacts* const facts = find(role);
    return facts != nullptr ? facts->name : std::string_view();
  }
  // What the role is a part of: "position"; otherwise its name.
  [[nodiscard]] std::string_view whole_of(Role role) const;
};

}  // namespace beespace::io
