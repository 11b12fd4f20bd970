#include "cases/program/reports/fit_parts.hpp"

#include "fitting/work/words.hpp"
#include "plots/drawing/text.hpp"

#include <algorithm>
#include <functional>
#include <utility>

namespace delabole {

const ProfileLikelihood* profile_of(const MechanismFit& fit, const std::string& parameter, bool with_priors) {
    const auto found = std::ranges::find_if(fit.profiles, [&](const ProfileLikelihood& profile) {
        return profile.parameter == parameter && profile.with_priors == with_priors;
    });
    return found == fit.profiles.end() ? nullptr : &*found;
}

std::string interval_in_words(const ProfileLikelihood* profile, const FreeParameter& parameter, Dimension dimension) {
    if (profile == nullptr) {
        return "";
    }
    const auto end = [&](double value, double bound) {
        return value_in_words(value, dimension) + (value == bound ? " (bound)" : "");
    };
    return end(profile->interval_95.lower, parameter.lower) + " to " + end(profile->interval_95.upper, parameter.upper);
}

std::string misfit_in_words(double misfit) {
    constexpr double unseen = 1e-6;  // a thousandth of a standard deviation
    return misfit < unseen ? "0" : number_in_words(misfit);
}

std::string title_of(const MechanismFit& fit) {
    return fit.title.empty() ? fit.name : fit.title;
}

std::string short_name(const MechanismFit& fit, const std::string& name) {
    const std::string ending = name.substr(name.rfind('.') + 1);
    const auto alike = std::ranges::count_if(fit.parameters, [&](const FreeParameter& parameter) {
        return parameter.name == ending || parameter.name.ends_with("." + ending);
    });
    return human_name(alike == 1 ? ending : name);
}

std::string screen_of(const Table& table, std::vector<std::string> titles) {
    std::vector<std::vector<std::string>> rows = {std::move(titles)};
    rows.insert(rows.end(), table.rows.begin(), table.rows.end());
    for (std::vector<std::string>& row : rows) {
        row.front().insert(0, "  ");
    }
    return table.rows.empty() ? "" : text_table(rows);
}

namespace {

// Returns the verdict, in sentences that begin with a capital, with the names that the sentence on the values uses.
std::string verdict_in_short_names(const MechanismFit& fit) {
    std::vector<std::string> names;
    for (const FreeParameter& parameter : fit.parameters) {
        names.push_back(parameter.name);
    }
    // Longer names come first, since a name may begin like another one.
    std::ranges::sort(names, std::greater{}, [](const std::string& name) { return name.size(); });
    const std::string& verdict = fit.identifiability.verdict;
    std::string text;
    for (std::size_t place = 0; place < verdict.size();) {
        const auto name = std::ranges::find_if(
            names, [&](const std::string& one) { return verdict.compare(place, one.size(), one) == 0; });
        if (name == names.end()) {
            text += verdict[place++];
            continue;
        }
        const std::string own = short_name(fit, *name);
        text += text.empty() || text.ends_with(". ") ? capitalised(own) : own;
        place += name->size();
    }
    return text;
}

std::string determined_in_words(const MechanismFit& fit) {
    const std::size_t count = fit.parameters.size();
    const auto rank = static_cast<std::size_t>(fit.identifiability.rank);
    if (count == 1) {
        return rank == 1 ? "The data determine its parameter near the best point"
                         : "The data do not determine its parameter";
    }
    const std::string what = rank >= count ? "all"
                             : rank == 0   ? "none"
                             : rank == 1   ? "one combination"
                                           : std::to_string(rank) + " combinations";
    return "The data determine " + what + " of its " + std::to_string(count) + " parameters" +
           (rank >= count ? " near the best point" : "");
}

// "30.9 deg to 39.6 deg" or "at most 12.1 kPa": an end at a bound of the search is not stated.
std::string range_in_words(const ProfileLikelihood* profile, const FreeParameter& parameter, Dimension dimension) {
    if (profile == nullptr) {
        return "";
    }
    const double lower = profile->interval_95.lower;
    const double upper = profile->interval_95.upper;
    const bool from_bound = lower == parameter.lower;
    const bool to_bound = upper == parameter.upper;
    if (from_bound && to_bound) {
        return "anywhere within its bounds";
    }
    return (from_bound ? "at most " + value_in_words(upper, dimension)
            : to_bound ? "at least " + value_in_words(lower, dimension)
                       : value_in_words(lower, dimension) + " to " + value_in_words(upper, dimension)) +
           " with 95 %";
}

// Lists only the first parameters, because a case names the most important ones first.
std::string values_in_words(const MechanismFit& fit, std::size_t most) {
    std::vector<std::string> values;
    for (std::size_t index = 0; index < std::min(most, fit.best.size()); ++index) {
        const FreeParameter& parameter = fit.parameters[index];
        const std::string range =
            range_in_words(profile_of(fit, parameter.name, true), parameter, fit.dimensions[index]);
        values.push_back(short_name(fit, parameter.name) + " " +
                         value_in_words(fit.best[index], fit.dimensions[index]) +
                         (range.empty() ? "" : " (" + range + ")"));
    }
    return list_in_words(values);
}

}  // namespace

HeadCard head_card(const FitResult& result) {
    HeadCard head{AnswerTone::open, {}, {}};
    if (result.mechanisms.empty()) {
        return head;
    }
    const MechanismFit& best = result.mechanisms.front();
    const bool with_priors = std::ranges::any_of(
        best.parameters, [](const FreeParameter& parameter) { return parameter.prior.has_value(); });
    if (best.best.empty() && !best.parameters.empty()) {
        head.sentences.emplace_back("No mechanism has an answer within the bounds of its parameters.");
        return head;
    }
    if (result.mechanisms.size() == 1) {
        constexpr std::size_t most = 3;
        if (const std::string values = values_in_words(best, most); !values.empty()) {
            head.sentences.push_back("Best fit" + std::string(with_priors ? " with the priors" : "") + ": " + values +
                                     ".");
        }
        head.sentences.push_back(verdict_in_short_names(best));
        return head;
    }
    const std::string probability = probability_of_best(result);
    const std::string count = std::to_string(result.mechanisms.size());
    const std::string with_probability = probability.empty() ? "" : ", with a probability of " + probability;
    // If other priors would put another mechanism first, the first sentence says so and names no best explanation.
    if (const std::string others = first_under_other_priors(result); !others.empty()) {
        head.sentences.push_back("Which of the " + count + " compared explains best depends on what was put in: " +
                                 best.name + " as given" + with_probability + ", " + others + ".");
    } else {
        head.sentences.push_back("Best explanation of the " + count + " compared" + with_probability + ": " +
                                 title_of(best) + ".");
        if (const std::string dependence = dependence_of_ranking(result); !dependence.empty()) {
            head.sentences.push_back(dependence);
        }
    }
    const std::string values = values_in_words(best, 2);
    head.sentences.push_back(determined_in_words(best) +
                             (values.empty() ? ""
                              : with_priors  ? "; with the priors they give " + values
                                             : "; they give " + values) +
                             ".");
    return head;
}

}  // namespace delabole
