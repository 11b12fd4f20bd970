#include "cases/program/reader/document.hpp"

#include "cases/program/reader/units.hpp"
#include "fitting/work/bare_number.hpp"

#include <toml++/toml.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace delabole {
namespace {

constexpr int deepest_nesting = 32;
constexpr std::size_t most_values = 200'000;

[[noreturn]] void refuse(std::string_view name, int line, int column, std::string message) {
    throw CaseError({{std::string(name), line, column, {}, {}, std::move(message)}});
}

Place place_of(const toml::source_region& source) {
    return {.line = static_cast<int>(source.begin.line), .column = static_cast<int>(source.begin.column)};
}

bool stands_before(const Place& first, const Place& second) {
    return first.line != second.line ? first.line < second.line : first.column < second.column;
}

// Index just after the string that starts at `start`. A string on one line ends with that line at the latest: TOML
// allows no line break in it, so the parser stops there with an error of its own.
std::size_t behind_string(std::string_view text, std::size_t start) {
    const char quote = text[start];
    const bool escapes = quote == '"';
    const std::string_view triple = quote == '"' ? "\"\"\"" : "'''";
    const bool several_lines = text.substr(start, 3) == triple;
    std::size_t index = start + (several_lines ? 3 : 1);
    while (index < text.size()) {
        if (escapes && text[index] == '\\') {
            index += 2;
        } else if (several_lines && text.substr(index, 3) == triple) {
            index += 3;
            // Up to two quotes may stand directly before the closing three.
            for (int extra = 0; extra < 2 && index < text.size() && text[index] == quote; ++extra) {
                ++index;
            }
            return index;
        } else if (!several_lines && (text[index] == quote || text[index] == '\n')) {
            return text[index] == quote ? index + 1 : index;
        } else {
            ++index;
        }
    }
    return text.size();
}

struct NestingExcess {
    int line;
    int column;
};

// The first place where brackets are nested, or a dotted key is, more than `limit` levels deep: checked before the TOML
// library is used, whose trees are built and freed recursively. Strings and comments do not count. For text that is not
// TOML the result has no meaning.
std::optional<NestingExcess> excessive_nesting(std::string_view text, int limit) {
    int line = 1;
    std::size_t line_start = 0;
    int brackets = 0;
    int dots = 0;
    const auto pass = [&](std::size_t from, std::size_t to) {
        for (std::size_t index = from; index < to; ++index) {
            if (text[index] == '\n') {
                ++line;
                line_start = index + 1;
            }
        }
    };
    for (std::size_t index = 0; index < text.size();) {
        const char character = text[index];
        std::size_t next = index + 1;
        switch (character) {
        case '"':
        case '\'':
            next = behind_string(text, index);
            break;
        case '#':
            next = text.find('\n', index);
            next = next == std::string_view::npos ? text.size() : next;
            break;
        case '[':
        case '{':
            ++brackets;
            dots = 0;
            break;
        case ']':
        case '}':
            brackets = brackets > 0 ? brackets - 1 : 0;
            dots = 0;
            break;
        case '.':
            ++dots;
            break;
        case '=':
        case ',':
        case '\n':
            dots = 0;
            break;
        default:
            break;
        }
        if (brackets > limit || dots > limit) {
            return NestingExcess{.line = line, .column = static_cast<int>(index - line_start) + 1};
        }
        pass(index, next);
        index = next;
    }
    return std::nullopt;
}

class Translator {
  public:
    explicit Translator(std::string_view name) : name_(name) {}

    Node translate(const toml::node& source) {
        Node node;
        node.place = place_of(source.source());
        node.key_place = node.place;
        if (++count_ > most_values) {
            refuse(name_, node.place.line, node.place.column,
                   "holds more than " + std::to_string(most_values) + " values");
        }
        source.visit([&](const auto& value) { fill(node, value); });
        return node;
    }

