#include "cases/program/results/kept_evaluations.hpp"

#include "cases/program/case/case_writer.hpp"
#include "fitting/work/ranks.hpp"
#include "numerics/archive.hpp"
#include "plots/drawing/atomic_file.hpp"
#include "plots/drawing/text.hpp"
#include "version/version.hpp"

#include <iostream>

namespace delabole {

template <class Type>
requires std::same_as<std::remove_const_t<Type>, StoreTraffic>
auto members_of(Type& traffic) {
    return std::tie(traffic.made, traffic.found, traffic.seconds_made, traffic.seconds_found);
}

KeptEvaluations::KeptEvaluations(const Options& options, const ResultFolder& folder)
    : path_(options.store.empty() ? folder.path() / "evaluations.sqlite" : options.store),
      in_result_folder_(options.store.empty()),
      ranks_(options.ranks),
      quiet_(options.quiet) {
    if (ranks_ == nullptr) {
        return;
    }
    const std::vector<std::string> machines = ranks_->exchange(Ranks::machine());
    const std::string& own = machines[static_cast<std::size_t>(ranks_->number())];
    if (own != machines.front()) {
        path_.replace_filename(path_.stem().string() + '-' + own + path_.extension().string());
    }
}

void KeptEvaluations::keep(ModelInterface& model, const CaseModel& of) {
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
    model = stored(std::move(model), *store_, resolved_model(of));
}

void KeptEvaluations::count_all() {
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
    }
}

void KeptEvaluations::enter(Json& provenance) const {
    if (store_) {
        provenance["evaluation_store"] = store_->path().string();
        provenance["evaluations_made"] = traffic_.made;
        provenance["evaluations_found"] = traffic_.found;
        provenance["evaluation_seconds_made"] = traffic_.seconds_made;
        provenance["evaluation_seconds_found"] = traffic_.seconds_found;
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
    return text + '\n';
}

void KeptEvaluations::say_how_to_go_on() const {
    if (store_) {
        std::cerr << "delabole: the same command goes on from what " << store_->path().string() << " keeps\n";
    }
}

}  // namespace delabole
