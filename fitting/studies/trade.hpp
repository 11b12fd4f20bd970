// Accuracy against cost: one search repeated at many settings of its numerical knobs, each knob alone around the case's
// own settings and a few corners; how far each answer is off, what it cost, and which settings no other beats.
//
// The cost is a count of operations and so the same on every machine; wall time is carried along, and decides nothing.
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

struct TradeKnob {
    std::string name;                     // "step_fraction"
    std::vector<double> levels;           // tried
    double own = 0;                       // in the case
    std::vector<std::string> words = {};  // of a choice: what 0, 1, ... stand for; empty for a number
};

struct TradeSetting {
    std::string group;           // "own", the name of the knob that alone is different, or as the caller names it
    std::vector<double> values;  // of the knobs, in their order
};

inline constexpr std::string_view own_group = "own";

// The case's own setting.
TradeSetting own_setting(const std::vector<TradeKnob>& knobs);

// The case's own setting with these knobs changed; names that are not among the knobs are passed over. A setting that
// is there already is not added again. Returns its index.
std::size_t add_setting(std::vector<TradeSetting>& settings, const std::vector<TradeKnob>& knobs,
                        const std::string& group, const std::vector<std::pair<std::string_view, double>>& changed);

// Every level of each knob, the others as in the case, where it is not there already.
void add_levels(std::vector<TradeSetting>& settings, const std::vector<TradeKnob>& knobs);

// A bracket of the value that is searched.
struct TradeAnswer {
    std::string_view failure = {};  // why there is none; empty where there is one
    double stands = 0;              // its two ends
    double fails = 0;
    double cost = 0;  // operations
    double steps = 0;
    double runs = 0;
    double wall_seconds = 0;
};

// Gives the search's share done, 0 to 1; the search ends with any failure once it returns false.
using TradeWatch = std::function<bool(double share)>;

struct TradeProblem {
    std::vector<TradeKnob> knobs;
    std::vector<TradeSetting> settings;
    std::optional<double> truth;  // absent: the value found at `finest`, which then has no error of its own
    std::size_t finest = 0;       // index of a setting
    // Pure and safe to call from several threads.
    std::function<TradeAnswer(std::span<const double> values, const TradeWatch& watch)> answer;
    // Relative, for the time left; positive.
    std::function<double(std::span<const double> values)> expected_cost;
    int threads = 1;  // >= 1; no result but the wall time depends on it
};

struct TradeRow {
    TradeSetting setting;
    TradeAnswer answer;
    std::optional<double> error = {};  // middle of the bracket less the truth; absent: no answer, or nothing to compare
    double error_bound = 0;            // of the end of the bracket that is farther off: no luck makes it small
    bool on_front = false;             // no setting is both cheaper and at least as accurate
};

// nothing_to_compare: no setting has both an answer and something to hold it against.
enum class TradeStatus { finished, interrupted, nothing_to_compare };

struct TradeResult {
    TradeStatus status = TradeStatus::finished;
    std::optional<double> truth = {};
    std::vector<TradeRow> rows = {};  // of the settings that were finished, in their order
};

// Called with the share of the expected cost done and the number of settings finished, never from two threads at once.
using TradeProgress = std::function<void(double share, std::size_t finished)>;

// The settings whose search was under way when `interrupted` was set are left out.
TradeResult trade(const TradeProblem& problem, const TradeProgress& progress, const std::atomic<bool>& interrupted);

// Rows of the front, from the cheapest on.
std::vector<std::size_t> front_of(const TradeResult& result);

// The most accurate row of each decade of cost, the cheapest of equals; from the cheapest decade on.
std::vector<std::size_t> best_of_each_decade(const TradeResult& result);

// "0.4", "dropped".
std::string level_in_words(const TradeKnob& knob, double level);
// The knobs that differ from the case: "stiffness_ratio 1e7, start dropped"; empty where none does.
std::string change_in_words(const std::vector<TradeKnob>& knobs, const TradeSetting& setting);

}  // namespace delabole
