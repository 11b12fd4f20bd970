// The base friction tests of chapter 3 as runs: what strength each slope needs to stand, one strength fitted to half of
// the scenes, the other half predicted.
#pragma once

#include "cases/program/thesis/chapter_3/base_friction_scene.hpp"

#include <cstddef>
#include <functional>
#include <vector>

namespace delabole {

// States that are one scene come together. Scenes are in the order in which Table 3.2 first has them. Every other one,
// from the first, is fitted, the rest predicted: so decided before any result was seen. Twins stay in one half.
struct BaseFrictionScene {
    BaseFrictionGeometry geometry;
    std::vector<std::size_t> state;  // indices of the table's rows
    bool fitted;
};

std::vector<BaseFrictionScene> base_friction_scenes(const std::vector<BaseFrictionState>& states,
                                                    const ModelMixture& mixture);

struct SceneNeed {
    CriticalStrength critical;
    CrackPath path;  // where it failed

    bool known() const { return critical.status < StrengthStatus::run_failed; }
    bool failed() const {
        return critical.status == StrengthStatus::found || critical.status == StrengthStatus::fails_however_strong;
    }
    double strength() const;  // kPa; infinite where it fails however strong, 0 where it stands however weak
};

SceneNeed needed_strength(const BaseFrictionGeometry& geometry, const ModelMixture& mixture,
                          const std::function<bool()>& watch = {});

// The scene with the strength all at once, kPa.
SceneNeed run_with_strength(const BaseFrictionGeometry& geometry, const ModelMixture& mixture, double strength,
                            const std::function<bool()>& watch = {});

// That a slope fails: a logistic in the logarithm of the strength it needs over the strength there is. Slabs are not
// alike, and a share of tests goes against any prediction, as 3(L) and 4(R) do, which are one scene.
double failure_probability(double needed, double strength);

struct StrengthFit {
    double strength;  // kPa
    double misfit;    // - log likelihood; a slope in limiting equilibrium counts half as failed
    double lower;     // kPa, between which the misfit is no more than 1.92 above the least: 95 %
    double upper;
    long evaluations;
};

// Fits the strength to the scenes whose need is known.
StrengthFit fit_strength(const std::vector<BaseFrictionState>& states, const std::vector<BaseFrictionScene>& scenes,
                         const std::vector<SceneNeed>& needs);

}  // namespace delabole
