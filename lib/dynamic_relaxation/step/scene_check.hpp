// Scenes that dynamic relaxation refuses to run.
#pragma once

#include "dynamic_relaxation/scene/scene.hpp"
#include "dynamic_relaxation/scene/settings.hpp"

namespace delabole {

// Numbers, outlines, stiffnesses and references. All but the overlap.
SceneFault check_scene(const RelaxationScene& scene);

// Ranges of settings.hpp.
SceneFault check_settings(const RelaxationSettings& settings);

// The first free block that has left the slope at the start; the scene must have passed check_scene.
SceneFault check_departure(const RelaxationScene& scene, const RelaxationSettings& settings);

// Overlaps of the initial geometry; the scene must have passed check_scene.
SceneFault check_start(const RelaxationScene& scene);

// All of them.
SceneFault check(const RelaxationScene& scene, const RelaxationSettings& settings);

}  // namespace delabole
