// [support_design] of a case: finds the cheapest support, puts it into the model, and reports it.
#pragma once

#include "cases/program/results/result_folder.hpp"
#include "fitting/studies/support_design.hpp"

#include <functional>
#include <optional>
#include <string>

namespace delabole {

struct DesignedSupport {
    SupportDesign design;
    SupportDesignResult found;
    std::string sentence;  // describes the cheapest support, or why there is none
};

// Puts into the case's model the cheapest support, or the strongest if none reaches the factor of safety. If no pattern
// has an answer the model keeps its own support. What --set gives is not chosen. Returns nothing if there is nothing to
// choose.
std::optional<DesignedSupport> design_support_of(CaseFile& file, const std::function<bool(double)>& watch);

// Adds the sentence after the verdict, which is the first.
void add_to_head(const DesignedSupport& support, HeadCard& head);

// Adds the figure and support.csv, and returns the result for result.json.
Json document_support(const DesignedSupport& support, const Sheet& sheet);

}  // namespace delabole
