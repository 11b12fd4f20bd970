// Index of items that each lie between two blocks, by block.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace delabole {

// `blocks_of` gives the two blocks of an item. The numbers of a block's items, in increasing order, are stored in
// of_block from begin[block] to begin[block + 1].
template <class Items, class BlocksOf>
void index_by_block(std::size_t blocks, const Items& items, const BlocksOf& blocks_of,
                    std::vector<std::uint32_t>& begin, std::vector<std::uint32_t>& of_block) {
    begin.assign(blocks + 1, 0);
    for (const auto& item : items) {
        const auto [one, other] = blocks_of(item);
        ++begin[one + 1];
        ++begin[other + 1];
    }
    for (std::size_t block = 0; block < blocks; ++block) {
        begin[block + 1] += begin[block];
    }
    of_block.resize(2 * items.size());
    std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
    for (std::uint32_t number = 0; number < items.size(); ++number) {
        const auto [one, other] = blocks_of(items[number]);
        of_block[next[one]++] = number;
        of_block[next[other]++] = number;
    }
}

}  // namespace delabole
