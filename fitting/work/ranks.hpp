// Processes that work on one study together, on one machine or several: those that mpirun has started.
//
// All ranks run the same program on the same case and hold the same data. Where a loop shares its work out (Evaluator,
// share_tasks), each does its part and all exchange what they found, so that after it they hold the same data again:
// results cannot depend on the number of ranks. Only the leading rank prints and writes files.
//
// A rank that is lost ends the others (mpirun sees to that): what had been exchanged is gone with them, what an
// evaluation store holds is not. For the same reason a study among ranks is not ended early by a stop flag, which would
// reach them at different points of their work.
#pragma once

#include <mutex>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace delabole {

class Ranks {
  public:
    // Joins the ranks that the same mpirun has started; a process that was started otherwise is alone. Once in a
    // program. Throws std::runtime_error where mpirun has started several and this program was built without MPI.
    Ranks();
    // Waits until every rank is here.
    ~Ranks();
    Ranks(const Ranks&) = delete;
    Ranks& operator=(const Ranks&) = delete;

    int count() const { return count_; }
    int number() const { return number_; }  // from 0
    bool leads() const { return number_ == 0; }
    bool alone() const { return count_ == 1; }

    // The bytes of every rank, by its number. Every rank calls it, in the same order, from the thread that made Ranks.
    std::vector<std::string> exchange(const std::string& own) const;

    // Name of the machine that this rank runs on.
    static std::string machine();

    // Ends every rank at once, with that exit code. Does not return unless alone.
    void end_all(int code) const;

    // A word that lives as long as this.
    std::string_view word(const std::string& text) const;

  private:
    int count_ = 1;
    int number_ = 0;
    mutable std::mutex mutex_;
    mutable std::set<std::string> words_;
};

}  // namespace delabole
