// SPDX-License-Identifier: GPL-3.0-or-later
// A case whose solver is a script: it writes spacing^2 as its error, and fails where it is told to.
#pragma once
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

namespace isph::test {

class ReportCase : public testing::Test {
protected:
    void SetUp() override
    {
        case_ =
            std::filesystem::temp_directory_path() / ("isphReport." + std::to_string(::getpid()));
        std::filesystem::remove_all(case_);
        write("system/particlesDict", "spacing 0.1; // d0\n");
        write("system/isphSchemes", "kernel wendlandC2;\nstabilisation { type none; }\n");
        write("system/controlDict", "application mySolver;\ndeltaT 0.01;\n");
        write("constant/soil", "sand { coeffs { D50 [mm] 1; } }\n");
        write("postProcessing/error/0/error.dat", "of the case itself\n");
        write("mySolver",
              "#!/bin/sh\n"
              "d=$(sed -n 's/^spacing *\\([^;]*\\);.*/\\1/p' system/particlesDict)\n"
              "echo 'Particles: 12 water, 3 wall, 0 soil; d0'\n"
              "echo run >> ../runs\n"
              "grep -q wendlandC4 system/isphSchemes && exit 3\n"
              "echo 'Time = 0.5s'\n"
              "if grep -q cubicSpline system/isphSchemes; then\n"
              "    printf -- '--> FOAM FATAL ERROR:\\nit blew up, see \"x\"\\n\\nFOAM exiting\\n'; "
              "exit 1\n"
              "fi\n"
              "grep -q quinticSpline system/isphSchemes && sleep 60\n"
              "echo 'Time = 1s'\n"
              "mkdir -p postProcessing/error/0\n"
              "awk \"BEGIN { print \\\"# Time L2\\\\n0 9\\\\n1 \\\" $d^2 }\" > "
              "postProcessing/error/0/error.dat\n");
        std::filesystem::permissions(case_ / "mySolver", std::filesystem::perms::owner_all);
    }
    void TearDown() override { std::filesystem::remove_all(case_); }

    void write(const std::string& name, const std::string& text) const
    {
        std::filesystem::create_directories((case_ / name).parent_path());
        std::ofstream(case_ / name) << text;
    }
    std::string read(const std::string& name) const
    {
        std::ostringstream text;
        text << std::ifstream(case_ / name).rdbuf();
        return text.str();
    }
    /// A reportDict with what every one needs.
    void writeReportDict(const std::string& text) const
    {
        write("system/reportDict",
              "commands (\"./mySolver\");\n"
              "errors { L2 { series \"postProcessing/error\"; column L2; } }\n" +
                  text);
    }

    std::filesystem::path case_;
};

}  // namespace isph::test
