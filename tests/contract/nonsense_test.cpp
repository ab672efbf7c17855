// Numbers that make no sense, in every field of every question that takes numbers: each brings a
// clear error, or the answer that the headers tell of; none is taken without a word, and no
// certificate comes of one.
#include <beespace/beespace.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace beespace {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kValues[] = {kNan, kInfinity, -kInfinity, -1.0, 0.0, 1e-320, 0x1p-101, 1e200};

struct Field {
  const char* name;
  // For each of the values, E for an error, a dot for an answer.
  const char* expected;
  std::function<std::optional<Error>(double value)> ask;
};

template <class T>
std::optional<Error> error_of(const Result<T>& result) {
  if (result) return std::nullopt;
  return result.error();
}

const std::vector<Point> kPoints = {{0, 0, 0}, {3, 4, 0}, {100, 0, 0}};
const std::vector<Mover> kMovers = {{{0, 0, 0}, {1, 0, 0}}, {{30, 4, 0}, {}}, {{100, 0, 0}, {}}};

std::optional<Error> search(const SearchOptions& options) {
  const auto pairs = error_of(find_pairs(kPoints, options));
  for (const auto& other :
       {error_of(find_at_risk(kPoints, options)), error_of(find_neighbors(kPoints, options)),
        error_of(count_neighbors(kPoints, options)),
        error_of(find_conflict_groups(kPoints, options)),
        error_of(brute_force::find_pairs(kPoints, options))}) {
    EXPECT_EQ(other.has_value(), pairs.has_value());
    if (!other || !pairs) continue;
    EXPECT_EQ(other->code, pairs->code);
  }
  return pairs;
}

std::optional<Error> predict(const PredictOptions& options) {
  const auto conflicts = error_of(predict_conflicts(kMovers, options));
  // Of two agents whose height is z no unit of heights is asked for.
  const bool of_two = options.height_unit_m == 1.0;
  for (const auto& other :
       {error_of(predict_pairs(kMovers, options)),
        of_two ? error_of(closest_approach(kMovers[0], kMovers[1], options.approach())) : conflicts,
        error_of(brute_force::predict_conflicts(kMovers, options))}) {
    EXPECT_EQ(other.has_value(), conflicts.has_value());
    if (!other || !conflicts) continue;
    EXPECT_EQ(other->code, conflicts->code);
  }
  return conflicts;
}

std::optional<Error> record(const ConflictOptions& options, double tolerance_m = 0.0) {
  std::vector<Track> tracks(2);
  tracks[0].fixes = {{0.0, {0, 0, 0}}, {10.0, {10, 0, 0}}};
  tracks[1].fixes = {{0.0, {10, 0, 0}}, {10.0, {0, 0, 0}}};
  tracks[0].tolerance_m = tolerance_m;
  const auto found = error_of(find_conflicts(tracks, options));
  EXPECT_EQ(error_of(brute_force::find_conflicts(tracks, options)).has_value(), found.has_value());
  return found;
}

// An answer has no NaN, and unusable input leaves no bee certified.
std::optional<Error> advised(const AdviseOptions& options, std::vector<Mover> movers = kMovers,
                             std::vector<Velocity> wishes = std::vector<Velocity>(3),
                             std::vector<FlightLimits> limits = {FlightLimits{10.0, 5.0}}) {
  Adviser adviser;
  Advised answer;
  AdviseOptions good;
  good.threshold_m = 5.0;
  const FlightLimits usual{10.0, 5.0};
  EXPECT_TRUE(adviser.advise(kMovers, std::vector<Velocity>(3), {&usual, 1}, good, answer));
  const Status status = adviser.advise(movers, wishes, limits, options, answer);
  if (!status) {
    EXPECT_TRUE(answer.advice.empty());
    return status.error();
  }
  EXPECT_EQ(answer.advice.size(), movers.size());
  for (const Advice& advice : answer.advice) {
    EXPECT_TRUE(std::isfinite(advice.velocity.x + advice.velocity.y + advice.velocity.z));
    EXPECT_FALSE(std::isnan(advice.clear_of_unknown_s));
  }
  if (answer.refused.empty()) return std::nullopt;
  EXPECT_EQ(answer.refused.size(), 1U);
  for (const Advice& advice : answer.advice) {
    EXPECT_FALSE(advice.certified && answer.refused[0].kind != RefusedKind::kPreferred);
  }
  return answer.refused[0].error;
}

