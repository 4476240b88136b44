// SPDX-License-Identifier: GPL-3.0-or-later
#include "selection/ModelTable.hpp"

#include <gtest/gtest.h>

using namespace isph;

namespace {

/// A family of this test program, made with an argument besides the dictionary.
class Shape {
public:
    static constexpr const char* family = "shapeOfTest";
    using Table = ModelTable<Shape, Real>;
    static Table& table()
    {
        static Table one;
        return one;
    }
    virtual ~Shape() = default;
    virtual Real area() const = 0;
};

class Square : public Shape {
public:
    static Schema keys() { return {Key::scalar("side", "length of a side").above(0)}; }
    Square(const Dictionary& dict, Real scale) : area_(scale * sqr(keys().get<Real>(dict, "side")))
    {
    }
    Real area() const override { return area_; }

private:
    Real area_;
};

class Unit : public Shape {
public:
    static Schema keys() { return {Key::scalar("factor", "of the area").byDefault("3")}; }
    Unit(const Dictionary& dict, Real scale) : area_(scale * keys().get<Real>(dict, "factor")) {}
    Real area() const override { return area_; }

private:
    Real area_;
};

const Shape::Table::Entry<Square> square{"square"};
const Shape::Table::Entry<Unit> unit{"unit"};

Real area(const std::string& text)
{
    return Shape::table().selectOnly(Dictionary::parse(text, "shapes"), 10)->area();
}

struct Refusal {
    std::string text;
    int line = 0;
};

Refusal refusal(const std::string& text)
{
    try {
        area(text);
    } catch (const FatalIOError& error) {
        EXPECT_EQ(error.file(), "shapes");
        return {error.what(), error.line()};
    }
    return {};
}

void expectPart(const std::string& text, const std::string& part)
{
    EXPECT_NE(text.find(part), std::string::npos) << "no \"" << part << "\" in:\n" << text;
}

TEST(ModelTable, MakesTheModelThatTheDictionaryNames)
{
    EXPECT_EQ(area("shapeOfTest square; squareCoeffs { side 2; }"), 40);
    EXPECT_EQ(area("shapeOfTest unit; unitCoeffs { factor 2; }"), 20);
}

TEST(ModelTable, CoefficientsOfOtherModelsMayStand)
{
    EXPECT_EQ(area("shapeOfTest unit; squareCoeffs { side 2; } unitCoeffs { factor 2; }"), 20);
}

TEST(ModelTable, CoefficientsMayBeAbsentWhereAllHaveDefaults)
{
    EXPECT_EQ(area("shapeOfTest unit;"), 30);
    const Refusal missing = refusal("\nshapeOfTest square;");
    expectPart(missing.text, "squareCoeffs is undefined");
    expectPart(missing.text, "side: length of a side");
}

TEST(ModelTable, AnUnknownNameGivesTheValidOnesInOpenFOAMsForm)
{
    const Refusal unknown = refusal("\nshapeOfTest sqare;");
    EXPECT_EQ(unknown.line, 2);
    EXPECT_EQ(unknown.text,
              "Unknown shapeOfTest type sqare, did you mean square?\n\n"
              "Valid shapeOfTest types are:\n\n2\n(\n    square\n    unit\n)\n");
}

TEST(ModelTable, UnknownKeysBesideAndInsideTheCoefficientsAreRefused)
{
    EXPECT_EQ(refusal("shapeOfTest unit;\nunitCoefs {}").line, 2);
    const Refusal inside = refusal("shapeOfTest unit;\nunitCoeffs\n{\n    facto 2;\n}");
    EXPECT_EQ(inside.line, 4);
    expectPart(inside.text, "factor");
}

TEST(ModelTable, ADictionaryMayHaveOtherKeysWhereTheChoiceIsOneOfMany)
{
    const Dictionary dict = Dictionary::parse("form unit; colour red;");
    EXPECT_EQ(Shape::table().select(dict, "form", 1)->area(), 3);
}

TEST(ModelTable, IsAmongTheFamiliesThatProgramsList)
{
    ASSERT_EQ(modelFamilies().count("shapeOfTest"), 1u);
    const AnyModelTable& table = *modelFamilies().at("shapeOfTest");
    EXPECT_EQ(table.names(), (std::vector<std::string>{"square", "unit"}));
    EXPECT_EQ(table.keys("square").keys().front().name, "side");
}

}  // namespace
