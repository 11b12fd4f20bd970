// A few threads that do the same work on different parts of the data, thousands of times a second.
#pragma once

#include <atomic>
#include <cstddef>
#include <thread>
#include <vector>

namespace delabole {

class Team {
  public:
    // The caller is one of the members; a team of one has no threads.
    explicit Team(std::size_t members);
    ~Team();
    Team(const Team&) = delete;
    Team& operator=(const Team&) = delete;

    std::size_t size() const { return threads_.size() + 1; }

    // Calls work(part) for part 0 to size() - 1, each in a thread of its own, and waits for all. `work` must not throw.
    template <class Work>
    void run(const Work& work) {
        start([](const void* context, std::size_t part) { (*static_cast<const Work*>(context))(part); }, &work);
    }

  private:
    using Function = void (*)(const void*, std::size_t);

    void start(Function function, const void* context);
    void follow(std::size_t part);

    std::vector<std::thread> threads_ = {};
    Function function_ = nullptr;
    const void* context_ = nullptr;
    std::atomic<std::size_t> round_{0};
    std::atomic<std::size_t> busy_{0};
    std::atomic<bool> over_{false};
};

// First item of a part, where `count` items are divided among `parts`.
inline std::size_t part_begin(std::size_t count, std::size_t part, std::size_t parts) {
    return count * part / parts;
}

}  // namespace delabole
