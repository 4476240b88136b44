// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of a step beside the pressure solve, on a column of shaken water in an open tank.
//
//     benchParts [options of Google Benchmark] [<dimension>:<particles> ...]
//
// Threads: OMP_NUM_THREADS. Kernel wendlandC2, h = 1.5 d0 in 2-D and 1.2 d0 in 3-D. Columns:
// neighbours of a particle, and particles that a second does.
#include "unit/SceneBuilder.hpp"

#include "core/Error.hpp"
#include "integrator/Predictor.hpp"
#include "pressure/PressureEquation.hpp"

#include <benchmark/benchmark.h>

using namespace isph;

namespace {

/// A tank, its water and what a step computes from them. Every part of a step is a function here.
template <int Dim>
struct Tank {
    explicit Tank(Real particles) : scene(filled(particles))
    {
        bin(scene.water.x);
        scene.water.reorder(grid.order());
        layAndDry(), pairs(), corrections(), surface(), predictor(), assembly();
    }

    /// The column of water fills the tank in all directions but upwards and half of its length.
    static Scene<Dim> filled(Real particles)
    {
        const int n = std::max(4, static_cast<int>(std::lround(std::pow(particles, 1.0 / Dim))));
        Vec<Dim> tank, water;
        for (int d = 0; d < Dim; ++d) tank[d] = water[d] = 1;
        tank[0] = 2;
        return SceneBuilder<Dim>(1.0 / n, Dim == 2 ? 1.5 : 1.2)
            .viscosity(1e-6)
            .water({}, water)
            .shakeWater(0.2)
            .openTank({}, tank)
            .build();
    }

    void layAndDry()
    {
        const Scheme<Dim>& scheme = scene.scheme;
        fields.soil.porosity.assign(scene.water.size(), 1);
        layPoints<Dim>(scene.water, fields.soil.porosity, scene.wallCloud, scene.box,
                       scheme.spacing, scheme.h0, scene.kernel->supportRadius(), fields.points);
        dryWalls(scene.wallCloud, scheme.spacing, scheme.h0, fields.points);
    }
    void bin(Span<const Vec<Dim>> x)
    {
        PairList<Dim>::binByCells(x, scene.kernel->supportRadius() * scene.scheme.h0, grid);
    }
    void cells() { bin(fields.points.x); }
    void pairs() { fields.pairs.build(fields.points, *scene.kernel); }
    void corrections() { fields.corrections.compute(fields.points, fields.pairs); }
    void surface()
    {
        findFreeSurface(fields.points, fields.pairs, fields.corrections, fields.role);
    }
    void predictor()
    {
        predict(scene.water, scene.wallCloud, medium, scene.scheme, StepWeights{1e-3, 1}, fields);
    }
    void assembly()
    {
        divergence.assign(scene.water.size(), 0);
        rows.number(fields.role, fields.points.water);
        assemble(fields.points, fields.pairs, fields.corrections, fields.role, medium,
                 PressureSource<Dim>{fields.v, scene.water.forceGradient, divergence,
                                     scene.scheme.force},
                 rows, matrix, rhs, anchored);
    }

    Scene<Dim> scene;
    StepFields<Dim> fields;
    CellGrid<Dim> grid;
    ClearWater<Dim> medium{1e-3};
    std::vector<Real> divergence, rhs;
    PressureRows rows;
    SymmetricMatrix matrix;
    std::vector<char> anchored;
};

template <int Dim>
void enter(Real particles, const std::string& name)
{
    const auto tank = std::make_shared<Tank<Dim>>(particles);
    const auto add = [&](const std::string& what, void (Tank<Dim>::*part)()) {
        const auto measure = [=](benchmark::State& state) {
            for (auto _ : state) (tank.get()->*part)();
            const auto n = static_cast<double>(tank->scene.water.size());
            state.counters["neighbours"] = static_cast<double>(tank->fields.pairs.size()) / n;
            state.counters["particles/s"] =
                benchmark::Counter(n, benchmark::Counter::kIsIterationInvariantRate);
        };
        benchmark::RegisterBenchmark((name + "/" + what).c_str(), measure)
            ->Unit(benchmark::kMillisecond)
            ->UseRealTime();
    };
    add("pointsAndWalls", &Tank<Dim>::layAndDry);
    add("cellGrid", &Tank<Dim>::cells);
    add("pairList", &Tank<Dim>::pairs);
    add("corrections", &Tank<Dim>::corrections);
    add("freeSurface", &Tank<Dim>::surface);
    add("predictor", &Tank<Dim>::predictor);
    add("assembly", &Tank<Dim>::assembly);
}

void enter(const std::string& word)
{
    const std::size_t colon = word.find(':');
    const std::string dimension = word.substr(0, colon);
    if (colon == std::string::npos || (dimension != "2" && dimension != "3"))
        throw FatalError(word + " is no <dimension>:<particles>, such as 3:1e5.");
    const Real particles = std::stod(word.substr(colon + 1));
    dimension == "2" ? enter<2>(particles, word) : enter<3>(particles, word);
}

}  // namespace

int main(int argc, char** argv)
{
    try {
        benchmark::Initialize(&argc, argv);
        std::vector<std::string> words(argv + 1, argv + argc);
        if (words.empty()) words = {"2:1e4", "2:2e5", "3:1e5"};
        for (const std::string& word : words) enter(word);
        benchmark::RunSpecifiedBenchmarks();
        return 0;
    } catch (const std::exception& error) {
        return reportFatal(error);
    }
}
