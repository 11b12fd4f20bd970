// Processes, started by mpirun on one machine or several, that work on one study together.
//
// All ranks run the same program on the same case and hold the same data. Loops that are shared out (Evaluator,
// share_tasks) let each rank do its part and then exchange the results, so that all ranks hold the same data again:
// results cannot depend on the number of ranks. Only the leading rank prints and writes files.
//
// If a rank dies, mpirun ends the others: exchanged results are lost, but an evaluation store keeps its entries. A
// study among ranks cannot be ended early by a stop flag, which would reach the ranks at different points of their
// work.
#pragma once

#include <mutex>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace delabole {

class Ranks {
  public:
    // Joins the ranks that the same mpirun has started; a process that was started otherwise is alone. May be made once
    // in a program. Throws std::runtime_error if mpirun has started several processes and this program was built
    // without MPI.
    Ranks();
    // Waits until every rank has arrived here.
    ~Ranks();
    Ranks(const Ranks&) = delete;
    Ranks& operator=(const Ranks&) = delete;

    int count() const { return count_; }
    int number() const { return number_; }  // from 0
    bool leads() const { return number_ == 0; }
    bool alone() const { return count_ == 1; }

    // The bytes of every rank, indexed by its number. Every rank calls this in the same order, from the thread that
    // made Ranks.
    std::vector<std::string> exchange(const std::string& own) const;

    // Name of the machine that this rank runs on.
    static std::string machine();

    // Ends every rank at once with that exit code. Returns only if this process is alone.
    void end_all(int code) const;

    // A copy of the text that exists as long as this object.
    std::string_view word(const std::string& text) const;

  private:
    int count_ = 1;
    int number_ = 0;
    mutable std::mutex mutex_;
    mutable std::set<std::string> words_;
};

}  // namespace delabole
