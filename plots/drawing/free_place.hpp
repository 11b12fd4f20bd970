// Places a text where it hides least of a figure.
#pragma once

#include "plots/drawing/figure.hpp"

#include <string>
#include <vector>

namespace delabole {

struct LabelPlace {
    Point at;
    Label::Align align = Label::Align::left;
    double raise = 0;  // as in Label
};

// Adds a text at one of the places, of which there must be at least one. Places are preferred at which it overlaps no
// other label and stays within the ranges of both axes, which must be given; among these the one where it hides the
// fewest arrows, lines and points; among equal places the first. `px_per_unit` along both axes.
void add_where_free(const std::vector<LabelPlace>& places, const std::string& text, const Point& px_per_unit,
                    Figure& figure, Colour colour = Colour::black);

}  // namespace delabole