std::optional<Error> advised_with(const std::function<void(AdviseOptions&)>& set) {
  AdviseOptions options;
  options.threshold_m = 5.0;
  set(options);
  return advised(options);
}

std::optional<Error> verified(const std::function<void(VerifyOptions&)>& set) {
  VerifyOptions options;
  options.threshold_m = 5.0;
  set(options);
  Verifier verifier(options);
  const Status first = verifier.add(0.0, kMovers);
  EXPECT_EQ(verifier.verdict().steps, 0U);
  return error_of(first);
}

std::optional<Error> swarmed(const std::function<void(SwarmOptions&)>& set) {
  SwarmOptions options;
  options.threshold_m = 5.0;
  set(options);
  Swarm swarm(options);
  const auto updated = error_of(swarm.update({1, 0.0, {0, 0, 0}}));
  const auto advanced = error_of(swarm.advance(0.0));
  EXPECT_EQ(updated.has_value(), advanced.has_value());
  return advanced;
}

std::optional<Error> contacted(const Obstacle& obstacle, double radius_m, double horizon_s) {
  const auto map = ObstacleMap::of({obstacle});
  const auto contact = error_of(first_contact_s(obstacle, kMovers[0], radius_m, horizon_s));
  if (!map) return map.error();
  const auto of_map = error_of(map->first_contact(kMovers[0], radius_m, horizon_s));
  EXPECT_EQ(of_map.has_value(), contact.has_value());
  return contact;
}

const ObstacleMap& some_map() {
  static const ObstacleMap map = *ObstacleMap::of({Sphere{{50, 0, 0}, 1.0}});
  return map;
}

