#include "fitting/work/progress.hpp"

#include <algorithm>
#include <utility>

namespace delabole {

namespace {

using Clock = std::chrono::steady_clock;

constexpr Clock::duration report_interval = std::chrono::milliseconds(50);

}  // namespace

ProgressMeter::ProgressMeter(FitProgressCallback callback, long expected_total)
    : callback_(std::move(callback)), expected_total_(static_cast<double>(std::max(expected_total, 1L))) {}

void ProgressMeter::begin_stage(std::string_view mechanism, std::string_view stage, long expected_evaluations) {
    mechanism_ = mechanism;
    stage_ = stage;
    expected_before_ += expected_in_stage_;
    expected_in_stage_ = static_cast<double>(expected_evaluations);
    worked_before_ = worked_;
    if (callback_) {
        report();
    }
}

void ProgressMeter::finish() {
    expected_before_ = expected_total_;
    expected_in_stage_ = 0;
    if (callback_) {
        report();
    }
}

void ProgressMeter::count(long evaluations, long usual_ones) {
    counted_ += evaluations;
    worked_ += usual_ones;
    if (!callback_ || Clock::now().time_since_epoch().count() < next_report_.load(std::memory_order_relaxed)) {
        return;
    }
    const std::unique_lock lock(reporting_, std::try_to_lock);
    if (lock.owns_lock()) {
        report();
    }
}

void ProgressMeter::report() {
    next_report_ = (Clock::now() + report_interval).time_since_epoch().count();
    const double in_stage = std::min(static_cast<double>(worked_ - worked_before_), expected_in_stage_);
    fraction_ = std::max(fraction_, std::min((expected_before_ + in_stage) / expected_total_, 1.0));
    callback_({mechanism_, stage_, fraction_, counted_});
}

}  // namespace delabole
