// Accuracy against cost: one search is repeated at many numerical settings, varied one at a time about the case's own
// settings and in a few combinations. The result shows the error and the cost of each, and which settings no other one
// beats.
//
// The cost is a count of operations and so is the same on every machine; wall time is recorded but decides nothing.
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace delabole {

struct TradeParameter {
    std::string name;                     // "step_fraction"
    std::vector<double> levels;           // values that are tried
    double own = 0;                       // value in the case
    std::vector<std::string> words = {};  // of a setting by choice: the words for 0, 1, ...; empty for a number
};

struct TradeSetting {
    std::string group;           // "own", the name of the only setting that differs, or a name given by the caller
    std::vector<double> values;  // of the settings in TradeProblem::parameters, in that order
};

inline constexpr std::string_view own_group = "own";

// The case's own setting.
TradeSetting own_setting(const std::vector<TradeParameter>& parameters);

// Adds the case's own setting with the given changes and returns its index; names that are not among the parameters are
// ignored. A setting that is already there is not added again.
std::size_t add_setting(std::vector<TradeSetting>& settings, const std::vector<TradeParameter>& parameters,
                        const std::string& group, const std::vector<std::pair<std::string_view, double>>& changed);

// Adds every level of each parameter, with the others as in the case, unless it is already there.
void add_levels(std::vector<TradeSetting>& settings, const std::vector<TradeParameter>& parameters);

// A bracket of the value that is searched for.
struct TradeAnswer {
    std::string_view failure = {};  // why there is no answer; empty if there is one
    double stands = 0;              // the two ends of the bracket
    double fails = 0;
    double cost = 0;  // operations
    double steps = 0;
    double runs = 0;
    double wall_seconds = 0;
};

// Called with the share of the search done, 0 to 1. After it returns false the search ends with some failure.
using TradeWatch = std::function<bool(double share)>;

struct TradeProblem {
    std::vector<TradeParameter> parameters;
    std::vector<TradeSetting> settings;
    std::optional<double> truth;  // absent: the value found at `finest` is used, which then has no error of its own
    std::size_t finest = 0;       // index of a setting
    // Has no side effects and is safe to call from several threads.
    std::function<TradeAnswer(std::span<const double> values, const TradeWatch& watch)> answer;
    // Relative cost, used for the time left; positive.
    std::function<double(std::span<const double> values)> expected_cost;
    int threads = 1;  // >= 1; no result but the wall time depends on it
};

struct TradeRow {
    TradeSetting setting;
    TradeAnswer answer;
    std::optional<double> error = {};  // middle of the bracket less the truth; absent: no answer, or no truth
    double error_bound = 0;            // of the more distant end of the bracket, so that it is not small by chance
    bool on_front = false;             // no setting is both cheaper and at least as accurate
};

// nothing_to_compare: no setting has both an answer and a truth to compare it with.
enum class TradeStatus { finished, interrupted, nothing_to_compare };

struct TradeResult {
    TradeStatus status = TradeStatus::finished;
    std::optional<double> truth = {};
    std::vector<TradeRow> rows = {};  // of the settings that were finished, in their order
};

// Called with the share of the expected cost done and the number of settings finished, never by two threads at once.
using TradeProgress = std::function<void(double share, std::size_t finished)>;

// Settings whose search was under way when `interrupted` was set are left out.
TradeResult trade(const TradeProblem& problem, const TradeProgress& progress, const std::atomic<bool>& interrupted);

// Rows of the front by increasing cost.
std::vector<std::size_t> front_of(const TradeResult& result);

// The most accurate row of each decade of cost, the cheapest of equals; in order of cost.
std::vector<std::size_t> best_of_each_decade(const TradeResult& result);

// A level as text: "0.4", "dropped".
std::string level_in_words(const TradeParameter& parameter, double level);
// The parameters that differ from the case, "stiffness_ratio 1e7, start dropped"; empty if none does.
std::string change_in_words(const std::vector<TradeParameter>& parameters, const TradeSetting& setting);

}  // namespace delabole
