// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/Vec.hpp"

namespace isph {

/// Symmetric matrix: its lower half.
template <int Dim>
struct SymMat {
    std::array<Real, Dim * (Dim + 1) / 2> half{};

    SymMat() = default;
    /// Of a matrix that is symmetric but for rounding.
    constexpr SymMat(const Mat<Dim>& m)
    {
        for (int r = 0, n = 0; r < Dim; ++r)
            for (int k = 0; k <= r; ++k) half[n++] = m[r][k];
    }
    constexpr Vec<Dim> operator[](int r) const
    {
        Vec<Dim> v;
        for (int k = 0; k < Dim; ++k)
            v[k] = half[r >= k ? r * (r + 1) / 2 + k : k * (k + 1) / 2 + r];
        return v;
    }
    constexpr operator Mat<Dim>() const
    {
        Mat<Dim> m;
        for (int r = 0; r < Dim; ++r) m[r] = (*this)[r];
        return m;
    }
    friend constexpr Vec<Dim> operator*(const SymMat& m, const Vec<Dim>& v)
    {
        return Mat<Dim>(m) * v;
    }
    friend constexpr Mat<Dim> operator*(const SymMat& m, const Mat<Dim>& b)
    {
        return Mat<Dim>(m) * b;
    }
    friend constexpr Mat<Dim> operator*(const Mat<Dim>& b, const SymMat& m)
    {
        return b * Mat<Dim>(m);
    }
};

}  // namespace isph