  private:
    void fill(Node& node, const toml::table& table) {
        node.kind = Node::Kind::table;
        node.entries.reserve(table.size());
        for (const auto& [key, value] : table) {
            Node& entry = node.entries.emplace_back(Entry{std::string(key.str()), translate(value)}).value;
            entry.key_place = place_of(key.source());
        }
        std::ranges::stable_sort(node.entries, stands_before, [](const auto& entry) { return entry.value.key_place; });
    }
    void fill(Node& node, const toml::array& array) {
        node.kind = Node::Kind::array;
        node.elements.reserve(array.size());
        for (const toml::node& element : array) {
            node.elements.push_back(translate(element));
        }
    }
    static void fill(Node& node, const toml::value<std::string>& value) {
        node.kind = Node::Kind::text;
        node.text = value.get();
    }
    static void fill(Node& node, const toml::value<std::int64_t>& value) {
        node.kind = Node::Kind::integer;
        node.integer = value.get();
        node.real = static_cast<double>(value.get());
    }
    static void fill(Node& node, const toml::value<double>& value) {
        node.kind = Node::Kind::real;
        node.real = value.get();
    }
    static void fill(Node& node, const toml::value<bool>& value) {
        node.kind = Node::Kind::boolean;
        node.boolean = value.get();
    }
    template <class DateOrTime>
    static void fill(Node& node, const DateOrTime&) {
        node.kind = Node::Kind::date;
    }

    std::string name_;
    std::size_t count_ = 0;
};

void mark_as_option(Node& node) {
    node.place = {.line = 0, .column = 0, .from_option = true};
    node.key_place = node.place;
    for (auto& [key, entry] : node.entries) {
        mark_as_option(entry);
    }
    for (Node& element : node.elements) {
        mark_as_option(element);
    }
}

Node value_of(const Setting& setting) {
    Node value;
    try {
        const Node line = parse_document("value = " + setting.value + "\n", "--set");
        if (line.entries.size() == 1 && line.entries.front().key == "value") {
            value = line.entries.front().value;
            mark_as_option(value);
            return value;
        }
    } catch (const CaseError&) {
        // The text is not a TOML value, for example an unquoted 40 m, and becomes a string.
    }
    value.kind = Node::Kind::text;
    value.text = setting.value;
    mark_as_option(value);
    return value;
}

struct PathPart {
    std::string key;
    std::vector<std::size_t> indices;  // from 1
};

// Empty if the path is malformed.
std::vector<PathPart> split_path(std::string_view path) {
    std::vector<PathPart> parts;
    while (true) {
        const std::size_t end = std::min(path.find('.'), path.size());
        std::string_view part = path.substr(0, end);
        PathPart result;
        while (part.ends_with(']')) {
            const std::size_t open = part.rfind('[');
            if (open == std::string_view::npos) {
                return {};
            }
            const auto index = bare_number<std::size_t>(part.substr(open + 1, part.size() - open - 2));
            if (index.value_or(0) == 0) {
                return {};
            }
            result.indices.insert(result.indices.begin(), *index);
            part = part.substr(0, open);
        }
        if (part.empty()) {
            return {};
        }
        result.key = std::string(part);
        parts.push_back(std::move(result));
        if (end == path.size()) {
            return parts;
        }
        path = path.substr(end + 1);
    }
}

}  // namespace

const Node* Node::find(std::string_view key) const {
    const auto found = std::ranges::find(entries, key, &Entry::key);
    return found == entries.end() ? nullptr : &found->value;
}

Node* Node::find(std::string_view key) {
    return const_cast<Node*>(std::as_const(*this).find(key));
}

namespace {

std::string_view line_of(std::string_view text, int line) {
    for (; line > 1 && text.find('\n') != std::string_view::npos; --line) {
        text.remove_prefix(text.find('\n') + 1);
    }
    return text.substr(0, text.find('\n'));
}

// Names the mistake that is likely in a line that is no TOML, since the messages of the parser do not.
std::string likely_mistake(std::string_view line) {
    line = line.substr(0, line.find('#'));
    const auto is_digit = [](char letter) { return letter >= '0' && letter <= '9'; };
    const std::size_t comma = line.find(',', line.find('='));
    const bool in_number = comma != std::string_view::npos && comma > 0 && comma + 1 < line.size() &&
                           is_digit(line[comma - 1]) && is_digit(line[comma + 1]);
    const bool quote_missing = std::ranges::count(line, '"') % 2 != 0;
    return quote_missing                                           ? " (a quotation mark may be missing in this line)"
           : in_number && line.find('[') == std::string_view::npos ? " (numbers have a decimal point, no comma)"
                                                                   : "";
}

}  // namespace

