// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/Particles.hpp"

namespace isph {

template <int Dim>
void Water<Dim>::resize(std::size_t n)
{
    x.resize(n), u.resize(n), uOld.resize(n), p.resize(n), id.resize(n);
    forceGradient.resize(n), forceGradientOld.resize(n);
}

template <int Dim>
void Water<Dim>::reorder(const std::vector<Index>& order)
{
    const auto permute = [&](auto& field) {
        if (field.empty()) return;
        auto sorted = field;
        for (std::size_t k = 0; k < order.size(); ++k) sorted[k] = field[order[k]];
        field.swap(sorted);
    };
    permute(x), permute(u), permute(uOld), permute(p), permute(id);
    permute(forceGradient), permute(forceGradientOld), permute(porosity), permute(porosityOld);
}

template struct Water<2>;
template struct Water<3>;

}  // namespace isph
