// SPDX-License-Identifier: GPL-3.0-or-later
#include "VariantCase.hpp"

#include "Process.hpp"
#include "RunLogs.hpp"
#include "case/StopSignal.hpp"
#include "case/TimeList.hpp"
#include "core/Log.hpp"
#include "dictionary/DictionarySource.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <sstream>

namespace isph {

namespace fs = std::filesystem;

namespace {

const std::vector<std::string> kStates{"stable", "unstable", "notRun", "stopped"};  // as State

constexpr const char* kResult = "reportResult";  ///< written last: a folder that has it is finished

std::string contentOf(const fs::path& file)
{
    std::ifstream in(file, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    if (!in) throw FatalError(fmt::format("Cannot read {}", file.string()));
    return text.str();
}

void write(const fs::path& file, const std::string& text)
{
    fs::create_directories(file.parent_path());
    std::ofstream out(file, std::ios::binary);
    out << text << std::flush;
    if (!out) throw FatalError(fmt::format("Cannot write {}", file.string()));
}

/// What programs write into a case, or what has no influence on its run.
bool isOutput(const fs::path& name, const std::string& number)
{
    const std::string text = name.string();
    return text == "postProcessing" || text == "report" || text == "pictures" ||
           text.starts_with("log.") || text.ends_with(".pvd") || text.ends_with(".md") ||
           (!text.empty() && text == number);
}

/// FNV-1a of 64 bits. source  Fowler, Noll & Vo, draft-eastlake-fnv
std::uint64_t hash(std::string_view text, std::uint64_t value)
{
    for (const char c : text) value = (value ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
    return (value ^ 0xff) * 0x100000001b3ULL;  // an end, so that "ab" "c" is not "a" "bc"
}

std::string quoted(std::string text)
{
    std::replace(text.begin(), text.end(), '"', '\'');
    std::replace(text.begin(), text.end(), '\\', '/');
    std::erase_if(text, [](char c) { return c == '$' || c == '\n'; });
    return "\"" + text + "\"";
}

std::string signalText(int signal)
{
    return fmt::format("ended by signal {} ({})", signal, strsignal(signal));
}

}  // namespace

const char* describe(Outcome::State state)
{
    switch (state) {
        case Outcome::State::stable:
            return "yes";
        case Outcome::State::unstable:
            return "no";
        case Outcome::State::stopped:
            return "stopped";
        case Outcome::State::notRun:
            break;
    }
    return "not run";
}

VariantCase::VariantCase(const Report& report, const Variant& variant, const fs::path& caseDir)
    : report_(report),
      variant_(variant),
      caseDir_(caseDir),
      folder_(caseDir / "report" / variant.name)
{
}

/// The case's files with the variant's values. Particles of time 0 come along where no command
/// makes them.
std::vector<VariantCase::File> VariantCase::input() const
{
    const bool makes = std::any_of(
        report_.commands.begin(), report_.commands.end(),
        [](const std::string& line) { return line.find("createParticles") != std::string::npos; });
    std::vector<std::string> numbers;
    for (const TimeFolder& time : timeFolders(caseDir_))
        if (time.value != 0 || makes) numbers.push_back(time.name);
    std::vector<File> files;
    for (const auto& entry : fs::directory_iterator(caseDir_)) {
        const fs::path name = entry.path().filename();
        const auto number = std::find(numbers.begin(), numbers.end(), name.string());
        if (isOutput(name, number == numbers.end() ? "" : *number)) continue;
        if (entry.is_regular_file()) files.push_back({name, contentOf(entry.path())});
        const bool otherCase = fs::exists(entry.path() / "system" / "controlDict");
        if (!entry.is_directory() || otherCase) continue;
        for (const auto& inner : fs::recursive_directory_iterator(entry.path()))
            if (inner.is_regular_file())
                files.push_back({fs::relative(inner.path(), caseDir_), contentOf(inner.path())});
    }
    std::erase_if(files, [](const File& file) { return file.name == "system/reportDict"; });
    std::sort(files.begin(), files.end(),
              [](const File& a, const File& b) { return a.name < b.name; });
    for (const Setting& setting : variant_.settings) {
        if (setting.isBase) continue;
        const auto file = std::find_if(files.begin(), files.end(), [&](const File& one) {
            return one.name == setting.key->file;
        });
        DictionarySource source(file->text, file->name.string());
        for (const std::string& entry : setting.key->entries) source.set(entry, setting.value.text);
        file->text = source.text();
    }
    return files;
}

std::string VariantCase::fingerprint(const std::vector<File>& files) const
{
    // Of files beside constant and system, only those count that a command names: Allcheck does
    // not.
    const auto runs = [&](const std::string& name) {
        return std::any_of(
            report_.commands.begin(), report_.commands.end(),
            [&](const std::string& line) { return line.find(name) != std::string::npos; });
    };
    std::uint64_t value = 0xcbf29ce484222325ULL;
    for (const File& file : files) {
        if (!file.name.has_parent_path() && !runs(file.name.string())) continue;
        value = hash(file.text, hash(file.name.string(), value));
    }
    for (const std::string& command : report_.commands) value = hash(command, value);
    return fmt::format("run{:016x}", hash(fmt::format("{}", report_.threads), value));
}

fs::path VariantCase::logOf(const std::string& command) const
{
    return folder_ / ("log." + fs::path(command.substr(0, command.find(' '))).filename().string());
}

bool VariantCase::finished() const
{
    if (!fs::exists(folder_ / kResult)) return false;
    const Dictionary result = Dictionary::read(folder_ / kResult);
    return result.get<std::string>("input") == fingerprint(input());
}

bool VariantCase::run() const
{
    const std::vector<File> files = input();
    fs::remove_all(folder_);
    {
        const auto lock = holdStarts();
        for (const File& file : files) {
            write(folder_ / file.name, file.text);
            fs::permissions(folder_ / file.name, fs::status(caseDir_ / file.name).permissions());
        }
    }
    Outcome::State state = Outcome::State::stable;
    std::string why;
    ProcessEnd end;
    for (const std::string& line : report_.commands) {
        const fs::path log = logOf(line);
        end = runCommand({line, folder_, log, report_.threads, report_.timeLimit});
        if (stopSignal() != 0) return false;
        if (end.succeeded()) continue;
        const LogFacts facts = readLog(log);
        state = end.timedOut      ? Outcome::State::stopped
                : facts.steps > 0 ? Outcome::State::unstable
                                  : Outcome::State::notRun;
        why = end.timedOut           ? fmt::format("time limit of {:g} s", *report_.timeLimit)
              : !facts.error.empty() ? facts.error
              : end.signal           ? signalText(end.signal)
                                     : fmt::format("{} ended with exit code {}", line, end.code);
        if (!facts.lastTime.empty()) why += " (at time " + facts.lastTime + ")";
        break;
    }
    const LogFacts facts = readLog(logOf(report_.commands.back()));
    write(folder_ / kResult,
          fmt::format("input {};\nstate {};\nwhy {};\nparticles {:g};\nsteps {:g};\n"
                      "wall {:.4g};\ncpu {:.4g};\nmemory {:g};\n",
                      fingerprint(files), kStates[static_cast<std::size_t>(state)], quoted(why),
                      facts.particles, facts.steps, end.wall, end.cpu, end.memory));
    return true;
}

Outcome VariantCase::outcome() const
{
    const Dictionary result = Dictionary::read(folder_ / kResult);
    Outcome outcome;
    outcome.state = static_cast<Outcome::State>(
        std::find(kStates.begin(), kStates.end(), result.getChoice("state", kStates)) -
        kStates.begin());
    outcome.why = result.get<std::string>("why");
    outcome.particles = result.get<Real>("particles");
    outcome.steps = result.get<Real>("steps");
    outcome.wall = result.get<Real>("wall");
    outcome.cpu = result.get<Real>("cpu");
    outcome.memory = result.get<Real>("memory");
    if (outcome.state != Outcome::State::stable) return outcome;
    checkLimits(outcome);
    if (outcome.state == Outcome::State::stable) readErrors(outcome);
    return outcome;
}

void VariantCase::checkLimits(Outcome& outcome) const
{
    for (const Quantity& limit : report_.limits) {
        const Real value = limit.of(folder_);
        if (value <= limit.above) continue;
        outcome.state = Outcome::State::unstable;
        outcome.why = fmt::format("{} {:.4g} is above {:g}", limit.name, value, limit.above);
        return;
    }
}

void VariantCase::readErrors(Outcome& outcome) const
{
    const auto keep = [&](const std::string& name, Real value) {
        if (!outcome.errors.emplace(name, std::abs(value)).second) return;
        outcome.errorNames.push_back(name);
    };
    for (const Quantity& error : report_.errors) try {
            keep(error.name, error.of(folder_));
        } catch (const FatalError& problem) {
            warning("{}, error {}: {}", variant_.name, error.name, problem.what());
        }
    if (report_.check.empty()) return;
    const fs::path log = folder_ / "log.check";
    runCommand({report_.check, folder_, log, report_.threads, {}});
    const auto lines = readCheckLines(log);
    if (lines.empty())
        warning("{}: {} printed no line <name> <value> <unit> bound ...; see {}", variant_.name,
                report_.check, log.string());
    for (const auto& [name, value] : lines) keep(name, value);
}

Real VariantCase::progress() const
{
    return lastProgress(logOf(report_.commands.back()));
}

}  // namespace isph
