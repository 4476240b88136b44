// SPDX-License-Identifier: GPL-3.0-or-later
#include "case/Packing.hpp"

#include "case/FaceLayer.hpp"
#include "case/PointGrid.hpp"
#include "case/SoilField.hpp"
#include "core/Parallel.hpp"

#include <algorithm>

namespace isph {

namespace {

constexpr Real smoothing = 1.5;    // h over the local spacing
constexpr Real rate = 0.15;        // c
constexpr Real evenness = 0.3;     // e: orders the particles
constexpr Real stiffness = 4;      // K: evens out the kernel sum where the spacing varies
constexpr Real longestStep = 0.1;  // in local spacings
constexpr Real settled = 3e-3;     // in local spacings
constexpr int mostSweeps = 200;
constexpr int sweepsPerSearch = 10;
constexpr Real skin = 0.5;    // of d0: how far two particles may approach between searches
constexpr Real margin = 0.4;  // in local spacings: what a particle keeps from the faces of its part

class Packing {
public:
    Packing(const PackingTask& task, std::vector<Point>& x)
        : task_(task),
          g_(task.geometry),
          d0_(g_.spacing),
          kernel_{g_.dimension},
          x_(x),
          spacing_(x.size(), d0_),
          volume_(x.size(), g_.cellVolume()),
          excess_(x.size(), 0),
          atMost_(x.size(), std::numeric_limits<Real>::max()),
          latticeSum_(latticeSum())
    {
        for (std::size_t i = 0; i < x_.size(); ++i)
            if (task_.mobility[i] > 0) mobile_.push_back(i);
    }

    void run()
    {
        if (mobile_.empty()) return;
        updateSpacing();
        layOutside();
        for (int sweep = 0; sweep < mostSweeps; ++sweep) {
            if (sweep % sweepsPerSearch == 0) {
                updateSpacing();
                search();
            }
            if (step() < settled) break;
        }
        for (std::size_t i : mobile_) x_[i] = g_.wrapped(x_[i]);
    }

private:
    /// sum_j V_j W_ij in a lattice.
    Real latticeSum() const
    {
        const int m = static_cast<int>(2 * smoothing), k0 = g_.dimension == 3 ? m : 0;
        Real sum = 0;
        for (int k = -k0; k <= k0; ++k)
            for (int j = -m; j <= m; ++j)
                for (int i = -m; i <= m; ++i)
                    sum +=
                        kernel_.w(std::sqrt(static_cast<Real>(i * i + j * j + k * k)), smoothing);
        return sum;
    }

    void updateSpacing()
    {
        parallelForDynamic(x_.size(), [&](Index i) {
            const Real porosity = task_.porosity(x_[i]);
            spacing_[i] = d0_ / std::pow(porosity, 1.0 / g_.dimension);
            volume_[i] = g_.cellVolume() / porosity;
        });
        widest_ = d0_;
        for (Real s : spacing_) widest_ = std::max(widest_, s);
    }

    /// The space around the mobile particles that is not theirs to fill, as points with volumes:
    /// cells of d0 that lie outside as a whole, so that a lattice goes on in them, and parts of
    /// others by halves.
    void layOutside()
    {
        BoundingBox box;
        for (std::size_t i : mobile_) box.include(x_[i]);
        const Real reach = 2 * smoothing * widest_;
        PointGrid mobile(reach);
        for (std::size_t i : mobile_) mobile.add(x_[i]);
        box = box.grown(reach, g_.dimension);
        for (int d = 0; d < g_.dimension; ++d) {  // whole cells from the corner of the domain
            box.min[d] = g_.domain.min[d] + std::floor((box.min[d] - g_.domain.min[d]) / d0_) * d0_;
            box.max[d] = box.min[d] + std::ceil((box.max[d] - box.min[d]) / d0_) * d0_;
        }
        forEachCell(box, g_.dimension, d0_ * (1 + 1e-9), [&](const Point& x, Real volume) {
            if (mobile.nearest(x, reach) >= 0) addOutside(x, volume);
        });
    }

    void addOutside(const Point& centre, Real volume)
    {
        const Real half = 0.5 * d0_;
        const int parts = 1 << g_.dimension;
        Real share[8], sum = 0;
        Point at[8];
        for (int p = 0; p < parts; ++p) {
            at[p] = centre;
            for (int d = 0; d < g_.dimension; ++d) at[p][d] += (p >> d & 1 ? 0.5 : -0.5) * half;
            share[p] = std::clamp(0.5 + task_.outside(g_.wrapped(at[p])) / half, 0.0, 1.0);
            sum += share[p];
        }
        if (sum > parts - 1e-6) {
            outside_.push_back(centre);
            outsideVolume_.push_back(volume);
            return;
        }
        for (int p = 0; p < parts; ++p) {
            if (share[p] == 0) continue;
            outside_.push_back(at[p]);
            outsideVolume_.push_back(share[p] * volume / parts);
        }
    }

