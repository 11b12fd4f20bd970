// How far a back-analysis or a sensitivity study has come.
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <mutex>
#include <string>
#include <string_view>

namespace delabole {

struct FitProgress {
    std::string_view mechanism;  // or the quantity of a sensitivity study
    std::string_view stage;      // "starts", "profiles", ...
    double fraction;             // of the expected evaluations of the whole work, 0 to 1, never falling
    long evaluations;            // so far
};

// Called at most about 20 times a second, from any thread but never from two at once.
using FitProgressCallback = std::function<void(const FitProgress&)>;

class ProgressMeter {
  public:
    // expected_total: evaluations of all stages to come.
    ProgressMeter(FitProgressCallback callback, long expected_total);

    // Not while other threads count.
    void begin_stage(std::string_view mechanism, std::string_view stage, long expected_evaluations);
    void finish();
    void count(long evaluations = 1);

  private:
    void report();

    FitProgressCallback callback_;
    double expected_total_;
    std::string mechanism_;
    std::string stage_;
    double expected_before_ = 0;
    double expected_in_stage_ = 0;
    long counted_before_ = 0;
    double fraction_ = 0;
    std::atomic<long> counted_ = 0;
    std::mutex reporting_;
    std::atomic<std::chrono::steady_clock::rep> next_report_ = 0;
};

}  // namespace delabole