const std::vector<Field>& fields() {
  // In order: NaN, infinity, -infinity, -1, 0, 1e-320, 2^-101, 1e200.
  static const std::vector<Field> all = {
      {"SearchOptions::threshold_m", "EEEEEE.E",
       [](double v) { return search({.threshold_m = v}); }},
      {"SearchOptions::vertical_m", "EEEEEE.E",
       [](double v) { return search({.threshold_m = 5.0, .vertical_m = v}); }},
      {"Index radius", "EEEE.E.E",
       [](double v) {
         const auto index = Index::build(kPoints);
         return error_of(index->find_around({}, v));
       }},
      {"PredictOptions::threshold_m", "EEEEEEEE",
       [](double v) { return predict({.threshold_m = v}); }},
      {"PredictOptions::vertical_m", "EEEEEEEE",
       [](double v) { return predict({.threshold_m = 5.0, .vertical_m = v}); }},
      {"PredictOptions::horizon_s", "EEEE.EEE",
       [](double v) { return predict({.threshold_m = 5.0, .horizon_s = v}); }},
      {"PredictOptions::height_unit_m", "EEEEEEEE",
       [](double v) {
         PredictOptions options{.threshold_m = 5.0, .vertical_m = 5.0};
         options.height_unit_m = v;
         return predict(options);
       }},
      {"ConflictOptions::threshold_m", "EEEEEEEE",
       [](double v) { return record({.threshold_m = v}); }},
      {"ConflictOptions::vertical_m", "EEEEEEEE",
       [](double v) { return record({.threshold_m = 5.0, .vertical_m = v}); }},
      {"ConflictOptions::max_gap_s", "E.EEE...",
       [](double v) { return record({.threshold_m = 5.0, .max_gap_s = v}); }},
      {"Track::tolerance_m", "EEEE.EEE", [](double v) { return record({.threshold_m = 5.0}, v); }},
      {"AdviseOptions::threshold_m", "EEEEEEEE",
       [](double v) { return advised_with([v](auto& options) { options.threshold_m = v; }); }},
      {"AdviseOptions::step_s", "EEEEEEEE",
       [](double v) { return advised_with([v](auto& options) { options.step_s = v; }); }},
      {"AdviseOptions::uncertainty_m", "EEEE.EEE",
       [](double v) { return advised_with([v](auto& options) { options.uncertainty_m = v; }); }},
      {"AdviseOptions::clearance_m with obstacles", "EEEEEEEE",
       [](double v) {
         return advised_with([v](auto& options) {
           options.obstacles = &some_map();
           options.clearance_m = v;
         });
       }},
      // NaN: not given.
      {"AdviseOptions::clearance_m without", ".EEEEEEE",
       [](double v) { return advised_with([v](auto& options) { options.clearance_m = v; }); }},
      {"AdviseOptions::intruder_horizon_s", "EEEEEEEE",
       [](double v) {
         return advised_with([v](auto& options) { options.intruder_horizon_s = v; });
       }},
      {"AdviseOptions::unknown_horizon_s", "EEEEEEEE",
       [](double v) {
         return advised_with([v](auto& options) { options.unknown_horizon_s = v; });
       }},
      // Values that are too small count as zero, for measured or computed numbers.
      {"UnknownAgent::center", "EEE....E",
       [](double v) {
         const std::vector<UnknownAgent> unknown = {{{v, 1e3, 0}, 1.0, 1.0, {}}};
         return advised_with([&](auto& options) { options.unknown = unknown; });
       }},
      {"UnknownAgent::radius_m", "EEEE...E",
       [](double v) {
         const std::vector<UnknownAgent> unknown = {{{0, 1e3, 0}, v, 1.0, {}}};
         return advised_with([&](auto& options) { options.unknown = unknown; });
       }},
      {"UnknownAgent::growth_mps", "EEEE...E",
       [](double v) {
         const std::vector<UnknownAgent> unknown = {{{0, 1e3, 0}, 1.0, v, {}}};
         return advised_with([&](auto& options) { options.unknown = unknown; });
       }},
      {"intruder", "EEE....E",
       [](double v) {
         const std::vector<Mover> intruders = {{{0, 1e3, v}, {}}};
         return advised_with([&](auto& options) { options.intruders = intruders; });
       }},
      {"advised position", "EEE....E",
       [](double v) {
         std::vector<Mover> movers = kMovers;
         movers[1].position.z = v;
         return advised({.threshold_m = 5.0}, movers);
       }},
      {"advised velocity", "EEE....E",
       [](double v) {
         std::vector<Mover> movers = kMovers;
         movers[1].velocity.z = v;
         return advised({.threshold_m = 5.0}, movers);
       }},
      {"wish", "EEE....E",
       [](double v) {
         return advised({.threshold_m = 5.0}, kMovers, {{}, {v, 0, 0}, {}});
       }},
      {"greatest speed of all", "EEEE.EEE",
       [](double v) {
         return advised({.threshold_m = 5.0}, kMovers, std::vector<Velocity>(3), {{v, 5.0}});
       }},
      {"greatest speed of one", "EEEE.EEE",
       [](double v) {
         return advised({.threshold_m = 5.0}, kMovers, std::vector<Velocity>(3),
                        {{10.0, 5.0}, {v, 5.0}, {10.0, 5.0}});
       }},
      {"greatest acceleration of all", "E.EEEEEE",
       [](double v) {
         return advised({.threshold_m = 5.0}, kMovers, std::vector<Velocity>(3), {{10.0, v}});
       }},
      {"greatest acceleration of one", "E.EEEEEE",
       [](double v) {
         return advised({.threshold_m = 5.0}, kMovers, std::vector<Velocity>(3),
                        {{10.0, 5.0}, {10.0, v}, {10.0, 5.0}});
       }},
      {"velocity_to_goal position", "EEE....E",
       [](double v) {
         return error_of(velocity_to_goal({v, 0, 0}, {1, 2, 3}, {10.0, 5.0}, 0.1));
       }},
      {"velocity_to_goal goal", "EEE....E",
       [](double v) {
         return error_of(velocity_to_goal({1, 2, 3}, {0, v, 0}, {10.0, 5.0}, 0.1));
       }},
      {"velocity_to_goal speed", "EEEE.EEE",
       [](double v) {
         return error_of(velocity_to_goal({}, {1, 2, 3}, {v, 5.0}, 0.1));
       }},
      {"velocity_to_goal acceleration", "E.EEEEEE",
       [](double v) {
         return error_of(velocity_to_goal({}, {1, 2, 3}, {10.0, v}, 0.1));
       }},
      {"velocity_to_goal step", "EEEEEEEE",
       [](double v) {
         return error_of(velocity_to_goal({}, {1, 2, 3}, {10.0, 5.0}, v));
       }},
      {"VerifyOptions::threshold_m", "EEEEEEEE",
       [](double v) { return verified([v](auto& options) { options.threshold_m = v; }); }},
      {"VerifyOptions::clearance_m with obstacles", "EEEEEEEE",
       [](double v) {
         return verified([v](auto& options) {
           options.obstacles = &some_map();
           options.clearance_m = v;
         });
       }},
      {"VerifyOptions::max_speed_mps", "E.EE....",
       [](double v) { return verified([v](auto& options) { options.max_speed_mps = v; }); }},
      {"VerifyOptions::max_acceleration_mps2", "E.EE....",
       [](double v) {
         return verified([v](auto& options) { options.max_acceleration_mps2 = v; });
       }},
      {"verified time after 0", "EEEEEEEE",
       [](double v) {
         Verifier verifier({.threshold_m = 5.0});
         EXPECT_TRUE(verifier.add(0.0, kMovers));
         return error_of(verifier.add(v, kMovers));
       }},
      {"verified position", "EEE....E",
       [](double v) {
         std::vector<Mover> movers = kMovers;
         movers[1].position.y = v;
         return error_of(Verifier({.threshold_m = 5.0}).add(0.0, movers));
       }},
      {"SwarmOptions::threshold_m", "EEEEEEEE",
       [](double v) { return swarmed([v](auto& options) { options.threshold_m = v; }); }},
      {"SwarmOptions::vertical_m", "EEEEEEEE",
       [](double v) { return swarmed([v](auto& options) { options.vertical_m = v; }); }},
      {"SwarmOptions::leave_factor", "EEEEEEEE",
       [](double v) { return swarmed([v](auto& options) { options.leave_factor = v; }); }},
      {"SwarmOptions::horizon_s", "EEEE.EEE",
       [](double v) { return swarmed([v](auto& options) { options.horizon_s = v; }); }},
      {"SwarmOptions::max_age_s", "EEEEEEEE",
       [](double v) { return swarmed([v](auto& options) { options.max_age_s = v; }); }},
      {"Report::position", "EEE....E",
       [](double v) {
         Swarm swarm({.threshold_m = 5.0});
         return error_of(swarm.update({1, 0.0, {v, 0, 0}}));
       }},
      {"Report::time_s", "EEE....E",
       [](double v) {
         Swarm swarm({.threshold_m = 5.0});
         return error_of(swarm.update({1, v, {}}));
       }},
      {"Sphere::radius_m", "EEEE.EEE",
       [](double v) {
         return contacted(Sphere{{50, 0, 0}, v}, 1.0, 1.0);
       }},
      {"first_contact radius", "EEEE.EEE",
       [](double v) {
         return contacted(Sphere{{50, 0, 0}, 1.0}, v, 1.0);
       }},
      {"first_contact horizon", "EEEE.EEE",
       [](double v) {
         return contacted(Sphere{{50, 0, 0}, 1.0}, 1.0, v);
       }},
      {"nearest_surface point", "EEE..EEE",
       [](double v) {
         return error_of(nearest_surface(Sphere{{50, 0, 0}, 1.0}, {v, 0, 0}));
       }},
      {"to_track tolerance", "EEEEEEEE",
       [](double v) {
         BezierPath path;
         path.pieces.push_back({1.0, {10, 0, 0}, {Point{0, 5, 0}, Point{10, 5, 0}}, 2});
         return error_of(to_track(path, v));
       }},
      {"to_ecef longitude", "EEE....E",
       [](double v) {
         return error_of(to_ecef({v, 10.0, 10.0}));
       }},
      {"to_ecef latitude", "EEE....E",
       [](double v) {
         return error_of(to_ecef({10.0, v, 10.0}));
       }},
      {"to_ecef height", "EEE....E",
       [](double v) {
         return error_of(to_ecef({10.0, 10.0, v}));
       }},
  };
  return all;
}

