#include "dynamic_relaxation/wide/team.hpp"

namespace delabole {

namespace {

// Rounds follow each other within microseconds: a thread polls this many times before it goes to sleep.
constexpr int polls_before_sleep = 2000;

}  // namespace

Team::Team(std::size_t members) {
    for (std::size_t part = 1; part < members; ++part) {
        threads_.emplace_back([this, part] { follow(part); });
    }
}

Team::~Team() {
    over_ = true;
    ++round_;
    round_.notify_all();
    for (std::thread& thread : threads_) {
        thread.join();
    }
}

void Team::start(Function function, const void* context) {
    function_ = function;
    context_ = context;
    busy_ = threads_.size();
    ++round_;
    round_.notify_all();
    function(context, 0);
    for (int poll = 0; busy_ != 0; ++poll) {
        if (poll > polls_before_sleep) {
            std::this_thread::yield();
        }
    }
}

void Team::follow(std::size_t part) {
    std::size_t done = 0;
    while (true) {
        for (int poll = 0; round_ == done && poll < polls_before_sleep; ++poll) {
        }
        round_.wait(done);
        done = round_;
        if (over_) {
            return;
        }
        function_(context_, part);
        --busy_;
    }
}

}  // namespace delabole
