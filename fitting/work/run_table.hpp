// Predictions of a costly model as a text, to be kept beside its case: a study that needs them again is repeated in
// seconds, by another version of the program or on another processor, too.
//
// Unlike the evaluation store, which promises the last bit, a table is read by people and lasts: inputs are written
// with 12 significant digits, outputs with 9 and profiles with 6, and corners of a profile are left out where it stays
// within 1/5000 of its extent. A study that makes the table uses inputs and predictions as they are written, so that
// one which reads it asks for the same runs. A prediction is found if each of its inputs agrees to 1e-9, which is far
// more than the processors' elementary functions differ by.
//
// The text is CSV without quotes. Its first line names the model by a hash, the second one the columns: inputs that are
// set in any run (empty: the base value), `failure`, outputs (empty: NaN; left out where all are), and `profile`, the
// coordinates of its corners separated by spaces. All numbers are SI.
#pragma once

#include "parameters/model_interface.hpp"

#include <cstddef>
#include <map>
#include <mutex>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace delabole {

// The text is no table of runs of this model. what() says so in words, beginning with the line: "line 3: ...".
class RunTableError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

class RunTable {
  public:
    // A run by its inputs, sorted by index, each once.
    using Key = std::vector<std::pair<std::size_t, double>>;
    struct Outcome {
        std::string failure;
        std::vector<double> outputs;
        Polyline profile;
    };
    static Key key_of(std::span<const Assignment> assignments);

    // `description`: the resolved model, equal for models that predict the same.
    RunTable(const ModelInterface& model, std::string_view description);

    // Adds the runs of a text. Throws RunTableError, and then adds none.
    void read(std::string_view text);
    // Returns the run of that key, which stays where it is: the one added, or an earlier one.
    const Outcome& add(const Key& key, const Outcome& outcome);
    const Outcome* find(const Key& key) const;
    const std::map<Key, Outcome>& runs() const { return runs_; }

    std::string text() const;

  private:
    std::string model_;
    std::vector<std::string> inputs_;
    std::vector<std::string> outputs_;
    std::map<Key, Outcome> runs_;
};

// A model's runs from a table and those that a study has used, of which a new table is made.
struct TabledRuns {
    // `empty`: a table of the same model without runs.
    TabledRuns(RunTable runs, RunTable empty) : known(std::move(runs)), used(std::move(empty)) {}

    RunTable known;
    RunTable used;
    long found = 0;  // predictions taken from `known`
    std::mutex mutex = {};
};

// A model that first searches the table. `runs` has to outlive it and its predictions, which may be requested from
// several threads.
ModelInterface tabled(ModelInterface model, TabledRuns& runs);

}  // namespace delabole
