// A case: the contents of a *.toml file, checked and in SI.
#pragma once

#include "cases/program/case/model_list.hpp"
#include "cases/program/case/model_outputs.hpp"
#include "cases/program/case/sweep.hpp"
#include "cases/program/reader/case_error.hpp"
#include "cases/program/reader/document.hpp"
#include "cases/program/reader/section.hpp"
#include "cases/program/reader/units.hpp"
#include "fitting/posterior/fit_problem.hpp"
#include "fitting/sensitivity/sensitivity_problem.hpp"
#include "fitting/studies/support_design.hpp"
#include "fitting/work/words.hpp"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace delabole {

// The word after `model =` in a case, and all possible ones.
std::string_view model_name(const CaseModel& model);
std::vector<std::string> model_names();

// The numbers of a case's model by name, with dimension, range, meaning and value. A fit may free them, a condition may
// change them and `required` may solve for them. The numbers of a study (its searches) are not among them.
std::vector<Quantity> named_inputs(const CaseModel& model);

// One [[expect]]: a printed value to be compared with the computed one.
struct Expectation {
    std::string label;  // what is compared, for reports; empty: the quantity and its conditions
    std::string quantity;
    WrittenValue value;                        // a number, a quantity or a word such as an outcome's name
    std::optional<WrittenValue> tolerance;     // absolute, of the value's dimension
    std::optional<double> relative_tolerance;  // of the value
    std::vector<Condition> conditions;         // inputs that differ from the case's, SI
    std::string source;
    std::string note;
    std::optional<std::string> unreachable;   // why the value cannot be reached: it is shown but does not fail
    std::optional<Dimension> dimension = {};  // if the model lists the quantity; value and tolerance are then converted
    Place place = {};

    // A word has to be equal. Any other value has exactly one tolerance, unless it is unreachable.
    bool is_word() const;
    static constexpr auto fields() {
        return FieldTable{with_default(section<&Expectation::label>("what is compared, in words")),
                          section<&Expectation::quantity>("name of an output of the model"),
                          section<&Expectation::value>("the value to compare with"),
                          section<&Expectation::tolerance>("greatest difference that is met"),
                          number<&Expectation::relative_tolerance>(at_least(0), "the same, of the value"),
                          section("with", &Expectation::conditions, "inputs that differ from the case's"),
                          with_default(section<&Expectation::source>("where the value comes from")),
                          with_default(section<&Expectation::note>("what a reader should know of it")),
                          section<&Expectation::unreachable>("why the value cannot be reached")};
    }
};

struct FitMechanism : MechanismTask {
    CaseModel model = {};  // the case's model with the sections that the mechanism replaces, or a model of another kind
    std::optional<CaseModel> coarse = {};  // the mechanism's model with the sections that its coarse model replaces
};

// [fit], SI throughout.
struct CaseFit : FitTask {
    std::vector<FitMechanism> mechanisms;  // at least one; without [[fit.mechanism]] one with the model's name
};

// [report]
struct ReportSettings {
    UnitSystem units;
    static constexpr auto fields() {
        return FieldTable{section<&ReportSettings::units>("of sentences, tables and figures; CSV and JSON are metric")};
    }
};

struct CaseFile {
    std::string name;  // as given by the caller, for messages
    std::string title;
    std::string description;
    CaseModel model;
    std::map<std::string, std::string> sources;  // key of the case -> where its value comes from
    std::vector<Expectation> expectations;
    std::vector<CaseSweep> sweeps;
    std::optional<CaseFit> fit;
    std::optional<SensitivityStudy> sensitivity;  // [sensitivity]
    std::optional<SupportDesign> support_design;  // [support_design]
    std::optional<ReportSettings> report;         // [report]; absent: metric
    std::map<std::string, KeyPlace> places;       // of every key that was read
    Node tree;                                    // the tree that it was read from
};

// Reads a case file, or standard input if its name is "-". `settings` (--set) replace values of the file; a setting of
// one alternative (such as water.filled_ratio) replaces the file's other alternative (water.water_depth). Throws
// CaseError with all problems: unreadable, larger than 4 MiB, not TOML, unknown or missing keys, units, ranges, names.
CaseFile read_case(const std::filesystem::path& path, const std::vector<Setting>& settings = {},
                   const OutputsOf& outputs_of = known_outputs);

// The same for text in memory; `name` replaces the name of the file in messages.
CaseFile parse_case(std::string_view text, std::string_view name, const std::vector<Setting>& settings = {},
                    const OutputsOf& outputs_of = known_outputs);

// The same for a tree that was not read from a file.
CaseFile case_of_tree(Node tree, std::string_view name, const std::vector<Setting>& settings = {},
                      const OutputsOf& outputs_of = known_outputs);

// The model with further keys of the case set, as by --set. Throws CaseError if it cannot be read with them.
CaseModel model_with(const CaseFile& case_file, const std::vector<Setting>& settings);

// A complaint about a value that only the model could judge, with the place of the value in the case.
Problem problem_at(const CaseFile& case_file, const std::string& key, std::string message);

}  // namespace delabole
