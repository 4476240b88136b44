// SPDX-License-Identifier: GPL-3.0-or-later
// Kernel sums at any place of the flow: how much of it is water, how much wall, and values of
// fields.
#pragma once
#include "core/Vec.hpp"
#include "functionObjects/FlowView.hpp"
#include "neighbours/CellGrid.hpp"

namespace isph {

/// The particles whose support contains a place x.
struct KernelSamples {
    std::vector<Index> owner;    ///< number in the FlowView (images have that of their particle)
    std::vector<Vec<3>> offset;  ///< x - x_j [m]
    std::vector<Real> weight;    ///< V_j W(x - x_j, h_j)
    std::vector<Real> slope;     ///< gradient of the weight = slope offset [1/m2]
    std::vector<Real> q;         ///< |offset|/h_j

    std::size_t size() const { return owner.size(); }
    void resize(std::size_t count);
    /// Leaves those out that `stays(owner)` denies, if at least `least` remain.
    template <class F>
    void keep(std::size_t least, F&& stays)
    {
        std::vector<std::size_t> kept;
        for (std::size_t k = 0; k < size(); ++k)
            if (stays(owner[k])) kept.push_back(k);
        if (kept.size() < least || kept.size() == size()) return;
        const auto pick = [&](auto& values) {
            for (std::size_t k = 0; k < kept.size(); ++k) values[k] = values[kept[k]];
            values.resize(kept.size());
        };
        pick(owner), pick(offset), pick(weight), pick(slope), pick(q);
    }
};

/// Particles of one kind with the volumes and widths of their kernels. In 2-D z = 0.
class KernelCloud {
public:
    /// volume [m^D] and h [m] of every position. Images are made along periodic directions of the
    /// flow.
    KernelCloud(const FlowView& flow, Span<const Vector3> position, Span<const Real> volume,
                Span<const Real> h);

    void gather(const Vec<3>& x, KernelSamples& samples) const;
    /// Positions, images included, in the order of cells.
    const std::vector<Vec<3>>& position() const { return position_; }
    /// The largest radius of a support [m].
    Real reach() const { return reach_; }

private:
    void addImages(const FlowView& flow);
    void sortByCells();

    const Kernel* kernel_;
    std::vector<Vec<3>> position_;
    std::vector<Index> owner_;
    std::vector<Real> scale_;  ///< V sigma/h^D
    std::vector<Real> inverseH_;
    Real reach_ = 0;
    CellGrid<3> grid_;
};

/// Shares of water and wall at a place; they sum to 1 in the bulk and beside walls, up to the error
/// of the kernel sum.
///     water = sum over water V_j W(x - x_j, h_j),  V_j = m/(eps_j rho0)        wall = the same
///     over walls
struct Shares {
    Real water = 0, wall = 0;
    Vec<3> waterGradient{}, wallGradient{};  ///< [1/m]

    /// Whether a place is in the water: the water fills at least half of what the walls leave, and
    /// the place is not deep in a wall (an eighth: a corner of three walls leaves that much at its
    /// tip).
    bool inWater() const { return water >= 0.5 * (1 - wall) && water >= 0.125; }
};

class KernelField {
public:
    /// Keeps a reference to `flow`. Throws FatalError where a particle has no finite position.
    explicit KernelField(const FlowView& flow);

    const FlowView& flow() const { return flow_; }
    const KernelCloud& water() const { return water_; }
    const KernelCloud& walls() const { return walls_; }

    Shares shares(const Vec<3>& x) const;
    /// The water that tells values at x: that of its own soil zone, where there is enough of it. At
    /// the face of soil fields have kinks, and a mean over both sides is off by their jump.
    void gatherOneSide(const Vec<3>& x, KernelSamples& samples) const;

private:
    const FlowView& flow_;
    KernelCloud water_, walls_;
};

/// Weights that give the value of a field at a place from those of the samples.
/// Moving least squares of first order: with p = (1, x_j - x) and M = sum_j w_j p p^T, the weight
/// is w_j p.M^-1 (1, 0..): exact for linear fields. Where the neighbours do not carry a gradient
/// (fewer than D + 2, or weights whose magnitudes sum to more than 6, the factor by which noise
/// would grow: a corner of the walls reaches 4), Shepard's w_j / sum w, exact for constants.
/// Samples must not be empty. source  Lancaster & Salkauskas (1981), Math. Comp. 37, 141-158;
/// Shepard (1968), ACM Conf., 517-524
std::vector<Real> interpolationWeights(const KernelSamples& samples, int dimension, Real length);

inline Vec<3> toVec(const Vector3& a)
{
    return Vec<3>{a};
}

/// A point that a dictionary names; in 2-D z = 0.
Vec<3> pointIn(const FlowView& flow, const Vector3& point);

/// Unit vector opposite to gravity, zero where there is none.
Vec<3> upward(const FlowView& flow);

}  // namespace isph
