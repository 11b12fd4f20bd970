// delabole check, show and init
#include "cases/program/case/case_writer.hpp"
#include "cases/program/commands/commands.hpp"
#include "cases/program/reader/case_error.hpp"
#include "cases/program/reader/spelling.hpp"
#include "cases/program/results/impossible_case.hpp"
#include "cases/program/results/result_folder.hpp"
#include "plots/drawing/atomic_file.hpp"

#include <algorithm>
#include <iostream>

namespace delabole {

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

ExitCode init_command(const std::string& model, const Options& options) {
    const std::vector<std::string> models = model_names();
    if (std::ranges::find(models, model) == models.end()) {
        throw UsageError("init: no model is named '" + model + "'; there is " + choices(models) +
                         suggestion(model, models));
    }
    const std::string text = commented_template(model);
    if (options.out.empty()) {
        std::cout << text;
        return ExitCode::ok;
    }
    std::error_code ignored;  // what cannot be looked at cannot be written either, and the writer says why
    if (std::filesystem::exists(options.out, ignored)) {
        throw OutputError(options.out, "it exists already and is not overwritten");
    }
    write_file_atomically(end_of_links(options.out), text);
    return ExitCode::ok;
}

}  // namespace delabole
