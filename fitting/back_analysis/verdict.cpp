#include "fitting/back_analysis/verdict.hpp"

#include "fitting/probability/estimate.hpp"
#include "fitting/work/words.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace delabole {

namespace {

constexpr double untouched_below = 1e-6;  // standard deviations of data over the whole range
constexpr double hardly_below = 0.5;      // standard deviations of data over the whole range
constexpr double far_off = 4;             // standard deviations of data
constexpr double involved_above = 0.05;   // share of a unit vector in the directions that the data do not see

using Places = std::vector<Eigen::Index>;

struct Sorted {
    Places untouched;
    Places determined;
    Places involved;
    Places missed;  // would be determined, but the data that depend on them are missed

    // The number of combinations of the involved ones that the data determine.
    int combinations(int rank) const { return rank - static_cast<int>(determined.size() + missed.size()); }
};

double effect_of(const Identifiability& facts, Eigen::Index place) {
    const Eigen::Map<const Eigen::VectorXd> values(facts.singular_values.data(), std::ssize(facts.singular_values));
    return facts.directions.row(place).cwiseProduct(values.transpose()).norm();
}

Sorted sorted_by_determination(const Identifiability& facts) {
    Sorted result;
    const auto count = static_cast<Eigen::Index>(facts.parameters.size());
    const auto far_from_data = [&](Eigen::Index place) {
        return facts.misses[static_cast<std::size_t>(place)] > far_off;
    };
    const Eigen::MatrixXd hidden = facts.directions.rightCols(count - facts.rank);
    for (Eigen::Index place = 0; place < count; ++place) {
        if (effect_of(facts, place) < untouched_below) {
            result.untouched.push_back(place);
        } else if (hidden.cols() > 0 && hidden.row(place).norm() > involved_above) {
            result.involved.push_back(place);
        } else {
            (far_from_data(place) ? result.missed : result.determined).push_back(place);
        }
    }
    // A combination is worth no more if data that are missed determine it.
    if (std::ranges::any_of(result.involved, far_from_data)) {
        result.missed.insert(result.missed.end(), result.involved.begin(), result.involved.end());
        result.involved.clear();
    }
    return result;
}

class Words {
  public:
    Words(const Identifiability& identifiability, const VerdictQuestion& question)
        : facts_(identifiability), question_(question) {}

    std::string all() const;

  private:
    std::string doubt() const;
    std::string combination(const Places& involved, int known) const;
    std::string missed(const Places& places) const;
    double miss(Eigen::Index place) const { return facts_.misses[static_cast<std::size_t>(place)]; }
    std::string exchange_rates(const Places& involved) const;
    std::string common_change(const Places& involved) const;
    std::string priors() const;
    Eigen::MatrixXd unseen() const { return facts_.directions.rightCols(count() - facts_.rank); }
    Eigen::Index count() const { return static_cast<Eigen::Index>(facts_.parameters.size()); }
    const std::string& name(Eigen::Index place) const { return facts_.parameters[static_cast<std::size_t>(place)]; }
    std::string names(const Places& places) const;
    std::string change(Eigen::Index place, double scaled) const;
    double round_step(Eigen::Index place) const;

