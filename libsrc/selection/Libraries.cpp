// SPDX-License-Identifier: GPL-3.0-or-later
#include "selection/Libraries.hpp"

#include "dictionary/Dictionary.hpp"

#include <dlfcn.h>
#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <set>
#include <sstream>
#include <utility>

namespace isph {

namespace fs = std::filesystem;

namespace {

constexpr const char* kProgram = "the program itself";

/// What loading has done so far. Conflicts are kept by library, so that asking again fails again.
struct LoadRecord {
    std::vector<std::string> loaded;
    std::set<std::string> families;
    std::map<std::string, std::string> conflicts;
    std::string current = kProgram;
};

LoadRecord& record()
{
    static LoadRecord one;
    return one;
}

const char kOwnPlace = 0;  // its address tells where this library was loaded from

/// The file that holds the code or data at `address`.
fs::path fileOf(const void* address)
{
    Dl_info found{};
    return dladdr(address, &found) != 0 && found.dli_fname != nullptr ? fs::path(found.dli_fname)
                                                                      : fs::path();
}

fs::path programFile()
{
    std::error_code ignored;
    return fs::read_symlink("/proc/self/exe", ignored);
}

std::string environment(const char* name)
{
    const char* value = std::getenv(name);
    return value == nullptr ? "" : value;
}

/// The files that `name` may mean, best first, without the system's paths.
std::vector<fs::path> candidates(const std::string& name)
{
    std::vector<fs::path> files;
    if (name.find('/') != std::string::npos) {
        files.push_back(fs::absolute(name));
        const fs::path inCase = fs::path(environment("FOAM_CASE")) / name;
        if (!environment("FOAM_CASE").empty() && inCase != files.back()) files.push_back(inCase);
        return files;
    }
    std::istringstream folders(environment("ISPH_LIBRARY_PATH"));
    for (std::string folder; std::getline(folders, folder, ':');)
        if (!folder.empty()) files.push_back(fs::absolute(folder) / name);
    files.push_back(programFile().parent_path().parent_path() / "lib" / name);
    const fs::path beside =
        fs::absolute(fileOf(&kOwnPlace)).lexically_normal().parent_path() / name;
    if (beside != files.back()) files.push_back(beside);
    return files;
}

/// dlopen; empty, or the loader's message. RTLD_NOW: a missing symbol is an error at the start.
std::string open(const std::string& file)
{
    return dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL) != nullptr ? "" : dlerror();
}

[[noreturn]] void failNotFound(const std::string& name, const std::vector<fs::path>& sought,
                               const std::string& loaderMessage)
{
    std::string text = fmt::format("Library \"{}\" not found. Sought as\n", name);
    for (const fs::path& file : sought) text += fmt::format("    {}\n", file.string());
    if (!loaderMessage.empty())
        text += fmt::format("and on the system's paths: {}\n", loaderMessage);
    text += environment("ISPH_LIBRARY_PATH").empty()
                ? "Name it by its full path, or set ISPH_LIBRARY_PATH to the folder that holds it."
                : "Name it by its full path, or add the folder that holds it to ISPH_LIBRARY_PATH.";
    throw FatalError(text);
}

/// Opens the first candidate that exists, else leaves it to the system's loader.
void openFirst(const std::string& name)
{
    const std::vector<fs::path> sought = candidates(name);
    for (const fs::path& file : sought) {
        std::error_code ignored;
        if (!fs::exists(file, ignored)) continue;
        const std::string message = open(file.string());
        if (!message.empty())
            throw FatalError(fmt::format("Library \"{}\" ({}) could not be loaded:\n{}", name,
                                         file.string(), message));
        return;
    }
    std::string message;
    if (name.find('/') == std::string::npos && (message = open(name)).empty()) return;
    failNotFound(name, sought, message);
}

}  // namespace

fs::path projectDir()
{
    const std::string chosen = environment("ISPH_PROJECT_DIR");
    if (!chosen.empty()) {
        if (fs::exists(fs::path(chosen) / "etc/controlDict")) return chosen;
        throw FatalError(
            fmt::format("ISPH_PROJECT_DIR is \"{}\", which holds no etc/controlDict.\n"
                        "Set it to the folder of isphPorousFoam, or unset it.",
                        chosen));
    }
    for (fs::path folder = programFile().parent_path();; folder = folder.parent_path()) {
        if (fs::exists(folder / "etc/controlDict")) return folder;
        if (folder == folder.parent_path()) break;
    }
    throw FatalError(
        fmt::format("No folder above {} holds etc/controlDict.\n"
                    "Set ISPH_PROJECT_DIR to the folder of isphPorousFoam.",
                    programFile().string()));
}

void loadLibrary(const std::string& name)
{
    LoadRecord& state = record();
    if (std::find(state.loaded.begin(), state.loaded.end(), name) == state.loaded.end()) {
        const std::string outer = std::exchange(state.current, name);
        try {
            openFirst(name);
        } catch (...) {
            state.current = outer;
            throw;
        }
        state.current = outer;
        state.loaded.push_back(name);
    }
    for (const std::string& part : {name, std::string(kProgram)})
        if (const auto bad = state.conflicts.find(part); bad != state.conflicts.end())
            throw FatalError(fmt::format("Library \"{}\" cannot be used:\n{}", part, bad->second));
}

namespace {
Dictionary familyLibraries()
{
    return Dictionary::read(projectDir() / "etc/controlDict").subDict("families");
}
}  // namespace

void loadFamily(const std::string& family)
{
    LoadRecord& state = record();
    if (state.families.count(family) != 0) return;
    const Dictionary libraries = familyLibraries();
    if (libraries.found(family)) loadLibrary(libraries.get<std::string>(family));
    state.families.insert(family);
}

std::vector<std::string> builtInFamilies()
{
    return familyLibraries().keywords();
}

const std::vector<std::string>& loadedLibraries()
{
    return record().loaded;
}

void noteConflict(const char* family, const char* model, int abi, const void* registered) noexcept
{
    LoadRecord& state = record();
    std::string& text = state.conflicts[state.current];
    if (abi != coreAbi())
        text += fmt::format(
            "    {} {} was built for interface version {}, this program has {}: "
            "build the library again\n",
            family, model, abi, coreAbi());
    else
        text += fmt::format("    {} {} is registered already, by {}\n", family, model,
                            fileOf(registered).string());
}

}  // namespace isph
