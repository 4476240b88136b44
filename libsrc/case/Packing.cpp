// SPDX-License-Identifier: GPL-3.0-or-later
#include "case/Packing.hpp"

#include "case/FaceLayer.hpp"
#include "case/OutsideSpace.hpp"
#include "case/PackingPush.hpp"
#include "case/PointGrid.hpp"
#include "case/SoilField.hpp"
#include "core/Parallel.hpp"

#include <algorithm>
#include <numeric>

namespace isph {

namespace {

constexpr Real smoothing = packingSmoothing;  // h over the local spacing
constexpr Real rate = 0.1;         // c; at 0.15 the excess of the sweep before makes some oscillate
constexpr Real longestStep = 0.1;  // in local spacings
constexpr Real settled = 2e-3;     // in local spacings
constexpr Real clear = 1.02;       // of d0: a spacing that no soil has widened
constexpr int mostSweeps = 200;
constexpr int sweepsPerSpacing = 10;
constexpr Real skin = 0.25;   // of d0: how far two particles may approach before the next search
constexpr Real margin = 0.4;  // in local spacings: what a particle keeps from the faces of its part

class Packing {
public:
    Packing(const PackingTask& task, const std::vector<Point>& x)
        : task_(task),
          g_(task.geometry),
          d0_(g_.spacing),
          kernel_{g_.dimension},
          order_(byPlace(x)),
          spacing_(x.size(), d0_),
          volume_(x.size(), g_.cellVolume()),
          excess_(x.size(), 0),
          atMost_(x.size(), std::numeric_limits<Real>::max()),
          latticeSum_(latticeSum())
    {
        for (std::size_t i : order_) x_.push_back(x[i]);
        for (std::size_t i = 0; i < x_.size(); ++i)
            if (task_.mobility[order_[i]] > 0) mobile_.push_back(i);
    }

    void run(std::vector<Point>& x)
    {
        if (mobile_.empty()) return;
        updateSpacing();
        std::vector<Point> around;
        for (std::size_t i : mobile_) around.push_back(x_[i]);
        outside_ = outsideSpace(g_, around, 2 * smoothing * widest_, task_.outside);
        search();
        push();
        for (std::size_t m = 0; m < mobile_.size(); ++m) excess_[mobile_[m]] = pushed_[m].excess;
        for (int sweep = 0; sweep < mostSweeps; ++sweep) {
            if (sweep % sweepsPerSpacing == 0) updateSpacing();
            if (approach() > skin * d0_) search();
            push();
            if (step() < settled) break;
        }
        for (std::size_t i : mobile_) x[order_[i]] = g_.wrapped(x_[i]);
    }

private:
    /// Particles with the same neighbours stand together: what one has loaded serves the next.
    std::vector<std::size_t> byPlace(const std::vector<Point>& x) const
    {
        using Cell = std::array<std::int64_t, 3>;
        std::vector<std::pair<Cell, std::size_t>> cells(x.size());
        for (std::size_t i = 0; i < x.size(); ++i) {
            for (int d = 0; d < 3; ++d)
                cells[i].first[d] = static_cast<std::int64_t>(std::floor(x[i][d] / (3 * d0_)));
            cells[i].second = i;
        }
        std::sort(cells.begin(), cells.end());
        std::vector<std::size_t> order;
        order.reserve(cells.size());
        for (const auto& cell : cells) order.push_back(cell.second);
        return order;
    }

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

    /// To the porosity where the particles are now. Supports that grow come nearer as well.
    void updateSpacing()
    {
        std::vector<Real> before = spacing_;
        parallelForDynamic(x_.size(), [&](Index i) {
            const Real porosity = task_.porosity(x_[i]);
            spacing_[i] = d0_ / std::pow(porosity, 1.0 / g_.dimension);
            volume_[i] = g_.cellVolume() / porosity;
        });
        Real growth = 0;
        for (std::size_t i = 0; i < x_.size(); ++i)
            growth = std::max(growth, spacing_[i] - before[i]);
        growth_ += 2 * smoothing * growth;
        widest_ = std::max(d0_, *std::max_element(spacing_.begin(), spacing_.end()));
    }

    /// Lists, for each mobile particle, what may come within its support before the next search.
    void search()
    {
        images_ = std::make_unique<PeriodicPoints>(g_, x_, 2 * smoothing * widest_ + d0_);
        const CellRows particles(smoothing * widest_, images_->x),
            outside(smoothing * widest_, outside_.x);
        const auto beyond = static_cast<Index>(images_->x.size());
        near_.resize(mobile_.size());
        parallelForDynamic(mobile_.size(), [&](Index m) {
            const std::size_t i = mobile_[m];
            near_[m].clear();
            particles.forEachWithin(x_[i], smoothing * (spacing_[i] + widest_) + skin * d0_,
                                    [&](Index k, const Point& r) {
                                        const Index j = images_->owner[k];
                                        const Real support =
                                            smoothing * (spacing_[i] + spacing_[j]) + skin * d0_;
                                        if (normSqr(r) < sqr(support) && k != static_cast<Index>(i))
                                            near_[m].push_back(k);
                                    });
            outside.forEachWithin(x_[i], 2 * smoothing * spacing_[i] + skin * d0_,
                                  [&](Index k, const Point&) { near_[m].push_back(beyond + k); });
        });
        searchedAt_ = x_;
        growth_ = 0;
    }

