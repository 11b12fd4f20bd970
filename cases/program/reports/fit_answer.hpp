// The answer of a back-analysis in a few sentences, and what its report says of single mechanisms again and again.
#pragma once

#include "fitting/mechanism/fit_result.hpp"
#include "plots/report/report.hpp"

#include <string>

namespace delabole {

// Which mechanism explains the observations best, what the data determine of it, and its first parameters.
HeadCard head_card(const FitResult& result);

std::string title_of(const MechanismFit& fit);

// Nothing where the fit has no profile of that parameter.
const ProfileLikelihood* profile_of(const MechanismFit& fit, const std::string& parameter, bool with_priors);

// The 95 % interval, its ends marked where they are bounds of the search: those are no evidence.
std::string interval_in_words(const ProfileLikelihood* profile, const FreeParameter& parameter, Dimension dimension);

}  // namespace delabole
