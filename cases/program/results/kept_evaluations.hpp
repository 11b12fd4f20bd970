// The evaluation store of a command, and tables of runs.
#pragma once

#include "cases/program/case/case_file.hpp"
#include "cases/program/results/result_folder.hpp"
#include "cases/program/terminal/options.hpp"
#include "fitting/work/evaluation_store.hpp"
#include "fitting/work/run_table.hpp"

#include <map>
#include <memory>
#include <string>

namespace delabole {

class KeptEvaluations {
  public:
    // The store is --store, or evaluations.sqlite in the result folder. It is opened when the first costly model needs
    // it, so that studies without one leave no file. Ranks on other machines than the leader's, which must not write to
    // the same file, have a store of their own beside it, named after their machine. Every rank calls this.
    KeptEvaluations(const Options& options, const ResultFolder& folder);

    // Makes a costly model use the store, and before it the table of its runs in the folder --runs. `of` is the case's
    // model from which it was made, `name` names its table. Throws StoreError for a table of another model.
    void keep(ModelInterface& model, const CaseModel& of, const std::string& name);

    // Every rank has to call this after the study; it collects the evaluations of all ranks.
    void collect();
    // If --runs was given, writes a table for each model with the runs that the study used.
    void write_runs(const ResultFolder& folder) const;
    // Adds the store and the number of evaluations made and found to the provenance, if there is a store.
    void enter(Json& provenance) const;
    // One line for the terminal, with its line end; empty if there is no store.
    std::string summary() const;
    // After a study that did not come to its end, tells on standard error that the same command continues from the
    // store.
    void say_how_to_go_on() const;

  private:
    long found_in_tables() const;

    std::filesystem::path path_;
    bool in_result_folder_;  // not given by --store
    std::unique_ptr<EvaluationStore> store_;
    const Ranks* ranks_;
    bool quiet_;
    StoreTraffic traffic_;
    std::filesystem::path runs_;                // empty: no tables
    std::map<std::string, TabledRuns> tabled_;  // by the names of the models
};

}  // namespace delabole
