// From the data sheet of a fleet to the tube of its agents, and how far apart they start.
#include <beespace/beespace.hpp>

#include <cstdio>

namespace {

// An outdoor show: RTK, and autopilots that fly setpoints themselves.
constexpr beespace::FleetFigures kShow{.loop = beespace::LoopPlace::kOnboard,
                                       .report_error_m = 0.10,
                                       .report_age_s = 0.30,
                                       .sensing_error_m = 0.10,
                                       .loop_period_s = 0.02,
                                       .loop_delay_s = 0.10,
                                       .deviation_mps = 0.3,
                                       .clock_error_s = 0.01,
                                       .correction_mps2 = 1.0,
                                       .correction_mps = 1.0};

// Research drones: plain GPS, velocity commands over Wi-Fi.
constexpr beespace::FleetFigures kGps{.loop = beespace::LoopPlace::kGround,
                                      .report_error_m = 2.5,
                                      .report_age_s = 0.35,
                                      .deviation_mps = 0.5,
                                      .clock_error_s = 0.02,
                                      .correction_mps2 = 1.0,
                                      .correction_mps = 1.5};

// A laboratory: small quadrotors, motion capture.
constexpr beespace::FleetFigures kIndoor{.loop = beespace::LoopPlace::kOnboard,
                                         .report_error_m = 0.005,
                                         .report_age_s = 0.05,
                                         .sensing_error_m = 0.005,
                                         .loop_period_s = 0.01,
                                         .loop_delay_s = 0.03,
                                         .deviation_mps = 0.15,
                                         .clock_error_s = 0.002,
                                         .correction_mps2 = 1.0,
                                         .correction_mps = 0.3};

void show(const char* name, const beespace::FleetFigures& figures,
          const beespace::LinkFigures& link, const beespace::FlightLimits& limits,
          double threshold_m) {
  const beespace::Result<beespace::Tube> tube = tube_of(figures, link, limits);
  if (!tube) {
    std::printf("%s: %s\n", name, tube.error().message.c_str());
    return;
  }
  std::printf("%s: a tube of %.2f m (clock %.2f m), kept apart %.2f m, start %.2f m apart;\n", name,
              tube->radius_m, tube->clock_m, threshold_m + 2.0 * tube->radius_m,
              2.0 * (threshold_m + 2.0 * tube->radius_m));
  std::printf("  plans use %.1f m/s and %.1f m/s^2; corrections at most %.2f m/s, %.2f m/s^2\n",
              tube->planned.max_speed_mps, tube->planned.max_acceleration_mps2,
              tube->correction_mps, tube->correction_mps2);
}

}  // namespace

int main() {
  show("show", kShow, {.period_s = 0.1, .command_delay = 4, .longest_loss = 8}, {6.0, 4.0}, 1.5);
  show("gps", kGps, {.period_s = 0.2, .command_delay = 2}, {8.0, 4.0}, 3.0);
  show("indoor", kIndoor, {.period_s = 0.05, .command_delay = 2, .longest_loss = 4}, {1.5, 3.0},
       0.3);
  // More wind than the reserve can hold.
  beespace::FleetFigures stormy = kShow;
  stormy.deviation_mps = 1.2;
  show("storm", stormy, {}, {6.0, 4.0}, 1.5);
}
