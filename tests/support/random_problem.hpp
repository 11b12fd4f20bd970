// Plane-failure problems for sweeps: a textbook slope, and random ones over wide ranges of all inputs. The generator's
// bits are those of the C++ standard, and the mapping to numbers is our own, so the problems are the same everywhere.
#pragma once

#include "plane_failure/parameters.hpp"

#include <cmath>
#include <cstdint>
#include <random>

namespace delabole {

// Wyllie & Mah (2004), example 7.1, drained.
inline PlaneFailure<> textbook_slope() {
    PlaneFailure<> problem{};
    problem.slope = {12.0, degrees(60), 0.0, {}, {}};
    problem.failure_plane = {degrees(35), {}};
    problem.tension_crack = TensionCrack<>{degrees(90), CrackAtDistance<>{4.0}};
    problem.rock = {26e3};
    problem.strength = Coulomb<>{25e3, degrees(37)};
    problem.water = Dry{};
    return problem;
}

class RandomProblem {
  public:
    explicit RandomProblem(std::uint64_t seed) : generator_(seed) {}

    double uniform(double lower, double upper) {
        return lower + (upper - lower) * static_cast<double>(generator_() >> 11) * 0x1p-53;
    }
    double logarithmic(double lower, double upper) { return std::exp(uniform(std::log(lower), std::log(upper))); }
    bool chance(double probability) { return uniform(0, 1) < probability; }
    int pick(int count) { return static_cast<int>(generator_() % static_cast<std::uint64_t>(count)); }

    PlaneFailure<> next() {
        PlaneFailure<> problem{};
        geometry(problem);
        strength(problem);
        water(problem);
        loads(problem);
        return problem;
    }

    void geometry(PlaneFailure<>& problem) {
        const double height = logarithmic(1e-3, 5e3);
        const double face = face_dip();
        problem.slope = {height, face, chance(0.4) ? 0.0 : uniform(degrees(-40), degrees(60)), {}, {}};
        if (chance(0.3)) {
            problem.slope.bench = Bench<>{height * uniform(0.05, 1), chance(0.5) ? 0.0 : uniform(-0.3, 0.8)};
        }
        problem.slope.toe_elevation = chance(0.5) ? 0.0 : uniform(-100, 100);
        const double gap = chance(0.2) ? logarithmic(1e-6, 0.5) : uniform(1, 60);
        problem.failure_plane.dip = std::max(face - degrees(gap), degrees(uniform(0.5, 5)));
        if (chance(0.3)) {
            problem.failure_plane.daylight_height = height * uniform(0, 0.8);
        }
        if (chance(0.85)) {
            const double dip = chance(0.5) ? degrees(90) : uniform(problem.failure_plane.dip, degrees(149));
            problem.tension_crack = TensionCrack<>{dip, crack_position(problem)};
        }
        problem.rock.unit_weight = logarithmic(100, 1e5);
    }

  private:
    double face_dip() {
        switch (pick(5)) {
        case 0:
            return degrees(90);
        case 1:
            return degrees(90 - logarithmic(1e-7, 1));
        default:
            return uniform(degrees(10), degrees(90));
        }
    }

    CrackPosition<> crack_position(const PlaneFailure<>& problem) {
        const double height = problem.slope.height;
        const double datum = problem.slope.toe_elevation.value_or(0.0);
        switch (pick(4)) {
        case 0:
            return CrackAtDistance<>{height * uniform(-0.5, 1)};
        case 1:
            return CrackOfDepth<>{chance(0.1) ? 0.0 : height * uniform(0, 0.9)};
        case 2:
            return CrackBaseBelowCrest<>{height * uniform(-0.3, 1)};
        default:
            return CrackBaseElevation<>{datum + height * uniform(0, 1.3)};
        }
    }

    WaterLevel<> level(const PlaneFailure<>& problem) {
        switch (pick(3)) {
        case 0:
            return WaterDepth<>{problem.slope.height * uniform(0, 0.4)};
        case 1:
            return FilledRatio<>{chance(0.1) ? 0.0 : chance(0.1) ? 1.0 : uniform(0, 1)};
        default:
            return WaterElevation<>{problem.slope.toe_elevation.value_or(0.0) + problem.slope.height * uniform(0, 1)};
        }
    }

