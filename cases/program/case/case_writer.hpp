// Cases as text: the resolved case of a result folder, the template of `delabole init`, the inputs of `delabole
// inputs`.
#pragma once

#include "cases/program/case/case_file.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace delabole {

// The case with every default written out, values in the units people read (in SI units where the decimal number would
// not give the identical double). Reading it again gives the identical model, fit and expectations.
std::string resolved_toml(const CaseFile& case_file);

// The part of it that makes the model: equal for models that predict the same, whatever else their cases hold.
std::string resolved_model(const CaseModel& model);

// 16 hexadecimal digits, FNV-1a over resolved_toml(): equal for cases that mean the same whatever their layout,
// comments and units. It tells cases apart, it does not protect against forgery.
std::string case_hash(const CaseFile& case_file);

// A case of the model, valid as it stands, with each key's meaning and range, and with what is optional and the other
// choices as comments. Throws std::invalid_argument for a name that is not in model_names().
std::string commented_template(std::string_view name);

enum class FurtherColumns { left, right };

// Rows as columns of text, each as wide as its longest entry, two blanks apart; the columns behind the first stand to
// the left or, as numbers do, to the right of their width.
std::string aligned_columns(const std::vector<std::vector<std::string>>& rows,
                            FurtherColumns further = FurtherColumns::left);

// A table of all numbers of the model, a line each: name, value, allowed range, meaning and source.
std::string described_inputs(const CaseFile& case_file);

}  // namespace delabole
