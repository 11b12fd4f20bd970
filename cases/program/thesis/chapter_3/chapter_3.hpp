// The items of the thesis's chapter 3: base friction tests and the tilting frame.
#pragma once

#include "cases/program/thesis/physical_models.hpp"
#include "cases/program/thesis/reproduction.hpp"
#include "plots/drawing/figure.hpp"

#include <array>

namespace delabole {

// A guess made after the tests were seen: slopes of 70 deg and more, on the frame, or with a changed toe fail.
bool steep_or_changed(const BaseFrictionState& state);

// Points of the tests by their behaviour.
void add_by_behaviour(const std::array<Polyline, 3>& points, Figure& figure);

Reproduction reproduce_table_3_2(const ResultFolder& folder, Report& report);
Reproduction reproduce_base_friction_plates(const ResultFolder& folder, Report& report);
Reproduction reproduce_base_friction_runs(const ResultFolder& folder, Report& report);
Reproduction reproduce_tilting_runs(const ResultFolder& folder, Report& report);
Reproduction reproduce_fig_3_2(const ResultFolder& folder, Report& report);
Reproduction reproduce_fig_3_6(const ResultFolder& folder, Report& report);
Reproduction reproduce_fig_3_7(const ResultFolder& folder, Report& report);

}  // namespace delabole
