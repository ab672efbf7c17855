// The recordings on which the search for conflicts is compared with brute force: small, hard,
// named.
#pragma once

#include "scenes/recorded_flights.hpp"
#include "tests/support/mover_scenes.hpp"
#include "tests/support/scene_maker.hpp"

#include <beespace/find_conflicts.hpp>
#include <beespace/track.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace beespace::test {

using Tracks = std::vector<Track>;

struct RecordingScene {
  std::string name;
  Tracks tracks;
  double threshold_m = 0.0;
  double vertical_m = 0.0;  // where cylinders are asked for
  double max_gap_s = std::numeric_limits<double>::infinity();

  [[nodiscard]] ConflictOptions options(Shape shape, bool inclusive) const {
    ConflictOptions options;
    options.threshold_m = threshold_m;
    if (shape != Shape::kSphere) options.vertical_m = vertical_m;
    options.inclusive = inclusive;
    options.max_gap_s = max_gap_s;
    return options;
  }

  // With heights apart: those of the track before, as far as there are any, then its own.
  [[nodiscard]] Tracks of(Shape shape) const {
    Tracks all = tracks;
    if (shape != Shape::kHeightsApart) return all;
    for (std::size_t id = 0; id < all.size(); ++id) {
      const std::vector<Fix>& others = tracks[(id + all.size() - 1) % all.size()].fixes;
      for (std::size_t i = 0; i < all[id].fixes.size(); ++i) {
        const Fix& fix = i < others.size() ? others[i] : all[id].fixes[i];
        all[id].heights_m.push_back(fix.position.z);
      }
    }
    return all;
  }

  // From the first fix to the last.
  [[nodiscard]] double lasts_s() const {
    double first = std::numeric_limits<double>::infinity();
    double last = -first;
    for (const Track& track : tracks) {
      if (track.fixes.empty()) continue;
      first = std::min(first, track.fixes.front().time_s);
      last = std::max(last, track.fixes.back().time_s);
    }
    return first <= last ? last - first : 0.0;
  }
};

// Drops fixes at random, except where a track has only two.
inline Tracks thinned(Tracks tracks, SceneMaker& make, std::size_t one_of) {
  for (Track& track : tracks) {
    std::vector<Fix> kept;
    for (const Fix& fix : track.fixes) {
      if (make.below(one_of) != 0) kept.push_back(fix);
    }
    if (kept.size() > 1) track.fixes = std::move(kept);
  }
  return tracks;
}

// A part of each track: from one of its fixes to another, or to the same, or nothing at all.
inline Tracks coming_and_going(Tracks tracks, SceneMaker& make) {
  for (Track& track : tracks) {
    std::size_t begin = make.below(track.fixes.size() + 1);
    std::size_t end = make.below(track.fixes.size() + 1);
    if (begin > end) std::swap(begin, end);
    track.fixes = std::vector<Fix>(track.fixes.begin() + static_cast<std::ptrdiff_t>(begin),
                                   track.fixes.begin() + static_cast<std::ptrdiff_t>(end));
  }
  return tracks;
}

inline Tracks moved(Tracks tracks, const Point& by, double later_s) {
  for (Track& track : tracks) {
    for (Fix& fix : track.fixes) {
      fix.position = shifted(fix.position, by);
      fix.time_s += later_s;
    }
  }
  return tracks;
}

// Small whole numbers, of places and of times: whatever can be at the edge of a conflict is.
inline Tracks lattice_tracks(SceneMaker& make, std::size_t count, double unit, double tick_s) {
  const auto integer = [&](int most) {
    return unit * (static_cast<double>(make.below(static_cast<std::size_t>(2 * most + 1))) - most);
  };
  Tracks tracks(count);
  for (Track& track : tracks) {
    std::size_t time = make.below(6);
    const std::size_t fixes = make.below(9);
    for (std::size_t i = 0; i < fixes; ++i) {
      track.fixes.push_back(
          {tick_s * static_cast<double>(time), {integer(5), integer(5), integer(3)}});
      time += 1 + make.below(3);
    }
  }
  return tracks;
}

// Side by side at exactly the threshold: along x, then along y, each with fixes at times of its
// own.
inline Tracks formation_tracks(SceneMaker& make, double step) {
  Tracks tracks;
  for (const Point& p : integer_lattice(3, step, {-7.0, 3.0, 50.0})) {
    Track track;
    for (double time = 0.0; time <= 8.0; time += 0.25) {
      const bool needed = time == 0.0 || time == 4.0 || time == 8.0;
      if (!needed && make.below(4) != 0) continue;
      const double turned = std::min(time, 4.0);
      track.fixes.push_back({time, shifted(p, {8.0 * turned, 4.0 * (time - turned), 0.0})});
    }
    tracks.push_back(std::move(track));
  }
  return tracks;
}

// A few with a fix at the beginning and one at the end, among those with many.
inline Tracks long_pieces_among_short(SceneMaker& make, const scenes::FixTimes& times) {
  Tracks tracks = scenes::random_turns(30, {120, 120, 30}, {2, 9}, times, 77);
  for (int i = 0; i < 12; ++i) {
    const std::vector<Point> ends = make.ragged_box(2, {-50, -50, 0}, {170, 170, 30});
    tracks.push_back({{{0.0, ends[0]}, {times.duration_s, ends[1]}}});
  }
  return tracks;
}

