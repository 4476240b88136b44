// SPDX-License-Identifier: GPL-3.0-or-later
// Dimension sets [mass length time temperature quantity current luminosity] of dictionary entries.
#pragma once
#include <array>
#include <string>

namespace isph {

struct Dimensions {
    std::array<double, 7> exponent{};
    friend bool operator==(const Dimensions&, const Dimensions&) = default;
    friend Dimensions operator*(Dimensions a, const Dimensions& b)
    {
        for (std::size_t k = 0; k < 7; ++k) a.exponent[k] += b.exponent[k];
        return a;
    }
    friend Dimensions operator/(Dimensions a, const Dimensions& b)
    {
        for (std::size_t k = 0; k < 7; ++k) a.exponent[k] -= b.exponent[k];
        return a;
    }
};

/// "[0 2 -1 0 0 0 0]"
std::string toString(const Dimensions& dimensions);

namespace dims {
inline constexpr Dimensions none{};
inline constexpr Dimensions length{{0, 1, 0, 0, 0, 0, 0}};
inline constexpr Dimensions time{{0, 0, 1, 0, 0, 0, 0}};
inline constexpr Dimensions velocity{{0, 1, -1, 0, 0, 0, 0}};
inline constexpr Dimensions acceleration{{0, 1, -2, 0, 0, 0, 0}};
inline constexpr Dimensions kinematicViscosity{{0, 2, -1, 0, 0, 0, 0}};
inline constexpr Dimensions density{{1, -3, 0, 0, 0, 0, 0}};
inline constexpr Dimensions area{{0, 2, 0, 0, 0, 0, 0}};
inline constexpr Dimensions pressure{{1, -1, -2, 0, 0, 0, 0}};
inline constexpr Dimensions rate{{0, 0, -1, 0, 0, 0, 0}};
}  // namespace dims

}  // namespace isph