    /// Lists, for each mobile particle, what may come within its support before the next search.
    void search()
    {
        images_ = std::make_unique<PeriodicPoints>(g_, x_, 2 * smoothing * widest_ + d0_);
        const PointGrid particles(smoothing * widest_, images_->x),
            outside(smoothing * widest_, outside_);
        near_.resize(mobile_.size());
        nearOutside_.resize(mobile_.size());
        parallelForDynamic(mobile_.size(), [&](Index m) {
            const std::size_t i = mobile_[m];
            near_[m].clear();
            nearOutside_[m].clear();
            particles.forEachWithin(
                x_[i], smoothing * (spacing_[i] + widest_) + skin * d0_,
                [&](Index k, const Point& r) {
                    const Index j = images_->owner[k];
                    const Real support = smoothing * (spacing_[i] + spacing_[j]) + skin * d0_;
                    if (normSqr(r) < sqr(support) && (j != static_cast<Index>(i) || normSqr(r) > 0))
                        near_[m].push_back(k);
                });
            outside.forEachWithin(x_[i], 2 * smoothing * spacing_[i] + skin * d0_,
                                  [&](Index k, const Point&) { nearOutside_[m].push_back(k); });
        });
    }

    /// f(j or -1 for space outside, volume, vector to it, h_ij) for what is within the support of
    /// particle m.
    template <class F>
    void forEachNear(std::size_t m, F&& f) const
    {
        const std::size_t i = mobile_[m];
        for (Index k : near_[m]) {
            const Index j = images_->owner[k];
            f(j, volume_[j], x_[j] + images_->shift[k] - x_[i],
              0.5 * smoothing * (spacing_[i] + spacing_[j]));
        }
        for (Index k : nearOutside_[m])
            f(-1, outsideVolume_[k], outside_[k] - x_[i], smoothing * spacing_[i]);
    }

    /// How much sum_j V_j W_ij exceeds that of a lattice.
    Real excess(std::size_t m) const
    {
        const std::size_t i = mobile_[m];
        Real sum = volume_[i] * kernel_.w(0, smoothing * spacing_[i]);
        forEachNear(m, [&](Index, Real volume, const Point& r, Real h) {
            const Real distance = norm(r);
            if (distance < 2 * h) sum += volume * kernel_.w(distance, h);
        });
        return sum - latticeSum_;
    }

    /// -h^2 sum_j V_j (e + K (n_i + n_j)) gradW_ij at the mobile particle m.
    Point push(std::size_t m) const
    {
        const std::size_t i = mobile_[m];
        Point sum;
        forEachNear(m, [&](Index j, Real volume, const Point& r, Real h) {
            const Real distance = norm(r);
            if (distance >= 2 * h) return;
            const Real excesses = excess_[i] + (j < 0 ? excess_[i] : excess_[j]);
            sum += volume * (evenness + stiffness * excesses) * kernel_.slope(distance, h) * r;
        });
        return sqr(smoothing * spacing_[i]) * sum;
    }

    Point outward(std::size_t i) const
    {
        return steepest([&](const Point& x) { return task_.own(i, x); }, x_[i], g_);
    }

    /// The move of one that slides: where it ends it is as far from the outside as before.
    Point alongFace(std::size_t i, const Point& by) const
    {
        const Point n = steepest(task_.outside, x_[i], g_);
        const Point to = x_[i] + by - dot(by, n) * n;
        return movedToLevel(task_.outside, to, task_.outside(x_[i]), g_) - x_[i];
    }

    /// Moves i by `by`, but nearer than `margin` to the faces of its part only along them; one that
    /// is too near goes back inwards.
    Point moved(std::size_t i, Point by)
    {
        const Real keep = margin * spacing_[i];
        if (task_.slides[i]) by = alongFace(i, by);
        atMost_[i] += norm(by);  // distances change no faster than places
        if (atMost_[i] < -keep) return x_[i] + by;
        const Real before = task_.own(i, x_[i]), after = task_.own(i, x_[i] + by);
        if (before < -keep && after < -keep) {
            atMost_[i] = after;
            return x_[i] + by;
        }
        const Point n = outward(i);
        by = by - dot(by, n) * n;
        if (before > -keep) by -= std::min(0.05 * spacing_[i], before + keep) * n;
        atMost_[i] = std::max(before, -keep);
        const Point x = x_[i] + by;
        return task_.own(i, x) <= atMost_[i] ? x : x_[i];
    }

    /// One sweep over all mobile particles at once; the largest step in local spacings.
    Real step()
    {
        parallelForDynamic(mobile_.size(), [&](Index m) { excess_[mobile_[m]] = excess(m); });
        std::vector<Point> next(mobile_.size());
        parallelForDynamic(mobile_.size(), [&](Index m) {
            const std::size_t i = mobile_[m];
            Point by = rate * task_.mobility[i] * push(m);
            const Real length = norm(by), most = longestStep * spacing_[i];
            if (length > most) by *= most / length;
            next[m] = moved(i, by);
        });
        Real largest = 0;
        for (std::size_t m = 0; m < mobile_.size(); ++m) {
            Point& x = x_[mobile_[m]];
            largest = std::max(largest, norm(next[m] - x) / spacing_[mobile_[m]]);
            x = next[m];
        }
        return largest;
    }

    const PackingTask& task_;
    const CaseGeometry& g_;
    Real d0_;
    PackingKernel kernel_;
    std::vector<Point>& x_;
    std::vector<Real> spacing_, volume_, excess_;
    std::vector<Real> atMost_;  ///< a bound of own() at x
    Real latticeSum_;
    std::vector<std::size_t> mobile_;
    std::vector<Point> outside_;
    std::vector<Real> outsideVolume_;
    std::unique_ptr<PeriodicPoints> images_;
    std::vector<std::vector<Index>> near_, nearOutside_;
    Real widest_ = 0;
};

}  // namespace

void pack(const PackingTask& task, std::vector<Point>& x)
{
    Packing(task, x).run();
}

}  // namespace isph
