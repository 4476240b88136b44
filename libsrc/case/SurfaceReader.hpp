// SPDX-License-Identifier: GPL-3.0-or-later
// What shapes ask of the library that reads surfaces.
#pragma once
#include "case/TriangleTree.hpp"
#include "selection/ModelTable.hpp"

#include <filesystem>
#include <memory>

namespace isph {

struct TriangleSurface {
    std::vector<Point> corners;
    std::vector<TriangleTree::Triangle> triangles;  ///< all with their corners in the same sense
};

/// A family of its own, so that readers and filters of VTK, 7 MB, are mapped by programs that meet
/// a shape of type surface only.
class SurfaceReader {
public:
    static constexpr const char* family = "surfaceReader";
    using Table = ModelTable<SurfaceReader>;
    static Table& table();
    /// The one that there is.
    static std::unique_ptr<SurfaceReader> select();
    static Schema keys() { return {}; }

    virtual ~SurfaceReader() = default;
    /// Throws FatalError: no such file, unknown format, no triangles, or a surface that is not
    /// closed (names the file and the number of open edges).
    virtual TriangleSurface read(const std::filesystem::path& file) const = 0;
};

}  // namespace isph