    void water(PlaneFailure<>& problem) {
        const double unit_weight = chance(0.5) ? 9810 : problem.rock.unit_weight * uniform(0.1, 1);
        const double height = problem.slope.height;
        switch (pick(7)) {
        case 0:
            problem.water = CrackAndBaseWater<>{unit_weight, level(problem)};
            break;
        case 1:
            problem.water = CrackOnlyWater<>{unit_weight, level(problem)};
            break;
        case 2:
            problem.water = BasePeakMidHeightWater<>{unit_weight, level(problem)};
            break;
        case 3:
            problem.water = PeakAtToeWater<>{unit_weight, level(problem)};
            break;
        case 4: {
            PiezometricLineWater<> line{unit_weight, {}};
            double x = height * uniform(-0.5, 0.5);
            for (int count = 2 + pick(4); count > 0; --count) {
                line.point.push_back({x, height * uniform(-0.2, 1)});
                x += height * uniform(0.05, 0.8);
            }
            problem.water = line;
            break;
        }
        case 5: {
            CustomWater<> custom;
            const auto fill = [&](std::vector<PressurePoint<>>& points) {
                double position = uniform(0, 0.3);
                for (int count = 2 + pick(3); count > 0; --count) {
                    points.push_back({position, unit_weight * height * uniform(0, 0.3)});
                    position += uniform(0.01, 0.2);
                }
            };
            fill(custom.base);
            if (problem.tension_crack) {
                fill(custom.crack);
            }
            problem.water = custom;
            break;
        }
        default:
            problem.water = Dry{};
        }
        if (chance(0.3)) {
            problem.pond = Pond<>{height * uniform(0, 1), unit_weight};
        }
    }

    void strength(PlaneFailure<>& problem) {
        const double stress = problem.rock.unit_weight * problem.slope.height;
        switch (pick(6)) {
        case 0:
            problem.strength = SteppedSurface<>{stress * uniform(0, 0.2), uniform(0, 0.7), uniform(0, 0.8)};
            break;
        case 1:
            problem.strength = PattonBilinear<>{uniform(0, 0.7), uniform(0, 0.8), stress * uniform(0, 0.5)};
            break;
        case 2:
            problem.strength = BartonBandis<>{uniform(0.2, 0.7), uniform(0, 20), stress * logarithmic(0.01, 1000)};
            break;
        case 3:
            problem.strength = PowerCurve<>{uniform(0, 2), uniform(0.01, 1), stress * uniform(0.1, 2),
                                            stress * uniform(0, 0.1), stress * uniform(0, 0.1)};
            break;
        default:
            problem.strength = Coulomb<>{stress * uniform(0, 0.3), uniform(0, degrees(89.9))};
        }
        if (chance(0.2)) {
            problem.tension_cutoff = TensionCutoff<>{stress * uniform(0, 0.1)};
        }
    }

    void loads(PlaneFailure<>& problem) {
        const double height = problem.slope.height;
        const double weight = problem.rock.unit_weight * height * height;
        if (chance(0.3)) {
            problem.seismic = SeismicLoad<>{uniform(-0.3, 0.5), uniform(-0.3, 0.3)};
        }
        while (chance(0.3)) {
            const double from = height * uniform(0, 0.5);
            problem.surcharge.push_back({weight / height * uniform(-0.05, 0.2), from, from + height * uniform(0, 0.5)});
        }
        while (chance(0.3)) {
            problem.line_load.push_back(
                {weight * uniform(0, 0.1), uniform(degrees(-90), degrees(270)), height * uniform(0, 0.5)});
        }
        while (chance(0.3)) {
            problem.bolt.push_back({weight * uniform(0, 0.1), uniform(degrees(-90), degrees(90)),
                                    height * uniform(0, 1), chance(0.5) ? BoltAction::active : BoltAction::passive});
        }
    }

    std::mt19937_64 generator_;
};

}  // namespace delabole
