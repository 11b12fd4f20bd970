// The series of a figure, by their kind and legend.
#pragma once

#include "plots/figure.hpp"

#include <gtest/gtest.h>

#include <string>
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

}  // namespace delabole
