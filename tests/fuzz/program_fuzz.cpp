// What `delabole check` and `delabole run` do with a case, but for writing files: any case is refused with a CaseError
// or answered, and no answer is NaN. How cases are changed, what is left out and what was counted: README.md.
#include "cases/analysis.hpp"
#include "cases/case_writer.hpp"
#include "cases/impossible_case.hpp"
#include "cases/stepped_base_bound.hpp"
#include "dynamic_relaxation/relaxation_study.hpp"

#include "case_mutator.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <string>
#include <string_view>

namespace {

using delabole::CaseModel;

constexpr double most_blocks = 150;
constexpr double most_steps = 200;

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

// Of the case's seconds to hours of work as many steps as a few milliseconds allow; false where nothing limits it.
bool limit_work(CaseModel& model) {
    if (auto* study = std::get_if<delabole::RelaxationStudy>(&model)) {
        auto& settings = study->settings ? *study->settings : study->settings.emplace();
        settings.most_steps = std::min(settings.most_steps.value_or(most_steps), most_steps);
        return static_cast<double>(number_of_blocks(*study)) <= most_blocks;
    }
    const auto* columns = std::get_if<delabole::SteppedBaseStudy<>>(&model);
    return columns == nullptr || announcement(*columns).empty();
}

void require(bool kept, std::string_view promise, const std::string& about) {
    if (!kept) {
        std::cerr << promise << ": " << about << '\n';
        std::abort();
    }
}

void run(const delabole::CaseFile& file) {
    const delabole::Analysis analysis = analyse_model(file.model);
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
    try {
        // In a folder with the files that shipped cases name.
        delabole::CaseFile file =
            delabole::parse_case({reinterpret_cast<const char*>(data), size}, DELABOLE_CASES "/relaxation/fuzz.toml");
        try {
            refuse_impossible(file);
        } catch (const delabole::CaseError& error) {
            ++counts.impossible;
            require(error.what()[0] != '\0', "a refusal has words", file.title);
            return 0;
        }
        if (limit_work(file.model)) {
            run(file);
        } else {
            ++counts.not_run;
        }
    } catch (const delabole::CaseError& error) {
        ++counts.not_read;
        require(error.what()[0] != '\0', "a refusal has words", "");
    }
    return 0;
}
// NOLINTEND(readability-identifier-naming)
