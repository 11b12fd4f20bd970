#include "cases/program/models/relaxation/ensemble_report.hpp"

#include "cases/program/models/relaxation/critical_report.hpp"
#include "cases/program/reader/units.hpp"
#include "cases/program/results/model_reports.hpp"
#include "fitting/work/words.hpp"
#include "plots/drawing/text.hpp"

#include <algorithm>

namespace delabole {

namespace {

// "3 of the 16 slopes of the ensemble"
std::string of_the_slopes(const RelaxationStudy& study, double number) {
    return number_in_words(number) + " of the " + number_in_words(study.ensemble->runs) + " slopes of the ensemble";
}

// "factor of safety"
std::string value_name(const CriticalPlan& plan) {
    return plan.parameter == CriticalParameter::strength_reduction ? "factor of safety"
                                                                   : human_name(name_of_critical(plan.parameter));
}

std::string side_of_mean(const MembersAtBounds& members) {
    return members.lower > 0 && members.upper > 0 ? ", with slopes beyond either bound of the search taken at it"
           : members.lower > 0                    ? " or less"
           : members.upper > 0                    ? " or more"
                                                  : "";
}

// Warns of slopes whose search ended at one of its bounds.
void append_bound_warnings(const RelaxationStudy& study, const RelaxationStudyAnswer& answer, Analysis& analysis) {
    const CriticalPlan& plan = *answer.plan;
    const MembersAtBounds& members = *answer.ensemble->at_bounds;
    const auto warn = [&](double number, bool is_lower) {
        if (number == 0) {
            return;
        }
        const bool one = number == 1;
        const bool fails = is_lower == plan.stands_low();
        const std::string does = fails ? (one ? " fails" : " fail") : (one ? " stands" : " stand");
        analysis.warnings.push_back(
            of_the_slopes(study, number) + does + " even at " + (is_lower ? "critical.lower, " : "critical.upper, ") +
            value_in_words(is_lower ? plan.lower : plan.upper, dimension_of(plan.parameter)) + ", and " +
            (one ? "is" : "are") + " taken at it: the mean " + value_name(plan) +
            (members.lower > 0 && members.upper > 0 ? " is neither at most nor at least what is given"
             : is_lower                             ? " is at most what is given"
                                                    : " is at least what is given"));
    };
    warn(members.lower, true);
    warn(members.upper, false);
}

}  // namespace

void take_means(const RelaxationStudy& study, const RelaxationStudyAnswer& answer, Analysis& analysis) {
    const std::vector<Quantity> quantities = model_interface(study).outputs;
    const std::vector<double> means = prediction_of(*answer.ensemble).outputs;
    for (std::size_t index = 0; index < quantities.size(); ++index) {
        const Quantity& quantity = quantities[index];
        const auto known = std::ranges::find(analysis.outputs, quantity.name, &NamedOutput::name);
        if (known != analysis.outputs.end()) {
            known->value = means[index];
        } else {
            const bool told = quantity.name.ends_with(".profile") ||
                              quantity.name.ends_with("post_failure.failed_area") ||
                              quantity.name == "ensemble_failing_share";
            analysis.outputs.push_back({quantity.name, quantity.meaning, quantity.dimension, means[index], !told});
        }
    }
    if (const double number = answer.ensemble->without_answer; number > 0) {
        analysis.warnings.push_back(of_the_slopes(study, number) + (number == 1 ? " has" : " have") +
                                    " no answer and " + (number == 1 ? "is" : "are") + " left out of its means");
    }
    if (answer.ensemble->at_bounds) {
        append_bound_warnings(study, answer, analysis);
        if (const std::string words = search_in_words(*answer.plan, *answer.critical); !words.empty()) {
            analysis.warnings.push_back("as drawn, " + words);
        }
    }
}

std::string ensemble_failure_in_words(const RelaxationStudyAnswer& answer) {
    const EnsemblePrediction& ensemble = *answer.ensemble;
    if (ensemble.failure == word_of(RelaxationOutcome::interrupted)) {
        return "the work ended among the slopes of the ensemble";
    }
    if (ensemble.failure == slopes_without_answer) {
        return "more than a quarter of the ensemble's slopes have no answer; the first of them: " +
               human_name(ensemble.first_cause);
    }
    return search_in_words(*answer.plan, *answer.critical) + "; so it is with every other slope of the ensemble";
}

std::optional<double> mean_critical(const RelaxationStudy& study, const RelaxationStudyAnswer& answer) {
    if (!answer.plan) {
        return std::nullopt;
    }
    const auto place = place_of(model_interface(study).outputs, name_of_critical(answer.plan->parameter));
    return answer.ensemble->mean[place.value()];
}

std::string ensemble_in_words(const RelaxationStudy& study, const RelaxationStudyAnswer& answer) {
    const EnsemblePrediction& ensemble = *answer.ensemble;
    const std::string number = ensemble.failing == 0                   ? "none"
                               : ensemble.failing == ensemble.answered ? "all"
                                                                       : number_in_words(ensemble.failing);
    const auto failing_of = [&](const std::string& whose) {
        return number + " of " + whose + ' ' + number_in_words(ensemble.answered) + " slopes " +
               (ensemble.failing <= 1 ? "fails" : "fail") + " at the given strength.";
    };
    const std::optional<double> mean = mean_critical(study, answer);
    if (!mean) {
        return "This is the slope as drawn; " + failing_of("the ensemble's");
    }
    const CriticalParameter parameter = answer.plan->parameter;
    return "The mean of the ensemble is " +
           (parameter == CriticalParameter::strength_reduction ? factor_in_words(*mean)
                                                               : value_in_words(*mean, dimension_of(parameter))) +
           side_of_mean(*ensemble.at_bounds) + "; " + failing_of("its");
}

}  // namespace delabole
