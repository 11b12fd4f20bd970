#include "cases/program/reader/section.hpp"

#include "cases/program/reader/names.hpp"

#include <algorithm>
#include <limits>
#include <tuple>
#include <utility>

namespace delabole {
namespace {

constexpr std::size_t most_problems = 100;
constexpr std::size_t most_sections = 20'000;

std::string shown_key(std::string_view key) {
    constexpr std::size_t longest = 80;
    const bool plain = key.size() <= longest && !key.empty() && std::ranges::all_of(key, [](char character) {
                           return character > ' ' && character != 0x7F && character != '"';
                       });
    return plain ? std::string(key) : shown(key);
}

}  // namespace

void Reading::complain(const Place& place, std::string key, std::string value, std::string message) {
    complain({.file = place.from_option ? "--set" : file_,
              .line = place.from_option ? 0 : place.line,
              .column = place.from_option ? 0 : place.column,
              .key = std::move(key),
              .value = std::move(value),
              .message = std::move(message)});
}

bool Reading::full() const {
    return problems_.size() >= most_problems;
}

void Reading::complain(Problem problem) {
    if (full()) {
        ++left_out_;
        return;
    }
    problems_.push_back(std::move(problem));
}

void Reading::complain_at(const std::string& key, std::string message) {
    const auto found = places_.find(key);
    if (found == places_.end()) {
        complain({.line = 1, .column = 1}, key, {}, std::move(message));
    } else {
        complain(found->second.place, key, found->second.value, std::move(message));
    }
}

void Reading::remember(const std::string& key, const Node& node) {
    const auto is_table = [](const Node& one) { return one.kind == Node::Kind::table; };
    const bool has_value = !is_table(node) && std::ranges::none_of(node.elements, is_table);
    places_.insert_or_assign(key, KeyPlace{.place = node.place, .value = has_value ? shown(node) : std::string{}});
}

void Reading::note_number(const std::string& key, Dimension dimension, const Interval& range) {
    if (key == sought_) {
        found_ = Quantity{.name = key, .dimension = dimension, .meaning = {}, .range = range, .value = 0};
    }
}

bool Reading::blames(const std::string& key) const {
    return std::ranges::find(problems_, key, &Problem::key) != problems_.end();
}

void Reading::finish() {
    if (problems_.empty()) {
        return;
    }
    const auto order = [](const Problem& problem) {
        return std::tie(problem.line, problem.column, problem.key, problem.message);
    };
    std::ranges::stable_sort(problems_, {}, order);
    // A section that several mechanisms share is checked for each of them, so the same problem may occur several times.
    const auto same = [&](const Problem& first, const Problem& second) { return order(first) == order(second); };
    problems_.erase(std::unique(problems_.begin(), problems_.end(), same), problems_.end());
    throw CaseError(std::move(problems_), left_out_);
}

Section::Section(Reading& reading, const Node& table, std::string path)
    : reading_(&reading), table_(&table), path_(std::move(path)) {
    if (!path_.empty()) {
        reading.remember(path_, table);
    }
}

Section::Section(const Section& around, const Node& table, std::string path)
    : Section(*around.reading_, table, std::move(path)) {
    names_ = around.names_;
    named_ = around.named_;
}

std::string Section::path_of(std::string_view key) const {
    return joined_path(path_, shown_key(key));
}

void Section::allow(std::string_view key) {
    allowed_.emplace_back(key);
}

const Node* Section::take(std::string_view key) {
    allow(key);
    const Node* node = table_->find(key);
    if (node != nullptr) {
        reading_->remember(path_of(key), *node);
    }
    return node;
}

const Node* Section::require(std::string_view key, std::string_view what) {
    const Node* node = take(key);
    if (node == nullptr) {
        reading_->complain(place(), path_of(key), {}, "is required: " + std::string(what));
    }
    return node;
}

void Section::complain(std::string_view key, const Node& value, std::string message) const {
    reading_->complain(value.place, path_of(key), shown(value), std::move(message));
}

bool Section::is_allowed(std::string_view key) const {
    return std::ranges::find(allowed_, key) != allowed_.end();
}

bool Section::belongs_to_replaced_kind(const Node& node) const {
    // The key is not looked up among the entries: since this is called for every unknown key, the time would grow with
    // the square of their number.
    const auto kind = reading_->places().find(path_of("kind"));
    return kind != reading_->places().end() && kind->second.place.from_option && !node.place.from_option;
}

void Section::complain_unknown(const std::string& key, const Node& node, const std::string& hint) const {
    const std::string where = path_.empty() ? "a case of this model" : path_;
    reading_->complain(
        node.key_place, path_of(key), {},
        "is not a key of " + where + (hint.empty() && !reading_->full() ? suggestion(key, allowed_) : hint));
}

std::optional<double> read_number(Reading& reading, const Node& node, const std::string& path, Dimension dimension,
                                  const Interval& range) {
    reading.note_number(path, dimension, range);
    ParsedQuantity parsed;
    if (node.kind == Node::Kind::text) {
        parsed = parse_quantity(node.text, dimension);
    } else if (node.kind == Node::Kind::integer || node.kind == Node::Kind::real) {
        parsed = unitless_quantity(node.real, dimension);
    } else {
        parsed.message = "must be " + std::string(dimension_words(dimension).phrase) + ", e.g. " +
                         std::string(dimension_words(dimension).example);
    }
    if (parsed.status != QuantityStatus::ok) {
        reading.complain(node.place, path, shown(node), parsed.message);
        return std::nullopt;
    }
    if (!range.contains(parsed.value)) {
        reading.complain(node.place, path, shown(node), "must be " + readable_range(range, dimension));
        return std::nullopt;
    }
    return parsed.value;
}

std::optional<double> read_number(Section& section, std::string_view key, Dimension dimension, const Interval& range,
                                  std::string_view what) {
    const std::string allowed = readable_range(range, dimension);
    const Node* node =
        section.require(key, std::string(what) + " (" +
                                 (allowed.empty() ? std::string(dimension_words(dimension).phrase) : allowed) + ")");
    return node == nullptr ? std::nullopt
                           : read_number(section.reading(), *node, section.path_of(key), dimension, range);
}

std::optional<std::string> read_text(Reading& reading, const Node& node, const std::string& path) {
    if (node.kind != Node::Kind::text) {
        reading.complain(node.place, path, shown(node), "must be text in quotes");
        return std::nullopt;
    }
    return node.text;
}

std::string require_text(Section& section, std::string_view key, std::string_view what) {
    const Node* node = section.require(key, what);
    if (node == nullptr) {
        return {};
    }
    std::string text = read_text(section.reading(), *node, section.path_of(key)).value_or("");
    if (node->kind == Node::Kind::text && text.find_first_not_of(" \t\r\n") == std::string::npos) {
        section.complain(key, *node, "must not be empty: " + std::string(what));
    }
    return text;
}

std::string read_optional_text(Section& section, std::string_view key) {
    const Node* node = section.take(key);
    return node == nullptr ? "" : read_text(section.reading(), *node, section.path_of(key)).value_or("");
}

void read_words(Section& section, std::string_view key, std::vector<std::string>& words) {
    const Node* list = section.take(key);
    if (list == nullptr) {
        return;
    }
    if (list->kind != Node::Kind::array) {
        section.complain(key, *list, "must be a list of texts, [\"one\", \"another\"]");
        return;
    }
    for (std::size_t index = 0; index < list->elements.size(); ++index) {
        const std::string path = indexed(section.path_of(key), index);
        words.push_back(read_text(section.reading(), list->elements[index], path).value_or(""));
    }
}

std::optional<WrittenValue> read_written(Reading& reading, const Node& node, const std::string& path) {
    switch (node.kind) {
    case Node::Kind::text:
        return node.text;
    case Node::Kind::integer:
    case Node::Kind::real:
        return node.real;
    default:
        reading.complain(node.place, path, shown(node), "must be a number, a quantity in quotes or a word in quotes");
        return std::nullopt;
    }
}

std::optional<std::int64_t> read_whole_number(Reading& reading, const Node& node, const std::string& path,
                                              const Interval& range) {
    constexpr std::int64_t most = std::numeric_limits<std::int64_t>::max();
    const auto lower = static_cast<std::int64_t>(range.lower);
    const std::int64_t upper = range.upper < static_cast<double>(most) ? static_cast<std::int64_t>(range.upper) : most;
    if (node.kind == Node::Kind::integer && node.integer >= lower && node.integer <= upper) {
        return node.integer;
    }
    reading.complain(node.place, path, shown(node),
                     "must be a whole number from " + std::to_string(lower) + " to " + std::to_string(upper));
    return std::nullopt;
}

Polyline read_polyline(Reading& reading, const Node& node, const std::string& path, Dimension dimension) {
    Polyline points;
    if (node.kind != Node::Kind::array) {
        reading.complain(node.place, path, shown(node), "must be a list of points [x, y]");
    }
    for (std::size_t index = 0; index < node.elements.size(); ++index) {
        const Node& element = node.elements[index];
        const std::string place = indexed(path, index);
        Point& point = points.emplace_back(Point::Zero());
        if (element.kind != Node::Kind::array || element.elements.size() != 2) {
            reading.complain(element.place, place, shown(element),
                             dimension == Dimension::length ? "must be a point [x, y], e.g. [\"0 ft\", \"350 ft\"]"
                                                            : "must be two numbers, [x, y]");
            continue;
        }
        for (const int axis : {0, 1}) {
            const Node& coordinate = element.elements[static_cast<std::size_t>(axis)];
            point[axis] = read_number(reading, coordinate, indexed(place, static_cast<std::size_t>(axis)), dimension,
                                      any_number())
                              .value_or(0);
        }
    }
    return points;
}

std::array<std::string, 2> read_pair(Reading& reading, const Node& node, const std::string& path,
                                     std::string_view meaning) {
    const auto is_text = [](const Node& element) { return element.kind == Node::Kind::text; };
    if (node.elements.size() == 2 && std::ranges::all_of(node.elements, is_text)) {
        return {node.elements[0].text, node.elements[1].text};
    }
    reading.complain(node.place, path, shown(node), "must be " + std::string(meaning));
    return {};
}

const Node* as_table(Reading& reading, const Node& node, const std::string& path) {
    if (node.kind != Node::Kind::table) {
        reading.complain(node.place, path, shown(node), "must be a section: [" + path + "] and its keys");
        return nullptr;
    }
    return &node;
}

const Node* take_table(Section& section, std::string_view key) {
    const Node* node = section.take(key);
    return node == nullptr ? nullptr : as_table(section.reading(), *node, section.path_of(key));
}

const std::vector<Node>* as_tables(Reading& reading, const Node& node, const std::string& path) {
    const bool tables = node.kind == Node::Kind::array && std::ranges::all_of(node.elements, [](const Node& element) {
                            return element.kind == Node::Kind::table;
                        });
    if (!tables) {
        reading.complain(node.place, path, shown(node), "must be a list of sections: [[" + path + "]] for each");
        return nullptr;
    }
    if (node.elements.size() > most_sections) {
        reading.complain(node.place, path, {}, "holds more than " + std::to_string(most_sections) + " sections");
        return nullptr;
    }
    return &node.elements;
}

std::optional<std::size_t> read_choice(Reading& reading, const Node& node, const std::string& path,
                                       const std::vector<std::string>& words) {
    if (node.kind == Node::Kind::text) {
        const auto found = std::ranges::find(words, node.text);
        if (found != words.end()) {
            return static_cast<std::size_t>(found - words.begin());
        }
    }
    reading.complain(node.place, path, shown(node), "must be " + choices(words) + suggestion(node.text, words));
    return std::nullopt;
}

}  // namespace delabole
