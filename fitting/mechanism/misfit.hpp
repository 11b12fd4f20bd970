// The misfit between one mechanism's predictions and the evidence, as defined in fit_problem.hpp.
//
// Names are resolved to indices once. The model is evaluated once per parameter vector for each distinct set of
// conditions. Observations of quantities that the model lacks, or with conditions on inputs that it lacks, are left out
// of the misfit and reported by not_compared().
#pragma once

#include "fitting/mechanism/fit_result.hpp"
#include "fitting/mechanism/input_binding.hpp"
#include "fitting/posterior/fit_problem.hpp"
#include "fitting/work/evaluation.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace delabole {

enum class Priors { counted, ignored };

struct MisfitParts {
    double data = 0;
    double prior = 0;
    std::string_view failure;  // why there is no misfit; owned by the model or by the Misfit
};

// (predicted - observed) / standard deviation of each datum. Profile samples are weighted so that their squares add up
// to the profile's part of the misfit. An equality with a prediction that scatters between slopes or loading paths is
// followed by a second residual, the cost of that scatter.
struct Residuals {
    std::vector<double> values;
    std::vector<bool> idle;       // true for a satisfied inequality, which adds nothing to the misfit
    std::vector<double> scatter;  // standard deviation between slopes or loading paths, added to that of the datum
    std::string_view failure;
};

// The observation that a residual belongs to.
struct Datum {
    std::string label;
    Relation relation;
    double standard_deviation;
    double share;  // of a datum: the samples of a profile share the weight of as many data as it has vertices
    bool cost;     // true for the cost of the scatter of a prediction

    bool operator==(const Datum&) const = default;
};

// The residual of a cost. If the real slope is one of several that scatter about the prediction, the normal
// density of the observation is lower by the factor below than without scatter. The factor is written as a square like
// all other residuals:
//     exp(-cost^2 / 2) = (standard deviation / hypot(standard deviation, scatter))^share.
double cost_of_scatter(double scatter, double standard_deviation, double share);

// Sum of squares of the residuals that are not idle; meaningful if there is no failure.
double data_misfit(const Residuals& residuals);

class Misfit {
  public:
    // Keeps references to both. Throws std::invalid_argument if check_problem finds a fault in the mechanism's names.
    // Evaluates the model at up to 16 points to learn whether it predicts a profile.
    Misfit(const Mechanism& mechanism, const FitProblem& problem);
    Misfit(const Misfit&) = delete;
    Misfit& operator=(const Misfit&) = delete;

    const Mechanism& mechanism() const { return mechanism_; }
    const FitProblem& problem() const { return problem_; }
    // Those of the problem, except where the mechanism states them in its own terms.
    const std::vector<QuantityObservation>& observations() const { return observations_; }
    const std::vector<Interval>& bounds() const { return bounds_; }
    std::vector<Dimension> dimensions() const;
    // Indices of the parameters with lower < upper.
    std::vector<std::size_t> free_parameters() const;
    bool has_priors() const;
    // The prior mean where there is one, moved into the bounds; otherwise the middle of the bounds.
    std::vector<double> centre() const;

    // All of the following take one number per parameter of the mechanism, SI.
    MisfitParts parts(std::span<const double> parameters) const;
    // The part of the priors alone; does not evaluate the model.
    double prior(std::span<const double> parameters) const;
    Evaluation value(std::span<const double> parameters, Priors priors) const;
    // The data's part; predictions are left out once it exceeds `most`.
    Evaluation value_of_data(std::span<const double> parameters, double most) const;
    Residuals residuals(std::span<const double> parameters) const;
    // The observation to which each residual belongs, in their order.
    std::vector<Datum> data() const;
    Prediction predict(std::span<const double> parameters) const;
    // One row per quantity observation of the problem, in its order.
    std::vector<ObservationFit> compare(std::span<const double> parameters) const;
    // Nothing if no profile is predicted.
    std::optional<ProfileFit> compare_profile(std::span<const double> parameters) const;

    // Logarithm of the factor by which the mechanism's own standard deviations of observed values raise the density of
    // these: data less precise than those of the problem make no mechanism more likely. Of data in terms of another
    // quantity densities cannot be compared; they count by their misfit alone.
    double log_own_precision() const { return log_own_precision_; }

    // How much the scatter of predictions lowers the logarithm of the likelihood if the mean agrees with the data.
    double scatter_cost(std::span<const double> parameters) const;

    // Index of an output of the model by name.
    std::optional<std::size_t> output(std::string_view name) const;
    int data_count() const;
    // Number of data left out; a profile counts with its number of vertices.
    int missing_count() const;
    // One sentence for each datum left out.
    std::vector<std::string> not_compared() const;

  private:
    struct ConditionSet {
        std::vector<Condition> conditions;
        InputBinding binding;
        std::vector<std::size_t> observations;  // indices into bound_
    };
    struct BoundObservation {
        std::size_t observation;  // index into observations_
        std::size_t output;
        std::vector<std::size_t> scatter;  // the outputs that give scatter as standard deviations
        std::string not_a_number;          // text of the failure if the output has no value
    };
    struct Unbound {
        std::size_t observation;
        std::string reason;
    };

    std::optional<std::size_t> input(std::string_view name) const;
    void bind_observations();
    std::size_t condition_set(const std::vector<Condition>& conditions);
    void find_out_about_profile();
    Prediction predict(const ConditionSet& set, std::span<const double> parameters) const;
    template <class Visitor, class Enough>
    std::string_view visit_residuals(std::span<const double> parameters, const Visitor& visit,
                                     const Enough& enough) const;
    template <class Visitor>
    std::string_view visit_quantities(const ConditionSet& set, const Prediction& prediction,
                                      const Visitor& visit) const;
    template <class Visitor>
    std::string_view visit_profile(const Prediction& prediction, const Visitor& visit) const;

    const Mechanism& mechanism_;
    const FitProblem& problem_;
    std::vector<QuantityObservation> observations_;
    double log_own_precision_ = 0;
    std::vector<Interval> bounds_;
    std::vector<ConditionSet> sets_;  // the first has no conditions
    std::vector<BoundObservation> bound_;
    std::vector<Unbound> unbound_;
    Polyline profile_samples_;
    std::vector<std::size_t> profile_scatter_;
    bool compares_profile_ = false;
};

}  // namespace delabole
