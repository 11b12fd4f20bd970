// The described parameters (parameters/fields.hpp) of every model as data: of what the Python classes are made.
//
// A class stands for a section of a case file. What is inlined there has no class of its own: its keys stand in the
// class around it.
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
        text,      // any
        texts,     // a list of them
        section,   // of classes.front()
        choice,    // a section of one of the classes
        sections,  // a list of sections of classes.front()
    };

    std::string key;
    std::string meaning;
    Kind kind = Kind::number;
    bool optional = false;  // may be absent; the keys of an inlined choice always may
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
    // The key that tells this section from others of a choice, and its value; empty where there is no choice. Of a
    // model: "model" and its name.
    std::string kind_key = {};
    std::string kind = {};
    std::vector<FieldSchema> fields = {};
};

// The classes of all models; each stands behind those that it refers to.
std::vector<ClassSchema> described_classes();

}  // namespace delabole
