#include "plots/drawing/svg.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>
#include <vector>

namespace delabole {

namespace {

struct Attribute {
    std::string name;
    std::string value;  // as written between the quotes, entities kept
};

struct Tag {
    std::string name;
    std::vector<Attribute> attributes;
    bool closing = false;       // </name>
    bool self_closing = false;  // <name/>
};

bool is_space(char letter) {
    return std::isspace(static_cast<unsigned char>(letter)) != 0;
}

std::string lower_case(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
    return text;
}

// Position of the '>' that ends the tag starting at `begin`; '>' may stand within quotes.
std::size_t tag_end(std::string_view text, std::size_t begin) {
    char quote = 0;
    for (std::size_t index = begin; index < text.size(); ++index) {
        if (quote != 0) {
            quote = text[index] == quote ? '\0' : quote;
        } else if (text[index] == '"' || text[index] == '\'') {
            quote = text[index];
        } else if (text[index] == '>') {
            return index;
        }
    }
    return std::string_view::npos;
}

// `text` without the enclosing < and >.
Tag parse_tag(std::string_view text) {
    Tag tag;
    if (text.starts_with('/')) {
        tag.closing = true;
        text.remove_prefix(1);
    }
    if (text.ends_with('/')) {
        tag.self_closing = true;
        text.remove_suffix(1);
    }
    std::size_t index = 0;
    const auto skip_spaces = [&] {
        while (index < text.size() && is_space(text[index])) {
            ++index;
        }
    };
    const auto word = [&] {
        const std::size_t begin = index;
        while (index < text.size() && !is_space(text[index]) && text[index] != '=') {
            ++index;
        }
        return std::string(text.substr(begin, index - begin));
    };
    tag.name = word();
    for (skip_spaces(); index < text.size(); skip_spaces()) {
        Attribute attribute{.name = word(), .value = ""};
        skip_spaces();
        if (index < text.size() && text[index] == '=') {
            ++index;
            skip_spaces();
            if (index < text.size() && (text[index] == '"' || text[index] == '\'')) {
                const std::size_t end = std::min(text.find(text[index], index + 1), text.size());
                attribute.value = text.substr(index + 1, end - index - 1);
                index = std::min(end + 1, text.size());
            } else {
                attribute.value = word();
            }
        } else if (attribute.name.empty()) {
            break;
        }
        tag.attributes.push_back(std::move(attribute));
    }
    return tag;
}

void prefix_references(std::string& value, std::string_view id_prefix) {
    for (const std::string_view opening : {"url(#", "url('#", "url(\"#"}) {
        for (std::size_t at = value.find(opening); at != std::string::npos; at = value.find(opening, at)) {
            at += opening.size();
            value.insert(at, id_prefix);
        }
    }
}

// False if the attribute has to be removed.
bool keep_attribute(Attribute& attribute, std::string_view id_prefix) {
    const std::string name = lower_case(attribute.name);
    if (name.starts_with("on")) {
        return false;
    }
    if (name == "id") {
        attribute.value.insert(0, id_prefix);
    } else if (name == "href" || name == "xlink:href") {
        if (attribute.value.starts_with('#')) {
            attribute.value.insert(1, id_prefix);
        } else if (!attribute.value.starts_with("data:image/")) {
            return false;  // the page must not load anything
        }
    }
    prefix_references(attribute.value, id_prefix);
    return true;
}

std::string written(const Tag& tag) {
    std::string text = tag.closing ? "</" : "<";
    text += tag.name;
    for (const Attribute& attribute : tag.attributes) {
        const char quote = attribute.value.find('"') == std::string::npos ? '"' : '\'';
        text += ' ' + attribute.name + '=' + quote + attribute.value + quote;
    }
    return text + (tag.self_closing ? "/>" : ">");
}

// Elements whose text is removed: scripts are unwanted, and gnuplot's titles ("gnuplot_plot_1") would show as tool
// tips.
bool dropped(const std::string& name) {
    const std::string lower = lower_case(name);
    return lower == "script" || lower == "title" || lower == "desc" || lower == "foreignobject";
}

void make_root(Tag& tag, std::string_view description) {
    std::erase_if(tag.attributes, [](const Attribute& attribute) {
        return attribute.name == "width" || attribute.name == "height" || attribute.name == "role" ||
               attribute.name == "aria-label";
    });
    tag.attributes.push_back({"width", "100%"});
    tag.attributes.push_back({"role", "img"});
    tag.attributes.push_back({"aria-label", escape_html(description)});
}

}  // namespace

std::string escape_html(std::string_view text) {
    std::string result;
    result.reserve(text.size());
    for (const char letter : text) {
        if (const std::size_t special = std::string_view("&<>\"'").find(letter); special != std::string_view::npos) {
            constexpr std::array entities{"&amp;", "&lt;", "&gt;", "&quot;", "&#39;"};
            result += entities[special];
            continue;
        }
        const bool control = static_cast<unsigned char>(letter) < 0x20 || letter == 0x7f;
        result += control && letter != '\n' ? ' ' : letter;
    }
    return result;
}

std::string inline_svg(std::string_view file, std::string_view id_prefix, std::string_view description) {
    const std::size_t begin = file.find("<svg");
    const std::size_t end = file.rfind("</svg>");
    if (begin == std::string_view::npos || end == std::string_view::npos || end < begin) {
        return {};
    }
    const std::string_view svg = file.substr(begin, end + 6 - begin);

    std::string result;
    std::string dropping;  // name of the element that is being left out
    bool root = true;
    std::size_t index = 0;
    while (index < svg.size()) {
        const std::size_t opening = std::min(svg.find('<', index), svg.size());
        if (dropping.empty()) {
            result += svg.substr(index, opening - index);
        }
        if (opening == svg.size()) {
            break;
        }
        if (svg.substr(opening).starts_with("<!--")) {
            const std::size_t comment_end = svg.find("-->", opening);
            index = comment_end == std::string_view::npos ? svg.size() : comment_end + 3;
            continue;
        }
        const std::size_t closing = tag_end(svg, opening + 1);
        if (closing == std::string_view::npos) {
            return {};
        }
        Tag tag = parse_tag(svg.substr(opening + 1, closing - opening - 1));
        index = closing + 1;
        if (!dropping.empty()) {
            if (tag.closing && tag.name == dropping) {
                dropping.clear();
            }
            continue;
        }
        if (dropped(tag.name)) {
            if (!tag.self_closing && !tag.closing) {
                dropping = tag.name;
            }
            continue;
        }
        std::vector<Attribute> kept;
        for (Attribute& attribute : tag.attributes) {
            if (keep_attribute(attribute, id_prefix)) {
                kept.push_back(std::move(attribute));
            }
        }
        tag.attributes = std::move(kept);
        if (std::exchange(root, false)) {
            make_root(tag, description);
        }
        result += written(tag);
    }
    return result;
}

}  // namespace delabole
