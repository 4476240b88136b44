// SPDX-License-Identifier: GPL-3.0-or-later
#include "case/StopSignal.hpp"

#include <csignal>

namespace isph {

namespace {

volatile std::sig_atomic_t received = 0;

extern "C" void rememberSignal(int number)
{
    received = number;
}

}  // namespace

void catchStopSignals()
{
    received = 0;
    struct sigaction action {};
    action.sa_handler = rememberSignal;
    action.sa_flags = static_cast<int>(SA_RESETHAND) | SA_RESTART;
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
}

int stopSignal()
{
    return received;
}

}  // namespace isph