    const Identifiability& facts_;
    const VerdictQuestion& question_;
};

std::string Words::names(const Places& places) const {
    std::vector<std::string> items;
    for (const Eigen::Index place : places) {
        items.push_back(name(place));
    }
    return list_in_words(items);
}

// "a rise of 0.043", "a fall of 3 deg"; `scaled` is a share of the range.
std::string Words::change(Eigen::Index place, double scaled) const {
    const double value = scaled * question_.ranges[place];
    return (value < 0 ? "a fall of " : "a rise of ") +
           value_in_words(std::abs(value), question_.dimensions[static_cast<std::size_t>(place)]);
}

// A round step, as a share of the range: one display unit or, for a range shorter than two units, the power of ten that
// fits into it at least twice.
double Words::round_step(Eigen::Index place) const {
    const double unit = shown_unit(question_.dimensions[static_cast<std::size_t>(place)]).si_per_unit;
    const double range = question_.ranges[place] / unit;
    const double step = range >= 2 ? 1.0 : std::pow(10.0, std::floor(std::log10(range / 2)));
    return step / range;
}

// If one combination of several parameters is known, a change of one of them can be offset by another.
std::string Words::exchange_rates(const Places& involved) const {
    Eigen::MatrixXd hidden(static_cast<Eigen::Index>(involved.size()), count() - facts_.rank);
    for (std::size_t row = 0; row < involved.size(); ++row) {
        hidden.row(static_cast<Eigen::Index>(row)) = unseen().row(involved[row]);
    }
    // The direction that the data determine is the one with the least part in the hidden directions.
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(hidden * hidden.transpose());
    const Eigen::VectorXd seen = solver.eigenvectors().col(0);
    const double step = round_step(involved[0]);
    std::vector<std::string> rates;
    for (Eigen::Index other = 1; other < seen.size(); ++other) {
        const Eigen::Index place = involved[static_cast<std::size_t>(other)];
        const double offset = -seen[0] / seen[other] * step;
        if (std::isfinite(offset)) {
            rates.push_back(change(place, offset) + " in " + name(place));
        }
    }
    std::string text;
    for (std::size_t index = 0; index < rates.size(); ++index) {
        text += (index == 0 ? "" : ", or by ") + rates[index];
    }
    const std::string line = question_.only_failure_observed ? "the line FS = 1" : "the valley of least misfit";
    return "along " + line + " " + change(involved[0], step) + " in " + name(involved[0]) + " is offset by " + text;
}

// The change of several parameters together along the one direction that the data do not determine.
std::string Words::common_change(const Places& involved) const {
    const Eigen::VectorXd direction = unseen().col(0);
    const double step = round_step(involved[0]) / direction[involved[0]];
    std::vector<std::string> changes;
    for (const Eigen::Index place : involved) {
        changes.push_back(change(place, step * direction[place]) + " in " + name(place));
    }
    return list_in_words(changes) + " together leave the predictions as they are";
}

std::string Words::combination(const Places& involved, int known) const {
    if (involved.empty()) {
        return {};
    }
    if (known <= 0) {
        return names(involved) +
               ": hardly any effect on what was observed near the best point (at that rate less than half a standard "
               "deviation over " +
               (involved.size() == 1 ? "its range)." : "their ranges).");
    }
    if (known == 1 && involved.size() > 1) {
        return names(involved) + ": only one combination is determined: " + exchange_rates(involved) + ".";
    }
    std::string text = names(involved) + ": only " + std::to_string(known) + " combinations of these " +
                       std::to_string(involved.size()) + " are determined";
    if (count() - facts_.rank == 1 && std::abs(unseen()(involved[0], 0)) > untouched_below) {
        text += ": " + common_change(involved);
    }
    return text + ".";
}

std::string Words::missed(const Places& places) const {
    double greatest = 0;
    for (const Eigen::Index place : places) {
        greatest = std::max(greatest, miss(place));
    }
    return names(places) + ": not determined: the best fit misses the data that depend on " +
           (places.size() == 1 ? "it" : "them") + " by up to " + number_in_words(greatest) + " standard deviations.";
}

std::string Words::doubt() const {
    switch (facts_.status) {
    case IdentifiabilityStatus::steps_disagree:
        return "Doubtful: the sensitivities at the best point change with the size of the step.";
    case IdentifiabilityStatus::model_fails_nearby:
        return "Doubtful: the model has no answer next to the best point.";
    case IdentifiabilityStatus::run_contradicts:
        return "Nothing is determined: the run at the best point contradicts the surrogate that was fitted in place of "
               "the model.";
    case IdentifiabilityStatus::not_evaluated:
        return "Not evaluated.";
    case IdentifiabilityStatus::reliable:
        break;
    }
    return {};
}

std::string Words::priors() const {
    const auto open = static_cast<int>(count()) - facts_.rank;
    if (open == 0) {
        return {};
    }
    if (!question_.has_priors) {
        return "There are no priors: fitted values of parameters that are not determined are one choice out of many.";
    }
    const auto still_open = static_cast<int>(count()) - facts_.rank_with_priors;
    if (still_open == 0) {
        return "The priors settle what the data leave open: the fitted values are a compromise that depends on "
               "them.";
    }
    const std::string of_all = " of " + std::to_string(count());
    return "Even with the priors " + std::to_string(still_open) +
           (still_open == 1 ? " direction" + of_all + " stays" : " directions" + of_all + " stay") +
           " open: the fitted values are one choice out of many.";
}

std::string Words::all() const {
    if (count() == 0) {
        return "No free parameters: nothing to identify.";
    }
    if (facts_.status == IdentifiabilityStatus::not_evaluated ||
        facts_.status == IdentifiabilityStatus::run_contradicts) {
        return doubt();
    }
    const Sorted sorted = sorted_by_determination(facts_);
    std::vector<std::string> sentences = {doubt()};
    if (!sorted.untouched.empty()) {
        sentences.push_back("Nothing observed depends on " + names(sorted.untouched) + " near the best point.");
    }
    if (!sorted.determined.empty()) {
        sentences.push_back(names(sorted.determined) + ": determined by the data.");
    }
    if (!sorted.missed.empty()) {
        sentences.push_back(missed(sorted.missed));
    }
    sentences.push_back(combination(sorted.involved, sorted.combinations(facts_.rank)));
    sentences.push_back(priors());
    std::string text;
    for (const std::string& sentence : sentences) {
        text += (text.empty() || sentence.empty() ? "" : " ") + sentence;
    }
    return text;
}

std::string limited_all_the_same(const Identifiability& identifiability,
                                 const std::vector<ProfileLikelihood>& profiles) {
    std::vector<std::string> limited;
    for (std::size_t place = 0; place < identifiability.parameters.size(); ++place) {
        const auto limits = [&](const ProfileLikelihood& profile) {
            return profile.parameter == identifiability.parameters[place] && !profile.with_priors &&
                   profile.determination != Determination::undetermined;
        };
        if (effect_of(identifiability, static_cast<Eigen::Index>(place)) < hardly_below &&
            std::ranges::any_of(profiles, limits)) {
            limited.push_back(identifiability.parameters[place]);
        }
    }
    return limited.empty() ? ""
                           : " That holds near the best point only: over the whole range the data alone limit " +
                                 list_in_words(limited) + " (95 % range from the data alone).";
}

// Names the parameters whose 95 % interval holds values that the data exclude.
std::string several_solutions(const std::vector<ProfileLikelihood>& profiles) {
    std::vector<std::string> split;
    for (const ProfileLikelihood& profile : profiles) {
        const double quantile = chi_square_quantile(0.95, 1);
        const auto possible = [&](double misfit) { return misfit <= profile.least_misfit + quantile; };
        // Twice the level: the points of a profile scatter where the model is rough.
        const auto excluded = [&](double misfit) {
            return std::isfinite(misfit) && misfit > profile.least_misfit + 2 * quantile;
        };
        const auto first = std::ranges::find_if(profile.misfits, possible);
        const auto last = std::find_if(profile.misfits.rbegin(), profile.misfits.rend(), possible).base();
        if (!profile.with_priors && first < last && std::any_of(first, last, excluded)) {
            split.push_back(profile.parameter);
        }
    }
    return split.empty() ? ""
                         : " There is more than one solution: the 95 % interval of " + list_in_words(split) +
                               " holds values that the data exclude.";
}

}  // namespace

