// SPDX-License-Identifier: GPL-3.0-or-later
#include "Variants.hpp"

#include "ReportCase.hpp"

#include "core/Error.hpp"

using namespace isph;

namespace {

class Variants : public test::ReportCase {
protected:
    std::vector<std::string> names(const std::string& text)
    {
        writeReportDict(text);
        const Report report = readReport(case_);
        std::vector<std::string> all;
        for (const Variant& variant : variantsOf(report)) all.push_back(variant.name);
        return all;
    }
    std::string failure(const std::string& text)
    {
        try {
            names(text);
        } catch (const FatalIOError& error) {
            EXPECT_TRUE(error.file().ends_with("system/reportDict")) << error.file();
            EXPECT_GT(error.line(), 0) << error.what();
            return error.what();
        }
        return "no error";
    }
};

using Names = std::vector<std::string>;

}  // namespace

TEST_F(Variants, OneAtATimeAreTheCaseAndEachValueByItself)
{
    EXPECT_EQ(names("vary { spacing { values (0.1 0.05); } kernel { values (cubicSpline); } "
                    "deltaT { range { from 0.01; to 1; n 3; scale log; } } }"),
              (Names{"base", "spacing=0.05", "kernel=cubicSpline", "deltaT=0.1", "deltaT=1"}));
}

TEST_F(Variants, AlongAKeyEachIsRunAtAllOfItsValues)
{
    EXPECT_EQ(
        names("along spacing; vary { spacing { values (0.2 0.1); } kernel { values "
              "(cubicSpline wendlandC2); } }"),
        (Names{"spacing=0.2", "base", "spacing=0.2_kernel=cubicSpline", "kernel=cubicSpline"}));
}

TEST_F(Variants, OfAGridAreAllCombinations)
{
    EXPECT_EQ(
        names("mode grid; vary { spacing { range { from 0.1; to 0.3; n 3; } } "
              "D50 { file \"constant/soil\"; entries (sand/coeffs/D50); values (1e-3 1e-5); } }"),
        (Names{"D50=1e-3", "D50=1e-5", "spacing=0.2_D50=1e-3", "spacing=0.2_D50=1e-5",
               "spacing=0.3_D50=1e-3", "spacing=0.3_D50=1e-5"}));
}

TEST_F(Variants, MaySetWholeDictionariesUnderAShortName)
{
    EXPECT_EQ(names("vary { stab { file \"system/isphSchemes\"; entries (stabilisation); "
                    "values (\"{ type constantAlpha; alpha 0.1; }\" \"{ type a/b; }\"); "
                    "labels (\"alpha 0.1\" \"a/b\"); } }"),
              (Names{"base", "stab=alpha_0.1", "stab=a_b"}));
}

TEST_F(Variants, CallADictionaryOfTheCaseByItsWordsInOneLine)
{
    write("system/isphSchemes", "stabilisation\n{\n    type   none;\n}\n");
    writeReportDict(
        "vary { s { file \"system/isphSchemes\"; entries (stabilisation); values (\"{}\"); } }");
    EXPECT_EQ(readReport(case_).keys[0].base.label, "{ type none; }");
}

TEST_F(Variants, SayInOneMessageWhatIsWrongWithReportDict)
{
    const auto says = [&](const std::string& text, const std::string& words) {
        const std::string message = failure(text);
        EXPECT_NE(message.find(words), std::string::npos) << text << "\n" << message;
    };
    says("vary { spacng { values (1); } }", "Did you mean 'spacing'?");
    says("vary { spacing { values (1); range { from 1; to 2; n 2; } } }", "either values");
    says("vary { spacing { values (1 1); } }", "stands twice");
    says("vary { spacing { values (1 2); labels (a); } }", "1 labels for 2 values");
    says("vary { spacing { value (1 2); } }", "value");
    says("vary { spacing { range { from 0; to 1; n 3; scale log; } } }", "above 0");
    says("vary { d { file \"constant/soil\"; entries (sand/D50); values (1); } }",
         "no entry sand/D50");
    says("vary { d { file \"constant/gone\"; entries (a); values (1); } }", "no constant/gone");
    says("vary { }", "nothing to report on");
    says("along kernel; vary { spacing { values (1); } }", "kernel");
    says("parallel 0; vary { spacing { values (1); } }", "parallel");
    says("mode both; vary { spacing { values (1); } }", "both");
    says("limits { a { series s; column c; } } vary { spacing { values (1); } }", "above");
    says("errors { a { series s; column c; measure median; } } vary { spacing { values (1); } }",
         "median");
}