    /// At most by so much have two particles, or their supports, come nearer since the search.
    Real approach() const
    {
        Real farthest = 0;
        for (std::size_t i : mobile_)
            farthest = std::max(farthest, normSqr(x_[i] - searchedAt_[i]));
        return 2 * std::sqrt(farthest) + growth_;
    }

    void setSources()
    {
        const std::size_t inside = images_->x.size();
        sources_.resize(inside + outside_.x.size());
        parallelFor(inside, [&](Index k) {
            const Index j = images_->owner[k];
            sources_[k] = {x_[j] + images_->shift[k], spacing_[j], volume_[j], excess_[j]};
        });
        parallelFor(outside_.x.size(), [&](Index k) {
            sources_[inside + k] = {outside_.x[k], PackingSource::ofTheOther, outside_.volume[k],
                                    0};
        });
    }

    /// For all mobile particles: -h^2 sum_j V_j (e + K (n_i + n_j)) gradW_ij with the excess n of
    /// the last sweep, and the excess of sum_j V_j W_ij over that of a lattice.
    void push()
    {
        setSources();
        pushed_.resize(mobile_.size());
        parallelForDynamic(mobile_.size(), [&](Index m) {
            pushed_[m] = pushOn(mobile_[m], sources_, near_[m], kernel_);
            pushed_[m].excess -= latticeSum_;
        });
    }

    Real own(std::size_t i, const Point& x) const { return task_.own(order_[i], x); }

    Point outward(std::size_t i) const
    {
        return steepest([&](const Point& x) { return own(i, x); }, x_[i], g_);
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
        // where soil widens the spacing the distance to a face widens too
        if (task_.slides[order_[i]] && spacing_[i] < clear * d0_) by = alongFace(i, by);
        atMost_[i] += norm(by);  // distances change no faster than places
        if (atMost_[i] < -keep) return x_[i] + by;
        const Real before = own(i, x_[i]), after = own(i, x_[i] + by);
        if (before < -keep && after < -keep) {
            atMost_[i] = after;
            return x_[i] + by;
        }
        const Point n = outward(i);
        by = by - dot(by, n) * n;
        if (before > -keep) by -= std::min(0.05 * spacing_[i], before + keep) * n;
        atMost_[i] = std::max(before, -keep);
        const Point x = x_[i] + by;
        return own(i, x) <= atMost_[i] ? x : x_[i];
    }

    /// Moves all mobile particles at once; the largest step in local spacings.
    Real step()
    {
        std::vector<Point> next(mobile_.size());
        parallelForDynamic(mobile_.size(), [&](Index m) {
            const std::size_t i = mobile_[m];
            Point by = rate * task_.mobility[order_[i]] * pushed_[m].by;
            const Real length = norm(by), most = longestStep * spacing_[i];
            if (length > most) by *= most / length;
            next[m] = moved(i, by);
        });
        Real largest = 0;
        for (std::size_t m = 0; m < mobile_.size(); ++m) {
            const std::size_t i = mobile_[m];
            largest = std::max(largest, norm(next[m] - x_[i]) / spacing_[i]);
            x_[i] = next[m];
            excess_[i] = pushed_[m].excess;
        }
        return largest;
    }

    const PackingTask& task_;
    const CaseGeometry& g_;
    Real d0_;
    PackingKernel kernel_;
    std::vector<std::size_t> order_;  ///< of the particles here, their places in the task
    std::vector<Point> x_;
    std::vector<Real> spacing_, volume_, excess_;
    std::vector<Real> atMost_;  ///< a bound of own() at x
    Real latticeSum_;
    std::vector<std::size_t> mobile_;
    OutsideSpace outside_;
    std::unique_ptr<PeriodicPoints> images_;
    std::vector<PackingSource> sources_;
    std::vector<std::vector<Index>> near_;  ///< of each mobile particle: places in sources_
    std::vector<PackingPush> pushed_;
    Real widest_ = 0;
    std::vector<Point> searchedAt_;  ///< x at the last search
    Real growth_ = 0;                ///< of supports since then
};

}  // namespace

void pack(const PackingTask& task, std::vector<Point>& x)
{
    Packing(task, x).run(x);
}

}  // namespace isph
