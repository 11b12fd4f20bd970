// Predictions of models on the disk, so that none is paid for twice: by the next run of a study, by the same study
// after it was killed, or by another process beside it.
//
// An entry is keyed by what computed it (the program, as a text), the model (its resolved description, as a text) and
// the bit patterns of the values assigned to its inputs. Texts are compared whole, so no hash can confuse two models.
// It holds the word of failure or the outputs and the profile, to the last bit, and what they cost.
//
// The file is an SQLite database with a write-ahead log, each entry a transaction: after a kill at any moment an entry
// that was finished is there, after a loss of power the last ones may be missing, and none is ever there by half. A
// rollback journal would also keep the last ones through a loss of power, but has to wait for the disk, 1 to 20 ms an
// entry instead of 0.04. The log lives in memory that the processes share: those of one machine may use a file at the
// same time, those of two machines with one network folder must not.
//
// Source: SQLite 3.40, www.sqlite.org/atomiccommit.html, /wal.html.
#pragma once

#include "parameters/model_interface.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string_view>

namespace delabole {

// The store cannot be opened, read or written. what() names the file and says what to do; whatever stands in the file
// is left as it is.
class StoreError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

// The number of predictions that a study asked the store for.
struct StoreTraffic {
    long made = 0;             // computed and kept
    long found = 0;            // there already
    double seconds_made = 0;   // summed over threads
    double seconds_found = 0;  // what those found had cost
};

class EvaluationStore {
  public:
    // Opens the store, or makes one where there is no file or an empty one. Entries of other programs stay and are not
    // seen. Throws StoreError: no permission, a file of another kind, another layout, damage.
    EvaluationStore(const std::filesystem::path& path, std::string_view program);
    ~EvaluationStore();
    EvaluationStore(const EvaluationStore&) = delete;
    EvaluationStore& operator=(const EvaluationStore&) = delete;

    const std::filesystem::path& path() const;
    StoreTraffic traffic() const;

    // The row under which the predictions of a model are kept.
    std::int64_t shelf_of(std::string_view model);

    // The prediction of `model` for these values, from the shelf or computed and put there. Safe to call from several
    // threads: one that asks for what another is computing waits for it. Exceptions of the model pass through and leave
    // nothing behind. Words of failure live as long as the store.
    Prediction predict(std::int64_t shelf, const ModelInterface& model, std::span<const Assignment> assignments);

  private:
    class Database;
    std::unique_ptr<Database> database_;
};

// The same model, which asks the store first. The store has to outlive it and what it predicts. `description`: the
// resolved model, equal for models that predict the same.
ModelInterface stored(ModelInterface model, EvaluationStore& store, std::string_view description);

}  // namespace delabole
