// Checks and runs a case as `delabole check` and `delabole run` do, but writes no files: any case is refused with a
// CaseError or answered, and no answer is NaN. How cases are changed, what is left out and what was counted: README.md.
#include "cases/program/case/case_writer.hpp"
#include "cases/program/models/stepped_base/bound.hpp"
#include "cases/program/results/analysis.hpp"
#include "cases/program/results/problems_of_case.hpp"
#include "dynamic_relaxation/study/relaxation_study.hpp"
#include "numerics/fnv_1a.hpp"

#include "case_mutator.hpp"
#include "coverage.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <string>
#include <string_view>
#include <variant>

namespace {

using delabole::CaseModel;

// Limits the work that a case may make.
struct Allowance {
    double blocks = 40;
    double steps = 40;
    int runs = 4;            // of a search, including the one at the case's own values
    bool equations = false;  // a static start, else all loads come suddenly; a bound by linear programming
};

// The bytes of the case decide, so that the allowance is the same whenever the case is run.
Allowance allowance_of(std::string_view text) {
    constexpr std::uint64_t lots = 32;
    const std::uint64_t lot = delabole::fnv_1a(text) % lots;
    Allowance allowed;
    allowed.equations = lot == 0;
    if (lot == 1) {
        allowed.steps = 200;
        allowed.runs = 30;
    }
    return allowed;
}

struct Counts {
    long cases = 0;
    long not_read = 0;
    long impossible = 0;
    long not_run = 0;
    long answered = 0;
    long unfinished = 0;

    ~Counts() { print(); }
    void print() const {
        std::cerr << cases << " cases: " << not_read << " refused by the reader, " << impossible
                  << " by their model or study; " << answered << " answered, " << unfinished
                  << " ended before an answer, " << not_run << " checked alone\n";
    }
};

Counts counts;

// Returns false where nothing limits the work to milliseconds: such a case is checked, but not run.
bool limit_work(CaseModel& model, const Allowance& allowed) {
    if (auto* study = std::get_if<delabole::RelaxationStudy>(&model)) {
        auto& settings = study->settings ? *study->settings : study->settings.emplace();
        settings.most_steps = std::min(settings.most_steps.value_or(allowed.steps), allowed.steps);
        if (!allowed.equations) {
            settings.start = delabole::RelaxationStart::dropped;
            if (study->critical) {
                std::visit([](auto& search) { search.path = delabole::LoadingPath::sudden; }, *study->critical);
            }
        }
        return static_cast<double>(number_of_blocks(*study)) <= allowed.blocks;
    }
    auto* columns = std::get_if<delabole::SteppedBaseStudy<>>(&model);
    if (columns != nullptr && !allowed.equations) {
        columns->linear_programming_bound.reset();
    }
    return columns == nullptr || announcement(*columns).empty();
}

void require(bool kept, std::string_view promise, const std::string& about) {
    if (!kept) {
        std::cerr << promise << ": " << about << '\n';
        std::abort();
    }
}

void run(const delabole::CaseFile& file, const Allowance& allowed) {
    delabole::AnalysisWork work;
    int looks = 0;  // a run asks first before its first step
    work.watch = [&](double, const std::string&, bool) { return ++looks <= allowed.runs; };
    const delabole::Analysis analysis = analyse_model(file.model, work);
    if (!analysis.failure.empty()) {
        ++counts.impossible;
        require(!impossible(file, analysis.failure).message.empty(), "a refusal has words", analysis.failure);
        return;
    }
    for (const delabole::NamedOutput& output : analysis.outputs) {
        const auto* number = std::get_if<double>(&output.value);
        require(number == nullptr || !std::isnan(*number), "an answer is a number", output.name);
    }
    ++(analysis.unfinished.empty() ? counts.answered : counts.unfinished);
}

}  // namespace

// The names are libFuzzer's.
// NOLINTBEGIN(readability-identifier-naming)
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most,
                                               unsigned int seed) {
    return delabole::fuzzing::mutate_case(data, size, most, seed);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    constexpr long between_reports = 10'000;
    if (++counts.cases % between_reports == 0) {
        counts.print();
    }
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    const Allowance allowed = allowance_of(text);
    try {
        // This folder holds the files that shipped cases name.
        delabole::CaseFile file = delabole::parse_case(text, DELABOLE_CASES "/relaxation/fuzz.toml");
        const bool is_limited = limit_work(file.model, allowed);
        try {
            refuse_impossible(file);
        } catch (const delabole::CaseError& error) {
            ++counts.impossible;
            require(error.what()[0] != '\0', "a refusal has words", file.title);
            return 0;
        }
        if (is_limited) {
            run(file, allowed);
        } else {
            ++counts.not_run;
        }
    } catch (const delabole::CaseError& error) {
        ++counts.not_read;
        require(error.what()[0] != '\0', "a refusal has words", "");
        delabole::fuzzing::forget_what_was_reached();
    }
    return 0;
}
// NOLINTEND(readability-identifier-naming)
