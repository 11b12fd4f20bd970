// Whether linear equations have a solution with non-negative unknowns: phase one of the simplex method, dense, for some
// dozens of unknowns. A template over the scalar.
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

namespace delabole {

// Solves coefficients x = right_sides, x >= 0, with `coefficients` row by row. Returns the least sum of one-sided
// violations of the equations for such an x: 0, except for rounding, if there is a solution.
//
// The unknown with the greatest gain enters the basis; after as many steps as there are numbers in the table the first
// unknown with a gain does, with which the method cannot cycle (Bland 1977, Math. Oper. Res. 2).
template <class T>
class Infeasibility {
  public:
    T operator()(const std::vector<T>& coefficients, const std::vector<T>& right_sides) {
        rows_ = right_sides.size();
        columns_ = coefficients.size() / rows_;
        table_.assign((rows_ + 1) * (columns_ + 1), T(0));
        basis_.assign(rows_, columns_);  // a slack, which never returns once it has left
        for (std::size_t row = 0; row < rows_; ++row) {
            const T sign = right_sides[row] < 0 ? T(-1) : T(1);
            for (std::size_t column = 0; column < columns_; ++column) {
                at(row, column) = sign * coefficients[row * columns_ + column];
            }
            at(row, columns_) = sign * right_sides[row];
            for (std::size_t column = 0; column <= columns_; ++column) {
                at(rows_, column) += at(row, column);
            }
        }
        const std::size_t patience = rows_ * columns_;
        for (std::size_t step = 0; step < 4 * patience; ++step) {
            const std::size_t column = entering(step < patience);
            const std::size_t row = column < columns_ ? leaving(column) : rows_;
            if (row == rows_) {
                break;
            }
            pivot(row, column);
        }
        T sum{};
        for (std::size_t row = 0; row < rows_; ++row) {
            sum += basis_[row] == columns_ ? at(row, columns_) : T(0);
        }
        return sum;
    }

  private:
    // Entries below this are rounding; coefficients are of the order of 1.
    const T zero = 1024 * std::numeric_limits<T>::epsilon();

    T& at(std::size_t row, std::size_t column) { return table_[row * (columns_ + 1) + column]; }

    std::size_t entering(bool steepest) {
        std::size_t best = columns_;
        T gain = zero;
        for (std::size_t column = 0; column < columns_; ++column) {
            if (at(rows_, column) > gain) {
                best = column;
                gain = at(rows_, column);
                if (!steepest) {
                    break;
                }
            }
        }
        return best;
    }

    std::size_t leaving(std::size_t column) {
        std::size_t best = rows_;
        T least{};
        for (std::size_t row = 0; row < rows_; ++row) {
            if (!(at(row, column) > zero)) {
                continue;
            }
            const T ratio = at(row, columns_) / at(row, column);
            if (best == rows_ || ratio < least || (ratio == least && basis_[row] < basis_[best])) {
                best = row;
                least = ratio;
            }
        }
        return best;
    }

    void pivot(std::size_t row, std::size_t column) {
        const T scale = 1 / at(row, column);
        for (std::size_t index = 0; index <= columns_; ++index) {
            at(row, index) *= scale;
        }
        for (std::size_t other = 0; other <= rows_; ++other) {
            const T factor = at(other, column);
            if (other == row || factor == 0) {
                continue;
            }
            for (std::size_t index = 0; index <= columns_; ++index) {
                at(other, index) -= factor * at(row, index);
            }
            at(other, column) = 0;
        }
        basis_[row] = column;
    }

    std::size_t rows_ = 0;
    std::size_t columns_ = 0;
    std::vector<T> table_;  // the last row holds the sum of the rows whose slack is in the basis
    std::vector<std::size_t> basis_;
};

}  // namespace delabole
