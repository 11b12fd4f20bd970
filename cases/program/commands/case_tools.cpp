// delabole check, show, init, inputs and outputs
#include "cases/program/case/case_writer.hpp"
#include "cases/program/case/model_outputs.hpp"
#include "cases/program/case/starting_cases.hpp"
#include "cases/program/commands/commands.hpp"
#include "cases/program/reader/case_error.hpp"
#include "cases/program/reader/names.hpp"
#include "cases/program/reader/units.hpp"
#include "cases/program/results/analysis.hpp"
#include "cases/program/results/problems_of_case.hpp"
#include "cases/program/results/result_folder.hpp"
#include "fitting/work/words.hpp"
#include "kinematics/kinematics.hpp"
#include "plots/drawing/atomic_file.hpp"
#include "plots/drawing/text.hpp"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace delabole {

namespace {

// Some outputs exist only under the conditions of an entry, so a quantity that resembles the name of an output leads to
// a question and not to an error.
std::vector<std::string> doubts_about_expectations(const CaseFile& file) {
    std::vector<std::string> outputs;  // computed only if needed, because a slope may have to be cut for it
    std::vector<std::string> doubts;
    for (const Expectation& expected : file.expectations) {
        if (expected.dimension || !(expected.tolerance || expected.relative_tolerance)) {
            continue;
        }
        if (outputs.empty()) {
            outputs = names_in(known_outputs(file.model));
        }
        if (const std::string meant = suggestion(expected.quantity, outputs); !meant.empty()) {
            doubts.push_back("line " + std::to_string(expected.place.line) + ": is " + expected.quantity +
                             " an output of the model?" + meant);
        }
    }
    return doubts;
}

}  // namespace

ExitCode check_command(const Paths& cases, const Options& options) {
    Json json = Json::array();
    bool all_valid = true;
    for (const std::filesystem::path& path : cases) {
        Json entry;
        entry["case"] = path.string();
        try {
            const CaseFile file = read_case(path, settings_of(options));
            refuse_impossible(file);
            entry["status"] = "ok";
            std::vector<std::string> questions = questions_about(file.model);
            std::ranges::move(doubts_about_expectations(file), std::back_inserter(questions));
            entry["questions"] = questions;
            for (const std::string& question : questions) {
                std::cerr << path.string() << ": " << question << '\n';
            }
            if (!options.json && !options.quiet) {
                std::cout << path.string() << ": ok\n";
            }
        } catch (const CaseError& error) {
            all_valid = false;
            entry["status"] = "invalid";
            entry["problems"] = Json::array();
            for (const Problem& problem : error.problems()) {
                entry["problems"].push_back(to_string(problem));
            }
            std::cerr << error.what() << '\n';
        }
        json.push_back(std::move(entry));
    }
    if (options.json) {
        std::cout << json_text(json);
    }
    return all_valid ? ExitCode::ok : ExitCode::invalid_case;
}

ExitCode show_command(const std::filesystem::path& path, const Options& options) {
    const CaseFile file = read_case(path, settings_of(options));
    if (options.json) {
        Json json;
        json["case"] = file.name;
        json["hash"] = case_hash(file);
        json["resolved"] = resolved_toml(file);
        std::cout << json_text(json);
    } else {
        std::cout << resolved_toml(file);
    }
    return ExitCode::ok;
}