std::string verdict(const Identifiability& identifiability, const VerdictQuestion& question) {
    return Words(identifiability, question).all();
}

bool in_doubt(const Identifiability& identifiability, const std::string& parameter) {
    if (identifiability.status == IdentifiabilityStatus::run_contradicts) {
        return true;
    }
    const auto found = std::ranges::find(identifiability.parameters, parameter);
    const auto place = static_cast<std::size_t>(found - identifiability.parameters.begin());
    return place < identifiability.misses.size() && identifiability.misses[place] > far_off;
}

std::vector<std::string> exchangeable(const Identifiability& identifiability) {
    std::vector<std::string> names;
    if (identifiability.singular_values.empty()) {
        return names;
    }
    const Sorted sorted = sorted_by_determination(identifiability);
    if (sorted.combinations(identifiability.rank) > 0) {
        for (const Eigen::Index place : sorted.involved) {
            names.push_back(identifiability.parameters[static_cast<std::size_t>(place)]);
        }
    }
    return names;
}

std::string doubt_from_profiles(const Identifiability& identifiability,
                                const std::vector<ProfileLikelihood>& profiles) {
    if (identifiability.singular_values.empty()) {
        return {};
    }
    if (identifiability.rank < static_cast<int>(identifiability.parameters.size())) {
        return limited_all_the_same(identifiability, profiles);
    }
    std::vector<std::string> open;
    for (const ProfileLikelihood& profile : profiles) {
        if (!profile.with_priors && profile.determination != Determination::determined) {
            open.push_back(profile.parameter);
        }
    }
    if (open.empty()) {
        return several_solutions(profiles);
    }
    return " That holds near the best point only: over the whole range the data alone close no 95 % interval for " +
           list_in_words(open) + ", and the fitted values depend on the priors.";
}

}  // namespace delabole
