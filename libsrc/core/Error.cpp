// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/Error.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdio>
#include <new>
#include <numeric>

namespace isph {

FatalIOError::FatalIOError(const std::string& message, std::string file, int line)
    : FatalError(message), file_(std::move(file)), line_(line)
{
}

int reportFatal(const std::exception& error)
{
    std::fflush(stdout);
    if (const auto* io = dynamic_cast<const FatalIOError*>(&error)) {
        const std::string place = io->line() > 0
                                      ? fmt::format("{} at line {}.", io->file(), io->line())
                                      : fmt::format("{}.", io->file());
        fmt::print(stderr, "\n\n--> FOAM FATAL IO ERROR:\n{}\n\nfile: {}\n\nFOAM exiting\n\n",
                   io->what(), place);
    } else {
        const bool memory = dynamic_cast<const std::bad_alloc*>(&error) ||
                            dynamic_cast<const std::length_error*>(&error);
        fmt::print(stderr, "\n\n--> FOAM FATAL ERROR:\n{}\n\nFOAM exiting\n\n",
                   memory
                       ? "Out of memory: the case asks for more particles than this machine holds."
                       : error.what());
    }
    return 1;
}

namespace {
std::size_t editDistance(std::string_view a, std::string_view b)
{
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t above = row[j];
            row[j] = std::min({above + 1, row[j - 1] + 1, diagonal + (a[i - 1] != b[j - 1])});
            diagonal = above;
        }
    }
    return row.back();
}
}  // namespace

std::string nearestName(std::string_view word, const std::vector<std::string>& candidates)
{
    std::string best;
    std::size_t bestDistance = std::max<std::size_t>(2, word.size() / 2) + 1;
    for (const std::string& candidate : candidates) {
        const std::size_t distance = editDistance(word, candidate);
        if (distance < bestDistance) {
            bestDistance = distance;
            best = candidate;
        }
    }
    return best;
}

std::string listOf(std::vector<std::string> names)
{
    std::sort(names.begin(), names.end());
    std::string text = fmt::format("{}\n(\n", names.size());
    for (const std::string& name : names) text += fmt::format("    {}\n", name);
    return text + ")\n";
}

}  // namespace isph