// One of them has a fix that is ten thousand kilometres away.
inline Tracks with_a_glitch(Tracks tracks) {
  Track& track = tracks[tracks.size() / 2];
  track.fixes[track.fixes.size() / 2].position = {1e7, -3e6, 5e5};
  return tracks;
}

inline Tracks with_tolerances(Tracks tracks) {
  for (std::size_t id = 0; id < tracks.size(); ++id) {
    constexpr double kTolerances[] = {0.0, 0.3, 3.1, 0.0, 0.01};
    tracks[id].tolerance_m = kTolerances[id % 5];
  }
  return tracks;
}

// All bees hover at one place, at times that overlap or not.
inline Tracks hovering_at_one_place(SceneMaker& make) {
  Tracks tracks(25);
  for (Track& track : tracks) {
    double time = 0.5 * static_cast<double>(make.below(40));
    for (std::size_t fixes = make.below(5); fixes > 0; --fixes) {
      track.fixes.push_back({time, {3, 4, 5}});
      time += 0.5 * static_cast<double>(1 + make.below(6));
    }
  }
  return tracks;
}

// Flights as loggers write them down, all in a box.
inline Tracks turning_tracks(std::uint64_t seed, bool regular = false) {
  return scenes::random_turns(45, {100, 100, 30}, {3, 12}, {12.0, 1.0, regular}, seed);
}

inline Tracks two_groups_a_day_apart() {
  Tracks tracks = turning_tracks(9);
  const Tracks later = moved(turning_tracks(10), {5, 5, 5}, 1e5);
  tracks.insert(tracks.end(), later.begin(), later.end());
  return tracks;
}

inline std::vector<RecordingScene> flown_scenes(SceneMaker& make) {
  const Tracks gaps = thinned(turning_tracks(3), make, 3);
  const Tracks irregular = coming_and_going(turning_tracks(4), make);
  const Tracks regular = coming_and_going(turning_tracks(5, true), make);
  const Tracks with_offset = moved(turning_tracks(7), {6.4e6, -1e7, 3e5}, 0.0);
  const Tracks few = with_tolerances(coming_and_going(turning_tracks(12, true), make));
  return {{"RandomTurns", turning_tracks(1), 9, 6},
          {"RandomTurnsAtTheSameTimes", turning_tracks(2, true), 9, 6},
          {"Gaps", gaps, 12, 9, 1.75},
          {"ComingAndGoing", irregular, 14, 9},
          {"GapsWhereverTheyCanBe", regular, 14, 9, 0.5},
          {"EpochTimes", moved(turning_tracks(6), {0, 0, 0}, 1.6e9), 9, 6},
          {"HugeOffsets", with_offset, 9, 6},
          {"Glitch", with_a_glitch(turning_tracks(8)), 9, 6},
          {"LongPiecesAmongShort", long_pieces_among_short(make, {12.0, 1.0}), 8, 5},
          {"EmptyForALongTime", two_groups_a_day_apart(), 9, 6},
          {"Tolerances", with_tolerances(turning_tracks(11)), 7, 5},
          {"TolerancesOfWhoComesAndGoes", few, 14, 12, 2.5}};
}

inline std::vector<RecordingScene> tied_scenes(SceneMaker& make) {
  const Track hovering{{{0.0, {1, 2, 3}}, {9.0, {1, 2, 3}}}};
  const Tracks far = moved(lattice_tracks(make, 50, 1.0, 0.5), {1e9, -1e9, 1e9}, 1.6e9);
  return {{"Empty", {}, 1, 1},
          {"OnlyEmptyTracks", Tracks(5), 1, 1},
          {"OneAlone", {hovering}, 1, 1},
          {"TwoAtTheSamePlace", {hovering, {}, hovering}, 1e-3, 1e-3},
          {"Lattice", lattice_tracks(make, 60, 1.0, 1.0), 3, 2},
          {"LatticeWithGaps", lattice_tracks(make, 60, 1.0, 1.0), 3, 2, 2.0},
          {"LatticeFarAway", far, 3, 2},
          {"LatticeWithTolerances", with_tolerances(lattice_tracks(make, 50, 1.0, 1.0)), 1, 1},
          {"LatticeOfTinyLengths", lattice_tracks(make, 40, 0x1p-98, 1.0), 0x3p-98, 0x1p-97},
          {"LatticeOfHugeLengths", lattice_tracks(make, 40, 0x1p+94, 1.0), 0x3p+94, 0x1p+95},
          {"FormationAtTheThreshold", formation_tracks(make, 4.0), 4, 4},
          {"HoveringAtOnePlace", hovering_at_one_place(make), 1, 1}};
}

inline std::vector<RecordingScene> recording_scenes() {
  SceneMaker make(20240917);
  std::vector<RecordingScene> all = flown_scenes(make);
  std::vector<RecordingScene> tied = tied_scenes(make);
  std::move(tied.begin(), tied.end(), std::back_inserter(all));
  return all;
}

}  // namespace beespace::test
