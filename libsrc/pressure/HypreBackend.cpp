// SPDX-License-Identifier: GPL-3.0-or-later
#include "pressure/HypreBackend.hpp"

namespace isph {

HypreBackend::Table& HypreBackend::table()
{
    static Table rows;
    return rows;
}

Schema HypreBackend::keys()
{
    return {
        Key::word("coarsening", "How BoomerAMG chooses the rows of coarser levels.")
            .byDefault("HMIS")
            .oneOf({"HMIS", "PMIS"}),
        Key::integer("aggressiveLevels",
                     "Levels of aggressive coarsening, counted from the finest.")
            .byDefault("1")
            .atLeast(0),
        Key::scalar("strongThreshold",
                    "Entries above this share of the largest of their row count as strong.")
            .byDefault("0.25")
            .above(0)
            .below(1),
    };
}

}  // namespace isph
