#include "cases/program/results/kept_evaluations.hpp"

#include "cases/program/case/case_writer.hpp"
#include "cases/program/reader/ordinary_file.hpp"
#include "fitting/work/ranks.hpp"
#include "numerics/archive.hpp"
#include "plots/drawing/atomic_file.hpp"
#include "plots/drawing/text.hpp"
#include "version/version.hpp"

#include <iostream>

namespace delabole {

DELABOLE_MEMBERS(RunTable::Outcome, failure, outputs, profile)
DELABOLE_MEMBERS(StoreTraffic, made, found, seconds_made, seconds_found)

namespace {

std::string file_of_table(const std::string& name) {
    return name + "_predictions.csv";
}

// Reads the table in a file; returns `empty` if there is no file.
RunTable known_runs(const std::filesystem::path& path, RunTable empty) {
    constexpr std::size_t largest = std::size_t{256} << 20;
    if (std::error_code ignored; !std::filesystem::exists(path, ignored)) {
        return empty;
    }
    const FileContent content = read_ordinary_file(path, "a table of runs", largest);
    if (!content.fault.empty()) {
        throw StoreError(path.string() + ' ' + content.fault);
    }
    try {
        empty.read(content.bytes);
    } catch (const RunTableError& error) {
        throw StoreError(path.string() + ", " + error.what());
    }
    return empty;
}

// Gives every rank the runs of all.
void exchange_runs(const Ranks& ranks, TabledRuns& runs) {
    ArchiveWriter writer;
    writer.put(runs.found);
    writer.put(static_cast<std::uint64_t>(runs.used.runs().size()));
    for (const auto& [key, outcome] : runs.used.runs()) {
        writer.put(key);
        writer.put(outcome);
    }
    runs.found = 0;
    for (const std::string& bytes : ranks.exchange(writer.bytes())) {
        ArchiveReader reader(bytes);
        long found = 0;
        std::uint64_t count = 0;
        reader.get(found);
        reader.get(count);
        runs.found += found;
        for (; count > 0; --count) {
            RunTable::Key key;
            RunTable::Outcome outcome;
            reader.get(key);
            reader.get(outcome);
            runs.used.add(key, outcome);
        }
    }
}

}  // namespace

KeptEvaluations::KeptEvaluations(const Options& options, const ResultFolder& folder)
    : path_(options.store.empty() ? folder.path() / "evaluations.sqlite" : options.store),
      in_result_folder_(options.store.empty()),
      ranks_(options.ranks),
      quiet_(options.quiet),
      runs_(options.runs) {
    if (ranks_ == nullptr) {
        return;
    }
    const std::vector<std::string> machines = ranks_->exchange(Ranks::machine());
    const std::string& own = machines[static_cast<std::size_t>(ranks_->number())];
    if (own != machines.front()) {
        path_.replace_filename(path_.stem().string() + '-' + own + path_.extension().string());
    }
}

void KeptEvaluations::keep(ModelInterface& model, const CaseModel& of, const std::string& name) {
    if (!model.costly) {
        return;
    }
    if (!store_) {
        if (in_result_folder_) {
            refuse_link(path_);
        }
        store_ = std::make_unique<EvaluationStore>(path_, fingerprint());
        if (ranks_ != nullptr && !ranks_->alone() && ranks_->leads() && !quiet_) {
            std::cerr << "delabole: " << ranks_->count() << " ranks; should one be lost, the same command goes on from "
                      << path_.string() << '\n';
        }
    }
    const std::string description = resolved_model(of);
    model = stored(std::move(model), *store_, description);
    if (!runs_.empty()) {
        const RunTable empty(model, description);
        TabledRuns& runs =
            tabled_.try_emplace(name, known_runs(runs_ / file_of_table(name), empty), empty).first->second;
        model = tabled(std::move(model), runs);
    }
}

void KeptEvaluations::collect() {
    if (!store_) {
        return;
    }
    const StoreTraffic own = store_->traffic();
    traffic_ = own;
    if (ranks_ != nullptr) {
        ArchiveWriter writer;
        writer.put(own);
        traffic_ = {};
        for (const std::string& bytes : ranks_->exchange(writer.bytes())) {
            StoreTraffic one;
            ArchiveReader(bytes).get(one);
            traffic_.made += one.made;
            traffic_.found += one.found;
            traffic_.seconds_made += one.seconds_made;
            traffic_.seconds_found += one.seconds_found;
        }
        for (auto& [name, runs] : tabled_) {
            exchange_runs(*ranks_, runs);
        }
    }
}

void KeptEvaluations::write_runs(const ResultFolder& folder) const {
    for (const auto& [name, runs] : tabled_) {
        folder.write(file_of_table(name), runs.used.text());
    }
}

void KeptEvaluations::enter(Json& provenance) const {
    if (store_) {
        provenance["evaluation_store"] = store_->path().string();
        provenance["evaluations_made"] = traffic_.made;
        provenance["evaluations_found"] = traffic_.found;
        provenance["evaluation_seconds_made"] = traffic_.seconds_made;
        provenance["evaluation_seconds_found"] = traffic_.seconds_found;
        if (!tabled_.empty()) {
            provenance["evaluations_from_tables"] = found_in_tables();
        }
    }
}

std::string KeptEvaluations::summary() const {
    if (!store_) {
        return {};
    }
    std::string text = std::to_string(traffic_.made) + " evaluations made, " + std::to_string(traffic_.found) +
                       " found in " + store_->path().string();
    if (traffic_.seconds_found > 0) {
        text += ", which saved " + human_number(traffic_.seconds_found, 2) + " s of one processor";
    }
    text += '\n';
    if (!tabled_.empty()) {
        text += std::to_string(found_in_tables()) + " found in tables of runs in " + runs_.string() + '\n';
    }
    return text;
}

long KeptEvaluations::found_in_tables() const {
    long found = 0;
    for (const auto& [name, runs] : tabled_) {
        found += runs.found;
    }
    return found;
}

void KeptEvaluations::say_how_to_go_on() const {
    if (store_) {
        std::cerr << "delabole: the same command goes on from what " << store_->path().string() << " keeps\n";
    }
}

}  // namespace delabole
