// SPDX-License-Identifier: GPL-3.0-or-later
#include "case/InitialVelocity.hpp"

#include <fmt/core.h>
#include <muParser.h>

#include <numbers>

namespace isph {

namespace {

/// Three expressions over one point.
struct Expressions {
    Point at;
    mu::Parser parser[3];

    Expressions(const Dictionary& dict, const std::vector<std::string>& texts)
    {
        for (int d = 0; d < 3; ++d) try {
                parser[d].DefineConst("pi", std::numbers::pi);
                parser[d].DefineVar("x", &at[0]);
                parser[d].DefineVar("y", &at[1]);
                parser[d].DefineVar("z", &at[2]);
                parser[d].SetExpr(texts[d]);
                parser[d].Eval();
            } catch (const mu::Parser::exception_type& error) {
                dict.fail("velocity", fmt::format("the expression \"{}\" of velocity: {}", texts[d],
                                                  error.GetMsg()));
            }
    }
};

}  // namespace

VelocityField readVelocity(const Dictionary& dict)
{
    if (!dict.found("velocity")) return {};
    bool expressions = false;
    for (const Token& token : dict.tokens("velocity"))
        expressions = expressions || token.kind == Token::Kind::string;
    if (!expressions) {
        const Point u{dict.get<Vector3>("velocity", dims::velocity)};
        return [u](const Point&) { return u; };
    }
    const auto texts = dict.get<std::vector<std::string>>("velocity", dims::velocity);
    if (texts.size() != 3)
        dict.fail("velocity", fmt::format("{} expressions where three are expected", texts.size()));
    const auto parsed = std::make_shared<Expressions>(dict, texts);
    return [parsed](const Point& x) {
        parsed->at = x;
        return Point{
            {parsed->parser[0].Eval(), parsed->parser[1].Eval(), parsed->parser[2].Eval()}};
    };
}

}  // namespace isph
