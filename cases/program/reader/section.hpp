// Reads a tree of values section by section and records which keys were used, unknown or wrong.
#pragma once

#include "cases/program/reader/case_error.hpp"
#include "cases/program/reader/document.hpp"
#include "cases/program/reader/units.hpp"
#include "geometry/polyline.hpp"
#include "parameters/fields.hpp"
#include "parameters/model_interface.hpp"

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace delabole {

// The place of a key in the case, and its value as written.
struct KeyPlace {
    Place place;
    std::string value;
};

// Records everything found while one case is read.
class Reading {
  public:
    explicit Reading(std::string file) : file_(std::move(file)) {}

    void complain(const Place& place, std::string key, std::string value, std::string message);
    void complain(Problem problem);
    // Complains at the key's own place if it is known, otherwise at the start of the file.
    void complain_at(const std::string& key, std::string message);

    void remember(const std::string& key, const Node& node);
    // Notes the number that is read at this key.
    void look_for(std::string key) { sought_ = std::move(key); }
    void note_number(const std::string& key, Dimension dimension, const Interval& range);
    // Nothing if no number was read there.
    const std::optional<Quantity>& found_number() const { return found_; }
    // Whether there is a complaint about the key.
    bool blames(const std::string& key) const;
    bool knows(const std::string& key) const { return places_.contains(key); }
    const std::map<std::string, KeyPlace>& places() const { return places_; }

    // Called after problems that leave open which inputs the model has, so that names of inputs cannot be checked.
    void lose_inputs() { inputs_known_ = false; }
    bool inputs_known() const { return inputs_known_; }

    bool clean() const { return problems_.empty(); }
    // Whether further problems are only counted and not listed, so that it is not worth searching for suggestions.
    bool full() const;
    // Throws CaseError if there were problems.
    void finish();

  private:
    std::string file_;
    std::vector<Problem> problems_;
    std::size_t left_out_ = 0;
    std::map<std::string, KeyPlace> places_;
    std::string sought_;
    std::optional<Quantity> found_;
    bool inputs_known_ = true;
};

// The names that a section may refer to.
struct ModelNames {
    std::string mechanism;
    std::vector<Quantity> inputs;
    std::vector<Quantity> outputs;
    bool inputs_known = true;  // false: the model itself could not be read, so an unknown name may be right
};
struct KnownNames {
    std::span<const ModelNames> models;  // empty: no name can be judged
    std::string_view output;             // the term for its outputs in complaints: "an output of the mechanism"
};

// One table of the tree. Every key that is asked for becomes a known key; finish() complains about the others.
class Section {
  public:
    Section(Reading& reading, const Node& table, std::string path);
    // A part of a section, in which names and numbers of Dimension::named have the same meaning.
    Section(const Section& around, const Node& table, std::string path);

    Reading& reading() const { return *reading_; }
    const std::string& path() const { return path_; }
    std::string path_of(std::string_view key) const;
    const Place& place() const { return table_->place; }

    // Declares a key as known without reading it.
    void allow(std::string_view key);
    bool is_allowed(std::string_view key) const;
    const std::vector<std::string>& allowed() const { return allowed_; }
    // The value of the key; nullptr if absent.
    const Node* take(std::string_view key);
    // The same, with a complaint "is required: <what>" if absent.
    const Node* require(std::string_view key, std::string_view what);
    bool contains(std::string_view key) const { return table_->find(key) != nullptr; }
    const Node* peek(std::string_view key) const { return table_->find(key); }

    void complain(std::string_view key, const Node& value, std::string message) const;

    const KnownNames& names() const { return names_; }
    void refer_to(const KnownNames& names) { names_ = names; }
    // Sets the quantity of which numbers of Dimension::named are values from here on; null if its name is unknown, so
    // that none of them can be checked.
    void name_quantity(const Quantity* quantity) { named_ = quantity; }
    const std::optional<const Quantity*>& named() const { return named_; }

    // `hint(key)` may explain a key that is unknown here; if the hint is empty, a key of similar spelling is suggested.
    template <class Hint>
    void finish(Hint&& hint) const {
        for (const auto& [key, node] : table_->entries) {
            if (!is_allowed(key) && !belongs_to_replaced_kind(node)) {
                complain_unknown(key, node, hint(key));
            }
        }
    }
    void finish() const {
        finish([](std::string_view) { return std::string{}; });
    }

  private:
    // Whether the node belongs to another kind than the one chosen by --set.
    bool belongs_to_replaced_kind(const Node& node) const;
    void complain_unknown(const std::string& key, const Node& node, const std::string& hint) const;

    Reading* reading_;
    const Node* table_;
    std::string path_;
    std::vector<std::string> allowed_;
    KnownNames names_ = {};
    std::optional<const Quantity*> named_ = {};  // absent: no quantity was named
};

// The value in SI if it is within the range; otherwise it complains and returns nothing.
std::optional<double> read_number(Reading& reading, const Node& node, const std::string& path, Dimension dimension,
                                  const Interval& range);
std::optional<double> read_number(Section& section, std::string_view key, Dimension dimension, const Interval& range,
                                  std::string_view what);

std::optional<std::string> read_text(Reading& reading, const Node& node, const std::string& path);
// Complains and returns an empty text if absent or blank.
std::string require_text(Section& section, std::string_view key, std::string_view what);
// Empty if absent.
std::string read_optional_text(Section& section, std::string_view key);
// Appends a list of texts; does nothing if absent.
void read_words(Section& section, std::string_view key, std::vector<std::string>& words);

std::optional<WrittenValue> read_written(Reading& reading, const Node& node, const std::string& path);

// Complains and returns nothing for a number that is not whole or out of the range.
std::optional<std::int64_t> read_whole_number(Reading& reading, const Node& node, const std::string& path,
                                              const Interval& range);
// Points [x, y] whose coordinates have the given dimension.
Polyline read_polyline(Reading& reading, const Node& node, const std::string& path, Dimension dimension);
// Two texts; `meaning` describes them in a complaint.
std::array<std::string, 2> read_pair(Reading& reading, const Node& node, const std::string& path,
                                     std::string_view meaning);

// The table of a key; complains and returns nullptr if its value is something else.
const Node* as_table(Reading& reading, const Node& node, const std::string& path);
// The same for a key that may be absent.
const Node* take_table(Section& section, std::string_view key);

// Calls read(section) for the table of a key, which may be absent.
template <class Read>
void for_table(Section& around, std::string_view key, Read&& read) {
    if (const Node* table = take_table(around, key)) {
        Section section(around.reading(), *table, around.path_of(key));
        read(section);
        section.finish();
    }
}

// Calls read(element section) for each table of an array of tables; an absent array is empty.
template <class Read>
void for_each_table(Section& section, std::string_view key, Read&& read);

// Index of a word in a list; if it is not there, complains with the choices and returns nothing.
std::optional<std::size_t> read_choice(Reading& reading, const Node& node, const std::string& path,
                                       const std::vector<std::string>& words);

// Complains and returns null if the value is not an array of tables.
const std::vector<Node>* as_tables(Reading& reading, const Node& node, const std::string& path);

template <class Read>
void for_each_table(Section& section, std::string_view key, Read&& read) {
    const Node* node = section.take(key);
    if (node == nullptr) {
        return;
    }
    const std::string path = section.path_of(key);
    const std::vector<Node>* tables = as_tables(section.reading(), *node, path);
    if (tables == nullptr) {
        return;
    }
    for (std::size_t index = 0; index < tables->size(); ++index) {
        Section element(section, (*tables)[index], indexed(path, index));
        read(element);
        element.finish();
    }
}

}  // namespace delabole
