// SPDX-License-Identifier: GPL-3.0-or-later
// Shared libraries of models: where they are sought, how they are loaded, what can go wrong.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace isph {

/// The project's folder, the one that holds etc/controlDict: $ISPH_PROJECT_DIR, else found upward
/// from the running program. Throws FatalError where neither leads to it.
std::filesystem::path projectDir();

/// Loads a library by file name or path (dlopen, never closed); a second call does nothing. A name
/// with a slash is a path from the working directory, else from the case ($FOAM_CASE); any other is
/// sought in $ISPH_LIBRARY_PATH (folders between colons), in the folder lib beside the program's,
/// beside the project's own libraries, then on the system's paths.
/// Throws FatalError that lists where it was sought, or with the loader's message, or when what it
/// registered clashes (same name twice, built for another interface version).
/// Symbols stay local to the library: two plug-ins that both call a class MyDrag do not mix.
void loadLibrary(const std::string& name);

/// Loads the built-in models of a family once: the library that etc/controlDict names in
/// families { <family> <library>; }. Families that are not named there have no library.
void loadFamily(const std::string& family);

/// The families that etc/controlDict names, in its order.
std::vector<std::string> builtInFamilies();

/// Libraries loaded so far, in order, as they were asked for.
const std::vector<std::string>& loadedLibraries();

/// The interface version that this program was built for; a model brings its own (kAbi).
int coreAbi();

/// A model that could not be registered; loadLibrary() reports it. `registered`: a function of the
/// model that holds the name already, null when the interface version is the reason.
void noteConflict(const char* family, const char* model, int abi,
                  const void* registered = nullptr) noexcept;

}  // namespace isph
