// Scenes that dynamic relaxation refuses to run.
#pragma once

#include "dynamic_relaxation/scene/scene.hpp"
#include "dynamic_relaxation/scene/settings.hpp"

namespace delabole {

// Checks numbers, outlines, stiffnesses and references, but not overlaps.
SceneFault check_scene(const RelaxationScene& scene);

// Checks the ranges of settings.hpp.
SceneFault check_settings(const RelaxationSettings& settings);

// Finds the first free block that has left the slope at the start; the scene must have passed check_scene.
SceneFault check_departure(const RelaxationScene& scene, const RelaxationSettings& settings);

// Checks overlaps of the initial geometry; the scene must have passed check_scene.
SceneFault check_start(const RelaxationScene& scene);

// Runs all of these checks.
SceneFault check(const RelaxationScene& scene, const RelaxationSettings& settings);

}  // namespace delabole
