#include "numerics/sparse_system.hpp"

#include <klu.h>

#include <new>
#include <utility>

namespace delabole {

struct SparseSystem::Factors {
    Factors() { klu_defaults(&common); }
    Factors(const Factors&) = delete;
    Factors& operator=(const Factors&) = delete;
    ~Factors() {
        klu_free_numeric(&numeric, &common);
        klu_free_symbolic(&symbolic, &common);
    }

    klu_common common = {};
    klu_symbolic* symbolic = nullptr;
    klu_numeric* numeric = nullptr;
};

SparseSystem::SparseSystem(SparsePattern pattern)
    : pattern_(std::move(pattern)), value_(pattern_.row.size(), 0.0), factors_(std::make_unique<Factors>()) {
    factors_->symbolic =
        klu_analyze(pattern_.size(), pattern_.column_begin.data(), pattern_.row.data(), &factors_->common);
    if (factors_->common.status == KLU_OUT_OF_MEMORY) {
        throw std::bad_alloc();
    }
}

SparseSystem::~SparseSystem() = default;
SparseSystem::SparseSystem(SparseSystem&& other) noexcept = default;
SparseSystem& SparseSystem::operator=(SparseSystem&& other) noexcept = default;

bool SparseSystem::solve(Eigen::VectorXd& vector) {
    klu_common& common = factors_->common;
    klu_symbolic* const symbolic = factors_->symbolic;
    klu_numeric*& numeric = factors_->numeric;
    if (symbolic == nullptr) {  // structurally singular
        return false;
    }
    int* const begin = pattern_.column_begin.data();
    int* const row = pattern_.row.data();
    // Pivots are kept as long as elimination makes entries grow by no more than this: it costs as many digits.
    constexpr double least_reciprocal_growth = 1e-6;
    const bool kept = numeric != nullptr && klu_refactor(begin, row, value_.data(), symbolic, numeric, &common) != 0 &&
                      common.status == KLU_OK &&
                      klu_rgrowth(begin, row, value_.data(), symbolic, numeric, &common) != 0 &&
                      common.rgrowth > least_reciprocal_growth;
    if (!kept) {
        klu_free_numeric(&numeric, &common);
        numeric = klu_factor(begin, row, value_.data(), symbolic, &common);
        if (common.status == KLU_OUT_OF_MEMORY) {
            throw std::bad_alloc();
        }
        if (numeric == nullptr || common.status != KLU_OK) {
            return false;
        }
    }
    return klu_solve(symbolic, numeric, pattern_.size(), 1, vector.data(), &common) != 0 && vector.allFinite();
}

}  // namespace delabole
