#include "cases/program/case/case_writer.hpp"

#include "cases/program/case/case_parts.hpp"
#include "cases/program/reader/described_writer.hpp"
#include "numerics/fnv_1a.hpp"

#include <algorithm>

namespace delabole {
namespace {

void write_coarse(std::string& text, const FitMechanism& mechanism) {
    if (!mechanism.coarse) {
        return;
    }
    text += "\n[fit.mechanism.coarse]\n";
    std::string sections;
    std::visit(
        [&](const auto& model) {
            const auto& base = std::get<std::remove_cvref_t<decltype(model)>>(mechanism.model);
            write_differences(text, sections, base, model, "fit.mechanism.coarse");
        },
        *mechanism.coarse);
    text += sections;
}

void write_mechanism(std::string& text, const FitMechanism& mechanism, const CaseModel& base) {
    text += "\n[[fit.mechanism]]\n";
    write_values(text, mechanism);
    std::string sections;
    std::visit(
        [&](const auto& model) {
            if (const auto* base_model = std::get_if<std::remove_cvref_t<decltype(model)>>(&base)) {
                write_differences(text, sections, *base_model, model, "fit.mechanism");
            } else {
                write_line(text, "model", in_quotes(model_name(mechanism.model)));
                write_values(text, model);
                write_sections(sections, model, "fit.mechanism");
            }
        },
        mechanism.model);
    text += sections;
    write_coarse(text, mechanism);
    write_sections(text, mechanism, "fit.mechanism");
}

void write_fit(std::string& text, const CaseFit& fit, const CaseModel& base) {
    text += "\n[fit]\n";
    write_values(text, fit);
    visit_fields(fit, [&](const FieldInfo& info, const auto& member) {
        if (info.key == "observation") {
            for (const FitMechanism& mechanism : fit.mechanisms) {
                write_mechanism(text, mechanism, base);
            }
        }
        detail::write_section(text, info, member, "fit", Dimension::ratio);
    });
}

std::size_t characters_in(std::string_view text) {
    return static_cast<std::size_t>(
        std::ranges::count_if(text, [](char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U; }));
}

}  // namespace

std::string resolved_model(const CaseModel& model) {
    std::string text;
    write_line(text, "model", in_quotes(model_name(model)));
    std::visit(
        [&](const auto& parameters) {
            write_values(text, parameters);
            write_sections(text, parameters, "");
        },
        model);
    return text;
}

std::string resolved_toml(const CaseFile& case_file) {
    std::string text = "schema = 1\n";
    write_text(text, "title", case_file.title);
    write_text(text, "description", case_file.description);
    text += resolved_model(case_file.model);
    if (!case_file.sources.empty()) {
        text += "\n[sources]\n";
        for (const auto& [key, source] : case_file.sources) {
            write_line(text, in_quotes(key), in_quotes(source));
        }
    }
    for (const Expectation& expectation : case_file.expectations) {
        text += "\n[[expect]]\n";
        write_values(text, expectation);
    }
    for (const CaseSweep& sweep : case_file.sweeps) {
        write_sweep(text, sweep);
    }
    if (case_file.fit) {
        write_fit(text, *case_file.fit, case_file.model);
    }
    if (case_file.sensitivity) {
        text += "\n[sensitivity]\n";
        write_values(text, *case_file.sensitivity);
        write_sections(text, *case_file.sensitivity, "sensitivity");
    }
    if (case_file.report) {
        text += "\n[report]\n";
        write_values(text, *case_file.report);
    }
    if (case_file.support_design) {
        text += "\n[support_design]\n";
        write_values(text, *case_file.support_design);
        write_sections(text, *case_file.support_design, "support_design");
    }
    return text;
}

std::string case_hash(const CaseFile& case_file) {
    std::uint64_t hash = fnv_1a(resolved_toml(case_file));
    constexpr std::string_view digits = "0123456789abcdef";
    std::string text(16, '0');
    for (auto digit = text.rbegin(); digit != text.rend(); ++digit, hash >>= 4U) {
        *digit = digits[hash & 0xFU];
    }
    return text;
}

std::string aligned_columns(const std::vector<std::vector<std::string>>& rows, FurtherColumns further) {
    std::vector<std::size_t> widths;
    for (const auto& row : rows) {
        widths.resize(std::max(widths.size(), row.size()));
        for (std::size_t column = 0; column < row.size(); ++column) {
            widths[column] = std::max(widths[column], characters_in(row[column]));
        }
    }
    std::string text;
    for (const auto& row : rows) {
        std::string line;
        for (std::size_t column = 0; column < row.size(); ++column) {
            const std::string padding(widths[column] - characters_in(row[column]), ' ');
            const bool left = column == 0 || further == FurtherColumns::left;
            line += (column == 0 ? "" : "  ") + (left ? row[column] + padding : padding + row[column]);
        }
        line.erase(line.find_last_not_of(' ') + 1);
        text += line + "\n";
    }
    return text;
}

std::string described_inputs(const CaseFile& case_file) {
    std::vector<std::vector<std::string>> rows{{"input", "value", "allowed", "meaning", "source"}};
    for (const Quantity& input : named_inputs(case_file.model)) {
        const auto source = case_file.sources.find(input.name);
        const std::string range = readable_range(input.range, input.dimension);
        rows.push_back({input.name, readable_quantity(input.value, input.dimension), range.empty() ? "any" : range,
                        input.meaning, source == case_file.sources.end() ? "" : source->second});
    }
    return aligned_columns(rows);
}

}  // namespace delabole
