// SPDX-License-Identifier: GPL-3.0-or-later
// Puts a particle of a file at another place.
//   moveParticle <file> <id> <x> <y> <z>
#include "output/VtpFile.hpp"

#include "core/Error.hpp"

#include <algorithm>
#include <cstdlib>

int main(int argc, char** argv)
{
    using namespace isph;
    try {
        if (argc != 6) throw FatalError("Usage: moveParticle <file> <id> <x> <y> <z>");
        ParticleFile file = readParticleFile(argv[1]);
        const auto& id = file.integer("id");
        const auto at = std::find(id.begin(), id.end(), std::strtoll(argv[2], nullptr, 10));
        if (at == id.end()) throw FatalError("No such particle");
        Vector3& x = file.points[static_cast<std::size_t>(at - id.begin())];
        for (std::size_t d = 0; d < 3; ++d) x[d] = std::strtod(argv[3 + d], nullptr);
        writeParticleFile(argv[1], file);
        return 0;
    } catch (const std::exception& error) {
        return reportFatal(error);
    }
}
