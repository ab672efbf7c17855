// All of beespace in one include.
#pragma once

#include <beespace/at_risk.hpp>
#include <beespace/bezier_path.hpp>
#include <beespace/brute_force.hpp>
#include <beespace/closest_approach.hpp>
#include <beespace/conflict.hpp>
#include <beespace/conflict_groups.hpp>
#include <beespace/crew.hpp>
#include <beespace/engine.hpp>
#include <beespace/find_conflicts.hpp>
#include <beespace/geodesy.hpp>
#include <beespace/id_rows.hpp>
#include <beespace/index.hpp>
#include <beespace/mover.hpp>
#include <beespace/nearest.hpp>
#include <beespace/neighbors.hpp>
#include <beespace/pairs.hpp>
#include <beespace/point.hpp>
#include <beespace/points_view.hpp>
#include <beespace/predict_conflicts.hpp>
#include <beespace/result.hpp>
#include <beespace/search_options.hpp>
#include <beespace/swarm.hpp>
#include <beespace/track.hpp>
#include <beespace/version.hpp>