namespace {

// The case in that file, the template of the model with that name, or the starting case with that name.
CaseFile case_or_model(const std::string& what, const Options& options) {
    const std::vector<std::string> models = model_names();
    if (std::ranges::find(models, what) != models.end()) {
        return parse_case(commented_template(what), what, settings_of(options));
    }
    const std::vector<std::string> names = starting_case_names();
    if (std::ranges::find(names, what) != names.end()) {
        return parse_case(starting_case(what), what, settings_of(options));
    }
    std::error_code ignored;
    if (!what.ends_with(".toml") && !std::filesystem::exists(what, ignored)) {
        throw UsageError("'" + what + "' is neither a name that init takes (" + choices(names) + ") nor a case file" +
                         suggestion(what, names));
    }
    return read_case(what, settings_of(options));
}

// Replaces everything from the line that begins with `first` to the next one that ends with `last`.
void replace_lines(std::string& text, const std::string& first, std::string_view last, const std::string& lines) {
    const std::size_t line_before = text.find("\n" + first);
    const std::size_t last_line = text.find(std::string(last) + "\n", line_before);
    if (line_before == std::string::npos || last_line == std::string::npos) {
        throw std::logic_error("the starting case of a jointed slope has no lines from " + first);
    }
    text.replace(line_before + 1, last_line + last.size() - line_before - 1, lines);
}

std::string corner(double x, double y) {
    return "    { x = \"" + human_number(x, 3) + " m\", y = \"" + human_number(y, 3) + " m\" },\n";
}

// Angles are rounded to a tenth of a degree.
std::string written_angle(double angle) {
    return human_number(std::round(angle / degrees(0.1)) / 10, 4) + " deg";
}

// Returns the starting case of a jointed slope with the face of the study, its friction, and a cut for each of its sets
// at the apparent dip of its mean in the section across the face. Sets that strike within 30 deg of the section are
// only named in a comment, since they could not be drawn as lines. Spacings do not follow from orientations: each cut
// has one to be replaced. The title includes that of the study. The result's check must be valid. Throws
// std::invalid_argument if no set is left.
std::string jointed_slope_of(const KinematicsStudy& study, const std::string& title, const KinematicsResult& result) {
    constexpr double near_the_section = degrees(30);
    constexpr double height = 12;  // m, as in the starting case
    constexpr double bench = 14;
    const SlopeOrientation& face = study.model.slope;
    std::string cuts;
    std::string left_out;
    for (const JointSetFeasibility& set : result.joint_set) {
        if (std::abs(std::cos(set.mean.dip_direction - face.face_dip_direction)) < std::sin(near_the_section)) {
            left_out += (left_out.empty() ? "" : ", ") + in_quotes(set.name);
            continue;
        }
        cuts += "    { name = " + in_quotes(set.name) + ", joint = \"joints\", trace = { kind = \"set\", dip = \"" +
                written_angle(set.apparent_dip) + "\", spacing = \"3 m\" } },  # scatters by " +
                written_angle(set.angular_standard_deviation) +
                (set.measured ? "; its mean is known to " + written_angle(set.measured->confidence_cone) + " with 95 %"
                              : "") +
                "\n";
    }
    if (cuts.empty()) {
        throw std::invalid_argument("no joint set crosses the section across the face: all strike within 30 deg of it");
    }
    const double crest = height / std::tan(face.face_dip);
    std::string text = starting_case("jointed_slope");
    replace_lines(text, "title = ", "\"",
                  "title = " + in_quotes(title + (title.empty() ? "A" : ": a") + " slope cut by its joint sets"));
    replace_lines(text, "outline = [", "\n]",
                  "outline = [\n" + corner(0, 0) + corner(crest + bench, 0) + corner(crest + bench, height) +
                      corner(crest, height) + "]");
    replace_lines(text, "joint = [", "]",
                  "joint = [{ name = \"joints\", friction_angle = \"" +
                      written_angle(study.model.strength.friction_angle) + "\" }]");
    replace_lines(text, "cut = [", "\n]",
                  "# Dips in the section across the face; the spacings are examples: replace them by measured ones.\n" +
                      (left_out.empty() ? "" : "# Without sets that strike within 30 deg of it: " + left_out + ".\n") +
                      "cut = [\n" + cuts + "]");
    return text;
}

// A slope cut by the joint sets of a study, which is given by its case or its result folder.
std::string slope_with_sets(const std::filesystem::path& path) {
    std::error_code ignored;
    const CaseFile file = read_case(std::filesystem::is_directory(path, ignored) ? path / "resolved.toml" : path);
    const auto* study = std::get_if<KinematicsStudy>(&file.model);
    if (study == nullptr) {
        throw UsageError("init: --sets " + path.string() + ": is a case of model " +
                         std::string(model_name(file.model)) + "; joint sets are those of one of model kinematics");
    }
    refuse_impossible(file);
    try {
        return jointed_slope_of(*study, file.title, analyse(*study));
    } catch (const std::invalid_argument& error) {
        throw UsageError("init: --sets " + path.string() + ": " + error.what());
    }
}

void print(const std::vector<Quantity>& quantities, const std::string& text, const Options& options) {
    if (!options.json) {
        std::cout << text;
        return;
    }
    Json json = Json::array();
    for (const Quantity& quantity : quantities) {
        json.push_back({{"name", quantity.name},
                        {"unit", std::string(display_unit(quantity.dimension).symbol)},
                        {"meaning", quantity.meaning}});
    }
    std::cout << json_text(json);
}

}  // namespace

ExitCode inputs_command(const std::string& what, const Options& options) {
    const CaseFile file = case_or_model(what, options);
    print(named_inputs(file.model), described_inputs(file), options);
    return ExitCode::ok;
}

ExitCode outputs_command(const std::string& what, const Options& options) {
    const std::vector<Quantity> outputs = known_outputs(case_or_model(what, options).model);
    std::vector<std::vector<std::string>> rows{{"output", "unit", "meaning"}};
    for (const Quantity& output : outputs) {
        rows.push_back({output.name, std::string(display_unit(output.dimension).symbol), output.meaning});
    }
    print(outputs, aligned_columns(rows), options);
    return ExitCode::ok;
}

ExitCode init_command(const CaseToStart& start, const Options& options) {
    const std::string& name = start.name;
    const std::vector<std::string> names = starting_case_names();
    if (std::ranges::find(names, name) == names.end()) {
        throw UsageError("init: no case to start from is named '" + name + "'; the names are " + list_in_words(names) +
                         suggestion(name, names));
    }
    if (!start.sets.empty() && name != "jointed_slope") {
        throw UsageError("init: --sets belongs to jointed_slope, not to " + name);
    }
    const std::string text = !start.sets.empty() ? slope_with_sets(start.sets)
                             : options.full      ? commented_template(name)
                                                 : starting_case(name);
    if (options.out.empty()) {
        std::cout << text;
        return ExitCode::ok;
    }
    // if the file cannot be examined it cannot be written either, and write_file_atomically reports why
    std::error_code ignored;
    if (std::filesystem::exists(options.out, ignored)) {
        throw OutputError(options.out, "it exists already and is not overwritten");
    }
    write_file_atomically(end_of_links(options.out), text);
    return ExitCode::ok;
}

}  // namespace delabole
