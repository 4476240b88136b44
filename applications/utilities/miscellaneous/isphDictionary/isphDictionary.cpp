// SPDX-License-Identifier: GPL-3.0-or-later
// Looks into dictionary files and changes them, as foamDictionary does.
//
//     isphDictionary system/controlDict -entry endTime -value
//     isphDictionary system/controlDict -entry stopAt -set writeNow
//     isphDictionary constant/porousZones -expand
//
// Without -expand entries are shown as they are written; changes leave the rest of the file as it
// is.
#include "core/Error.hpp"
#include "dictionary/Dictionary.hpp"
#include "dictionary/DictionarySource.hpp"
#include "selection/CommandLine.hpp"

#include <fmt/format.h>

#include <filesystem>

namespace {

using namespace isph;

/// The entry of a resolved dictionary at "a/b/c": its dictionary and its keyword.
std::pair<const Dictionary*, std::string> entryAt(const Dictionary& top, std::string_view path)
{
    const Dictionary* dict = &top;
    for (std::size_t slash = path.find('/'); slash != std::string_view::npos;
         slash = path.find('/')) {
        if (slash > 0) dict = &dict->subDict(path.substr(0, slash));
        path.remove_prefix(slash + 1);
    }
    std::string key(path);
    if (key.size() > 1 && key.front() == '"' && key.back() == '"')
        key = key.substr(1, key.size() - 2);
    return {dict, key};
}

void print(const std::string& text)
{
    fmt::print("{}", text);
}

std::string joined(const std::vector<std::string>& keywords)
{
    return fmt::format("{}\n", fmt::join(keywords, "\n"));
}

void printResolved(const CommandLine& line, const Dictionary& top)
{
    const std::string path = line.value("entry");
    if (path.empty()) return print(line.has("keywords") ? joined(top.keywords()) : top.toString());
    const auto [dict, key] = entryAt(top, path);
    if (line.has("keywords")) return print(joined(dict->subDict(key).keywords()));
    if (line.has("value")) return print(dict->valueText(key) + "\n");
    if (dict->isDict(key)) return print(fmt::format("{}\n{}\n", key, dict->valueText(key)));
    print(fmt::format("{:<15} {};\n", key, dict->valueText(key)));
}

void printWritten(const CommandLine& line, const DictionarySource& source)
{
    const std::string path = line.value("entry");
    if (line.has("keywords")) return print(joined(source.keywords(path)));
    if (path.empty()) return print(source.text());
    print((line.has("value") ? source.valueText(path) : source.entryText(path)) + "\n");
}

void change(const CommandLine& line, DictionarySource source, const std::filesystem::path& file)
{
    const std::string path = line.value("entry");
    if (line.has("set")) source.set(path, line.value("set"));
    if (line.has("add")) source.add(path, line.value("add"));
    if (line.has("remove")) source.remove(path);
    source.write(file);
}

/// Options that contradict one another, or miss the one that they need.
void checkOptions(const CommandLine& line)
{
    const auto count = [&](std::initializer_list<const char*> names) {
        int n = 0;
        for (const char* name : names) n += line.has(name) ? 1 : 0;
        return n;
    };
    const int changes = count({"set", "add", "remove"}), views = count({"value", "keywords"});
    if (changes > 1 || views > 1 || (changes == 1 && (views == 1 || line.has("expand"))))
        throw FatalError(
            "Only one of the options -value -keywords -set -add -remove can be given, and -expand "
            "only with the first two");
    if ((changes == 1 || line.has("value")) && line.value("entry").empty())
        throw FatalError("The options -value -set -add -remove need -entry <path>");
}

}  // namespace

int main(int argc, char** argv)
{
    try {
        CommandLine line("isphDictionary", "Prints and changes entries of dictionary files.");
        line.argument("file", "the dictionary, relative to the case")
            .option("entry", "path", "the entry, as a/b/c; without it the whole file")
            .flag("value", "prints the value only")
            .flag("keywords", "prints the keywords of the file or of the entry")
            .flag("expand", "resolves macros and directives, prints in canonical form")
            .option("set", "value", "sets the entry, adds it where it is missing")
            .option("add", "value", "adds the entry, which must not be there yet")
            .flag("remove", "removes the entry");
        if (const auto exitCode = line.parse(argc, argv)) return *exitCode;
        checkOptions(line);
        const std::filesystem::path given = line.value("file");
        const std::filesystem::path file = line.has("case") ? line.caseDir() / given : given;
        if (line.has("expand"))
            printResolved(line, Dictionary::read(file));
        else if (line.has("set") || line.has("add") || line.has("remove"))
            change(line, DictionarySource::read(file), file);
        else
            printWritten(line, DictionarySource::read(file));
        return 0;
    } catch (const std::exception& error) {
        return isph::reportFatal(error);
    }
}
