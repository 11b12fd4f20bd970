// The progress of a back-analysis or a sensitivity study.
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
    double fraction;             // share of the expected work as a whole, 0 to 1, never decreasing
    long evaluations;            // so far
};

// Called at most about 20 times a second, from any thread but never from two at once.
using FitProgressCallback = std::function<void(const FitProgress&)>;

class ProgressMeter {
  public:
    // expected_total: number of evaluations of all stages to come.
    ProgressMeter(FitProgressCallback callback, long expected_total);

    // Must not be called while other threads count.
    void begin_stage(std::string_view mechanism, std::string_view stage, long expected_evaluations);
    void finish();
    void count(long evaluations = 1) { count(evaluations, evaluations); }
    // Counts evaluations that take as long as `usual_ones` usual ones.
    void count(long evaluations, long usual_ones);

  private:
    void report();

    FitProgressCallback callback_;
    double expected_total_;
    std::string mechanism_;
    std::string stage_;
    double expected_before_ = 0;
    double expected_in_stage_ = 0;
    long worked_before_ = 0;
    double fraction_ = 0;
    std::atomic<long> counted_ = 0;
    std::atomic<long> worked_ = 0;  // measured in usual evaluations
    std::mutex reporting_;
    std::atomic<std::chrono::steady_clock::rep> next_report_ = 0;
};

}  // namespace delabole
