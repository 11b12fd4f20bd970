// Cases as text: the resolved case of a result folder, the template of `delabole init`, the inputs of `delabole
// inputs`.
#pragma once

#include "cases/program/case/case_file.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace delabole {

// The case with every default written out. Values are in display units, or in SI units if the decimal number would not
// give the identical double. Reading the text again gives the identical model, fit and expectations.
std::string resolved_toml(const CaseFile& case_file);

// The part of that text that describes the model: equal for models that predict the same, whatever else their cases
// hold.
std::string resolved_model(const CaseModel& model);

// 16 hexadecimal digits, FNV-1a over resolved_toml(): equal for cases with the same meaning, whatever their layout,
// comments and units. It distinguishes cases but does not protect against forgery.
std::string case_hash(const CaseFile& case_file);

// A valid case of the model with the meaning and range of each key; optional keys and alternatives are comments. Throws
// std::invalid_argument for a name that is not in model_names().
std::string commented_template(std::string_view name);

enum class FurtherColumns { left, right };

// Rows as columns of text, each as wide as its longest entry and two blanks apart. The first column is aligned to the
// left; the others are aligned to the left, or to the right as numbers are.
std::string aligned_columns(const std::vector<std::vector<std::string>>& rows,
                            FurtherColumns further = FurtherColumns::left);

// A table of all numbers of the model, one line each: name, value, allowed range, meaning and source.
std::string described_inputs(const CaseFile& case_file);

}  // namespace delabole
