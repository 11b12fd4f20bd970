// The described parameters (parameters/fields.hpp) of every model as data, from which the Python classes are generated.
//
// A class corresponds to a section of a case file. Inlined members have no class of their own; their keys belong to the
// class around them.
#pragma once

#include "parameters/fields.hpp"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace delabole {

struct FieldSchema {
    enum class Kind {
        number,
        word,      // one of `words`
        text,      // any text
        texts,     // a list of texts
        section,   // of classes.front()
        choice,    // a section of one of the classes
        sections,  // a list of sections of classes.front()
    };

    std::string key;
    std::string meaning;
    Kind kind = Kind::number;
    bool optional = false;  // may be absent; the keys of an inlined choice always may be
    Dimension dimension = Dimension::ratio;
    Interval range = {};  // SI
    std::vector<std::string> words = {};
    std::vector<std::string> classes = {};
};

constexpr std::array<std::string_view, 7> enum_names(FieldSchema::Kind) {
    return {"number", "word", "text", "texts", "section", "choice", "sections"};
}

struct ClassSchema {
    std::string name;
    std::string meaning;
    // The key that distinguishes this section from the others of a choice, and its value; empty if there is no choice.
    // For a model they are "model" and its name.
    std::string kind_key = {};
    std::string kind = {};
    std::vector<FieldSchema> fields = {};
};

// The classes of all models; each follows those that it refers to.
std::vector<ClassSchema> described_classes();

}  // namespace delabole
