// SPDX-License-Identifier: GPL-3.0-or-later
// The time loop.
#include "Run.hpp"

#include "FlowViews.hpp"
#include "RunLog.hpp"
#include "SceneFiles.hpp"
#include "case/Time.hpp"
#include "core/LargeArray.hpp"
#include "core/Log.hpp"
#include "erosion/Erosion.hpp"
#include "functionObjects/FunctionObjectList.hpp"
#include "integrator/DragImplicitStep.hpp"
#include "integrator/PaperStep.hpp"
#include "integrator/TimeStep.hpp"
#include "output/TimeFolders.hpp"

#include <optional>

namespace isph {

namespace {

/// Steps from one sorting of the particles to the next: the swiftest cross a few cells in them.
constexpr int kSortInterval = 20;

template <int Dim>
std::unique_ptr<ProjectionStep<Dim>> makeStep(const CaseFiles& files, Scene<Dim>& scene,
                                              Timers& timers)
{
    if (readProjection(files.schemes) == Projection::paper)
        return std::make_unique<PaperStep<Dim>>(scene, readPaperDrag(files.schemes), timers);
    return std::make_unique<DragImplicitStep<Dim>>(scene, timers);
}

template <int Dim>
class Run {
public:
    Run(const CaseFiles& files, const Dictionary& controlDict, const RunOptions& options)
        : start_(startFolder(controlDict, files.caseDir)),
          scene_(readScene<Dim>(files, start_)),
          time_(controlDict, files.caseDir, readTimeState(start_)),
          step_(makeStep(files, scene_, timers_)),
          writer_(files.caseDir)
    {
        if (options.functionObjects)
            functions_ =
                FunctionObjectList(controlDict, {files.caseDir, time_.name(), time_.instant()});
        measures_ = options.functionObjects;
        functions_.meet(time_);
        readErosion(files);
        logScene(files, scene_);
        if (erosion_) info("Erosion: {}\n", erosion_->model().formula());
    }

    int loop()
    {
        const double wallStart = wallSeconds();
        const int firstIndex = time_.index();
        info("Starting time loop\n");
        step_->look();
        measure();
        while (time_.run()) {
            followControlDict();
            advance();
            if (time_.writeTime()) write();
            measure();
        }
        if (time_.exitCode() == 0 && functions_.dueAtEnd(time_.instant())) execute();
        const Real particleSteps =
            Real(time_.index() - firstIndex) * static_cast<Real>(scene_.water.size());
        logTimings(timers_, scene_.water.size(), particleSteps, wallSeconds() - wallStart);
        const int code = time_.exitCode();
        if (code == 0) info("End\n");
        else
            info("Stopped at time {} by signal {}; started again, it goes on from there\n",
                 time_.name(), code - 128);
        return code;
    }

private:
    /// Function objects that were edited in controlDict while the run goes on; with an error in
    /// them the ones before the change stay.
    void followControlDict()
    {
        if (time_.rereads() == rereads_) return;
        rereads_ = time_.rereads();
        if (!measures_) return;
        try {
            functions_.reread(time_.controlDict(),
                              {time_.caseDir(), time_.name(), time_.instant()});
            functions_.meet(time_);
        } catch (const FatalError& error) {
            warning("{}\nthe function objects before the change stay", error.what());
        }
    }

    void advance()
    {
        const Real dtOld = time_.index() > 0 ? time_.deltaT() : 0;
        const CourantNumber perTime =
            courantRate(scene_.scheme, scene_.water, step_->fields().soil.porosity);
        const auto& eddyViscosity = step_->fields().eddyViscosity;
        if (!courantAtStart_) courantAtStart_ = perTime.max;
        if (time_.adjustTimeStep())
            time_.setDeltaT(stepSize<Dim>(scene_.scheme, time_.maxCo(), time_.maxDeltaT(),
                                          time_.controlDeltaT(), dtOld, perTime.max, eddyViscosity,
                                          *courantAtStart_));
        time_.advance();
        if (!time_.adjustTimeStep())
            requireStableStep<Dim>(scene_.scheme, time_.deltaT(), perTime.max, eddyViscosity);
        logStepStart(time_, perTime.mean * time_.deltaT(), perTime.max * time_.deltaT());
        if (time_.index() % kSortInterval == 0) sort();
        const StepReport report = step_->advance(time_.deltaT(), dtOld);
        if (erosion_) erode();
        requireFinite(scene_.water, time_.value(), time_.deltaT());
        log_.write(time_, report);
    }

    void readErosion(const CaseFiles& files)
    {
        if (!files.hasErosion) return;
        if (!scene_.porous)
            files.erosion.fail("erosionModel",
                               "There is no soil in this case that could be eroded.");
        erosion_.emplace(ErosionModel::select(files.erosion), scene_.scheme.spacing);
    }

    void erode()
    {
        const auto timer = timers_.scope("erosion");
        const StepFields<Dim>& fields = step_->fields();
        const Scheme<Dim>& scheme = scene_.scheme;
        const ErosionReport report = erosion_->advance(
            {fields.pairs.grid(), fields.points, scene_.water.u, fields.soil.porosity,
             scheme.density, scheme.viscosity, scheme.force},
            *scene_.porous, scene_.box, time_.deltaT(), scene_.soil);
        if (report.moving > 0) scene_.porous->place(scene_.soil, scene_.box);
        info("Erosion: {} particles released, {} released so far", report.released, report.moving);
    }

    void sort()
    {
        sortParticles(scene_, step_->fields().pairs.reach());
        scene_.solver->forget();   // what it keeps belongs to rows of other particles
    }

    void write()
    {
        const auto timer = timers_.scope("output");
        sort();
        step_->release(), scene_.solver->release();
        step_->look();
        step_->rest();
        returnFreeMemory();   // makes room for the files
        const Real spacing = scene_.scheme.spacing;
        std::map<std::string, ParticleFile> files{{"water", waterFile(scene_, step_->fields())}};
        if (scene_.walls.size() > 0) files.emplace("walls", fileOf(scene_.walls, spacing));
        if (scene_.soil.size() > 0) files.emplace("soil", fileOf(scene_.soil, spacing));
        const ParticleParts parts(files.begin(), files.end());
        writer_.write(time_.state(), parts, time_.purgeWrite());
        logExtent(scene_.water);
    }

    void measure()
    {
        if (functions_.due(time_.instant())) execute();
    }

    void execute()
    {
        const auto timer = timers_.scope("function objects");
        functions_.execute(flowView(scene_, step_->fields(), time_.value()));
    }

    Timers timers_;
    TimeFolder start_;
    Scene<Dim> scene_;
    Time time_;
    std::unique_ptr<ProjectionStep<Dim>> step_;
    TimeFolderWriter writer_;
    FunctionObjectList functions_;
    std::optional<Erosion<Dim>> erosion_;   ///< only where the case has constant/erosionProperties
    StepLog log_;
    /// Spacings per second of the fastest water, at the start of the run
    std::optional<Real> courantAtStart_;
    bool measures_ = true;
    int rereads_ = 0;   ///< of controlDict, that the function objects have followed
};

}  // namespace

template <int Dim>
int runCase(const CaseFiles& files, const Dictionary& controlDict, const RunOptions& options)
{
    Run<Dim> run(files, controlDict, options);
    return options.dryRun ? 0 : run.loop();
}

template int runCase<2>(const CaseFiles&, const Dictionary&, const RunOptions&);
template int runCase<3>(const CaseFiles&, const Dictionary&, const RunOptions&);

}  // namespace isph
