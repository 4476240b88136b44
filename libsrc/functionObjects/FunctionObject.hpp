// SPDX-License-Identifier: GPL-3.0-or-later
// Function objects: what is measured while a run goes on, chosen in controlDict's functions { }.
#pragma once
#include "functionObjects/FlowView.hpp"
#include "selection/ModelTable.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace isph {

/// One measurement. Its row is written to postProcessing/<name>/<startTime>/<name>.dat.
class FunctionObject {
public:
    static constexpr const char* family = "functionObject";
    using Table = ModelTable<FunctionObject>;
    static Table& table();

    virtual ~FunctionObject() = default;

    /// Column names after "Time", without blanks.
    virtual std::vector<std::string> columns() const = 0;
    /// Values of the columns for this flow.
    virtual std::vector<Real> measure(const FlowView& flow) = 0;
};

}  // namespace isph
