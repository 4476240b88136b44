// SPDX-License-Identifier: GPL-3.0-or-later
// Files and folders that are whole or absent: written under a temporary name, checked when read.
#pragma once
#include <filesystem>
#include <string>
#include <string_view>

namespace isph {

/// The content of a file. Throws FatalIOError if it cannot be read.
std::string readWholeFile(const std::filesystem::path& file);

/// Writes `content` to a temporary name in the same folder and renames it to `file`.
/// Throws FatalIOError (disk full, no permission); then `file` is as it was.
void writeWholeFile(const std::filesystem::path& file, std::string_view content);

/// Puts the finished folder `from` in the place of `to`, beside it, and removes what stood there. A
/// program that is killed leaves the one or the other. Throws FatalIOError.
void moveIntoPlace(const std::filesystem::path& from, const std::filesystem::path& to);

/// The content of an XML file with its checksum (CRC-32) as last line, an XML comment.
std::string withChecksum(std::string content);

/// Throws FatalIOError naming `source` unless the content ends with `lastTag` and, where a checksum
/// stands behind that, agrees with it.
void requireUndamaged(std::string_view content, std::string_view lastTag,
                      const std::string& source);

}  // namespace isph
