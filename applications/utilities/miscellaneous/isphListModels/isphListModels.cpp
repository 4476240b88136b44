// SPDX-License-Identifier: GPL-3.0-or-later
// isphListModels: the model families, their models, and the keys of a model.
#include "AnnotatedDictionaries.hpp"

#include "core/Error.hpp"
#include "core/Log.hpp"
#include "selection/CommandLine.hpp"
#include "selection/ModelTable.hpp"

using namespace isph;

namespace {

/// "Valid porousModel types are:" and the names, as OpenFOAM's error messages and -list options do.
void listFamily(const std::string& family, const AnyModelTable& table)
{
    info("Valid {} types are:\n\n{}", family, listOf(table.names()));
}

/// The names alone, one a line, for scripts.
void printNames(const std::string&, const AnyModelTable& table)
{
    for (const std::string& name : table.names()) info("{}", name);
}

/// Shows all families, or the one of this name.
void showFamilies(const std::string& wanted, void (*show)(const std::string&, const AnyModelTable&))
{
    std::vector<std::string> known;
    for (const auto& [family, table] : modelFamilies()) {
        known.push_back(family);
        if (wanted.empty() || wanted == family) show(family, *table);
    }
    if (!wanted.empty() && modelFamilies().count(wanted) == 0)
        throw FatalError(
            fmt::format("Unknown family {}\n\nValid families are:\n\n{}", wanted, listOf(known)));
}

/// The keys of a model, whichever family it is of: default, type, dimensions, range and meaning.
void printKeys(const std::string& model)
{
    std::vector<std::string> known;
    bool found = false;
    for (const auto& [family, table] : modelFamilies())
        for (const std::string& name : table->names()) {
            known.push_back(name);
            if (name != model) continue;
            found = true;
            const std::string keys = table->keys(name).annotated();
            info("// {} {}{}\n{}", family, name, keys.empty() ? " has no keys" : "", keys);
        }
    if (found) return;
    const std::string near = nearestName(model, known);
    throw FatalError(fmt::format("Unknown model {}{}\n\nValid models are:\n\n{}", model,
                                 near.empty() ? "" : ", did you mean " + near + "?",
                                 listOf(known)));
}

}  // namespace

int main(int argc, char** argv)
{
    try {
        CommandLine line("isphListModels",
                         "Lists the models that dictionaries can name, and their keys.");
        line.option("family", "name", "only the models of this family");
        line.flag("names", "the names alone, one a line, for scripts");
        line.option("keys", "model", "the keys of a model, with defaults, dimensions and ranges");
        line.option("annotated", "dir",
                    "write the annotated dictionaries of the families to a folder");
        if (const auto exitCode = line.parse(argc, argv)) return *exitCode;

        for (const std::string& family : builtInFamilies()) loadFamily(family);
        if (line.has("annotated"))
            writeAnnotatedDictionaries(line.value("annotated"));
        else if (line.has("keys"))
            printKeys(line.value("keys"));
        else
            showFamilies(line.value("family"), line.has("names") ? printNames : listFamily);
        return 0;
    } catch (const std::exception& error) {
        return reportFatal(error);
    }
}
