// Positions of the entries of a sparse matrix.
#pragma once

#include <vector>

namespace delabole {

// Compressed columns: the entries of column j are those from column_begin[j] to before column_begin[j + 1], with their
// rows in increasing order.
struct SparsePattern {
    std::vector<int> column_begin = {0};
    std::vector<int> row = {};

    int size() const { return static_cast<int>(column_begin.size()) - 1; }
};

}  // namespace delabole