Node parse_document(std::string_view text, std::string_view name) {
    if (text.size() > largest_case_bytes) {
        refuse(name, 0, 0, "is larger than 4 MiB, the limit for a case file");
    }
    if (const auto excess = excessive_nesting(text, deepest_nesting)) {
        refuse(name, excess->line, excess->column,
               "is nested more than " + std::to_string(deepest_nesting) + " levels deep");
    }
    try {
        const toml::table table = toml::parse(text, name);
        Node root = Translator(name).translate(table);
        root.place = {.line = 1, .column = 1};
        return root;
    } catch (const toml::parse_error& error) {
        const Place place = place_of(error.source());
        refuse(name, place.line, place.column,
               "is not a case file (TOML): " + std::string(error.description()) +
                   likely_mistake(line_of(text, place.line)));
    }
}

Setting parse_setting(std::string_view text) {
    const std::size_t equals = text.find('=');
    const auto trim = [](std::string_view part) {
        const std::size_t first = std::min(part.find_first_not_of(" \t"), part.size());
        const std::size_t last = part.find_last_not_of(" \t");
        return last == std::string_view::npos ? std::string_view{} : part.substr(first, last - first + 1);
    };
    const std::string_view key = trim(text.substr(0, equals));
    if (equals == std::string_view::npos || key.empty()) {
        refuse("--set", 0, 0, shown(text) + " is not of the form key=value, e.g. slope.height=\"40 m\"");
    }
    return {.key = std::string(key), .value = std::string(trim(text.substr(equals + 1)))};
}

std::string put_value(Node& root, std::string_view path, Node value) {
    const std::vector<PathPart> parts = split_path(path);
    if (parts.empty() || parts.size() > static_cast<std::size_t>(deepest_nesting)) {
        return "is not a key such as slope.height or bolt[1].force";
    }
    Node* target = &root;
    for (const PathPart& part : parts) {
        if (target->kind != Node::Kind::table) {
            return "lies inside a value that is not a section";
        }
        Node* entry = target->find(part.key);
        if (entry == nullptr && part.indices.empty()) {
            entry = &target->entries.emplace_back(Entry{part.key, Node{}}).value;
            entry->place = value.place;
            entry->key_place = value.key_place;
        }
        for (const std::size_t index : part.indices) {
            if (entry == nullptr || entry->kind != Node::Kind::array || index > entry->elements.size()) {
                return "has no element " + std::to_string(index) + " in the case";
            }
            entry = &entry->elements[index - 1];
        }
        target = entry;
    }
    *target = std::move(value);
    return {};
}

void apply_setting(Node& root, const Setting& setting, std::vector<Problem>& problems) {
    if (std::string problem = put_value(root, setting.key, value_of(setting)); !problem.empty()) {
        problems.push_back({"--set", 0, 0, setting.key, setting.value, std::move(problem)});
    }
}

std::string shown(const Node& node) {
    switch (node.kind) {
    case Node::Kind::table:
        return "{ ... }";
    case Node::Kind::array:
        return "[ ... ]";
    case Node::Kind::boolean:
        return node.boolean ? "true" : "false";
    case Node::Kind::date:
        return "a date or time";
    case Node::Kind::integer:
        return std::to_string(node.integer);
    case Node::Kind::real:
        return shortest_number(node.real);
    case Node::Kind::text:
        break;
    }
    return shown(node.text);
}

std::string shown(std::string_view text) {
    constexpr std::size_t most_characters = 60;
    if (text.size() <= most_characters) {
        return in_quotes(text);
    }
    std::size_t end = most_characters;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) {
        --end;
    }
    return in_quotes(std::string(text.substr(0, end)) + "...");
}

std::string in_quotes(std::string_view text) {
    std::string result = "\"";
    for (const char character : text) {
        const auto code = static_cast<unsigned char>(character);
        if (character == '"' || character == '\\') {
            result += '\\';
            result += character;
        } else if (character == '\n') {
            result += "\\n";
        } else if (character == '\t') {
            result += "\\t";
        } else if (code < 0x20 || code == 0x7F) {
            constexpr std::string_view hexadecimal = "0123456789ABCDEF";
            result += "\\u00";
            result += hexadecimal[code >> 4U];
            result += hexadecimal[code & 0xFU];
        } else {
            result += character;
        }
    }
    return result + "\"";
}

}  // namespace delabole
