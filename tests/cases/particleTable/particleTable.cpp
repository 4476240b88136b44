// SPDX-License-Identifier: GPL-3.0-or-later
// Fields of a particle file as text, for the tests: a line a particle in the order of id, with all
// digits.
//   particleTable <file> <field>...        (position: where it is)
#include "output/VtpFile.hpp"

#include "core/Error.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdio>
#include <numeric>

namespace {

using namespace isph;

std::string field(const ParticleFile& file, const std::string& name, std::size_t i)
{
    if (name == "position")
        return fmt::format("{} {} {}", file.points[i][0], file.points[i][1], file.points[i][2]);
    if (file.integers.contains(name)) return fmt::format("{}", file.integers.at(name)[i]);
    if (file.vectors.contains(name)) {
        const Vector3& v = file.vectors.at(name)[i];
        return fmt::format("{} {} {}", v[0], v[1], v[2]);
    }
    return fmt::format("{}", file.scalar(name)[i]);
}

void print(const ParticleFile& file, const std::vector<std::string>& names)
{
    const auto& id = file.integer("id");
    std::vector<std::size_t> order(file.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return id[a] < id[b]; });
    for (const std::size_t i : order) {
        std::string line = fmt::format("{}", id[i]);
        for (const std::string& name : names) line += " " + field(file, name, i);
        std::puts(line.c_str());
    }
}

}  // namespace

int main(int argc, char** argv)
{
    try {
        if (argc < 3) throw FatalError("Usage: particleTable <file> <field>...");
        print(readParticleFile(argv[1]), {argv + 2, argv + argc});
        return 0;
    } catch (const std::exception& error) {
        return reportFatal(error);
    }
}
