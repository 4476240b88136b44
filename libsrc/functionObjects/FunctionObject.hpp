// SPDX-License-Identifier: GPL-3.0-or-later
// Function objects: what is measured while a run goes on, chosen in controlDict's functions { }.
#pragma once
#include "functionObjects/FlowView.hpp"
#include "selection/ModelTable.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace isph {

/// One measurement. Its rows are written to postProcessing/<name>/<startTime>/<name>.dat.
/// A model's keys() returns keysWith({its own keys}).
class FunctionObject {
public:
    static constexpr const char* family = "functionObject";
    using Table = ModelTable<FunctionObject>;
    static Table& table();

    /// The keys that every function object has (type, libs, enabled, log, startTime, endTime and
    /// the controls of execution and writing), and the model's own.
    static Schema keysWith(const Schema& own);

    virtual ~FunctionObject() = default;

    /// Values of the columns for this flow. None of them may be other than finite.
    virtual std::vector<Real> measure(const FlowView& flow) = 0;
    /// Column names after "Time", without blanks. Asked only after the first measure().
    virtual std::vector<std::string> columns() const = 0;
    /// What a reader of the file has to know besides (places, units), a line each.
    virtual std::vector<std::string> header() const { return {}; }
    /// Whether a run that ends is measured although no control asks for that time.
    virtual bool measuresAtEnd() const { return false; }
    /// The run goes on from a restart: `first` is the first row that its beginning wrote.
    virtual void resume(Span<const Real> first) { (void)first; }
};

}  // namespace isph
