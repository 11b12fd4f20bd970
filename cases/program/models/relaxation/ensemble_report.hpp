// The means of an ensemble of slopes in the report of the one as drawn.
#pragma once

#include "cases/program/results/analysis.hpp"
#include "cases/program/results/answers.hpp"
#include "dynamic_relaxation/study/relaxation_study.hpp"

#include <optional>
#include <string>

namespace delabole {

// The means of an ensemble take the place of the numbers of the slope as drawn; words, tables and figures remain those
// of that slope. Warnings tell which slopes the means leave out, or take at a bound.
void take_means(const RelaxationStudy& study, const RelaxationStudyAnswer& answer, Analysis& analysis);

// Why the ensemble has no means.
std::string ensemble_failure_in_words(const RelaxationStudyAnswer& answer);

// "The mean of the ensemble is FS 1.58 or less; 3 of its 16 slopes fail at the given strength."
std::string ensemble_in_words(const RelaxationStudy& study, const RelaxationStudyAnswer& answer);

// Mean of the value searched for; nothing without a search.
std::optional<double> mean_critical(const RelaxationStudy& study, const RelaxationStudyAnswer& answer);

}  // namespace delabole
