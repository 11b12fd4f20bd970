#include "fitting/work/evaluation_store.hpp"

#include "numerics/archive.hpp"
#include "numerics/fnv_1a.hpp"

#include <sqlite3.h>

#include <chrono>
#include <system_error>
#include <thread>
#include <utility>

namespace delabole {

namespace {

constexpr int layout = 1;                     // version of the tables below
constexpr int application = 0x44656C62;       // "Delb", stored in the header of the file
constexpr int patience_milliseconds = 60000;  // wait for other processes, each of which writes for some milliseconds

constexpr const char* tables =
    "CREATE TABLE model (id INTEGER PRIMARY KEY, program TEXT NOT NULL, description TEXT NOT NULL,"
    " UNIQUE (program, description));"
    "CREATE TABLE evaluation (model INTEGER NOT NULL REFERENCES model (id), parameters BLOB NOT NULL,"
    " failure TEXT NOT NULL, outputs BLOB NOT NULL, profile BLOB NOT NULL, seconds REAL NOT NULL,"
    " checksum INTEGER NOT NULL, UNIQUE (model, parameters));";

// Bytes that identify the values: sorted by input, and the last of several values for one input, as assign() applies
// them.
std::string key_of(std::span<const Assignment> assignments) {
    std::map<std::size_t, double> values;
    for (const Assignment& assignment : assignments) {
        values[assignment.input] = assignment.value;
    }
    ArchiveWriter writer;
    for (const auto& [input, value] : values) {
        writer.put(input);
        writer.put(value);
    }
    return writer.bytes();
}

std::string bytes_of(const std::vector<double>& values) {
    ArchiveWriter writer;
    writer.put(values);
    return writer.bytes();
}

std::string bytes_of(const Polyline& line) {
    std::vector<double> values;
    for (const Point& point : line) {
        values.push_back(point.x());
        values.push_back(point.y());
    }
    return bytes_of(values);
}

}  // namespace

struct EvaluationStore::Entry {
    std::string failure;
    std::string outputs;
    std::string profile;
    double seconds = 0;

    std::int64_t checksum(std::int64_t model_id, std::string_view key) const {
        ArchiveWriter writer;
        writer.put(model_id);
        for (const std::string_view text :
             {key, std::string_view(failure), std::string_view(outputs), std::string_view(profile)}) {
            writer.put(text);
        }
        writer.put(seconds);
        return static_cast<std::int64_t>(fnv_1a(writer.bytes()));
    }
};

// An SQL statement from preparation to finalisation.
class EvaluationStore::Statement {
  public:
    Statement(EvaluationStore& store, const char* text) : store_(store) {
        store_.demand(sqlite3_prepare_v2(store_.connection_.get(), text, -1, &statement_, nullptr));
    }
    ~Statement() { sqlite3_finalize(statement_); }
    Statement(const Statement&) = delete;
    Statement& operator=(const Statement&) = delete;

    void bind(int place, std::int64_t value) { store_.demand(sqlite3_bind_int64(statement_, place, value)); }
    void bind(int place, double value) { store_.demand(sqlite3_bind_double(statement_, place, value)); }
    void bind_text(int place, std::string_view text) {
        store_.demand(sqlite3_bind_text64(statement_, place, text.data(), text.size(), nullptr, SQLITE_UTF8));
    }
    void bind_bytes(int place, std::string_view bytes) {
        store_.demand(sqlite3_bind_blob64(statement_, place, bytes.data(), bytes.size(), nullptr));
    }
    // False after the last row.
    bool step() {
        const int code = sqlite3_step(statement_);
        if (code != SQLITE_ROW && code != SQLITE_DONE) {
            store_.demand(code);
        }
        return code == SQLITE_ROW;
    }
    std::int64_t integer(int column) const { return sqlite3_column_int64(statement_, column); }
    double real(int column) const { return sqlite3_column_double(statement_, column); }
    std::string bytes(int column) const {
        const void* data = sqlite3_column_blob(statement_, column);
        const auto size = static_cast<std::size_t>(sqlite3_column_bytes(statement_, column));
        return data == nullptr ? std::string() : std::string(static_cast<const char*>(data), size);
    }

