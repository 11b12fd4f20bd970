// A case: what stands in one *.toml file, checked and in SI.
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
#include <tuple>
#include <vector>

namespace delabole {

// The word after `model =` in a case, and all of them.
std::string_view model_name(const CaseModel& model);
std::vector<std::string> model_names();

// The numbers of a case's model by name, with dimension, range, meaning and value; those a fit may set free, a
// condition may change and `required` may solve for. What a study asks for (its searches) is not among them.
std::vector<Quantity> named_inputs(const CaseModel& model);

// One [[expect]]: a value printed somewhere, to be compared with the computed one.
struct Expectation {
    std::string label;  // what is compared, in words, for reports; empty: the quantity and its conditions
    std::string quantity;
    WrittenValue value;                        // a number, a quantity or a word such as an outcome's name
    std::optional<WrittenValue> tolerance;     // absolute, of the value's dimension
    std::optional<double> relative_tolerance;  // of the value
    std::vector<Condition> conditions;         // inputs that differ from the case's, SI
    std::string source;
    std::string note;
    std::optional<std::string> unreachable;   // why the printed value cannot be reached: shown, not failed
    std::optional<Dimension> dimension = {};  // where the model lists the quantity; value and tolerance then convert
    Place place = {};

    // A word has to be equal; anything else has exactly one tolerance, unless it is unreachable.
    bool is_word() const;
    static constexpr auto fields() {
        using E = Expectation;
        return std::tuple{with_default(section("label", &E::label, "what is compared, in words")),
                          section("quantity", &E::quantity, "name of an output of the model"),
                          section("value", &E::value, "the value to compare with"),
                          section("tolerance", &E::tolerance, "greatest difference that is met"),
                          number("relative_tolerance", &E::relative_tolerance, Dimension::ratio, at_least(0),
                                 "the same, of the value"),
                          section("with", &E::conditions, "inputs that differ from the case's"),
                          with_default(section("source", &E::source, "where the value comes from")),
                          with_default(section("note", &E::note, "what a reader should know of it")),
                          section("unreachable", &E::unreachable, "why the value cannot be reached")};
    }
};

struct FitMechanism : MechanismTask {
    CaseModel model = {};  // the case's, with the sections that the mechanism replaces; or one of its own kind
    std::optional<CaseModel> coarse = {};  // the mechanism's own, with the sections that its coarse model replaces
};

// [fit], SI throughout.
struct CaseFit : FitTask {
    std::vector<FitMechanism> mechanisms;  // at least one; a case without [[fit.mechanism]] has one named as its model
};

// [report]
struct ReportSettings {
    UnitSystem units;
    static constexpr auto fields() {
        return std::tuple{
            section("units", &ReportSettings::units, "of sentences, tables and figures; CSV and JSON are metric")};
    }
};

struct CaseFile {
    std::string name;  // as the caller named it, for messages
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
    std::map<std::string, KeyPlace> places;       // every key that was read
    Node tree;                                    // that it was read from
};

// Reads a case file, or standard input where its name is "-", with `settings` (--set) put in place of what the file
// says. A setting of one choice (as water.filled_ratio) takes the place of the file's other choice (water.water_depth).
// Throws CaseError with everything that is wrong: unreadable, larger than 4 MiB, not TOML, unknown or missing keys,
// units, ranges, names.
CaseFile read_case(const std::filesystem::path& path, const std::vector<Setting>& settings = {},
                   const OutputsOf& outputs_of = known_outputs);

// The same for text in memory; `name` stands for the file in messages.
CaseFile parse_case(std::string_view text, std::string_view name, const std::vector<Setting>& settings = {},
                    const OutputsOf& outputs_of = known_outputs);

// The same for a tree that no file was read for.
CaseFile case_of_tree(Node tree, std::string_view name, const std::vector<Setting>& settings = {},
                      const OutputsOf& outputs_of = known_outputs);

// The model with further keys of the case set, as by --set. Throws CaseError where it cannot be read with them.
CaseModel model_with(const CaseFile& case_file, const std::vector<Setting>& settings);

// A complaint about a value that only the model could judge, at the place where the case gives it.
Problem problem_at(const CaseFile& case_file, const std::string& key, std::string message);

}  // namespace delabole
