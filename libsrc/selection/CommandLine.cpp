// SPDX-License-Identifier: GPL-3.0-or-later
#include "selection/CommandLine.hpp"

#include "core/Error.hpp"
#include "core/Log.hpp"
#include "core/Parallel.hpp"
#include "dictionary/Dictionary.hpp"
#include "selection/Libraries.hpp"

#include <fmt/format.h>
#include <unistd.h>
#include <boost/program_options.hpp>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <ctime>

namespace isph {

namespace fs = std::filesystem;
namespace po = boost::program_options;

namespace {

/// A command line that the user has to change; the message stands above the usage.
struct Refusal {
    std::string message;
};

std::string now(const char* format)
{
    const std::time_t seconds = std::time(nullptr);
    std::tm local{};
    localtime_r(&seconds, &local);
    std::array<char, 64> text{};
    return {text.data(), std::strftime(text.data(), text.size(), format, &local)};
}

std::string hostName()
{
    std::array<char, 256> name{};
    return gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "unknown";
}

std::string withoutDashes(const std::string& option)
{
    return option.substr(std::min(option.find_first_not_of('-'), option.size()));
}

}  // namespace

std::string programVersion()
{
    return ISPH_VERSION;
}

CommandLine::CommandLine(std::string program, std::string description)
    : program_(std::move(program)), description_(std::move(description))
{
    option("case", "dir", "works in this case directory, not in the present one");
    option("libs", "'(\"libX.so\" ...)'", "loads these libraries first");
    flag("noFunctionObjects", "runs no function objects");
    flag("help", "prints this text");
    flag("version", "prints the version");
}

CommandLine& CommandLine::flag(std::string name, std::string description)
{
    options_.push_back({std::move(name), "", std::move(description)});
    return *this;
}

CommandLine& CommandLine::option(std::string name, std::string valueName, std::string description)
{
    options_.push_back({std::move(name), std::move(valueName), std::move(description)});
    return *this;
}

CommandLine& CommandLine::argument(std::string name, std::string description)
{
    arguments_.push_back({std::move(name), "", std::move(description)});
    return *this;
}

std::string CommandLine::usage() const
{
    std::string text = fmt::format("\nUsage: {} [OPTIONS]", program_);
    for (const Item& item : arguments_) text += fmt::format(" <{}>", item.name);
    text += fmt::format("\n\n{}\n\n", description_);
    for (const Item& item : arguments_)
        text += fmt::format("  {:<30} {}\n", fmt::format("<{}>", item.name), item.description);
    text += "options:\n";
    for (const Item& item : options_) {
        const std::string value = item.valueName.empty() || item.valueName[0] == '\''
                                      ? item.valueName
                                      : fmt::format("<{}>", item.valueName);
        text +=
            fmt::format("  {:<30} {}\n", fmt::format("-{} {}", item.name, value), item.description);
    }
    return text + "\n";
}

std::string CommandLine::invalidOption(const std::string& name) const
{
    std::vector<std::string> names;
    for (const Item& item : options_) names.push_back(item.name);
    const std::string near = nearestName(name, names);
    return fmt::format("Invalid option: -{}{}", name,
                       near.empty() ? "" : fmt::format("\nDid you mean -{}?", near));
}

int CommandLine::refuse(const std::string& message) const
{
    fmt::print(stderr, "\n{}\n{}", message, usage());
    return 1;
}

void CommandLine::readWords(const std::vector<std::string>& words)
{
    po::options_description known;
    for (const Item& item : options_) {
        if (item.valueName.empty())
            known.add_options()(item.name.c_str(), "");
        else
            known.add_options()(item.name.c_str(), po::value<std::string>(), "");
    }
    using namespace po::command_line_style;
    const auto style = allow_long | allow_long_disguise | long_allow_adjacent | long_allow_next;
    // Words without a dash come back as options without a name.
    const auto parsed = po::command_line_parser(words).options(known).style(style).run();
    std::size_t given = 0;
    for (const po::option& option : parsed.options) {
        if (!option.string_key.empty()) {
            values_[option.string_key] = option.value.empty() ? "" : option.value.front();
            continue;
        }
        for (const std::string& word : option.value) {
            if (word.size() > 1 && word[0] == '-')
                throw Refusal{invalidOption(withoutDashes(word))};
            if (given++ < arguments_.size()) values_[arguments_[given - 1].name] = word;
        }
    }
    if (given != arguments_.size() && !has("help") && !has("version"))
        throw Refusal{fmt::format("Wrong number of arguments, expected {} found {}",
                                  arguments_.size(), given)};
}

std::optional<int> CommandLine::parse(int argc, const char* const* argv)
{
    const std::vector<std::string> words(argv + 1, argv + argc);
    words_ = fmt::format("{}", fmt::join(argv, argv + argc, " "));
    try {
        readWords(words);
    } catch (const Refusal& refusal) {
        return refuse(refusal.message);
    } catch (const po::unknown_option& unknown) {  // of two dashes; one dash comes back as a word
        return refuse(invalidOption(withoutDashes(unknown.get_option_name())));
    } catch (const po::invalid_command_line_syntax& error) {
        const bool missing = error.kind() == po::invalid_command_line_syntax::missing_parameter;
        return refuse(fmt::format("Option -{} {}", withoutDashes(error.get_option_name()),
                                  missing ? "needs a value" : "takes no value"));
    } catch (const po::error& error) {
        return refuse(error.what());
    }
    if (has("help")) {
        writeInfo(usage());
        return 0;
    }
    if (has("version")) {
        info("{} {}", program_, programVersion());
        return 0;
    }
    useCase();
    loadLibraries();
    return {};
}

void CommandLine::useCase()
{
    caseDir_ = fs::absolute(value("case", ".")).lexically_normal();
    if (!caseDir_.has_filename()) caseDir_ = caseDir_.parent_path();  // "x/." and "x/" mean x
    if (!fs::is_directory(caseDir_))
        throw FatalError(fmt::format("Case directory \"{}\" does not exist", caseDir_.string()));
    setenv("FOAM_CASE", caseDir_.c_str(), 1);
    setenv("FOAM_CASENAME", caseDir_.filename().c_str(), 1);
    if (std::getenv("ISPH_PROJECT_DIR")) return;
    try {
        setenv("ISPH_PROJECT_DIR", projectDir().c_str(), 1);
    } catch (const FatalError&) {
        // Stays unset: who needs the project's folder says so when it does.
    }
}

void CommandLine::loadLibraries() const
{
    if (!has("libs")) return;
    const Dictionary libs =
        Dictionary::parse(fmt::format("libs {};", value("libs")), "option -libs");
    for (const std::string& name : libs.get<std::vector<std::string>>("libs")) loadLibrary(name);
}

std::string CommandLine::value(const std::string& name, const std::string& otherwise) const
{
    const auto it = values_.find(name);
    return it == values_.end() ? otherwise : it->second;
}

Real CommandLine::number(const std::string& name, Real otherwise) const
{
    if (!has(name)) return otherwise;
    const std::string text = value(name);
    char* end = nullptr;
    const Real number = std::strtod(text.c_str(), &end);
    if (text.empty() || *end != '\0')
        throw FatalError(fmt::format("Option -{} is '{}': expected a number", name, text));
    return number;
}

void CommandLine::printBanner() const
{
    info("/*---------------------------------------------------------------------------*\\");
    info("  isphPorousFoam: free-surface flow, seepage and scour by incompressible SPH");
    info("  Version: {}", programVersion());
    info("\\*---------------------------------------------------------------------------*/");
    info("Build  : {}", programVersion());
    info("Exec   : {}", words_);
    info("Date   : {}", now("%b %d %Y"));
    info("Time   : {}", now("%H:%M:%S"));
    info("Host   : \"{}\"", hostName());
    info("PID    : {}", getpid());
    info("Case   : {}", caseDir_.string());
    info("nProcs : 1");
    info("Threads: {}\n", threadCount());
}

}  // namespace isph