  private:
    EvaluationStore& store_;
    sqlite3_stmt* statement_ = nullptr;
};

EvaluationStore::EvaluationStore(std::filesystem::path path, std::string_view program)
    : path_(std::move(path)), program_(program), connection_(nullptr, sqlite3_close) {
    open();
}

StoreTraffic EvaluationStore::traffic() const {
    const std::lock_guard lock(mutex_);
    return traffic_;
}

void EvaluationStore::refuse_as_damaged(const std::string& reason) const {
    refuse("is damaged (" + reason + "): move it away and the work begins anew, or save what it holds by `sqlite3 " +
           path_.string() + " .recover`; nothing in it was changed");
}

void EvaluationStore::demand(int code) const {
    switch (code) {
    case SQLITE_OK:
        return;
    case SQLITE_NOTADB:
        refuse("is no evaluation store: name another file, or move this one away; nothing in it was changed");
    case SQLITE_CORRUPT:
        refuse_as_damaged(sqlite3_errmsg(connection_.get()));
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
        refuse("was locked by another process for a minute: end that process, or name another file");
    case SQLITE_FULL:
        refuse("cannot grow: the disk is full; with room on it the same command goes on from what is kept");
    default:
        refuse("cannot be used as an evaluation store: " + std::string(sqlite3_errmsg(connection_.get())));
    }
}

void EvaluationStore::execute(const char* text) {
    demand(sqlite3_exec(connection_.get(), text, nullptr, nullptr, nullptr));
}

void EvaluationStore::execute_patiently(const char* text) {
    constexpr auto pause = std::chrono::milliseconds(5);
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::milliseconds(patience_milliseconds);
    int code = sqlite3_exec(connection_.get(), text, nullptr, nullptr, nullptr);
    while (code == SQLITE_BUSY && std::chrono::steady_clock::now() < deadline) {
        std::this_thread::sleep_for(pause);
        code = sqlite3_exec(connection_.get(), text, nullptr, nullptr, nullptr);
    }
    demand(code);
}

std::int64_t EvaluationStore::pragma(const char* text) {
    Statement statement(*this, text);
    return statement.step() ? statement.integer(0) : 0;
}

void EvaluationStore::open() {
    if (std::error_code ignored;
        std::filesystem::exists(path_, ignored) && !std::filesystem::is_regular_file(path_, ignored)) {
        refuse("is no ordinary file: name another one for the evaluation store");
    }
    // The path is made absolute, because SQLite gives some relative names such as ":memory:" a special meaning.
    const std::string name = std::filesystem::absolute(path_).string();
    sqlite3* opened = nullptr;
    const int code = sqlite3_open_v2(name.c_str(), &opened,
                                     SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE | SQLITE_OPEN_FULLMUTEX, nullptr);
    connection_.reset(opened);  // also after a failure, for its message
    demand(code);
    demand(sqlite3_busy_timeout(connection_.get(), patience_milliseconds));
    if (sqlite3_db_readonly(connection_.get(), "main") != 0) {
        refuse("cannot be written: give yourself the right to, or name another file");
    }
    if (pragma("SELECT count(*) FROM sqlite_master") == 0 && pragma("PRAGMA application_id") == 0) {
        lay_out();
    }
    check_layout();
    execute_patiently("PRAGMA journal_mode = WAL");
    execute("PRAGMA synchronous = NORMAL");
}

void EvaluationStore::lay_out() {
    // A process that comes second finds the tables already made by the first.
    execute("BEGIN IMMEDIATE");
    if (pragma("SELECT count(*) FROM sqlite_master") == 0) {
        execute(tables);
        execute(("PRAGMA application_id = " + std::to_string(application)).c_str());
        execute(("PRAGMA user_version = " + std::to_string(layout)).c_str());
    }
    execute("COMMIT");
}

void EvaluationStore::check_layout() {
    if (pragma("PRAGMA application_id") != application) {
        refuse("is a database of another program: name another file; nothing in it was changed");
    }
    const std::int64_t found = pragma("PRAGMA user_version");
    if (found != layout) {
        refuse("is an evaluation store of layout " + std::to_string(found) +
               ", of another version of delabole; this one " + "uses layout " + std::to_string(layout) +
               ": name another file, or move this one away; nothing in it was changed");
    }
    Statement check(*this, "PRAGMA quick_check(1)");
    if (check.step() && check.bytes(0) != "ok") {
        refuse_as_damaged(check.bytes(0));
    }
}

std::int64_t EvaluationStore::id_of_model(std::string_view model) {
    const std::lock_guard lock(mutex_);
    Statement insert(*this, "INSERT OR IGNORE INTO model (program, description) VALUES (?, ?)");
    insert.bind_text(1, program_);
    insert.bind_text(2, model);
    insert.step();
    Statement select(*this, "SELECT id FROM model WHERE program = ? AND description = ?");
    select.bind_text(1, program_);
    select.bind_text(2, model);
    if (!select.step()) {
        refuse_as_damaged("a model just entered is missing");
    }
    return select.integer(0);
}

std::optional<EvaluationStore::Entry> EvaluationStore::find(std::int64_t model_id, const std::string& key) {
    Statement select(*this,
                     "SELECT failure, outputs, profile, seconds, checksum FROM evaluation"
                     " WHERE model = ? AND parameters = ?");
    select.bind(1, model_id);
    select.bind_bytes(2, key);
    if (!select.step()) {
        return std::nullopt;
    }
    Entry entry{select.bytes(0), select.bytes(1), select.bytes(2), select.real(3)};
    if (entry.checksum(model_id, key) != select.integer(4)) {
        refuse_as_damaged("an entry differs from its checksum");
    }
    return entry;
}

void EvaluationStore::keep(std::int64_t model_id, const std::string& key, const Entry& entry) {
    // If another process was quicker, its entry is kept, which holds the same values.
    Statement insert(*this, "INSERT OR IGNORE INTO evaluation VALUES (?, ?, ?, ?, ?, ?, ?)");
    insert.bind(1, model_id);
    insert.bind_bytes(2, key);
    insert.bind_text(3, entry.failure);
    insert.bind_bytes(4, entry.outputs);
    insert.bind_bytes(5, entry.profile);
    insert.bind(6, entry.seconds);
    insert.bind(7, entry.checksum(model_id, key));
    insert.step();
}

Prediction EvaluationStore::prediction_of(const Entry& entry, std::size_t outputs) {
    Prediction prediction;
    if (!entry.failure.empty()) {
        prediction.failure = *words_.insert(entry.failure).first;
    }
    ArchiveReader numbers(entry.outputs);
    numbers.get(prediction.outputs);
    ArchiveReader line(entry.profile);
    std::vector<double> coordinates;
    line.get(coordinates);
    const bool fits = numbers.whole() && line.whole() && coordinates.size() % 2 == 0 &&
                      (prediction.outputs.empty() || prediction.outputs.size() == outputs);
    if (!fits) {
        refuse_as_damaged("an entry does not belong to its model");
    }
    for (std::size_t index = 0; index < coordinates.size(); index += 2) {
        prediction.profile.emplace_back(coordinates[index], coordinates[index + 1]);
    }
    return prediction;
}

Prediction EvaluationStore::compute(std::int64_t model_id, const std::string& key, const ModelInterface& model,
                                    std::span<const Assignment> assignments) {
    const auto begin = std::chrono::steady_clock::now();
    Prediction prediction = model.predict(assignments);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    const std::lock_guard lock(mutex_);
    keep(model_id, key,
         {std::string(prediction.failure), bytes_of(prediction.outputs), bytes_of(prediction.profile), seconds});
    ++traffic_.made;
    traffic_.seconds_made += seconds;
    return prediction;
}

Prediction EvaluationStore::predict(std::int64_t model_id, const ModelInterface& model,
                                    std::span<const Assignment> assignments) {
    const std::string key = key_of(assignments);
    const std::pair place{model_id, key};
    std::promise<Prediction> promise;
    {
        std::unique_lock lock(mutex_);
        if (const auto other = under_way_.find(place); other != under_way_.end()) {
            const std::shared_future<Prediction> awaited = other->second;
            lock.unlock();
            Prediction prediction = awaited.get();
            lock.lock();
            ++traffic_.found;
            return prediction;
        }
        if (const std::optional<Entry> entry = find(model_id, key)) {
            Prediction prediction = prediction_of(*entry, model.outputs.size());
            ++traffic_.found;
            traffic_.seconds_found += entry->seconds;
            return prediction;
        }
        under_way_.emplace(place, promise.get_future().share());
    }
    const auto leave = [&] {
        const std::lock_guard lock(mutex_);
        under_way_.erase(place);
    };
    try {
        Prediction prediction = compute(model_id, key, model, assignments);
        promise.set_value(prediction);
        leave();
        return prediction;
    } catch (...) {
        promise.set_exception(std::current_exception());
        leave();
        throw;
    }
}

ModelInterface stored(ModelInterface model, EvaluationStore& store, std::string_view description) {
    const std::int64_t model_id = store.id_of_model(description);
    const auto computed = std::make_shared<const ModelInterface>(model);
    model.predict = [&store, model_id, computed](std::span<const Assignment> assignments) {
        return store.predict(model_id, *computed, assignments);
    };
    return model;
}

}  // namespace delabole
