// SPDX-License-Identifier: GPL-3.0-or-later
// Particles as VTK XML poly data (.vtp): appended, LZ4, one vertex per point, so ParaView shows
// them.
#pragma once
#include "dictionary/Dictionary.hpp"

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace isph {

/// One set of particles with its fields. The maps scalars, vectors and integers are point data and
/// hold one value per point; names and numbers are field data of any length. On disk reals are
/// Float64 and integers Int64; "dimension" among the numbers is Int64 as well.
struct ParticleFile {
    std::vector<Vector3> points;
    std::map<std::string, std::vector<Real>> scalars;
    std::map<std::string, std::vector<Vector3>> vectors;
    std::map<std::string, std::vector<std::int64_t>> integers;
    std::map<std::string, std::vector<std::string>> names;
    std::map<std::string, std::vector<Real>> numbers;
    std::string source;  ///< the file it was read from; named in the errors below

    std::size_t size() const { return points.size(); }

    /// A field that must be there. Throws FatalIOError naming `source`, the field and those
    /// present.
    const std::vector<Real>& scalar(const std::string& name) const;
    const std::vector<Vector3>& vector(const std::string& name) const;
    const std::vector<std::int64_t>& integer(const std::string& name) const;
    const std::vector<std::string>& nameList(const std::string& name) const;
    Real number(const std::string& name) const;  ///< field data of exactly one value
};

/// Writes to a temporary name beside `file` and renames, so that `file` is whole or absent. The
/// last line of the file is a checksum of the rest (an XML comment that other readers skip).
/// errors  FatalIOError if the file cannot be written; FatalError if a field's length is not size()
void writeParticleFile(const std::filesystem::path& file, const ParticleFile& particles);

/// Reads back every bit that writeParticleFile wrote, and any .vtp of other programs whose point
/// data have 1 or 3 components.
/// errors  FatalIOError naming the file if it is missing, cut off, damaged or of another kind
ParticleFile readParticleFile(const std::filesystem::path& file);

}  // namespace isph
