#include "numerics/sparse_system.hpp"

#include "numerics/frontal_factors.hpp"

#include <klu.h>

#include <new>
#include <optional>
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
    bool analysed = false;  // by KLU
    std::optional<FrontalFactors> fronts = {};
};

namespace {

// With fewer unknowns the solution is as fast without dense matrices.
constexpr int many_unknowns = 72;

// An order of the groups in which elimination creates few new entries.
std::vector<int> elimination_order(const SparsePattern& pattern, int group) {
    SparsePattern groups;
    for (int column = 0; column < pattern.size(); column += group) {
        const int end = pattern.column_begin[static_cast<std::size_t>(column) + 1];
        for (int entry = pattern.column_begin[static_cast<std::size_t>(column)]; entry < end; entry += group) {
            groups.row.push_back(pattern.row[static_cast<std::size_t>(entry)] / group);
        }
        groups.column_begin.push_back(static_cast<int>(groups.row.size()));
    }
    klu_common common = {};
    klu_defaults(&common);
    klu_symbolic* symbolic = klu_analyze(groups.size(), groups.column_begin.data(), groups.row.data(), &common);
    if (symbolic == nullptr) {
        throw std::bad_alloc();
    }
    std::vector<int> order(symbolic->Q, symbolic->Q + groups.size());
    klu_free_symbolic(&symbolic, &common);
    return order;
}

}  // namespace

SparseSystem::SparseSystem(SparsePattern pattern, int group)
    : pattern_(std::move(pattern)), value_(pattern_.row.size(), 0.0), factors_(std::make_unique<Factors>()) {
    if (group > 1 && pattern_.size() >= many_unknowns) {
        factors_->fronts.emplace(pattern_, group, elimination_order(pattern_, group));
    }
}

SparseSystem::~SparseSystem() = default;
SparseSystem::SparseSystem(SparseSystem&& other) noexcept = default;
SparseSystem& SparseSystem::operator=(SparseSystem&& other) noexcept = default;

bool SparseSystem::solve(Eigen::VectorXd& vector) {
    return factors_->fronts && solve_by_fronts(vector) ? true : solve_by_klu(vector);
}

bool SparseSystem::solve_by_fronts(Eigen::VectorXd& vector) {
    // Greatest accepted residual, as a share of the products that make up a row. KLU's pivots may lose more digits.
    constexpr double little = 1e-11;
    constexpr int most_improvements = 2;
    FrontalFactors& fronts = *factors_->fronts;
    if (!fronts.factor(value_)) {
        return false;
    }
    const double greatest = Eigen::Map<const Eigen::VectorXd>(value_.data(), static_cast<Eigen::Index>(value_.size()))
                                .lpNorm<Eigen::Infinity>();
    Eigen::VectorXd solution = vector;
    fronts.solve(solution);
    for (int improvements = 0; solution.allFinite(); ++improvements) {
        Eigen::VectorXd left = left_over(vector, solution);
        const double products = greatest * solution.lpNorm<Eigen::Infinity>() + vector.lpNorm<Eigen::Infinity>();
        if (left.lpNorm<Eigen::Infinity>() <= little * products) {
            vector = std::move(solution);
            return true;
        }
        if (improvements == most_improvements) {
            break;
        }
        fronts.solve(left);
        solution += left;
    }
    return false;
}

Eigen::VectorXd SparseSystem::left_over(const Eigen::VectorXd& right, const Eigen::VectorXd& solution) const {
    Eigen::VectorXd left = right;
    for (int column = 0; column < pattern_.size(); ++column) {
        const double by = solution(column);
        const int end = pattern_.column_begin[static_cast<std::size_t>(column) + 1];
        for (int entry = pattern_.column_begin[static_cast<std::size_t>(column)]; entry < end; ++entry) {
            left(pattern_.row[static_cast<std::size_t>(entry)]) -= by * value_[static_cast<std::size_t>(entry)];
        }
    }
    return left;
}

bool SparseSystem::solve_by_klu(Eigen::VectorXd& vector) {
    klu_common& common = factors_->common;
    klu_symbolic*& symbolic = factors_->symbolic;
    klu_numeric*& numeric = factors_->numeric;
    int* const begin = pattern_.column_begin.data();
    int* const row = pattern_.row.data();
    if (!factors_->analysed) {
        factors_->analysed = true;
        symbolic = klu_analyze(pattern_.size(), begin, row, &common);
        if (common.status == KLU_OUT_OF_MEMORY) {
            throw std::bad_alloc();
        }
    }
    if (symbolic == nullptr) {  // structurally singular
        return false;
    }
    // Pivots are kept as long as elimination makes entries grow by no more than this factor, which is also the loss of
    // digits.
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
