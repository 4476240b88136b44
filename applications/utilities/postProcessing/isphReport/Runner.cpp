// SPDX-License-Identifier: GPL-3.0-or-later
#include "Runner.hpp"

#include "case/StopSignal.hpp"
#include "core/Log.hpp"
#include "core/Timers.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <mutex>
#include <thread>

namespace isph {

namespace {

enum class Phase { waiting, running, done };

std::string minutes(Real seconds)
{
    const int whole = static_cast<int>(std::lround(seconds));
    return fmt::format("{}:{:02d}", whole / 60, whole % 60);
}

class Runner {
public:
    Runner(std::vector<const VariantCase*> todo, std::size_t finishedBefore)
        : todo_(std::move(todo)),
          phase_(todo_.size()),
          before_(finishedBefore),
          start_(wallSeconds()),
          terminal_(isatty(STDOUT_FILENO) != 0)
    {
    }

    bool run(int parallel)
    {
        std::vector<std::thread> workers;
        const auto count = std::min(static_cast<std::size_t>(parallel), todo_.size());
        for (std::size_t k = 0; k < count; ++k) workers.emplace_back([this] { work(); });
        while (ended_ < todo_.size() && !halted()) {
            std::this_thread::sleep_for(std::chrono::milliseconds(200));
            if (terminal_) showBar();
        }
        for (std::thread& worker : workers) worker.join();
        if (terminal_) fmt::print("\r\033[K");
        if (problem_) std::rethrow_exception(problem_);
        return stopSignal() == 0;
    }

private:
    bool halted() const { return stopSignal() != 0 || failed_; }

    void work()
    {
        for (std::size_t k = next_++; k < todo_.size() && !halted(); k = next_++) try {
                phase_[k] = Phase::running;
                if (!todo_[k]->run()) return;
                phase_[k] = Phase::done;
                ++ended_;
                report(k);
            } catch (...) {
                const std::lock_guard<std::mutex> lock(mutex_);
                problem_ = std::current_exception();
                failed_ = true;
            }
    }

    void report(std::size_t k)
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        if (terminal_) return;
        info("{} of {}: {} ({} gone)", before_ + ended_, before_ + todo_.size(),
             todo_[k]->variant().name, minutes(wallSeconds() - start_));
        std::fflush(stdout);
    }

    void showBar() const
    {
        constexpr int width = 30;
        Real done = static_cast<Real>(ended_);
        int running = 0;
        for (std::size_t k = 0; k < todo_.size(); ++k) {
            if (phase_[k] != Phase::running) continue;
            ++running;
            done += todo_[k]->progress();
        }
        const Real share = done / static_cast<Real>(todo_.size()), gone = wallSeconds() - start_;
        const auto filled = static_cast<std::size_t>(std::lround(width * share));
        fmt::print("\r\033[K[{}{}] {:.0f} %  {} of {} variants, {} running, {} gone{}",
                   std::string(filled, '#'), std::string(width - filled, '-'), 100 * share,
                   before_ + ended_, before_ + todo_.size(), running, minutes(gone),
                   share > 0 ? ", about " + minutes(gone * (1 - share) / share) + " left" : "");
        std::fflush(stdout);
    }

    std::vector<const VariantCase*> todo_;
    std::vector<std::atomic<Phase>> phase_;
    std::size_t before_;
    double start_;
    bool terminal_;
    std::atomic<std::size_t> next_{0}, ended_{0};
    std::atomic<bool> failed_{false};
    std::exception_ptr problem_;
    std::mutex mutex_;
};

}  // namespace

bool runVariants(const std::vector<VariantCase>& all, int parallel, bool again)
{
    std::vector<const VariantCase*> todo;
    for (const VariantCase& one : all)
        if (again || !one.finished()) todo.push_back(&one);
    const std::size_t before = all.size() - todo.size();
    if (before > 0) info("{} of {} variants are finished already", before, all.size());
    return todo.empty() || Runner(todo, before).run(parallel);
}

}  // namespace isph
