#include "plots/block_figures.hpp"
#include "samples.hpp"
#include "series_of.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace delabole {
namespace {

TEST(BlockFigure, Draws) {
    EXPECT_TRUE(block_figure(samples::single_block()).equal_scales);
}

}  // namespace
}  // namespace delabole
