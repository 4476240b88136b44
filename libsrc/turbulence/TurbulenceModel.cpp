// SPDX-License-Identifier: GPL-3.0-or-later
#include "turbulence/TurbulenceModel.hpp"

namespace isph {

TurbulenceModel::Table& TurbulenceModel::table()
{
    static Table one;
    return one;
}

std::unique_ptr<TurbulenceModel> TurbulenceModel::select(const Dictionary& turbulenceProperties)
{
    return table().selectOnly(turbulenceProperties);
}

}  // namespace isph
