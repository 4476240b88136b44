// SPDX-License-Identifier: GPL-3.0-or-later
#include "output/WholeFile.hpp"

#include "core/Error.hpp"

#include <fmt/core.h>
#include <boost/crc.hpp>
#include <fcntl.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <system_error>

namespace isph {

namespace {

struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, Close>;

[[noreturn]] void failed(const std::string& what, const std::filesystem::path& file)
{
    throw FatalIOError(fmt::format("{}: {}", what, std::strerror(errno)), file.string(), 0);
}

std::string checksumLine(std::string_view content)
{
    boost::crc_32_type crc;
    crc.process_bytes(content.data(), content.size());
    return fmt::format("<!-- crc32 {:08x} -->\n", crc.checksum());
}

}  // namespace

std::string readWholeFile(const std::filesystem::path& file)
{
    std::error_code ignored;
    if (std::filesystem::is_directory(file, ignored))
        errno = EISDIR;
    else if (const File in{std::fopen(file.c_str(), "rb")}) {
        std::string content;
        content.resize(std::filesystem::file_size(file, ignored));
        content.resize(std::fread(content.data(), 1, content.size(), in.get()));
        if (!std::ferror(in.get())) return content;
    }
    failed("cannot read file", file);
}

void writeWholeFile(const std::filesystem::path& file, std::string_view content)
{
    const std::filesystem::path temporary = file.string() + ".part";
    File out{std::fopen(temporary.c_str(), "wb")};
    if (!out) failed("cannot write file", file);
    bool written = std::fwrite(content.data(), 1, content.size(), out.get()) == content.size() &&
                   std::fflush(out.get()) == 0;
    int cause = errno;
    out.reset();
    if (written && std::rename(temporary.c_str(), file.c_str()) != 0) {
        written = false;
        cause = errno;
    }
    if (written) return;
    std::remove(temporary.c_str());
    errno = cause;
    failed("cannot write file", file);
}

void moveIntoPlace(const std::filesystem::path& from, const std::filesystem::path& to)
{
    namespace fs = std::filesystem;
    std::error_code cause, ignored;
    if (!fs::exists(to)) {
        fs::rename(from, to, cause);
    } else if (renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_EXCHANGE) == 0) {
        fs::remove_all(from, ignored);
    } else {  // a file system that cannot exchange names
        const fs::path old = to.parent_path() / ("." + to.filename().string() + ".old");
        fs::remove_all(old, ignored);
        fs::rename(to, old, cause);
        if (!cause) fs::rename(from, to, cause);
        if (!cause) fs::remove_all(old, ignored);
    }
    if (cause) throw FatalIOError("cannot write folder: " + cause.message(), to.string(), 0);
}

std::string withChecksum(std::string content)
{
    if (content.empty() || content.back() != '\n') content += '\n';
    content += checksumLine(content);
    return content;
}

void requireUndamaged(std::string_view content, std::string_view lastTag, const std::string& source)
{
    const auto tag = content.rfind(lastTag);
    const auto isTail = [&](std::string_view rest) { return rest.size() <= 64; };
    if (tag == std::string_view::npos || !isTail(content.substr(tag + lastTag.size())))
        throw FatalIOError(fmt::format("the file is cut off: its end, {}, is missing", lastTag),
                           source, 0);
    const auto endOfTag = content.find('\n', tag);
    const std::string_view rest =
        endOfTag == std::string_view::npos ? "" : content.substr(endOfTag + 1);
    if (rest.empty()) return;  // written by another program
    if (rest != checksumLine(content.substr(0, endOfTag + 1)))
        throw FatalIOError("the file is damaged: its content does not agree with its checksum",
                           source, 0);
}

}  // namespace isph
