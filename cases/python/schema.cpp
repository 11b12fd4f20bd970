#include "cases/python/schema.hpp"

#include "cases/program/case/model_list.hpp"
#include "cases/program/reader/described_kinds.hpp"

#include <algorithm>
#include <cctype>
#include <source_location>
#include <stdexcept>
#include <string_view>

namespace delabole {

namespace {

// The compilers write the type in a function's name as [with Type = delabole::SlopeSection...; this takes
// "SlopeSection" out of it, also for delabole::SlopeSection<double>.
template <class Type>
std::string name_of_type() {
    const std::string_view text = std::source_location::current().function_name();
    constexpr std::string_view before = "Type = delabole::";
    const std::size_t begin = text.find(before) + before.size();
    return std::string(text.substr(begin, text.find_first_of("<;]", begin) - begin));
}

// Turns "plane_failure" into "PlaneFailure".
std::string in_camel_case(std::string_view words) {
    std::string name;
    bool begins = true;
    for (const char letter : words) {
        if (letter != '_') {
            name += begins ? static_cast<char>(std::toupper(static_cast<unsigned char>(letter))) : letter;
        }
        begins = letter == '_';
    }
    return name;
}

class Description {
  public:
    std::vector<ClassSchema> take() { return std::move(classes_); }

    template <class Model>
    void add_model() {
        ClassSchema made{in_camel_case(Model::kind), "", "model", std::string(Model::kind)};
        add_fields<Model>(made, false);
        made.meaning = "The model " + made.kind + ": its keys are those of a case file of that model.";
        add(std::move(made));
    }

  private:
    void add(ClassSchema made) {
        if (std::ranges::find(classes_, made.name, &ClassSchema::name) != classes_.end()) {
            throw std::logic_error("two sections would be the class " + made.name);
        }
        classes_.push_back(std::move(made));
    }

    // The name of the class for a section; the class is made if it does not exist.
    template <class Section>
    std::string class_of(std::string_view meaning, std::string_view kind_key = {}, std::string_view kind = {}) {
        std::string name = name_of_type<Section>();
        const auto known = std::ranges::find(classes_, name, &ClassSchema::name);
        if (known == classes_.end()) {
            ClassSchema made{name, std::string(meaning), std::string(kind_key), std::string(kind)};
            add_fields<Section>(made, false);
            add(std::move(made));
        } else if (known->kind_key != kind_key) {
            throw std::logic_error(name + " is a choice in one place and not in another");
        }
        return name;
    }

    template <class Section>
    void add_fields(ClassSchema& owner, bool optional) {
        field_table<Section>.for_each([&](const auto& field) { add_field(owner, optional, field); });
    }

    template <class Owner, class Member>
    void add_field(ClassSchema& owner, bool optional, const Field<Owner, Member>& field) {
        if (field.info.key.empty()) {
            add_inlined<Member>(owner, optional);
            return;
        }
        FieldSchema made{std::string(field.info.key), text_of(field.info)};
        made.optional = optional;
        describe<Member>(made, field.info);
        // Two alternatives of a choice may have the same key, which then occurs once.
        if (std::ranges::find(owner.fields, made.key, &FieldSchema::key) == owner.fields.end()) {
            owner.fields.push_back(std::move(made));
        }
    }

    template <class Member>
    void add_inlined(ClassSchema& owner, bool optional) {
        if constexpr (is_variant<Member>) {
            [&]<class... Types>(const std::variant<Types...>*) {
                (add_fields<Types>(owner, true), ...);
            }(static_cast<const Member*>(nullptr));
        } else if constexpr (Described<Member>) {
            add_fields<Member>(owner, optional);
        }
    }

    template <class Member>
    void describe(FieldSchema& made, const FieldInfo& info) {
        using Kind = FieldSchema::Kind;
        if constexpr (is_optional<Member>) {
            made.optional = true;
            describe<typename Member::value_type>(made, info);
        } else if constexpr (NumberType<Member>) {
            made.dimension = info.dimension;
            made.range = info.range;
        } else if constexpr (std::is_enum_v<Member>) {
            made.kind = Kind::word;
            for (const std::string_view word : enum_names(Member{})) {
                made.words.emplace_back(word);
            }
        } else if constexpr (std::same_as<Member, std::string>) {
            made.kind = Kind::text;
        } else if constexpr (is_list_of_texts<Member>) {
            made.kind = Kind::texts;
            made.optional = true;
        } else if constexpr (is_vector<Member>) {
            made.kind = Kind::sections;
            made.optional = true;
            made.classes.push_back(class_of<typename Member::value_type>(info.meaning));
        } else if constexpr (is_variant<Member>) {
            made.kind = Kind::choice;
            [&]<class... Types>(const std::variant<Types...>*) {
                if constexpr ((requires { Types::kind; } && ...)) {
                    (made.classes.push_back(class_of<Types>(info.meaning, kind_key<Member>(), Types::kind)), ...);
                }
            }(static_cast<const Member*>(nullptr));
        } else {
            made.kind = Kind::section;
            made.classes.push_back(class_of<Member>(info.meaning));
        }
    }

    std::vector<ClassSchema> classes_;
};

template <class... Models>
void add_models(Description& description, const std::variant<Models...>*) {
    (description.add_model<Models>(), ...);
}

}  // namespace

std::vector<ClassSchema> described_classes() {
    Description description;
    add_models(description, static_cast<const Models*>(nullptr));
    return description.take();
}

}  // namespace delabole
