// SPDX-License-Identifier: GPL-3.0-or-later
// Arithmetic of #calc and #eval, by muParser.
#pragma once
#include <string>

namespace isph {

/// The value of an expression without variables: + - * / ^, comparisons, && ||, a ? b : c, and the
/// functions of muParser (sin cos tan asin acos atan atan2 sinh cosh tanh exp log ln log10 log2
/// sqrt abs sign rint min max sum avg) with pow sqr mag floor ceil hypot degToRad radToDeg and pi
/// besides. log is the natural one, and 1/2 is a half (OpenFOAM compiles #calc as C++, where it is
/// 0). Throws std::runtime_error for anything else.
double evaluate(const std::string& expression);

}  // namespace isph
