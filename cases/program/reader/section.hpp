// Reading a tree of values section by section: what was used, what is unknown, what is wrong.
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

// Where a key stands in the case, and how its value was written.
struct KeyPlace {
    Place place;
    std::string value;
};

// "bolt[2]" for index 1
std::string indexed(const std::string& key, std::size_t index);

// Everything found while one case is read.
class Reading {
  public:
    explicit Reading(std::string file) : file_(std::move(file)) {}

    void complain(const Place& place, std::string key, std::string value, std::string message);
    void complain(Problem problem);
    // Complains at the key's own place where it is known, at the start of the file otherwise.
    void complain_at(const std::string& key, std::string message);

    void remember(const std::string& key, const Node& node);
    // Notes which number is read at this key.
    void look_for(std::string key) { sought_ = std::move(key); }
    void note_number(const std::string& key, Dimension dimension, const Interval& range);
    // Nothing where no number was read there.
    const std::optional<Quantity>& found_number() const { return found_; }
    // Whether there is a complaint about it.
    bool blames(const std::string& key) const;
    bool knows(const std::string& key) const { return places_.contains(key); }
    const std::map<std::string, KeyPlace>& places() const { return places_; }

    // Problems that leave open which inputs the model has, so that names of inputs cannot be checked.
    void lose_inputs() { inputs_known_ = false; }
    bool inputs_known() const { return inputs_known_; }

    bool clean() const { return problems_.empty(); }
    // More problems are counted, not listed: not worth a search for the right word.
    bool full() const;
    // Throws CaseError when there were problems.
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
    bool inputs_known = true;  // false: the model itself could not be read, so a name that is not found may be right
};
struct KnownNames {
    std::span<const ModelNames> models;  // empty: no name can be judged
    std::string_view output;             // what complaints call an output of these: "an output of the mechanism"
};

// One table of the tree. Every key asked for is a known key; finish() complains about the others.
class Section {
  public:
    Section(Reading& reading, const Node& table, std::string path);
    // Part of a section: names mean the same in it, and so do numbers of Dimension::named.
    Section(const Section& around, const Node& table, std::string path);

    Reading& reading() const { return *reading_; }
    const std::string& path() const { return path_; }
    std::string path_of(std::string_view key) const;
    const Place& place() const { return table_->place; }

    // Makes a key known without reading it.
    void allow(std::string_view key);
    bool is_allowed(std::string_view key) const;
    // The key's value, nullptr when absent.
    const Node* take(std::string_view key);
    // The same, with a complaint when absent: "is required: <what>".
    const Node* require(std::string_view key, std::string_view what);
    bool contains(std::string_view key) const { return table_->find(key) != nullptr; }
    const Node* peek(std::string_view key) const { return table_->find(key); }

    void complain(std::string_view key, const Node& value, std::string message) const;

    const KnownNames& names() const { return names_; }
    void refer_to(const KnownNames& names) { names_ = names; }
    // The quantity that numbers of Dimension::named are values of from here on; null: a name that nobody knows, so that
    // none can be judged.
    void name_quantity(const Quantity* quantity) { named_ = quantity; }
    const std::optional<const Quantity*>& named() const { return named_; }

    // `hint(key)` may explain a key that is unknown here; an empty hint leaves it to the spelling.
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
    // True of what the file says of another kind than the one that --set chose.
    bool belongs_to_replaced_kind(const Node& node) const;
    void complain_unknown(const std::string& key, const Node& node, const std::string& hint) const;

    Reading* reading_;
    const Node* table_;
    std::string path_;
    std::vector<std::string> allowed_;
    KnownNames names_ = {};
    std::optional<const Quantity*> named_ = {};  // absent: nothing was named
};

// The value in SI, inside the range; nothing, with a complaint, when it is not.
std::optional<double> read_number(Reading& reading, const Node& node, const std::string& path, Dimension dimension,
                                  const Interval& range);
std::optional<double> read_number(Section& section, std::string_view key, Dimension dimension, const Interval& range,
                                  std::string_view what);

std::optional<std::string> read_text(Reading& reading, const Node& node, const std::string& path);
// Empty, with a complaint, when absent or blank.
std::string require_text(Section& section, std::string_view key, std::string_view what);
// Empty when absent.
std::string read_optional_text(Section& section, std::string_view key);
// A list of texts, appended; nothing when absent.
void read_words(Section& section, std::string_view key, std::vector<std::string>& words);

std::optional<WrittenValue> read_written(Reading& reading, const Node& node, const std::string& path);

// Nothing, with a complaint, for a number that is not whole or out of the range.
std::optional<std::int64_t> read_whole_number(Reading& reading, const Node& node, const std::string& path,
                                              const Interval& range);
// Points [x, y], coordinates of a dimension.
Polyline read_polyline(Reading& reading, const Node& node, const std::string& path, Dimension dimension);
// Two texts; `meaning` says which in a complaint.
std::array<std::string, 2> read_pair(Reading& reading, const Node& node, const std::string& path,
                                     std::string_view meaning);

// The table of a key, or nullptr with a complaint when its value is something else.
const Node* as_table(Reading& reading, const Node& node, const std::string& path);
// The same of a key that may be absent.
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

// Calls read(element section) for each table of an array of tables; absent is empty.
template <class Read>
void for_each_table(Section& section, std::string_view key, Read&& read);

// Index of a word in a list; nothing, with a complaint that names the choices, when it is not in it.
std::optional<std::size_t> read_choice(Reading& reading, const Node& node, const std::string& path,
                                       const std::vector<std::string>& words);

// Complains when the value is not an array of tables.
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
