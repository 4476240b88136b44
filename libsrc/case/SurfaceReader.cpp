// SPDX-License-Identifier: GPL-3.0-or-later
#include "case/SurfaceReader.hpp"

namespace isph {

SurfaceReader::Table& SurfaceReader::table()
{
    static Table rows;
    return rows;
}

std::unique_ptr<SurfaceReader> SurfaceReader::select()
{
    const Dictionary none = Dictionary::parse("", "surfaceReader");
    return table().make("VTK", none, none, "surfaceReader");
}

}  // namespace isph
