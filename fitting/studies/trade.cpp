#include "fitting/studies/trade.hpp"

#include "fitting/work/parallel.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <mutex>
#include <numeric>

namespace delabole {

namespace {

// "1e7" or "0.05": the settings range over so many decades that plain digits would be hard to count.
std::string in_few_characters(double value) {
    std::array<char, 32> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
    std::string text(buffer.data(), end);
    for (const std::string_view sign : {"e+0", "e+", "e-0"}) {
        if (const std::size_t at = text.find(sign); at != std::string::npos) {
            text.replace(at, sign.size(), sign == "e-0" ? "e-" : "e");
        }
    }
    return text;
}

// Share of the expected cost that all searches together have done.
class TradeMeter {
  public:
    TradeMeter(const TradeProblem& problem, const TradeProgress& progress)
        : progress_(progress), share_(problem.settings.size()) {
        for (const TradeSetting& setting : problem.settings) {
            expected_.push_back(problem.expected_cost(setting.values));
        }
        total_ = std::accumulate(expected_.begin(), expected_.end(), 0.0);
    }

    void report(std::size_t setting, double share) {
        const std::lock_guard lock(mutex_);
        finished_ += share >= 1 && share_[setting] < 1 ? 1 : 0;
        share_[setting] = std::max(share_[setting], std::min(share, 1.0));
        if (progress_) {
            progress_(std::inner_product(share_.begin(), share_.end(), expected_.begin(), 0.0) / total_, finished_);
        }
    }

  private:
    const TradeProgress& progress_;
    std::vector<double> expected_ = {};
    std::vector<double> share_;
    double total_ = 0;
    std::size_t finished_ = 0;
    std::mutex mutex_ = {};
};

void compare(TradeRow& row, double truth) {
    if (row.answer.failure.empty()) {
        row.error = (row.answer.stands + row.answer.fails) / 2 - truth;
        row.error_bound = std::max(std::abs(row.answer.stands - truth), std::abs(row.answer.fails - truth));
    }
}

void mark_front(std::vector<TradeRow>& rows) {
    std::vector<TradeRow*> compared;
    for (TradeRow& row : rows) {
        if (row.error) {
            compared.push_back(&row);
        }
    }
    std::stable_sort(compared.begin(), compared.end(), [](const TradeRow* one, const TradeRow* other) {
        return std::pair(one->answer.cost, one->error_bound) < std::pair(other->answer.cost, other->error_bound);
    });
    const TradeRow* best = nullptr;
    for (TradeRow* row : compared) {
        if (best == nullptr || row->error_bound < best->error_bound) {
            row->on_front = true;
            best = row;
        }
    }
}

}  // namespace

TradeSetting own_setting(const std::vector<TradeParameter>& parameters) {
    TradeSetting own{std::string(own_group), {}};
    for (const TradeParameter& parameter : parameters) {
        own.values.push_back(parameter.own);
    }
    return own;
}

std::size_t add_setting(std::vector<TradeSetting>& settings, const std::vector<TradeParameter>& parameters,
                        const std::string& group, const std::vector<std::pair<std::string_view, double>>& changed) {
    TradeSetting setting = own_setting(parameters);
    setting.group = group;
    for (const auto& change : changed) {
        for (std::size_t index = 0; index < parameters.size(); ++index) {
            if (parameters[index].name == change.first) {
                setting.values[index] = change.second;
            }
        }
    }
    const auto same = std::find_if(settings.begin(), settings.end(),
                                   [&](const TradeSetting& other) { return other.values == setting.values; });
    const auto index = static_cast<std::size_t>(same - settings.begin());
    if (same == settings.end()) {
        settings.push_back(std::move(setting));
    }
    return index;
}

void add_levels(std::vector<TradeSetting>& settings, const std::vector<TradeParameter>& parameters) {
    for (const TradeParameter& parameter : parameters) {
        for (const double level : parameter.levels) {
            add_setting(settings, parameters, parameter.name, {{parameter.name, level}});
        }
    }
}

TradeResult trade(const TradeProblem& problem, const TradeProgress& progress, const std::atomic<bool>& interrupted) {
    const std::size_t count = problem.settings.size();
    std::vector<std::optional<TradeAnswer>> answers(count);
    TradeMeter meter(problem, progress);
    run_tasks(count, problem.threads, [&](std::size_t setting) {
        if (interrupted) {
            return;
        }
        const TradeAnswer answer = problem.answer(problem.settings[setting].values, [&](double share) {
            meter.report(setting, std::min(share, 0.999));
            return !interrupted;
        });
        // A search that had its answer when the interrupt came counts as finished.
        if (answer.failure.empty() || !interrupted) {
            answers[setting] = answer;
            meter.report(setting, 1);
        }
    });

    TradeResult result;
    result.truth = problem.truth;
    if (const auto& finest = answers[problem.finest]; !result.truth && finest && finest->failure.empty()) {
        result.truth = (finest->stands + finest->fails) / 2;
    }
    for (std::size_t setting = 0; setting < count; ++setting) {
        if (!answers[setting]) {
            result.status = TradeStatus::interrupted;
            continue;
        }
        TradeRow row{problem.settings[setting], *answers[setting]};
        if (result.truth && (problem.truth || setting != problem.finest)) {
            compare(row, *result.truth);
        }
        result.rows.push_back(std::move(row));
    }
    mark_front(result.rows);
    const bool compared =
        std::any_of(result.rows.begin(), result.rows.end(), [](const TradeRow& row) { return row.error.has_value(); });
    if (result.status == TradeStatus::finished && !compared) {
        result.status = TradeStatus::nothing_to_compare;
    }
    return result;
}

std::vector<std::size_t> front_of(const TradeResult& result) {
    std::vector<std::size_t> front;
    for (std::size_t index = 0; index < result.rows.size(); ++index) {
        if (result.rows[index].on_front) {
            front.push_back(index);
        }
    }
    std::sort(front.begin(), front.end(), [&](std::size_t one, std::size_t other) {
        return result.rows[one].answer.cost < result.rows[other].answer.cost;
    });
    return front;
}

std::vector<std::size_t> best_of_each_decade(const TradeResult& result) {
    std::map<double, std::size_t> best;
    for (std::size_t index = 0; index < result.rows.size(); ++index) {
        const TradeRow& row = result.rows[index];
        if (!row.error) {
            continue;
        }
        const auto [found, added] = best.try_emplace(std::floor(std::log10(std::max(row.answer.cost, 1.0))), index);
        const TradeRow& other = result.rows[found->second];
        if (!added && std::pair(row.error_bound, row.answer.cost) < std::pair(other.error_bound, other.answer.cost)) {
            found->second = index;
        }
    }
    std::vector<std::size_t> rows;
    rows.reserve(best.size());
    for (const auto& entry : best) {
        rows.push_back(entry.second);
    }
    return rows;
}

std::string level_in_words(const TradeParameter& parameter, double level) {
    const auto index = static_cast<std::size_t>(level);
    return index < parameter.words.size() ? parameter.words[index] : in_few_characters(level);
}

std::string change_in_words(const std::vector<TradeParameter>& parameters, const TradeSetting& setting) {
    std::string text;
    for (std::size_t index = 0; index < parameters.size(); ++index) {
        const TradeParameter& parameter = parameters[index];
        if (setting.values[index] != parameter.own) {
            text +=
                (text.empty() ? "" : ", ") + parameter.name + ' ' + level_in_words(parameter, setting.values[index]);
        }
    }
    return text;
}

}  // namespace delabole
