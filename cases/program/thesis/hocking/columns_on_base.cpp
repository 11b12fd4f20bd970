#include "cases/program/thesis/hocking/columns_on_base.hpp"

#include <cmath>

namespace delabole {

namespace {

Point turned(double along, double normal, double dip) {
    return {along * std::cos(dip) - normal * std::sin(dip), along * std::sin(dip) + normal * std::cos(dip)};
}

HockingBlock block_at(double along, double normal, double width, double height, double dip) {
    HockingBlock block;
    block.width = width;
    block.height = height;
    block.dip = dip;
    block.centroid = turned(along + width / 2, normal + height / 2, dip);
    return block;
}

}  // namespace

std::vector<HockingBlock> make_blocks(const HockingColumns& columns) {
    const auto count = static_cast<int>(columns.heights.size());
    std::vector<HockingBlock> blocks;
    const auto within = [&](int column) { return column >= 0 && column < count ? column : no_block; };
    for (int column = 0; column < count; ++column) {
        HockingBlock block = block_at(column * (columns.width + columns.gap), column * columns.step, columns.width,
                                      columns.heights[static_cast<std::size_t>(column)], columns.dip);
        block.neighbours.downhill = within(column - 1);
        block.neighbours.uphill = within(column + 1);
        blocks.push_back(block);
    }
    const int bases =
        columns.base == HockingBase::one_block ? 1 : columns.downhill_bases + count + columns.uphill_bases;
    for (int number = 0; number < bases; ++number) {
        const int column = number - columns.downhill_bases;
        const bool one = columns.base == HockingBase::one_block;
        const double width = columns.width * (one ? columns.downhill_bases + count + columns.uphill_bases : 1);
        HockingBlock block = block_at(column * columns.width, column * columns.step - columns.base_height, width,
                                      columns.base_height, columns.dip);
        block.fixed = true;
        const int index = count + number;
        if (one) {
            for (int above = 0; above < count; ++above) {
                blocks[static_cast<std::size_t>(above)].neighbours.below = index;
            }
        } else {
            block.neighbours.above = within(column);
            block.neighbours.above_downhill = within(column - 1);
            block.neighbours.above_uphill = within(column + 1);
            const auto stand_on = [&](int above, int HockingNeighbours::*place) {
                if (within(above) != no_block) {
                    blocks[static_cast<std::size_t>(above)].neighbours.*place = index;
                }
            };
            stand_on(column, &HockingNeighbours::below);
            stand_on(column + 1, &HockingNeighbours::below_downhill);
            stand_on(column - 1, &HockingNeighbours::below_uphill);
        }
        blocks.push_back(block);
    }
    if (columns.coordinate_unit > 0) {
        for (HockingBlock& block : blocks) {
            block.centroid = (block.centroid / columns.coordinate_unit).array().round() * columns.coordinate_unit;
        }
    }
    return blocks;
}

}  // namespace delabole
