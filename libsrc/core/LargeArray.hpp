// SPDX-License-Identifier: GPL-3.0-or-later
// Arrays over particles, rows and pairs, whose memory goes from one to the next without the system.
#pragma once
#include <cstddef>
#include <new>
#include <utility>
#include <vector>

namespace isph {

/// Memory for an array. From 1 MB on it is of huge pages, where the system has them, for loops over
/// pairs and rows touch many pages at a time; and what is given back is kept for whoever asks next:
/// the system takes longer to hand out clean pages than a step to fill them. Throws std::bad_alloc.
void* takeMemory(std::size_t bytes, std::size_t alignment);
void giveMemory(void* memory, std::size_t bytes, std::size_t alignment) noexcept;

/// Hands what is kept and not in use back to the system.
void returnFreeMemory() noexcept;

/// Allocator of that memory. Numbers are left as they are where no value is asked for, so that the
/// threads that fill an array are the first to touch it.
template <class T>
struct KeptMemory {
    using value_type = T;

    KeptMemory() = default;
    template <class U>
    KeptMemory(const KeptMemory<U>&) noexcept {}

    T* allocate(std::size_t n) { return static_cast<T*>(takeMemory(n * sizeof(T), alignof(T))); }
    void deallocate(T* memory, std::size_t n) noexcept
    {
        giveMemory(memory, n * sizeof(T), alignof(T));
    }

    template <class U>
    void construct(U* place) { ::new (static_cast<void*>(place)) U; }
    template <class U, class... Values>
    void construct(U* place, Values&&... values)
    {
        ::new (static_cast<void*>(place)) U(std::forward<Values>(values)...);
    }

    friend bool operator==(const KeptMemory&, const KeptMemory&) { return true; }
};

/// A vector whose resize() leaves new numbers without a value.
template <class T>
using LargeArray = std::vector<T, KeptMemory<T>>;

}  // namespace isph