TEST(Nonsense, BringsAnErrorOrTheAnswerThatIsDocumented) {
  for (const Field& field : fields()) {
    std::string found;
    for (const double value : kValues) {
      SCOPED_TRACE(testing::Message() << field.name << " = " << value);
      const auto error = field.ask(value);
      found += error ? 'E' : '.';
      EXPECT_TRUE(!error || error->message.size() > 20) << error->message;
    }
    EXPECT_EQ(found, field.expected) << field.name;
  }
}

// An earlier answer of an Engine does not remain after a query that fails.
TEST(Nonsense, LeavesNoEarlierAnswerBehind) {
  Engine engine;
  std::vector<PointId> ids;
  std::vector<Pair> pairs;
  IdRows rows;
  std::vector<std::uint32_t> counts;
  std::vector<Nearest> nearest;
  std::vector<Conflict> conflicts;
  const auto index = Index::build(kPoints);
  ASSERT_TRUE(index);
  const std::vector<Point> bad = {{0, 0, 0}, {kNan, 0, 0}};
  const std::vector<Mover> bad_movers = {{{0, 0, 0}, {}}, {{kNan, 0, 0}, {}}};
  const SearchOptions within{.threshold_m = 50.0};
  const SearchOptions cylinder{.threshold_m = 50.0, .vertical_m = 5.0};
  using Asks = std::vector<std::function<Status(bool well)>>;
  const auto points_of = [&](bool well) { return PointsView(well ? kPoints : bad); };
  const auto movers_of = [&](bool well) { return MoversView(well ? kMovers : bad_movers); };
  const auto check = [](auto& answer, const Asks& asks) {
    for (std::size_t k = 0; k < asks.size(); ++k) {
      ASSERT_TRUE(asks[k](true)) << k;
      ASSERT_NE(answer.size(), 0U) << k;
      ASSERT_FALSE(asks[k](false)) << k;
      ASSERT_EQ(answer.size(), 0U) << k;
    }
  };
  for (const SearchOptions& options : {within, cylinder}) {
    check(ids, {[&](bool well) { return engine.find_at_risk(points_of(well), options, ids); },
                [&](bool well) {
                  return engine.find_at_risk_between(points_of(well), kPoints, options, ids);
                }});
    check(pairs, {[&](bool well) { return engine.find_pairs(points_of(well), options, pairs); },
                  [&](bool well) {
                    return engine.find_pairs_between(points_of(well), kPoints, options, pairs);
                  }});
    check(rows,
          {[&](bool well) { return engine.find_neighbors(points_of(well), options, rows); },
           [&](bool well) {
             return engine.find_neighbors_between(points_of(well), kPoints, options, rows);
           },
           [&](bool well) { return engine.find_conflict_groups(points_of(well), options, rows); }});
    check(counts,
          {[&](bool well) { return engine.count_neighbors(points_of(well), options, counts); },
           [&](bool well) {
             return engine.count_neighbors_between(points_of(well), kPoints, options, counts);
           }});
    check(nearest,
          {[&](bool well) { return engine.find_nearest_within(points_of(well), options, nearest); },
           [&](bool well) {
             return engine.find_nearest_within_between(points_of(well), kPoints, options, nearest);
           }});
  }
  check(nearest,
        {[&](bool well) { return engine.find_nearest(points_of(well), nearest); },
         [&](bool well) { return engine.find_nearest_between(points_of(well), kPoints, nearest); },
         [&](bool well) { return index->k_nearest(points_of(well)[1], 2, nearest); }});
  check(ids, {[&](bool well) { return index->find_around(points_of(well)[1], 10.0, false, ids); }});
  const PredictOptions ahead{.threshold_m = 20.0};
  check(conflicts,
        {[&](bool well) { return engine.predict_conflicts(movers_of(well), ahead, conflicts); }});
  check(pairs, {[&](bool well) { return engine.predict_pairs(movers_of(well), ahead, pairs); }});
}

