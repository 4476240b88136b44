// SPDX-License-Identifier: GPL-3.0-or-later
#include "Process.hpp"

#include "case/StopSignal.hpp"
#include "core/Error.hpp"
#include "core/Timers.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <thread>
#include <vector>

extern char** environ;

namespace isph {

namespace fs = std::filesystem;

namespace {

/// The environment with a number of threads of its own.
std::vector<std::string> environmentFor(int threads)
{
    std::vector<std::string> all;
    for (char** entry = environ; *entry; ++entry)
        if (std::strncmp(*entry, "OMP_NUM_THREADS=", 16) != 0) all.emplace_back(*entry);
    all.push_back(fmt::format("OMP_NUM_THREADS={}", threads));
    return all;
}

/// A process group of its own, so that the shell and what it started end together.
pid_t start(const Command& command)
{
    posix_spawn_file_actions_t files;
    posix_spawnattr_t attributes;
    posix_spawn_file_actions_init(&files);
    posix_spawnattr_init(&attributes);
    posix_spawn_file_actions_addchdir_np(&files, command.folder.c_str());
    posix_spawn_file_actions_addopen(&files, 0, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&files, 1, command.log.c_str(), O_WRONLY | O_CREAT | O_TRUNC,
                                     0644);
    posix_spawn_file_actions_adddup2(&files, 1, 2);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
    std::vector<std::string> environment = environmentFor(command.threads);
    std::vector<char*> variables;
    for (std::string& entry : environment) variables.push_back(entry.data());
    variables.push_back(nullptr);
    // In the place of the shell where it is one command: its use is then what is measured.
    const bool single = command.line.find_first_of(";&|=\n") == std::string::npos;
    std::string shell = "/bin/sh", option = "-c", line = (single ? "exec " : "") + command.line;
    char* words[] = {shell.data(), option.data(), line.data(), nullptr};
    pid_t pid = 0;
    const auto lock = holdStarts();
    const int error = posix_spawn(&pid, "/bin/sh", &files, &attributes, words, variables.data());
    posix_spawn_file_actions_destroy(&files);
    posix_spawnattr_destroy(&attributes);
    if (error)
        throw FatalError(fmt::format("Cannot run {}: {}", command.line, std::strerror(error)));
    return pid;
}

Real seconds(const timeval& time)
{
    return static_cast<Real>(time.tv_sec) + 1e-6 * static_cast<Real>(time.tv_usec);
}

}  // namespace

std::unique_lock<std::mutex> holdStarts()
{
    static std::mutex starts;
    return std::unique_lock(starts);
}

ProcessEnd runCommand(const Command& command)
{
    constexpr auto pause = std::chrono::milliseconds(5);
    constexpr Real kilobyte = 1024, patience = 30;  // seconds to write a state after SIGTERM
    const double begin = wallSeconds();
    const pid_t pid = start(command);
    ProcessEnd end;
    double told = 0;
    int status = 0;
    rusage used{};
    while (wait4(pid, &status, WNOHANG, &used) == 0) {
        end.timedOut = command.timeLimit && wallSeconds() - begin > *command.timeLimit;
        if ((end.timedOut || stopSignal() != 0) && told == 0) {
            kill(-pid, SIGTERM);
            told = wallSeconds();
        }
        if (told > 0 && wallSeconds() - told > patience) kill(-pid, SIGKILL);
        std::this_thread::sleep_for(pause);
    }
    // What the shell started may still write its state: the next command waits for that.
    while (told > 0 && kill(-pid, 0) == 0) {
        if (wallSeconds() - told > patience) kill(-pid, SIGKILL);
        std::this_thread::sleep_for(pause);
    }
    end.wall = wallSeconds() - begin;
    end.cpu = seconds(used.ru_utime) + seconds(used.ru_stime);
    end.memory = kilobyte * static_cast<Real>(used.ru_maxrss);
    if (WIFEXITED(status)) end.code = WEXITSTATUS(status);
    if (WIFSIGNALED(status)) end.signal = WTERMSIG(status);
    return end;
}

void findOwnPrograms()
{
    std::error_code error;
    const fs::path program = fs::read_symlink("/proc/self/exe", error);
    if (error) return;
    const char* path = std::getenv("PATH");
    const std::string all = program.parent_path().string() + (path ? std::string(":") + path : "");
    setenv("PATH", all.c_str(), 1);
}

}  // namespace isph
