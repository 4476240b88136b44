// SPDX-License-Identifier: GPL-3.0-or-later
#include "dictionary/Expression.hpp"

#include <fmt/core.h>
#include <muParser.h>

#include <cmath>
#include <numbers>
#include <regex>
#include <stdexcept>

namespace isph {

namespace {

void addFunctions(mu::Parser& parser)
{
    parser.DefineConst("pi", std::numbers::pi);
    parser.DefineFun("pow",
                     static_cast<mu::fun_type2>([](double a, double b) { return std::pow(a, b); }));
    parser.DefineFun(
        "hypot", static_cast<mu::fun_type2>([](double a, double b) { return std::hypot(a, b); }));
    parser.DefineFun("sqr", static_cast<mu::fun_type1>([](double a) { return a * a; }));
    parser.DefineFun("mag", static_cast<mu::fun_type1>([](double a) { return std::abs(a); }));
    parser.DefineFun("floor", static_cast<mu::fun_type1>([](double a) { return std::floor(a); }));
    parser.DefineFun("ceil", static_cast<mu::fun_type1>([](double a) { return std::ceil(a); }));
    parser.DefineFun("degToRad", static_cast<mu::fun_type1>(
                                     [](double a) { return a * std::numbers::pi / 180; }));
    parser.DefineFun("radToDeg", static_cast<mu::fun_type1>(
                                     [](double a) { return a * 180 / std::numbers::pi; }));
}

}  // namespace

double evaluate(const std::string& expression)
{
    static const std::regex callOfPi("\\bpi\\(\\)");  // the other dialect's spelling
    mu::Parser parser;
    addFunctions(parser);
    int results = 0;
    double value = 0;
    try {
        parser.SetExpr(std::regex_replace(expression, callOfPi, "pi"));
        value = parser.Eval(results)[0];
    } catch (const mu::Parser::exception_type& error) {
        throw std::runtime_error(error.GetMsg());
    }
    if (results != 1) throw std::runtime_error(fmt::format("it has {} values, not one", results));
    if (!std::isfinite(value)) throw std::runtime_error("its value is not finite");
    return value;
}

struct FieldExpression::Parsed {
    std::array<Real, 3> place{};
    Real time = 0;
    mu::Parser parser;
};

FieldExpression::FieldExpression(const std::string& text,
                                 const std::map<std::string, Real>& constants)
    : parsed_(std::make_unique<Parsed>())
{
    int results = 0;
    try {
        mu::Parser& parser = parsed_->parser;
        addFunctions(parser);
        parser.DefineVar("x", &parsed_->place[0]);
        parser.DefineVar("y", &parsed_->place[1]);
        parser.DefineVar("z", &parsed_->place[2]);
        parser.DefineVar("t", &parsed_->time);
        for (const auto& [name, value] : constants) parser.DefineConst(name, value);
        parser.SetExpr(text);
        parser.Eval(results);
    } catch (const mu::Parser::exception_type& error) {
        throw std::runtime_error(error.GetMsg());
    }
    if (results != 1) throw std::runtime_error(fmt::format("it has {} values, not one", results));
}

FieldExpression::~FieldExpression() = default;
FieldExpression::FieldExpression(FieldExpression&&) noexcept = default;
FieldExpression& FieldExpression::operator=(FieldExpression&&) noexcept = default;

Real FieldExpression::operator()(const std::array<Real, 3>& place, Real time) const
{
    parsed_->place = place;
    parsed_->time = time;
    return parsed_->parser.Eval();
}

}  // namespace isph
