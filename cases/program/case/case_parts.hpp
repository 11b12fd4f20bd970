// The parts of a case that are not its model; used by case_file.cpp only.
#pragma once

#include "cases/program/case/case_file.hpp"

#include <filesystem>
#include <span>

namespace delabole {

// What the reader knows of a model while it reads names of inputs and outputs.
struct ModelNames {
    std::vector<Quantity> inputs;
    std::vector<Quantity> outputs;
    bool inputs_known = true;  // false: the model itself could not be read, so a name that is not found may be right
};

ModelNames names_of(const CaseModel& model, const OutputsOf& outputs_of, bool inputs_known);

std::vector<std::string> names_in(const std::vector<Quantity>& quantities);

// `with = { "water.filled_ratio" = 1.0 }`: inputs of any of the models. Empty when absent.
std::vector<Condition> read_conditions(Section& section, std::span<const ModelNames> models,
                                       std::string_view key = "with");

// `also` of a free or uncertain input: further inputs, of its dimension, that take its value.
std::vector<std::string> read_others(Section& parameter, const Quantity& input, const ModelNames& names);

// Ends where an input is meant to end, and equal steps between.
std::vector<double> spaced_values(double from, double to, int points);
std::vector<CaseSweep> read_sweeps(Section& root, const ModelNames& names);
void write_sweep(std::string& text, const CaseSweep& sweep, const CaseModel& model);

// key = "value", nothing where the value is empty; and `with` of a list of conditions.
void write_text(std::string& text, std::string_view key, const std::string& value);
void write_conditions(std::string& text, const std::vector<Condition>& conditions,
                      const std::vector<std::vector<Quantity>>& inputs, std::string_view key = "with");

std::vector<Expectation> read_expectations(Section& root, const ModelNames& names);
// [[fit.candidate]] of the section [fit].
std::vector<CaseCandidate> read_candidates(Section& fit, const std::vector<ModelNames>& models);
// [[fit.conclusion]] of the same; `models` are those of the mechanisms, in their order.
std::vector<Conclusion> read_conclusions(Section& fit, const std::vector<FitMechanism>& mechanisms,
                                         const std::vector<ModelNames>& models);
// Puts what mechanisms have from those that they are `like` in their place in the tree.
void copy_alike_mechanisms(Node& tree, Reading& reading);
CaseFit read_fit(Section& root, const CaseFile& case_file, const OutputsOf& outputs_of);
CaseSensitivity read_sensitivity(Section& root, const CaseModel& model, const OutputsOf& outputs_of);
// The keys that need not exist are checked after everything else was read.
std::map<std::string, std::string> read_sources(Section& root);
void check_sources(Reading& reading, const std::map<std::string, std::string>& sources);

// An empty model of the kind that `model = ...` names; complains where there is none.
std::optional<CaseModel> choose_model(Section& section);
// Reads what a mechanism or the case says of its model.
void read_model(Section& section, CaseModel& model);
void replace_in_model(Section& section, CaseModel& model);

// Of a model read without a complaint: puts what files beside the case hold in the place of their names, then checks
// what concerns several inputs at once. `prefix` is the mechanism's path with a dot, or empty for the case.
void complete_model(Reading& reading, CaseModel& model, const std::filesystem::path& case_path,
                    const std::string& prefix);

}  // namespace delabole
