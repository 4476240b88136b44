// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/LargeArray.hpp"

#include <malloc.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <map>
#include <mutex>

namespace isph {

namespace {
constexpr std::size_t kPage = 4096;
/// What is smaller the standard allocator keeps well itself. A higher limit would keep the memory
/// of some arrays of a step here and that of others there.
constexpr std::size_t kLeast = std::size_t{1} << 20;

/// A range of addresses that is cut into arrays. Pages that have been touched stay with it.
class Range {
public:
    Range()
    {
        // Addresses cost nothing: as many as for twice the memory of the machine.
        const auto pages = static_cast<std::size_t>(sysconf(_SC_PHYS_PAGES));
        const std::size_t size = 2 * pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
        constexpr int fresh = MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE;
        void* memory = mmap(nullptr, size, PROT_READ | PROT_WRITE, fresh, -1, 0);
        if (memory == MAP_FAILED)
            return;  // addresses are limited: the standard allocator has to do
        begin_ = top_ = static_cast<char*>(memory);
        end_ = begin_ + size;
        madvise(begin_, size, MADV_HUGEPAGE);
    }

    bool owns(const void* memory) const { return memory >= begin_ && memory < end_; }

    /// The smallest gap that is large enough, else what follows the last array; null: no room.
    void* take(std::size_t bytes)
    {
        const std::size_t size = rounded(bytes);
        const std::lock_guard lock(mutex_);
        auto best = gap_.end();
        for (auto gap = gap_.begin(); gap != gap_.end(); ++gap)
            if (gap->second >= size && (best == gap_.end() || gap->second < best->second))
                best = gap;
        if (best != gap_.end()) {
            const auto [place, room] = *best;
            gap_.erase(best);
            if (room > size) gap_.emplace(place + size, room - size);
            return place;
        }
        if (static_cast<std::size_t>(end_ - top_) < size) return nullptr;
        return std::exchange(top_, top_ + size);
    }

    void give(void* memory, std::size_t bytes)
    {
        const std::lock_guard lock(mutex_);
        auto gap = gap_.emplace(static_cast<char*>(memory), rounded(bytes)).first;
        if (const auto next = std::next(gap); next != gap_.end()) join(gap, next);
        if (gap != gap_.begin()) join(std::prev(gap), gap);
    }

    void returnFree()
    {
        const std::lock_guard lock(mutex_);
        for (const auto& [place, size] : gap_) madvise(place, size, MADV_DONTNEED);
        if (gap_.empty() || gap_.rbegin()->first + gap_.rbegin()->second != top_) return;
        top_ = gap_.rbegin()->first;
        gap_.erase(std::prev(gap_.end()));
    }

private:
    using Gaps = std::map<char*, std::size_t>;   ///< places and sizes

    /// Makes one gap of two where they touch.
    void join(Gaps::iterator gap, Gaps::iterator next)
    {
        if (gap->first + gap->second != next->first) return;
        gap->second += next->second;
        gap_.erase(next);
    }
    static std::size_t rounded(std::size_t bytes) { return (bytes + kPage - 1) / kPage * kPage; }

    char *begin_ = nullptr, *top_ = nullptr, *end_ = nullptr;
    Gaps gap_;   ///< between arrays, no two side by side
    std::mutex mutex_;
};

Range& range()
{
    static Range& all = *new Range;   // never destroyed: static arrays give their memory back late
    return all;
}
}  // namespace

void* takeMemory(std::size_t bytes, std::size_t alignment)
{
    if (bytes >= kLeast)
        if (void* memory = range().take(bytes)) return memory;
    if (alignment <= __STDCPP_DEFAULT_NEW_ALIGNMENT__) return ::operator new(bytes);
    return ::operator new(bytes, std::align_val_t{alignment});
}

void giveMemory(void* memory, std::size_t bytes, std::size_t alignment) noexcept
{
    if (bytes >= kLeast && range().owns(memory)) return range().give(memory, bytes);
    if (alignment <= __STDCPP_DEFAULT_NEW_ALIGNMENT__) return ::operator delete(memory);
    ::operator delete(memory, std::align_val_t{alignment});
}

void returnFreeMemory() noexcept
{
    range().returnFree();
    malloc_trim(0);
}

}  // namespace isph
