// SPDX-License-Identifier: GPL-3.0-or-later
#include "functionObjects/KernelField.hpp"

#include <fmt/core.h>

#include <numeric>

namespace isph {

namespace {

std::vector<Real> waterVolumes(const FlowView& flow)
{
    std::vector<Real> volume(flow.position.size());
    for (std::size_t i = 0; i < volume.size(); ++i) volume[i] = flow.occupiedVolume(i);
    return volume;
}

std::vector<Real> waterLengths(const FlowView& flow)
{
    std::vector<Real> h(flow.position.size());
    for (std::size_t i = 0; i < h.size(); ++i) h[i] = flow.smoothingLength(i);
    return h;
}

/// Solves the symmetric positive definite system M c = e_0 of n <= 4 unknowns by Cholesky's method.
/// False where M is singular to working accuracy.
bool solveForValue(std::array<std::array<Real, 4>, 4> m, int n, std::array<Real, 4>& c)
{
    constexpr Real leastPivot =
        1e-10;  // of its diagonal entry: below, the neighbours lie in a plane
    for (int k = 0; k < n; ++k) {
        const Real whole = m[k][k];
        for (int l = 0; l < k; ++l) m[k][k] -= sqr(m[k][l]);
        if (!(m[k][k] > leastPivot * whole)) return false;
        m[k][k] = std::sqrt(m[k][k]);
        for (int r = k + 1; r < n; ++r) {
            for (int l = 0; l < k; ++l) m[r][k] -= m[r][l] * m[k][l];
            m[r][k] /= m[k][k];
        }
    }
    for (int k = 0; k < n; ++k) {
        c[k] = k == 0 ? 1 : 0;
        for (int l = 0; l < k; ++l) c[k] -= m[k][l] * c[l];
        c[k] /= m[k][k];
    }
    for (int k = n - 1; k >= 0; --k) {
        for (int l = k + 1; l < n; ++l) c[k] -= m[l][k] * c[l];
        c[k] /= m[k][k];
    }
    return true;
}

}  // namespace

void KernelSamples::resize(std::size_t count)
{
    owner.resize(count);
    offset.resize(count);
    weight.resize(count);
    slope.resize(count);
    q.resize(count);
}

KernelCloud::KernelCloud(const FlowView& flow, Span<const Vector3> position,
                         Span<const Real> volume, Span<const Real> h)
    : kernel_(flow.kernel), owner_(position.size())
{
    const Real sigma = kernel_->normalisation(flow.dimension);
    std::iota(owner_.begin(), owner_.end(), Index{0});
    for (std::size_t i = 0; i < position.size(); ++i) {
        position_.push_back(toVec(position[i]));
        if (!std::isfinite(normSqr(position_.back())))
            throw FatalError(fmt::format(
                "Particle {} stands at ({} {} {}): the flow has no finite state to measure", i,
                position[i][0], position[i][1], position[i][2]));
        scale_.push_back(volume[i] * sigma / (flow.dimension == 2 ? sqr(h[i]) : cube(h[i])));
        inverseH_.push_back(1 / h[i]);
        reach_ = std::max(reach_, kernel_->supportRadius() * h[i]);
    }
    addImages(flow);
    sortByCells();
}

/// Cells of half the reach: the cube of those that a ball touches then holds 2.5^3 in place of 3^3
/// of what a cube of the reach holds, and a row of them is one run through memory.
void KernelCloud::sortByCells()
{
    constexpr Real perReach = 2;
    const Real edge = reach_ > 0 ? reach_ / perReach : 1;
    grid_.build(position_, edge);
    const std::vector<Index> order = grid_.order();
    const auto sorted = [&](auto& field) {
        auto before = std::move(field);
        field.resize(before.size());
        for (std::size_t k = 0; k < before.size(); ++k) field[k] = before[order[k]];
    };
    sorted(position_), sorted(owner_), sorted(scale_), sorted(inverseH_);
    grid_.build(position_, edge);
}

void KernelCloud::addImages(const FlowView& flow)
{
    for (int d = 0; d < flow.dimension; ++d) {
        if (!flow.periodic[d]) continue;
        const Real period = flow.domainMax[d] - flow.domainMin[d];
        const std::size_t own = position_.size();
        for (std::size_t i = 0; i < own; ++i)
            for (const int side : {-1, 1}) {
                Vec<3> x = position_[i];
                x[d] += side * period;
                if (x[d] < flow.domainMin[d] - reach_ || x[d] > flow.domainMax[d] + reach_)
                    continue;
                position_.push_back(x);
                owner_.push_back(owner_[i]);
                scale_.push_back(scale_[i]);
                inverseH_.push_back(inverseH_[i]);
            }
    }
}

void KernelCloud::gather(const Vec<3>& x, KernelSamples& samples) const
{
    if (position_.empty()) return samples.resize(0);
    const Real supportSqr = sqr(kernel_->supportRadius());
    // Two in three candidates lie outside the ball, in no order: each is written and the next one
    // takes its place, without a branch to be guessed.
    thread_local std::vector<Index> found;
    const Vec<3>* const position = position_.data();
    const Real* const inverseH = inverseH_.data();
    Index *next = found.data(), *end = next + found.size();
    grid_.forEachNear(x, reach_, [&](Index j) {
        if (next == end) {
            const std::ptrdiff_t count = next - found.data();
            found.resize(2 * found.size() + 64);
            next = found.data() + count, end = found.data() + found.size();
        }
        *next = j;
        next += normSqr(x - position[j]) * sqr(inverseH[j]) < supportSqr;
    });
    const auto count = static_cast<std::size_t>(next - found.data());
    samples.resize(count);
    for (std::size_t k = 0; k < count; ++k) {
        const Index j = found[k];
        samples.offset[k] = x - position[j];
        samples.q[k] = norm(samples.offset[k]) * inverseH[j];
    }
    kernel_->evaluate(samples.q, samples.weight, samples.slope);
    for (std::size_t k = 0; k < count; ++k) {
        const Index j = found[k];
        samples.weight[k] *= scale_[j];
        samples.slope[k] *= scale_[j] * sqr(inverseH_[j]);
        samples.owner[k] = owner_[j];
    }
}

KernelField::KernelField(const FlowView& flow)
    : flow_(flow),
      water_(flow, flow.position, waterVolumes(flow), waterLengths(flow)),
      walls_(flow, flow.wallPosition, flow.wallVolume,
             std::vector<Real>(flow.wallPosition.size(), flow.smoothingRatio * flow.spacing))
{
}

Shares KernelField::shares(const Vec<3>& x) const
{
    thread_local KernelSamples samples;
    Shares shares;
    water_.gather(x, samples);
    for (std::size_t k = 0; k < samples.size(); ++k) {
        shares.water += samples.weight[k];
        shares.waterGradient += samples.slope[k] * samples.offset[k];
    }
    walls_.gather(x, samples);
    for (std::size_t k = 0; k < samples.size(); ++k) {
        shares.wall += samples.weight[k];
        shares.wallGradient += samples.slope[k] * samples.offset[k];
    }
    return shares;
}

void KernelField::gatherOneSide(const Vec<3>& x, KernelSamples& samples) const
{
    water_.gather(x, samples);
    if (!flow_.zoneAt) return;
    const auto least = static_cast<std::size_t>(flow_.dimension + 2);   // for a gradient
    const Index zone = flow_.zoneAt({x[0], x[1], x[2]});
    samples.keep(least, [&](Index i) { return flow_.zone[i] == zone; });
}

std::vector<Real> interpolationWeights(const KernelSamples& samples, int dimension, Real length)
{
    constexpr Real mostGrowth = 6;
    const int n = dimension + 1;
    const auto basis = [&](std::size_t k, int r) {
        return r == 0 ? 1 : -samples.offset[k][r - 1] / length;
    };
    std::array<std::array<Real, 4>, 4> moment{};
    for (std::size_t k = 0; k < samples.size(); ++k)
        for (int r = 0; r < n; ++r)
            for (int c = 0; c <= r; ++c)
                moment[r][c] += samples.weight[k] * basis(k, r) * basis(k, c);
    std::vector<Real> weights(samples.weight);
    std::array<Real, 4> coefficient{};
    if (static_cast<int>(samples.size()) >= dimension + 2 &&
        solveForValue(moment, n, coefficient)) {
        Real growth = 0;
        for (std::size_t k = 0; k < samples.size(); ++k) {
            Real value = 0;
            for (int r = 0; r < n; ++r) value += coefficient[r] * basis(k, r);
            weights[k] *= value;
            growth += std::abs(weights[k]);
        }
        if (growth <= mostGrowth) return weights;
        weights = samples.weight;
    }
    for (Real& weight : weights) weight /= moment[0][0];
    return weights;
}

Vec<3> pointIn(const FlowView& flow, const Vector3& point)
{
    return Vec<3>{{point[0], point[1], flow.dimension == 2 ? 0 : point[2]}};
}

Vec<3> upward(const FlowView& flow)
{
    return -unit(toVec(flow.gravity));
}

}  // namespace isph
