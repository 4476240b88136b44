// SPDX-License-Identifier: GPL-3.0-or-later
// Arithmetic of #calc and #eval, by muParser.
#pragma once
#include "core/Types.hpp"

#include <array>
#include <map>
#include <memory>
#include <string>

namespace isph {

/// The value of an expression without variables: + - * / ^, comparisons, && ||, a ? b : c, and the
/// functions of muParser (sin cos tan asin acos atan atan2 sinh cosh tanh exp log ln log10 log2
/// sqrt abs sign rint min max sum avg) with pow sqr mag floor ceil hypot degToRad radToDeg and pi
/// besides. log is the natural one, and 1/2 is a half (OpenFOAM compiles #calc as C++, where it is
/// 0). Throws std::runtime_error for anything else.
double evaluate(const std::string& expression);

/// An expression of a place x, y, z [m], the time t [s] and named constants, with the functions of
/// evaluate(): parsed once, evaluated often. Not for several threads at once.
class FieldExpression {
public:
    /// Throws std::runtime_error for anything that is no single value, with muParser's message.
    FieldExpression(const std::string& text, const std::map<std::string, Real>& constants);
    ~FieldExpression();
    FieldExpression(FieldExpression&&) noexcept;
    FieldExpression& operator=(FieldExpression&&) noexcept;

    /// Not finite where the expression is not (log(0)).
    Real operator()(const std::array<Real, 3>& place, Real time) const;

private:
    struct Parsed;
    std::unique_ptr<Parsed> parsed_;
};

}  // namespace isph
