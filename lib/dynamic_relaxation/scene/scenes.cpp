#include "dynamic_relaxation/scene/scenes.hpp"

#include <algorithm>

namespace delabole {

namespace {

constexpr std::size_t of_interface = 0;
constexpr std::size_t of_base = 1;
constexpr double clear_widths = 3;  // of the base in front of columns
// The plane extends as far as blocks may slide: from a plane of a few widths they would fall off unnoticed.
constexpr double plane_widths = 1000;

RelaxationScene empty_scene(const StandingBlocks& blocks) {
    RelaxationScene scene;
    scene.material = {blocks.interface, blocks.base};
    scene.gravity.tilt = scene.gravity.final_tilt = blocks.tilt;
    return scene;
}

RelaxationBlock fixed_block(Polygon<> outline, double density) {
    RelaxationBlock block{std::move(outline), density};
    block.fixed = true;
    block.joint = std::vector<std::size_t>(block.outline.size(), of_base);
    return block;
}

RelaxationBlock standing_block(const StandingBlock& block, double x, double y, double density) {
    RelaxationBlock standing{upright_rectangle(x, y, x + block.width, y + block.height), density};
    standing.joint = {of_base, of_interface, of_interface, of_interface};
    return standing;
}

}  // namespace

RelaxationScene row_scene(const StandingBlocks& blocks) {
    RelaxationScene scene = empty_scene(blocks);
    double x = 0;
    double widest = 0;
    for (const StandingBlock& block : blocks.block) {
        scene.block.push_back(standing_block(block, x, 0, blocks.density));
        x += block.width;
        widest = std::max(widest, block.width);
    }
    scene.block.push_back(
        fixed_block(upright_rectangle(-plane_widths * widest, -widest, x + plane_widths * widest, 0), blocks.density));
    return scene;
}

RelaxationScene column_scene(const StandingBlocks& blocks) {
    RelaxationScene scene = empty_scene(blocks);
    double x = 0;
    double y = 0;
    std::vector<RelaxationBlock> bases;
    for (const StandingBlock& block : blocks.block) {
        const double depth = block.width + block.step_above;
        const double before = bases.empty() ? clear_widths * block.width : 0;
        scene.block.push_back(standing_block(block, x, y, blocks.density));
        bases.push_back(fixed_block(upright_rectangle(x - before, y - depth, x + block.width, y), blocks.density));
        x += block.width;
        y += block.step_above;
    }
    scene.block.insert(scene.block.end(), bases.begin(), bases.end());
    return scene;
}

double stiffness_of_ratio(double ratio, const StandingBlock& block, double density, double gravity) {
    return ratio * density * gravity * block.height;
}

}  // namespace delabole
