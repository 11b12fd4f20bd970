// The series of a figure, by their kind and legend.
#pragma once

#include "plots/drawing/figure.hpp"

#include <gtest/gtest.h>

#include <string>
#include <variant>
#include <vector>

namespace delabole {

template <class Type>
std::vector<Type> all(const Figure& figure) {
    std::vector<Type> result;
    for (const Series& series : figure.series) {
        if (const auto* content = std::get_if<Type>(&series)) {
            result.push_back(*content);
        }
    }
    return result;
}

template <class Type>
Type with_legend(const Figure& figure, const std::string& legend) {
    for (const Type& series : all<Type>(figure)) {
        if (series.legend == legend) {
            return series;
        }
    }
    ADD_FAILURE() << "no series \"" << legend << "\"";
    return {};
}

// Returns the legends of every kind in drawing order; series without one are left out.
inline std::vector<std::string> legends(const Figure& figure) {
    std::vector<std::string> result;
    for (const Series& series : figure.series) {
        std::visit(
            [&](const auto& content) {
                if constexpr (requires { content.legend; }) {
                    if (!content.legend.empty()) {
                        result.push_back(content.legend);
                    }
                }
            },
            series);
    }
    return result;
}

}  // namespace delabole
