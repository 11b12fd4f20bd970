// Predictions of models kept on disk, so that none is computed twice: by the next run of a study, by the same study
// after it was killed, or by another process at the same time.
//
// An entry is identified by the program that computed it (as a text), the model (its resolved description, as a text)
// and the bit patterns of the values assigned to its inputs. Texts are compared as a whole, so no hash can confuse two
// models. It holds the failure text or the outputs and the profile, to the last bit, and the time they took.
//
// The file is an SQLite database with a write-ahead log, and each entry is a transaction: after a kill at any moment
// every finished entry is there, after a loss of power the last ones may be missing, and no entry is ever incomplete. A
// rollback journal would also keep the last entries through a loss of power, but has to wait for the disk, 1 to 20 ms
// an entry instead of 0.04 ms. The log uses memory that the processes share: processes on one machine may use a file at
// the same time, processes on two machines with one network folder must not.
//
// Source: SQLite 3.40, www.sqlite.org/atomiccommit.html, /wal.html.
#pragma once

#include "parameters/model_interface.hpp"

#include <cstdint>
#include <filesystem>
#include <future>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

struct sqlite3;

namespace delabole {

// The store cannot be opened, read or written. what() names the file and says what to do; the contents of the file are
// left unchanged.
class StoreError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

// Counts of the predictions that a study requested from the store.
struct StoreTraffic {
    long made = 0;             // computed and stored
    long found = 0;            // already stored
    double seconds_made = 0;   // summed over threads
    double seconds_found = 0;  // time that those found had taken
};

class EvaluationStore {
  public:
    // Opens the store, or makes one if the file does not exist or is empty. Entries of other programs are kept and
    // ignored. Throws StoreError: no permission, a file of another kind, another layout, damage.
    EvaluationStore(std::filesystem::path path, std::string_view program);

    const std::filesystem::path& path() const { return path_; }
    StoreTraffic traffic() const;

    // Identifier of the table row of a model; its predictions refer to it.
    std::int64_t id_of_model(std::string_view model);

    // Returns the stored prediction of `model` for these values, or computes and stores it. Safe to call from several
    // threads: if another thread is already computing it, the call waits for that. Exceptions of the model are passed
    // on, and then nothing is stored. Failure texts stay valid as long as the store.
    Prediction predict(std::int64_t model_id, const ModelInterface& model, std::span<const Assignment> assignments);

  private:
    struct Entry;
    class Statement;

    void open();
    void lay_out();
    void check_layout();
    void execute(const char* text);
    // SQLite does not wait for other processes when a lock has to become a stronger one, for example when two processes
    // open a new file at once; here the statement is repeated instead.
    void execute_patiently(const char* text);
    std::int64_t pragma(const char* text);
    void demand(int code) const;
    [[noreturn]] void refuse(const std::string& sentence) const { throw StoreError(path_.string() + ' ' + sentence); }
    [[noreturn]] void refuse_as_damaged(const std::string& reason) const;

    std::optional<Entry> find(std::int64_t model_id, const std::string& key);
    void keep(std::int64_t model_id, const std::string& key, const Entry& entry);
    Prediction prediction_of(const Entry& entry, std::size_t outputs);
    Prediction compute(std::int64_t model_id, const std::string& key, const ModelInterface& model,
                       std::span<const Assignment> assignments);

    std::filesystem::path path_;
    std::string program_;
    mutable std::mutex mutex_;  // guards everything below
    StoreTraffic traffic_;
    std::unique_ptr<sqlite3, int (*)(sqlite3*)> connection_;
    std::set<std::string> words_;  // texts of failures, at addresses that do not change
    std::map<std::pair<std::int64_t, std::string>, std::shared_future<Prediction>> under_way_;
};

// A model that looks in the store first. The store has to outlive it and its predictions. `description` is the resolved
// model, equal for models that predict the same.
ModelInterface stored(ModelInterface model, EvaluationStore& store, std::string_view description);

}  // namespace delabole
