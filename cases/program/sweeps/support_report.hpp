// [support_design] of a case: the cheapest support found and put into its model, and how that is told.
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
    std::string sentence;  // what the cheapest support is, or why there is none
};

// Puts the cheapest support into the case's model, or the strongest where none reaches the factor of safety. Where no
// pattern has an answer, the model keeps its own. What --set gives is not chosen. Returns nothing where there is
// nothing to choose.
std::optional<DesignedSupport> design_support_of(CaseFile& file, const std::function<bool(double)>& watch);

// Puts the sentence behind the first, the verdict.
void add_to_head(const DesignedSupport& support, HeadCard& head);

// The figure, support.csv, the result for result.json.
Json document_support(const DesignedSupport& support, const ResultFolder& folder, Report& report);

}  // namespace delabole
