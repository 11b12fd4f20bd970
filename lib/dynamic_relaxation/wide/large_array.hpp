// Arrays of many megabytes that every step reads, on pages of 2 MB where the system has them: address translation with
// small pages took a fifth of the time of a step of 100 000 blocks.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>
#include <vector>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace delabole {

template <class T>
struct LargePageAllocator {
    using value_type = T;  // NOLINT(readability-identifier-naming): the name that containers ask for

    LargePageAllocator() = default;
    template <class Other>
    LargePageAllocator(const LargePageAllocator<Other>& /*other*/) {}

    T* allocate(std::size_t count) {
        if (!is_large(count)) {
            return std::allocator<T>().allocate(count);
        }
        const std::size_t bytes = (count * sizeof(T) + page - 1) / page * page;
        void* const memory = std::aligned_alloc(page, bytes);
        if (memory == nullptr) {
            throw std::bad_alloc();
        }
#ifdef __linux__
        // The advice affects speed alone, so that its result is ignored.
        static_cast<void>(madvise(memory, bytes, MADV_HUGEPAGE));
#endif
        return static_cast<T*>(memory);
    }
    void deallocate(T* memory, std::size_t count) {
        if (is_large(count)) {
            std::free(memory);
        } else {
            std::allocator<T>().deallocate(memory, count);
        }
    }

    bool operator==(const LargePageAllocator&) const = default;

  private:
    static constexpr std::size_t page = std::size_t{1} << 21;
    static bool is_large(std::size_t count) {
        return count >= page / sizeof(T);
    }
};

template <class T>
using LargeArray = std::vector<T, LargePageAllocator<T>>;

}  // namespace delabole
