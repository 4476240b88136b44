// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers of particles side by side in memory, read for eight particles at a time.
#pragma once
#include "core/Lanes.hpp"
#include "core/LargeArray.hpp"

namespace isph {

/// `Size` numbers, four or a multiple of kLanes, of every particle. It refers to the memory of a
/// RecordStore.
template <int Size>
class Records {
public:
    static constexpr int kHalf = kLanes / 2;
    static_assert(Size == kHalf || Size % kLanes == 0);
    explicit Records(Real* first) : first_(first) {}

    Real* operator[](Index i) const { return first_ + static_cast<std::ptrdiff_t>(Size) * i; }

    /// The first numbers of eight particles: eight loads and a transposition in registers for every
    /// eight.
    template <int Numbers = Size>
    [[gnu::always_inline]] std::array<Lanes, Numbers> gather(const Index* particle) const
    {
        static_assert((Numbers == Size || Numbers % kLanes == 0) && Numbers <= Size);
        std::array<Lanes, Numbers> all;
        if constexpr (Numbers == kHalf) {
            for (int l = 0; l < kHalf; ++l)
                all[l] = loadLanes((*this)[particle[l]], (*this)[particle[l + kHalf]]);
            transpose(all);
            return all;
        }
        for (int part = 0; part < Numbers; part += kLanes) {
            std::array<Lanes, kLanes> block;
            for (int l = 0; l < kLanes; ++l) block[l] = loadLanes((*this)[particle[l]] + part);
            transpose(block);
            for (int l = 0; l < kLanes; ++l) all[part + l] = block[l];
        }
        return all;
    }

private:
    Real* first_;
};

/// Memory of records, used again by one pass over the pairs after the other. It is not filled
/// before its use.
class RecordStore {
public:
    /// Room for n records, whose numbers are whatever stood there.
    template <int Size>
    Records<Size> records(Index n)
    {
        return Records<Size>(numbers(static_cast<std::size_t>(n) * Size));
    }

    /// Room for n numbers without any order.
    Real* numbers(std::size_t n)
    {
        const std::size_t lines = n / kLanes + 1;
        if (lines_.size() < lines) {
            release();
            lines_.resize(lines + lines / 32);
        }
        return lines_[0].number.data();
    }

    /// Gives the memory back until the next use.
    void release() { lines_ = LargeArray<Line>(); }

private:
    struct alignas(64) Line {
        std::array<Real, kLanes> number;
    };
    LargeArray<Line> lines_;
};

}  // namespace isph
