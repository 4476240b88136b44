// SPDX-License-Identifier: GPL-3.0-or-later
#include "functionObjects/FunctionObject.hpp"
#include "functionObjects/KernelField.hpp"

#include "core/Parallel.hpp"

#include <algorithm>
#include <cmath>

namespace isph {
namespace {

constexpr Real kSolidWidth = 0.5;  // of h: 20 spacings cubed lose 0.2 % at the edges, with h 0.9 %

using Block = std::array<Index, 3>;

/// Whether a particle's own place lies outside what the grid counts, so that it flies as spray.
bool isSpray(const KernelField& field, Index i)
{
    return !field.shares(toVec(field.flow().position[i])).inWater();
}

/// Share of a cell of edge `edge` that lies where a smooth field is positive, from its value and
/// gradient at the centre: exact where the surface of a half-space is parallel to a face. Other
/// inclinations err to both sides and cancel over a surface.
Real filledShare(Real value, const Vec<3>& gradient, Real edge)
{
    const Real rise = edge * norm(gradient);  // of the field through the cell
    return std::clamp(0.5 + value / std::max(rise, Real(1e-12)), Real(0), Real(1));
}

/// The grid of cells of edge d0/2 over the water. It is anchored at the origin, so that a volume
/// does not change with the extent of the water.
class CellSum {
public:
    explicit CellSum(const KernelField& field)
        : field_(field),
          flow_(field.flow()),
          solid_(flow_, flow_.wallPosition, flow_.wallVolume,
                 std::vector<Real>(flow_.wallPosition.size(),
                                   kSolidWidth * flow_.smoothingRatio * flow_.spacing)),
          cell_(0.5 * flow_.spacing),
          width_(static_cast<int>(std::ceil(field.water().reach() / cell_)))
    {
    }

    Real volume() const
    {
        const std::vector<Block> blocks = wetBlocks();
        const int layers = flow_.dimension == 3 ? width_ : 1;
        std::vector<Real> part(blocks.size() *
                               static_cast<std::size_t>(layers));  // many, for many threads
        parallelForDynamic(part.size(),
                           [&](Index k) { part[k] = inLayer(blocks[k / layers], k % layers); });
        return orderedSum(part.size(), [&](Index k) { return part[k]; });
    }

private:
    /// Blocks of width_ cells in each direction that hold water or touch one that does, in order.
    std::vector<Block> wetBlocks() const
    {
        const Real edge = width_ * cell_;
        std::vector<Block> own;
        for (const Vec<3>& x : field_.water().position()) {
            own.emplace_back();
            for (int d = 0; d < flow_.dimension; ++d)
                own.back()[d] = static_cast<Index>(std::floor(x[d] / edge));
        }
        makeUnique(own);
        std::vector<Block> all;
        const int layers = flow_.dimension == 3 ? 1 : 0;
        for (const Block& block : own)
            for (Index c = -layers; c <= layers; ++c)
                for (Index b = -1; b <= 1; ++b)
                    for (Index a = -1; a <= 1; ++a)
                        all.push_back({block[0] + a, block[1] + b, block[2] + c});
        makeUnique(all);
        return all;
    }

    static void makeUnique(std::vector<Block>& all)
    {
        std::sort(all.begin(), all.end());
        all.erase(std::unique(all.begin(), all.end()), all.end());
    }

    /// Layer c of a block's cells, in 2-D its only one.
    Real inLayer(const Block& block, int c) const
    {
        Real sum = 0;
        for (int b = 0; b < width_; ++b)
            for (int a = 0; a < width_; ++a)
                sum +=
                    inCell({block[0] * width_ + a, block[1] * width_ + b, block[2] * width_ + c});
        return sum;
    }

    Real inCell(const Block& number) const
    {
        Vec<3> x{};
        Real volume = 1;
        for (int d = 0; d < flow_.dimension; ++d) {
            const Real low = number[d] * cell_, high = low + cell_;
            x[d] = low + 0.5 * cell_;
            volume *= flow_.periodic[d] ? std::max(Real(0), std::min(high, flow_.domainMax[d]) -
                                                                std::max(low, flow_.domainMin[d]))
                                        : cell_;
        }
        if (volume <= 0) return 0;
        const Shares shares = field_.shares(x);
        if (shares.water <= 0) return 0;
        const Real wet = filledShare(shares.water - 0.5 * (1 - shares.wall),
                                     shares.waterGradient + 0.5 * shares.wallGradient, cell_);
        const Real filled = wet > 0 && shares.wall > 0 ? std::min(wet, openShare(x)) : wet;
        if (filled <= 0) return 0;
        return volume * filled * (flow_.porosityAt ? flow_.porosityAt({x[0], x[1], x[2]}) : 1);
    }

    Real openShare(const Vec<3>& x) const
    {
        thread_local KernelSamples samples;
        solid_.gather(x, samples);
        Real share = 0;
        Vec<3> gradient{};
        for (std::size_t k = 0; k < samples.size(); ++k) {
            share += samples.weight[k];
            gradient += samples.slope[k] * samples.offset[k];
        }
        return filledShare(0.5 - share, gradient, cell_);
    }

    const KernelField& field_;
    const FlowView& flow_;
    KernelCloud solid_;
    Real cell_;
    int width_;
};

/// Water volume on a grid of spacing d0/2, beside that of the particles.              [m3, in 2-D
/// m2]
///   grid        sum over cells (d0/2)^D eps min(s, w): s the share of the cell below the water
///   surface,
///               where the water fills half of what the walls leave (water share = (1 - wall
///               share)/2), w that outside the walls (wall share < 1/2, by kernels of half the
///               width, because the contour of a share cuts corners off), both from the kernel sums
///               at its centre; eps the porosity of the zone there
///   spray       m/rho0 of the particles whose own place is not in that water (drops of one or a
///   few
///               particles, whose kernel sum stays below the half)
///   particles   sum m/rho0
///   difference  (grid - particles)/particles, and differenceWithSpray, (grid + spray -
///   particles)/particles
class Volume : public FunctionObject {
public:
    static Schema keys() { return keysWith({}); }
    explicit Volume(const Dictionary&) {}

    std::vector<Real> measure(const FlowView& flow) override
    {
        const std::size_t n = flow.position.size();
        const Real one = flow.particleMass() / flow.density;
        const Real particles = static_cast<Real>(n) * one;
        if (n == 0) return {0, 0, 0, 0, 0};
        const KernelField field(flow);
        const Real grid = CellSum(field).volume();
        const Real spray =
            one * orderedSum(n, [&](Index i) { return isSpray(field, i) ? 1.0 : 0.0; });
        return {grid, spray, particles, (grid - particles) / particles,
                (grid + spray - particles) / particles};
    }

    std::vector<std::string> columns() const override
    {
        return {"grid", "spray", "particles", "difference", "differenceWithSpray"};
    }

    std::vector<std::string> header() const override
    {
        return {"volumes [m3], in 2-D [m2]; differences as fractions"};
    }
};

const FunctionObject::Table::Entry<Volume> entry{"volume"};

}  // namespace
}  // namespace isph
