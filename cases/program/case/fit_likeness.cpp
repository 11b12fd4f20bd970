// [[fit.mechanism]] with `like`: a mechanism that differs from an earlier one in a few values.
#include "cases/program/case/case_parts.hpp"

#include "cases/program/reader/section.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace delabole {

namespace {

// Limit of copies. Each is as large as the mechanism that it copies, and a small file must not become a huge case.
constexpr std::size_t most_alike = 20;

Node* mechanisms_in(Node& tree) {
    Node* fit = tree.find("fit");
    Node* mechanisms = fit != nullptr && fit->kind == Node::Kind::table ? fit->find("mechanism") : nullptr;
    return mechanisms != nullptr && mechanisms->kind == Node::Kind::array ? mechanisms : nullptr;
}

// The earlier mechanism of that name; complains and returns null if there is none.
const Node* find_like(const std::vector<Node>& mechanisms, std::size_t index, const Node& like, const std::string& path,
                      Reading& reading) {
    const std::optional<std::string> name = read_text(reading, like, path);
    if (!name) {
        return nullptr;
    }
    const auto end = mechanisms.begin() + static_cast<std::ptrdiff_t>(index);
    const auto found = std::find_if(mechanisms.begin(), end, [&](const Node& other) {
        const Node* text = other.find("name");
        return text != nullptr && text->kind == Node::Kind::text && text->text == *name;
    });
    if (found == end) {
        reading.complain(like.place, path, shown(like), "is not the name of an earlier mechanism");
        return nullptr;
    }
    return &*found;
}

void put_values(Node& mechanism, const Node& with, const std::string& path, Reading& reading) {
    if (const Node* table = as_table(reading, with, path)) {
        for (const auto& [key, value] : table->entries) {
            if (const std::string problem = put_value(mechanism, key, value); !problem.empty()) {
                reading.complain(value.place, path + "." + key, shown(value), problem);
            }
        }
    }
}

}  // namespace

void copy_alike_mechanisms(Node& tree, Reading& reading) {
    Node* list = mechanisms_in(tree);
    std::size_t alike = 0;
    for (std::size_t index = 0; list != nullptr && index < list->elements.size(); ++index) {
        const std::string path = "fit.mechanism[" + std::to_string(index + 1) + "]";
        Node own = list->elements[index];
        const Node* like = own.kind == Node::Kind::table ? own.find("like") : nullptr;
        if (like == nullptr) {
            continue;
        }
        if (++alike > most_alike) {
            reading.complain(
                like->place, path + ".like", shown(*like),
                "is one more than the " + std::to_string(most_alike) + " mechanisms that may be like others");
            return;
        }
        const Node* model = find_like(list->elements, index, *like, path + ".like", reading);
        Node made = model == nullptr ? Node{} : *model;
        made.place = own.place;
        made.key_place = own.key_place;
        std::erase_if(made.entries, [](const Entry& entry) { return entry.key == "title"; });
        for (const Entry& entry : own.entries) {
            if (entry.key != "like" && entry.key != "with") {
                std::erase_if(made.entries, [&](const Entry& other) { return other.key == entry.key; });
                made.entries.push_back(entry);
            }
        }
        if (const Node* with = own.find("with"); with != nullptr && model != nullptr) {
            put_values(made, *with, path + ".with", reading);
        }
        list->elements[index] = std::move(made);
    }
}

}  // namespace delabole
