// SPDX-License-Identifier: GPL-3.0-or-later
#include "AnnotatedDictionaries.hpp"

#include "core/Error.hpp"
#include "selection/ModelTable.hpp"

#include <fmt/format.h>

#include <fstream>

namespace isph {

namespace {

/// One file: which family it chooses from, the model it shows as chosen, and what it is for.
struct Page {
    const char* file;
    const char* folder;  ///< of the case, where the file stands
    const char* family;
    const char* shown;
    const char* scope;  ///< sub-dictionary that holds the choice, empty for the file itself
    const char* about;
};

constexpr Page kPages[] = {
    {"porousZones", "constant", "porousModel", "akbari", "rubble",
     "// Resistance of the soil, zone by zone. The names of the zones are those that the soil of\n"
     "// system/particlesDict refers to; here there is one, rubble. Without this file there is no "
     "soil.\n"},
    {"turbulenceProperties", "constant", "turbulenceModel", "Smagorinsky", "",
     "// Eddy viscosity of the free water. Without this file the flow is laminar.\n"},
    {"erosionProperties", "constant", "erosionModel", "thresholdVelocity", "",
     "// When water takes grains away from the soil. Without this file the soil stays as it is.\n"},
    {"kernels", "system", "kernel", "wendlandC2", "",
     "// The smoothing kernel, a key of system/isphSchemes.\n"},
};

std::string indented(const std::string& text, int levels)
{
    return std::string(static_cast<std::size_t>(4 * levels), ' ') + text;
}

/// "<family> <shown>;   // one of ..." and <name>Coeffs of every model that has keys.
std::string choice(const Page& page, const AnyModelTable& table, int level)
{
    std::string text = indented(fmt::format("{} {};   // one of {}\n", page.family, page.shown,
                                            fmt::join(table.names(), " ")),
                                level);
    for (const std::string& name : table.names()) {
        const Schema keys = table.keys(name);
        if (keys.keys().empty()) continue;
        text += "\n" + indented(name + "Coeffs\n", level) + indented("{\n", level) +
                keys.annotated(level + 1) + indented("}\n", level);
    }
    return text;
}

std::string annotated(const Page& page, const AnyModelTable& table)
{
    const std::string scope = page.scope;
    std::string text = fmt::format(
        "FoamFile {{ format ascii; class dictionary; location \"{}\"; object {}; }}\n\n{}"
        "//\n// A value is the default; a key behind // has none. Coefficients of models that are "
        "not chosen may\n"
        "// stay. Written by isphListModels -annotated from what the models declare.\n\n",
        page.folder, page.file, page.about);
    return text + (scope.empty() ? choice(page, table, 0)
                                 : scope + "\n{\n" + choice(page, table, 1) + "}\n");
}

}  // namespace

std::vector<AnnotatedFile> annotatedDictionaries()
{
    std::vector<AnnotatedFile> files;
    for (const Page& page : kPages) {
        loadFamily(page.family);
        files.push_back({page.file, annotated(page, *modelFamilies().at(page.family))});
    }
    return files;
}

void writeAnnotatedDictionaries(const std::filesystem::path& folder)
{
    std::error_code ignored;
    std::filesystem::create_directories(folder, ignored);
    for (const AnnotatedFile& file : annotatedDictionaries()) {
        std::ofstream out(folder / file.name);
        out << file.text;
        out.close();
        if (!out) throw FatalError(fmt::format("Cannot write {}", (folder / file.name).string()));
    }
}

}  // namespace isph
