// SPDX-License-Identifier: GPL-3.0-or-later
#include "erosion/ErosionModel.hpp"

namespace isph {

ErosionModel::Table& ErosionModel::table()
{
    static Table one;
    return one;
}

std::unique_ptr<ErosionModel> ErosionModel::select(const Dictionary& erosionProperties)
{
    return table().selectOnly(erosionProperties);
}

}  // namespace isph
