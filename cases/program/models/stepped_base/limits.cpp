// Reports what is impossible about columns on a stepped base, and which value is the cause.
#include "cases/program/reader/units.hpp"
#include "cases/program/results/model_reports.hpp"
#include "limit_equilibrium/columns/base_profile.hpp"
#include "limit_equilibrium/stepped_base/stepped_base_study.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace delabole {

namespace {

// The first load or bolt that does not fit on its column, and the limit that it violates.
struct Misplaced {
    std::string key;
    std::string explanation;
};

double highest_point(const ColumnScene<>& scene, const ColumnSlope<>& slope, std::size_t index) {
    const Column<>& column = slope.columns[index];
    double highest = 0;
    const std::vector<Polyline> outlines = column_outlines(scene);
    for (const Point& point : outlines[index]) {
        highest = std::max(highest, point.y() * std::cos(slope.base_dip) - point.x() * std::sin(slope.base_dip));
    }
    return highest - column.base_v;
}

void put_on(ColumnScene<>& scene, const PointLoad<>& load) {
    scene.point_load = {load};
}
void put_on(ColumnScene<>& scene, const ColumnBolt<>& bolt) {
    scene.bolt = {bolt};
}
// The force is unknown, since it is what is required.
void put_on(ColumnScene<>& scene, const RequiredCable<>& cable) {
    scene.bolt = {{cable.block, 0, cable.plunge, cable.height}};
}

template <class Load>
std::optional<Misplaced> first_misplaced(const ColumnScene<>& bare, const ColumnSlope<>& slope, const std::string& list,
                                         const std::vector<Load>& loads) {
    for (std::size_t index = 0; index < loads.size(); ++index) {
        const Load& load = loads[index];
        ColumnScene<> scene = bare;
        put_on(scene, load);
        if (make_columns(scene).check != ColumnCheck::load_outside_columns) {
            continue;
        }
        const std::string key = list + "[" + std::to_string(index + 1) + "]";
        const auto count = static_cast<double>(slope.columns.size());
        if (load.block > count || load.block != std::floor(load.block)) {
            return Misplaced{key + ".block", "there are only " + std::to_string(slope.columns.size()) + " columns"};
        }
        const auto number = static_cast<std::size_t>(load.block);
        // Whole millimetres below it, so that the height is allowed when copied into the case.
        const double height = std::floor(highest_point(bare, slope, number - 1) * 1e3) / 1e3;
        return Misplaced{key + ".height", "lies above the top of column " + std::to_string(number) + ", which is " +
                                              readable_quantity(height, Dimension::length) + " high"};
    }
    return std::nullopt;
}

std::optional<Misplaced> first_misplaced(const SteppedBaseStudy<>& study) {
    const ColumnScene<>& given = study.model.scene;
    SteppedBaseStudy<> unloaded = study;
    unloaded.model.scene.point_load.clear();
    unloaded.model.scene.bolt.clear();
    const ColumnScene<> bare = resolve(unloaded).problem.scene;
    const ColumnSlope<> slope = make_columns(bare);
    if (slope.check != ColumnCheck::valid) {
        return std::nullopt;
    }
    if (auto load = first_misplaced(bare, slope, "point_load", given.point_load)) {
        return load;
    }
    if (auto bolt = first_misplaced(bare, slope, "bolt", given.bolt)) {
        return bolt;
    }
    return first_misplaced(bare, slope, "required_cable", study.required_cable);
}

// Keys of steps that are higher than the block below them.
std::vector<std::string> keys_of_high_steps(const SteppedBaseStudy<>& study) {
    std::vector<std::string> keys;
    const auto* given = std::get_if<BlockColumns<>>(&study.model.scene.columns);
    for (std::size_t index = 0; given != nullptr && index < given->block.size(); ++index) {
        if (given->block[index].step_above > given->block[index].height) {
            keys.push_back("columns.block[" + std::to_string(index + 1) + "].step_above");
        }
    }
    keys.emplace_back("columns.base_inclination");
    return keys;
}

}  // namespace

Impossibility impossibility(const SteppedBaseStudy<>& study, std::string_view failure) {
    Impossibility found = stated_impossibility(SteppedBaseStudy<>::kind, failure);
    if (failure == word_of(ColumnCheck::step_larger_than_block)) {
        found.keys = keys_of_high_steps(study);
    } else if (failure == word_of(ColumnCheck::load_outside_columns)) {
        if (const auto misplaced = first_misplaced(study)) {
            found = {{misplaced->key}, misplaced->explanation};
        }
    }
    return found;
}

}  // namespace delabole
