// The parts of a case other than its model; used by case_file.cpp only.
#pragma once

#include "cases/program/case/case_file.hpp"
#include "cases/program/reader/names.hpp"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <iterator>

namespace delabole {

// Complains about each name in a list that an earlier element also has.
template <class Element, class Name>
void check_unique(Reading& reading, const std::string& list, const std::vector<Element>& elements, Name name,
                  const std::string& key, const std::string& complaint) {
    for (std::size_t index = 0; index < elements.size(); ++index) {
        const auto end = elements.begin() + static_cast<std::ptrdiff_t>(index);
        const std::string& own = elements[index].*name;
        if (!own.empty() && std::ranges::find(elements.begin(), end, own, name) != end) {
            reading.complain_at(indexed(list, index) + "." + key, complaint);
        }
    }
}

// Complains about each text in a list that is given but empty.
template <class Element, class Text>
void check_not_empty(Reading& reading, const std::string& list, const std::vector<Element>& elements, Text text,
                     const std::string& key) {
    for (std::size_t index = 0; index < elements.size(); ++index) {
        const std::string path = indexed(list, index) + "." + key;
        if ((elements[index].*text).find_first_not_of(" \t\r\n") == std::string::npos && reading.knows(path) &&
            !reading.blames(path)) {
            reading.complain_at(path, "must not be empty");
        }
    }
}

// Complains about a name that no element of a list has.
template <class Element, class Name>
void check_among(Reading& reading, const std::string& key, const std::string& name,
                 const std::vector<Element>& elements, Name name_of, std::string_view complaint) {
    if (name.empty() || std::ranges::find(elements, name, name_of) != elements.end()) {
        return;
    }
    std::vector<std::string> names;
    std::ranges::transform(elements, std::back_inserter(names), name_of);
    reading.complain_at(key, std::string(complaint) + suggestion(name, names));
}

ModelNames names_of(const CaseModel& model, const OutputsOf& outputs_of, bool inputs_known);

// Complains about a name that cannot be that of a file.
void check_file_name(Reading& reading, const std::string& key, const std::string& name);

// The number at a key of the case that is not an input of its model, such as settings.stiffness_ratio; nothing if there
// is no such number. `value` is one that the key may have.
using NumberAtKey = std::function<std::optional<Quantity>(const std::string& key, const Node& value)>;
std::vector<CaseSweep> read_sweeps(Section& root, const ModelNames& names, const NumberAtKey& number_at);
void write_sweep(std::string& text, const CaseSweep& sweep);

std::vector<Expectation> read_expectations(Section& root, const ModelNames& names);
// Copies into each mechanism with `like` the parts of the other mechanism that it does not replace.
void copy_alike_mechanisms(Node& tree, Reading& reading);
// Each of these reads its own section.
CaseFit read_fit(Section& section, const CaseFile& case_file, const OutputsOf& outputs_of);
SupportDesign read_support_design(Section& section, const CaseModel& model, const ModelNames& names);
SensitivityStudy read_sensitivity(Section& section, const ModelNames& names);
// Sources may refer to any key, so they are checked after everything else was read.
std::map<std::string, std::string> read_sources(Section& root);
void check_sources(Reading& reading, const std::map<std::string, std::string>& sources);

// An empty model of the kind that `model = ...` names; complains if there is no such kind.
std::optional<CaseModel> choose_model(Section& section);
// read_model reads all sections of a model; replace_in_model only those that are given.
void read_model(Section& section, CaseModel& model);
void replace_in_model(Section& section, CaseModel& model);

// Completes a model that was read without a complaint: reads the files that it names, then checks what concerns several
// inputs together. `prefix` is the mechanism's path with a dot, or empty for the case.
void complete_model(Reading& reading, CaseModel& model, const std::filesystem::path& case_path,
                    const std::string& prefix);

}  // namespace delabole
