// SPDX-License-Identifier: GPL-3.0-or-later
// Directives that read other files.
#include "core/Error.hpp"
#include "dictionary/DictionaryParser.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

namespace isph {

namespace fs = std::filesystem;

namespace {

/// The etc folders: of $ISPH_PROJECT_DIR, else those above the running program.
std::vector<fs::path> etcFolders()
{
    if (const char* project = std::getenv("ISPH_PROJECT_DIR"); project && *project)
        return {fs::path(project) / "etc"};
    std::error_code ignored;
    std::vector<fs::path> folders;
    for (fs::path folder = fs::read_symlink("/proc/self/exe", ignored).parent_path();
         folder != folder.parent_path(); folder = folder.parent_path())
        if (fs::is_directory(folder / "etc")) folders.push_back(folder / "etc");
    return folders;
}

std::string listed(const std::vector<fs::path>& folders)
{
    std::string text;
    for (const fs::path& folder : folders) text += fmt::format("\n    {}", folder.string());
    return text.empty() ? "\n    (no folder: set ISPH_PROJECT_DIR)" : text;
}

/// A call of #includeFunc: "probes(U, p, funcName=gauges, writeInterval=2)".
struct FunctionCall {
    std::string name;
    std::vector<std::string> fields{};
    std::vector<std::pair<std::string, std::string>> settings{};
};

std::string trimmed(const std::string& text)
{
    const std::size_t first = text.find_first_not_of(" \t\n");
    return first == std::string::npos
               ? ""
               : text.substr(first, text.find_last_not_of(" \t\n") - first + 1);
}

FunctionCall functionCall(const std::string& text)
{
    const std::size_t open = text.find('(');
    FunctionCall call{trimmed(text.substr(0, open))};
    if (open == std::string::npos) return call;
    int depth = 0;
    std::string argument;
    const auto finish = [&] {
        const std::size_t equals = argument.find('=');
        if (equals != std::string::npos)
            call.settings.emplace_back(trimmed(argument.substr(0, equals)),
                                       trimmed(argument.substr(equals + 1)));
        else if (!trimmed(argument).empty())
            call.fields.push_back(trimmed(argument));
        argument.clear();
    };
    for (const char c : text.substr(open + 1)) {
        if (c == ')' && depth == 0) break;
        if (c == '(') ++depth;
        if (c == ')') --depth;
        if (c == ',' && depth == 0)
            finish();
        else
            argument += c;
    }
    finish();
    return call;
}

}  // namespace

fs::path DictionaryParser::relativeToThisFile(const std::string& file) const
{
    return fs::path(lexer_.file()).parent_path() / file;  // an absolute file stays as it is
}

void DictionaryParser::include(const Lexeme& name)
{
    includeAny(name, nullptr);
}

void DictionaryParser::includeAny(const Lexeme& name, std::vector<Token>* tokens)
{
    const std::string file = textArgument(name);
    if (name.text != "includeEtc") {
        const fs::path path = relativeToThisFile(file);
        const bool optional = name.text != "include";
        if (optional && !fs::exists(path)) return;
        return includeFile(path, name, tokens);
    }
    const std::vector<fs::path> folders = etcFolders();
    for (const fs::path& folder : folders)
        if (fs::is_regular_file(folder / file)) return includeFile(folder / file, name, tokens);
    fail(fmt::format("#includeEtc cannot find \"{}\". Sought in{}", file, listed(folders)),
         name.line);
}

/// The file's entries go into the present dictionary, or its words into `tokens` where a value is
/// being read.
void DictionaryParser::includeFile(const fs::path& file, const Lexeme& name,
                                   std::vector<Token>* tokens)
{
    if (!fs::is_regular_file(file))
        fail(fmt::format("Cannot open include file \"{}\" while reading dictionary \"{}\"",
                         file.string(), current().name()),
             name.line);
    const fs::path unique = fs::weakly_canonical(file);
    if (std::find(state_.files.begin(), state_.files.end(), unique) != state_.files.end())
        fail(fmt::format("The file \"{}\" includes itself", file.string()), name.line);
    const std::string text = textOfFile(file);
    Lexer lexer(text, file.lexically_normal().string());
    DictionaryParser parser(lexer, state_);
    state_.files.push_back(unique);
    if (tokens) {
        for (Lexeme lexeme = lexer.next(); lexeme.kind != Lexeme::Kind::end; lexeme = lexer.next())
            parser.appendValue(*tokens, lexeme);
    } else {
        parser.parseBody();
    }
    state_.files.pop_back();
}

/// Where the configuration of a function object stands: the case's system folder,
/// etc/caseDicts/postProcessing.
fs::path DictionaryParser::functionFile(const std::string& function, const Lexeme& name) const
{
    std::vector<fs::path> folders{fs::path(lexer_.file()).parent_path()};
    if (const char* home = std::getenv("FOAM_CASE")) folders.push_back(fs::path(home) / "system");
    for (const fs::path& folder : folders)
        if (fs::is_regular_file(folder / function)) return folder / function;
    for (const fs::path& etc : etcFolders()) {
        folders.push_back(etc / "caseDicts/postProcessing");
        if (!fs::is_directory(folders.back())) continue;
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folders.back()))
            if (entry.is_regular_file() && entry.path().filename() == function) return entry.path();
    }
    fail(fmt::format("#includeFunc cannot find \"{}\". Sought in{}", function, listed(folders)),
         name.line);
}

/// "#includeFunc probes(U, p, writeInterval=2)": the file as a sub-dictionary of that name, with
/// `fields` and the other arguments set in it; funcName=x gives it another name.
void DictionaryParser::includeFunction(const Lexeme& name)
{
    std::string text = textArgument(name);
    if (lexer_.peek().is('(')) {  // a call with spaces is no single word
        for (int depth = 0; depth > 0 || lexer_.peek().is('(');) {
            const Lexeme lexeme = lexer_.next();
            if (lexeme.kind == Lexeme::Kind::end)
                fail("The '(' after #includeFunc is not closed", name.line);
            if (lexeme.is('(')) ++depth;
            if (lexeme.is(')')) --depth;
            text += lexeme.kind == Lexeme::Kind::string ? fmt::format("\"{}\" ", lexeme.text)
                                                        : lexeme.text + " ";
        }
    }
    const FunctionCall call = functionCall(text);
    Dictionary function = readFile(functionFile(call.name, name));
    if (function.found("FoamFile")) function.remove("FoamFile");
    if (!call.fields.empty())
        function.set("fields", fmt::format("({})", fmt::join(call.fields, " ")));
    DictionaryEntry entry{call.name, here(name)};
    for (const auto& [key, value] : call.settings) {
        if (key == "funcName")
            entry.key = value;
        else
            function.set(key, value);
    }
    entry.dict = std::make_unique<Dictionary>(std::move(function));
    rename(*entry.dict, current().name() + "/" + entry.key);
    Dictionary part;
    if (!admits(entry)) return;
    DictionaryAccess::content(part).put(std::move(entry));
    mergeInto(current(), part);
}

}  // namespace isph
