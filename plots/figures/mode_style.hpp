// Styles by which figures distinguish the modes of failure: in colour, and by lightness on a black and white copy.
#pragma once

#include "plots/figures/block_figures.hpp"

#include <array>

namespace delabole {

struct ModeStyle {
    Colour colour;
    double opacity;
};

inline constexpr std::array drawn_modes{
    DrawnMode::plain, DrawnMode::stays,           DrawnMode::slides, DrawnMode::topples, DrawnMode::slides_and_topples,
    DrawnMode::moves, DrawnMode::held_by_corners, DrawnMode::fixed};

constexpr ModeStyle style_of(DrawnMode mode) {
    constexpr std::array<ModeStyle, drawn_modes.size()> styles{{{Colour::rock, 0.3},
                                                                {Colour::light_grey, 0.35},
                                                                {Colour::blue, 0.45},
                                                                {Colour::orange, 0.5},
                                                                {Colour::purple, 0.6},
                                                                {Colour::green, 0.35},
                                                                {Colour::vermilion, 0.4},
                                                                {Colour::grey, 0.6}}};
    return styles[static_cast<std::size_t>(mode)];
}

}  // namespace delabole
