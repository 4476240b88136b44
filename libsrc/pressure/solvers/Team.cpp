// SPDX-License-Identifier: GPL-3.0-or-later
#include "pressure/solvers/Team.hpp"

#include <omp.h>

#include <thread>

namespace isph {

namespace {
/// Looks at what others have not done yet, a hundredth of a microsecond each, and how often the
/// processor is offered to other programs after that, before a thread is put to sleep: as long as
/// one thread takes for the smallest levels.
constexpr int kLooks = 200, kOffers = 200;
}  // namespace

int Team::threadNumber()
{
    return omp_get_thread_num();
}

int Team::threadsHere()
{
    return omp_get_num_threads();
}

void Team::meet() const
{
    std::atomic<unsigned>& round = shared_->round;
    const unsigned now = round.load(std::memory_order_relaxed);
    if (shared_->arrived.fetch_add(1, std::memory_order_acq_rel) + 1 == size_) {
        shared_->arrived.store(0, std::memory_order_relaxed);
        round.store(now + 1, std::memory_order_release);
        round.notify_all();
        return;
    }
    const auto waiting = [&] { return round.load(std::memory_order_acquire) == now; };
    for (int look = 0; look < kLooks && waiting(); ++look) {
#ifdef __x86_64__
        __builtin_ia32_pause();
#endif
    }
    for (int offer = 0; offer < kOffers && waiting(); ++offer) std::this_thread::yield();
    while (waiting()) round.wait(now, std::memory_order_acquire);
}

}  // namespace isph
