// How the figures tell the modes of failure apart: in colour, and in lightness on a black and white copy.
#pragma once

#include "plots/figures/block_figures.hpp"

#include <string>

namespace delabole {

struct ModeStyle {
    Colour colour;
    double opacity;
};

inline constexpr std::array drawn_modes{
    DrawnMode::plain, DrawnMode::stays,           DrawnMode::slides, DrawnMode::topples, DrawnMode::slides_and_topples,
    DrawnMode::moves, DrawnMode::held_by_corners, DrawnMode::fixed};

constexpr ModeStyle style_of(DrawnMode mode) {
    switch (mode) {
    case DrawnMode::stays:
        return {Colour::light_grey, 0.35};
    case DrawnMode::slides:
        return {Colour::blue, 0.45};
    case DrawnMode::topples:
        return {Colour::orange, 0.5};
    case DrawnMode::slides_and_topples:
        return {Colour::purple, 0.6};
    case DrawnMode::moves:
        return {Colour::green, 0.35};
    case DrawnMode::held_by_corners:
        return {Colour::vermilion, 0.4};
    case DrawnMode::fixed:
        return {Colour::grey, 0.6};
    case DrawnMode::plain:
        break;
    }
    return {Colour::rock, 0.3};
}

inline std::string legend_of_mode(DrawnMode mode) {
    return std::string(enum_names(mode)[static_cast<std::size_t>(mode)]);
}

}  // namespace delabole
