// SPDX-License-Identifier: GPL-3.0-or-later
#include "RunLogs.hpp"

#include <charconv>
#include <fstream>
#include <sstream>

namespace isph {

namespace {

std::string trimmed(const std::string& line)
{
    const std::size_t begin = line.find_first_not_of(" \t\r");
    return begin == std::string::npos
               ? ""
               : line.substr(begin, line.find_last_not_of(" \t\r") - begin + 1);
}

/// The lines of a message up to the place or the end that follows it, as one.
std::string readMessage(std::istream& log)
{
    constexpr std::size_t most = 200;
    std::string message;
    bool begun = false;
    for (std::string line; std::getline(log, line);) {
        line = trimmed(line);
        if (line.starts_with("file: ") || line.starts_with("FOAM exiting")) break;
        if (line.empty() && begun) break;
        if (line.empty()) continue;
        begun = true;
        message += (message.empty() ? "" : " ") + line;
    }
    return message.size() <= most ? message : message.substr(0, most) + "...";
}

}  // namespace

LogFacts readLog(const std::filesystem::path& file)
{
    LogFacts facts;
    std::ifstream log(file);
    for (std::string line; std::getline(log, line);) {
        if (line.starts_with("Particles: ")) {
            std::istringstream(line.substr(11)) >> facts.particles;
        } else if (line.starts_with("Time = ")) {
            ++facts.steps;
            facts.lastTime = line.substr(7);
        } else if (line.starts_with("--> FOAM FATAL")) {
            facts.error = readMessage(log);
        }
    }
    return facts;
}

Real lastProgress(const std::filesystem::path& file)
{
    constexpr std::streamoff tail = 8192;  // a step writes less than a kilobyte
    const std::string word = "Progress = ";
    std::ifstream log(file, std::ios::ate);
    if (!log) return 0;
    const std::streamoff size = log.tellg();
    log.seekg(std::max<std::streamoff>(0, size - tail));
    std::ostringstream text;
    text << log.rdbuf();
    const std::size_t at = text.str().rfind(word);
    if (at == std::string::npos) return 0;
    return std::strtod(text.str().c_str() + at + word.size(), nullptr) / 100;
}

std::vector<std::pair<std::string, Real>> readCheckLines(const std::filesystem::path& file)
{
    std::vector<std::pair<std::string, Real>> all;
    std::ifstream log(file);
    for (std::string line; std::getline(log, line);) {
        std::istringstream words(line);
        std::string name, value, unit, bound;
        if (!(words >> name >> value >> unit >> bound) || bound != "bound") continue;
        Real number = 0;
        const auto [stop, error] =
            std::from_chars(value.data(), value.data() + value.size(), number);
        if (error == std::errc() && *stop == 0) all.emplace_back(name, number);
    }
    return all;
}

}  // namespace isph
