// SPDX-License-Identifier: GPL-3.0-or-later
// Small vectors and matrices; the dimension (2 or 3) is the template parameter of all numerics.
#pragma once
#include "core/Types.hpp"

#include <array>
#include <cmath>

namespace isph {

template <int Dim>
struct Vec {
    std::array<Real, Dim> c{};

    constexpr Real& operator[](int d) { return c[d]; }
    constexpr Real operator[](int d) const { return c[d]; }

    constexpr Vec& operator+=(const Vec& b)
    {
        for (int d = 0; d < Dim; ++d) c[d] += b.c[d];
        return *this;
    }
    constexpr Vec& operator-=(const Vec& b)
    {
        for (int d = 0; d < Dim; ++d) c[d] -= b.c[d];
        return *this;
    }
    constexpr Vec& operator*=(Real s) { for (int d = 0; d < Dim; ++d) c[d] *= s; return *this; }

    friend constexpr Vec operator+(Vec a, const Vec& b) { return a += b; }
    friend constexpr Vec operator-(Vec a, const Vec& b) { return a -= b; }
    friend constexpr Vec operator-(Vec a) { return a *= -1.0; }
    friend constexpr Vec operator*(Vec a, Real s) { return a *= s; }
    friend constexpr Vec operator*(Real s, Vec a) { return a *= s; }
    friend constexpr Vec operator/(Vec a, Real s) { return a *= 1.0 / s; }
    friend constexpr bool operator==(const Vec& a, const Vec& b) { return a.c == b.c; }
};

template <int Dim>
constexpr Real dot(const Vec<Dim>& a, const Vec<Dim>& b)
{
    Real s = 0;
    for (int d = 0; d < Dim; ++d) s += a[d] * b[d];
    return s;
}

template <int Dim>
constexpr Real normSqr(const Vec<Dim>& a) { return dot(a, a); }

template <int Dim>
inline Real norm(const Vec<Dim>& a) { return std::sqrt(dot(a, a)); }

/// a, shortened to the given length where it is longer.
template <int Dim>
inline Vec<Dim> atMost(const Vec<Dim>& a, Real length)
{
    const Real n = norm(a);
    return n > length ? (length / n) * a : a;
}

/// a/|a|, and zero where |a| is too small to have a direction.
template <int Dim>
inline Vec<Dim> unit(const Vec<Dim>& a)
{
    const Real length = norm(a);
    return length > 1e-300 ? a / length : Vec<Dim>{};
}

/// Row-major square matrix.
template <int Dim>
struct Mat {
    std::array<Vec<Dim>, Dim> row{};

    constexpr Vec<Dim>& operator[](int r) { return row[r]; }
    constexpr const Vec<Dim>& operator[](int r) const { return row[r]; }

    static constexpr Mat identity()
    {
        Mat m;
        for (int d = 0; d < Dim; ++d) m[d][d] = 1;
        return m;
    }
    constexpr Mat& operator+=(const Mat& b)
    {
        for (int d = 0; d < Dim; ++d) row[d] += b.row[d];
        return *this;
    }
    constexpr Mat& operator*=(Real s) { for (int d = 0; d < Dim; ++d) row[d] *= s; return *this; }
    friend constexpr Mat operator+(Mat a, const Mat& b) { return a += b; }
    friend constexpr Mat operator*(Mat a, Real s) { return a *= s; }
    friend constexpr Mat operator*(Real s, Mat a) { return a *= s; }
    friend constexpr Vec<Dim> operator*(const Mat& m, const Vec<Dim>& v)
    {
        Vec<Dim> r;
        for (int d = 0; d < Dim; ++d) r[d] = dot(m.row[d], v);
        return r;
    }
    friend constexpr Mat operator*(const Mat& a, const Mat& b)
    {
        Mat m;
        for (int r = 0; r < Dim; ++r)
            for (int k = 0; k < Dim; ++k) m[r] += a[r][k] * b[k];
        return m;
    }
};

/// a (x) b
template <int Dim>
constexpr Mat<Dim> outer(const Vec<Dim>& a, const Vec<Dim>& b)
{
    Mat<Dim> m;
    for (int d = 0; d < Dim; ++d) m[d] = a[d] * b;
    return m;
}

template <int Dim>
constexpr Real trace(const Mat<Dim>& m)
{
    Real t = 0;
    for (int d = 0; d < Dim; ++d) t += m[d][d];
    return t;
}

template <int Dim>
constexpr Mat<Dim> transpose(const Mat<Dim>& m)
{
    Mat<Dim> t;
    for (int r = 0; r < Dim; ++r)
        for (int k = 0; k < Dim; ++k) t[r][k] = m[k][r];
    return t;
}

constexpr Real determinant(const Mat<2>& m) { return m[0][0] * m[1][1] - m[0][1] * m[1][0]; }
constexpr Real determinant(const Mat<3>& m)
{
    return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1])
         - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0])
         + m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

/// Inverse of a matrix whose determinant the caller knows to be away from zero.
constexpr Mat<2> inverse(const Mat<2>& m)
{
    const Real s = 1 / determinant(m);
    Mat<2> r;
    r[0] = {m[1][1] * s, -m[0][1] * s};
    r[1] = {-m[1][0] * s, m[0][0] * s};
    return r;
}
constexpr Mat<3> inverse(const Mat<3>& m)
{
    const Real s = 1 / determinant(m);
    Mat<3> r;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            const int a = (j + 1) % 3, b = (j + 2) % 3, p = (i + 1) % 3, q = (i + 2) % 3;
            r[i][j] = s * (m[a][p] * m[b][q] - m[a][q] * m[b][p]);
        }
    return r;
}

/// Smallest eigenvalue of the symmetric part of m (closed forms for 2 x 2 and 3 x 3).
inline Real smallestEigenvalue(const Mat<2>& m)
{
    const Real mean = 0.5 * (m[0][0] + m[1][1]), half = 0.5 * (m[0][0] - m[1][1]);
    return mean - std::hypot(half, 0.5 * (m[0][1] + m[1][0]));
}
inline Real smallestEigenvalue(const Mat<3>& m)
{
    const Real a01 = 0.5 * (m[0][1] + m[1][0]), a02 = 0.5 * (m[0][2] + m[2][0]),
               a12 = 0.5 * (m[1][2] + m[2][1]);
    const Real q = trace(m) / 3;
    const Real p2 = sqr(m[0][0] - q) + sqr(m[1][1] - q) + sqr(m[2][2] - q) +
                    2 * (sqr(a01) + sqr(a02) + sqr(a12));
    if (p2 < 1e-300) return q;
    const Real p = std::sqrt(p2 / 6);
    Mat<3> b;
    b[0] = {(m[0][0] - q) / p, a01 / p, a02 / p};
    b[1] = {a01 / p, (m[1][1] - q) / p, a12 / p};
    b[2] = {a02 / p, a12 / p, (m[2][2] - q) / p};
    const Real r = std::fmin(1.0, std::fmax(-1.0, 0.5 * determinant(b)));
    const Real twoThirdsPi = 2.0943951023931953;
    return q + 2 * p * std::cos(std::acos(r) / 3 + twoThirdsPi);
}

}  // namespace isph
