// SPDX-License-Identifier: GPL-3.0-or-later
#include "output/TimeFolders.hpp"

#include "output/WholeFile.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <set>
#include <system_error>

namespace isph {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void cannotWrite(const fs::path& path, const std::error_code& cause)
{
    throw FatalIOError("cannot write time folder: " + cause.message(), path.string(), 0);
}

void makeFolder(const fs::path& path)
{
    std::error_code failed;
    fs::create_directories(path, failed);
    if (failed) cannotWrite(path, failed);
}

/// Names of the .vtp files in a folder, without suffix: water, walls, soil, then the others.
std::vector<std::string> partsIn(const fs::path& folder)
{
    const std::vector<std::string> first = {"water", "walls", "soil"};
    std::set<std::string> others;
    std::vector<std::string> parts;
    for (const std::string& part : first)
        if (fs::exists(folder / (part + ".vtp"))) parts.push_back(part);
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator(folder, ignored))
        if (entry.path().extension() == ".vtp") others.insert(entry.path().stem().string());
    for (const std::string& part : first) others.erase(part);
    parts.insert(parts.end(), others.begin(), others.end());
    return parts;
}

std::string escaped(const std::string& text)
{
    std::string out;
    for (const char c : text) {
        if (c == '&')
            out += "&amp;";
        else if (c == '<')
            out += "&lt;";
        else if (c == '"')
            out += "&quot;";
        else
            out += c;
    }
    return out;
}

}  // namespace

void writeTimeFolder(const fs::path& caseDir, const TimeState& state, const ParticleParts& parts)
{
    const fs::path temporary = caseDir / ("." + state.name + ".part");
    std::error_code ignored;
    fs::remove_all(temporary, ignored);  // of a run that was killed
    makeFolder(temporary / "uniform");
    TimeState complete = state;
    complete.parts.clear();
    for (const auto& [name, particles] : parts) {
        writeParticleFile(temporary / (name + ".vtp"), particles);
        complete.parts.push_back(name);
    }
    writeWholeFile(temporary / "uniform" / "time", timeStateText(complete));
    moveIntoPlace(temporary, caseDir / state.name);
}

std::map<std::string, ParticleFile> readTimeFolder(const TimeFolder& folder)
{
    std::vector<std::string> names = readTimeState(folder).parts;
    if (names.empty()) names = partsIn(folder.path);
    if (std::find(names.begin(), names.end(), "water") == names.end())
        throw FatalIOError(fmt::format("time folder {} has no water.vtp", folder.name),
                           folder.path.string(), 0);
    std::map<std::string, ParticleFile> parts;
    for (const std::string& name : names)
        parts.emplace(name, readParticleFile(folder.path / (name + ".vtp")));
    return parts;
}

fs::path pvdFile(const fs::path& caseDir)
{
    fs::path whole = fs::weakly_canonical(caseDir);
    if (!whole.has_filename()) whole = whole.parent_path();
    return caseDir / (whole.filename().string() + ".pvd");
}

void writePvd(const fs::path& caseDir)
{
    std::vector<std::string> order;  // a part keeps its number over all times
    std::string sets;
    for (const TimeFolder& folder : timeFolders(caseDir))
        for (const std::string& part : partsIn(folder.path)) {
            if (std::find(order.begin(), order.end(), part) == order.end()) order.push_back(part);
            const auto number = std::find(order.begin(), order.end(), part) - order.begin();
            const std::string name = escaped(part);
            sets += fmt::format(
                "    <DataSet timestep=\"{0}\" group=\"\" part=\"{1}\" name=\"{2}\" "
                "file=\"{0}/{2}.vtp\"/>\n",
                folder.name, number, name);
        }
    writeWholeFile(pvdFile(caseDir),
                   "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" "
                   "byte_order=\"LittleEndian\">\n  <Collection>\n" +
                       sets + "  </Collection>\n</VTKFile>\n");
}

TimeFolderWriter::TimeFolderWriter(fs::path caseDir) : caseDir_(std::move(caseDir))
{
    std::error_code ignored;
    std::vector<fs::path> unfinished;
    for (const auto& entry : fs::directory_iterator(caseDir_, ignored)) {
        const fs::path name = entry.path().filename();
        const bool ours = name.extension() == ".part" || name.extension() == ".old";
        if (ours && name.string().front() == '.' && entry.is_directory())
            unfinished.push_back(entry.path());
    }
    for (const fs::path& folder : unfinished) fs::remove_all(folder, ignored);
}

void TimeFolderWriter::write(const TimeState& state, const ParticleParts& parts, int keep)
{
    writeTimeFolder(caseDir_, state, parts);
    std::erase(written_, state.name);
    written_.push_back(state.name);
    std::error_code ignored;
    while (keep > 0 && written_.size() > static_cast<std::size_t>(keep)) {
        fs::remove_all(caseDir_ / written_.front(), ignored);
        written_.pop_front();
    }
    writePvd(caseDir_);
}

}  // namespace isph
