// The evaluation store of a study as its command uses it.
#pragma once

#include "cases/program/case/case_file.hpp"
#include "cases/program/results/result_folder.hpp"
#include "cases/program/terminal/options.hpp"
#include "fitting/work/evaluation_store.hpp"

#include <memory>
#include <string>

namespace delabole {

class KeptEvaluations {
  public:
    // --store, or evaluations.sqlite in the result folder: opened once a model asks for it, so that studies of models
    // that are not costly leave no file. Ranks on another machine than the leader's, which may not write the same file,
    // have one of their own beside it, named after theirs. Every rank calls this.
    KeptEvaluations(const Options& options, const ResultFolder& folder);

    // Makes the model look into the store where it is costly. `of`: what the model was made from.
    void keep(ModelInterface& model, const CaseModel& of);

    // To be called by every rank, once the study is done: its evaluations are counted together with theirs.
    void count_all();
    // For the provenance: the store, and how many evaluations were made and found. Nothing where there is none.
    void enter(Json& provenance) const;
    // One line for the reader of the screen, with its end; empty where there is no store.
    std::string summary() const;
    // Says so on standard error after a study that did not come to its end.
    void say_how_to_go_on() const;

  private:
    std::filesystem::path path_;
    bool in_result_folder_;  // and so not named by the user
    std::unique_ptr<EvaluationStore> store_;
    const Ranks* ranks_;
    bool quiet_;
    StoreTraffic traffic_;
};

}  // namespace delabole
