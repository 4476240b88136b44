// SPDX-License-Identifier: GPL-3.0-or-later
// Shared libraries of models: where they are sought, how they are loaded, what can go wrong.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace isph {

/// The project's folder: $ISPH_PROJECT_DIR, else found from the place of the running program.
std::filesystem::path projectDir();

/// Loads a library by file name or path (dlopen, never closed); a second call does nothing. Sought in:
/// the path itself, $ISPH_LIBRARY_PATH, the folder lib beside the program's, the system's paths.
/// Throws FatalError that lists where it was sought, or with the loader's message, or when what it
/// registered clashes (same name twice, built for another interface version).
void loadLibrary(const std::string& name);

/// Loads the built-in models of a family once: the library that etc/controlDict names in
/// families { <family> <library>; }. Families that are not named there have no library.
void loadFamily(const std::string& family);

/// Libraries loaded so far, in order.
const std::vector<std::string>& loadedLibraries();

int coreAbi();
void noteConflict(const char* family, const char* model, int abi) noexcept;

}  // namespace isph