// Arrays that do not fit together are no question at all, wherever they are handed in.
TEST(Nonsense, ArraysThatDoNotFitTogether) {
  const std::vector<double> x = {1, 2, 3};
  const std::span<const double> all(x);
  const PointsView ragged = PointsView::separate(all, all.first(2), all.first(1));
  const SearchOptions within{.threshold_m = 50.0};
  const SearchOptions cylinder{.threshold_m = 50.0, .vertical_m = 5.0};
  std::vector<Point> ecef(1);
  std::vector<std::optional<Error>> errors = {
      error_of(find_nearest(ragged)),      error_of(find_nearest_between(kPoints, ragged)),
      error_of(find_closest_pair(ragged)), error_of(find_closest_pair_between(kPoints, ragged)),
      error_of(Index::build(ragged)),      error_of(to_ecef(ragged, ecef))};
  const auto index = Index::build(kPoints);
  errors.push_back(error_of(index->find_around(ragged, {50.0})));
  errors.push_back(error_of(index->k_nearest(ragged, 1)));
  for (const SearchOptions& options : {within, cylinder}) {
    errors.push_back(error_of(find_at_risk(ragged, options)));
    errors.push_back(error_of(find_pairs(ragged, options)));
    errors.push_back(error_of(find_neighbors(ragged, options)));
    errors.push_back(error_of(count_neighbors(ragged, options)));
    errors.push_back(error_of(find_conflict_groups(ragged, options)));
    errors.push_back(error_of(brute_force::find_pairs(ragged, options)));
    errors.push_back(error_of(find_pairs_between(kPoints, ragged, options)));
    errors.push_back(error_of(find_pairs_between(ragged, kPoints, options)));
    errors.push_back(
        error_of(visit_pairs(ragged, options, [](std::span<const Pair>) { return true; })));
  }
  const PredictOptions ahead{.threshold_m = 5.0};
  for (const MoversView& movers : {MoversView(kPoints, ragged), MoversView(ragged, ragged),
                                   MoversView(kPoints, PointsView(std::span(kPoints).first(1)))}) {
    errors.push_back(error_of(predict_conflicts(movers, ahead)));
    errors.push_back(error_of(predict_pairs(movers, ahead)));
    errors.push_back(error_of(brute_force::predict_conflicts(movers, ahead)));
    errors.push_back(error_of(Verifier({.threshold_m = 5.0}).add(0.0, movers)));
  }
  for (std::size_t k = 0; k < errors.size(); ++k) {
    ASSERT_TRUE(errors[k]) << k;
    EXPECT_EQ(errors[k]->code, ErrorCode::kInvalidArgument) << k << ": " << errors[k]->message;
  }
}

}  // namespace
}  // namespace beespace
