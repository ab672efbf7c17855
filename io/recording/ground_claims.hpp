// Aircraft that say that they are on the ground, while what they report before and after shows that
// they fly.
//
// Reports come in the order of the input; an aircraft whose time goes back is looked at anew from
// there. A run of claims is taken for flight where one of these holds:
// - it goes on at more than 45 m/s on average for a minute: no roll before a take-off or after a
//   landing lasts so long;
// - its heights differ by more than 100 m within two minutes: no runway does;
// - it is more than 50 m higher than where the aircraft flew within the minute before or after;
// - at least 20 s before and after it the aircraft flies within 50 m of its height, at over 30 m/s:
//   who touches down and goes comes from higher, and climbs;
// - it goes on at more than 25 m/s on average in each of two minutes, one after the other: an
//   aircraft may fly so slowly, at 60 kt, but none rolls so far.
//
// A run is surely on the ground where it is not taken for flight, and two of its claims, 10 s or
// more apart, are no more than 25 m/s and a climb of 1 m/s away from each other.
//
// A drone whose autopilot says that it has landed is on the ground without such claims. It may land
// on a tower, or take off from one, so that its height beside those of its flight says nothing; and
// where its claims are more than 5 s apart, another run begins.
#pragma once

#include "io/frames/coordinate_frame.hpp"

#include <beespace/track.hpp>

#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <string_view>

namespace beespace::io {

// What a report says of where it is made: in the air, on the ground as an aircraft says it, or
// landed as an autopilot has found.
enum class GroundClaim : std::uint8_t { kNone, kSaysOnGround, kLanded };

class GroundClaims {
 public:
  // A run that is over, for which nothing more can be said.
  struct Run {
    std::uint64_t claims = 0;
    bool in_flight = false;  // they were made in flight
    bool surely_ground = false;
    bool landed = false;  // by the autopilot of a drone
    double begins_s = 0.0;
    double ends_s = 0.0;
  };
  // Whose run it is.
  using Settle = std::function<void(const std::string& id, const Run& run)>;

  // The next report of that aircraft. Where the height is unknown it is not-a-number.
  void take(std::string_view id, const Fix& fix, GroundClaim claim, Frame frame,
            const Settle& settle);
  // At the end of the input.
  void finish(const Settle& settle);

 private:
  // Heights over some time.
  struct Stretch {
    double begins_s = std::numeric_limits<double>::infinity();
    double ends_s = -std::numeric_limits<double>::infinity();
    double low_m = std::numeric_limits<double>::infinity();
    double high_m = -std::numeric_limits<double>::infinity();

    void add(const Fix& fix);
    void add(const Stretch& other);
    [[nodiscard]] double lasts_s() const { return ends_s - begins_s; }
  };

  struct Aircraft {
    Fix last = {};
    bool known = false;    // there is a last report
    Stretch earlier = {};  // of where it flew: the last half a minute or so,
    Stretch lately = {};   // and since then
    // The run of claims; none where `claims` is 0.
    std::uint64_t claims = 0;
    bool over = false;  // it flies again
    bool in_flight = false;
    bool fast = false;     // the last minute of claims was that of no roll
    bool slow = false;     // some claims were those of who stands or taxies
    bool landed = false;   // they are those of an autopilot
    Fix anchor = {};       // the first claim, or one a minute and more ago
    Fix step = {};         // the same, of ten seconds
    Stretch window = {};   // of the claims since then
    Stretch run = {};      // of all claims
    Stretch before = {};   // of where it flew before
    Fix flew_before = {};  // the last of these
    bool flew = false;     // there is one
  };

  static Run run_of(const Aircraft& aircraft);
  static void begin_run(Aircraft& aircraft, const Fix& fix);
  static void claim(Aircraft& aircraft, const Fix& fix, Frame frame);
  static void fly(Aircraft& aircraft, const Fix& fix, Frame frame);

  std::map<std::string, Aircraft, std::less<>> aircraft_;
};

}  // namespace beespace::io
