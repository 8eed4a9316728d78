// Safe writing of files: at any time a file has its complete old or its complete new content.
#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "core/result.h"

namespace braitenlab {

// The file that is written at this path: the target of its links, also one that does not exist, so that no link is
// replaced. Empty for links in a circle.
std::filesystem::path behind_links(const std::filesystem::path&);

// Why FileWriter does not write at this path, whatever its content: there is a folder, a pipe or a device, the file
// would be in /dev, /proc or /sys, or links lead in a circle.
std::optional<Error> replacement_fault(const std::filesystem::path&);

// Writes a file in pieces: beside it first, then renamed over it by commit(). Without commit(), or if anything fails,
// the old file stays as it was. A link is followed, and the file keeps its permissions. The folder must exist.
class FileWriter {
public:
    // `flush`: commit() waits until the content is on the disk, so that it survives a power failure.
    explicit FileWriter(const std::filesystem::path&, bool flush = true);
    FileWriter(FileWriter&&) noexcept = default;
    FileWriter& operator=(FileWriter&&) = delete;
    ~FileWriter();

    void write(std::string_view);

    // The first error so far.
    const std::optional<Error>& problem() const { return error_; }

    // Writes everything to the temporary file, which commit() only renames then. Fails as commit() does.
    std::optional<Error> complete();

    // Fails with the first error of all calls: no permission, no room on the disk, no such folder,
    // replacement_fault().
    std::optional<Error> commit();

private:
    struct Close {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };
    void fail(int reason);

    void remove_beside();

    std::filesystem::path wanted_, path_, beside_;  // beside_: empty once there is no temporary file
    std::unique_ptr<std::FILE, Close> file_;
    std::optional<Error> error_;
    bool flush_;
};

// Writes a file at once, as FileWriter does. Creates missing folders.
std::optional<Error> write_whole(const std::filesystem::path&, std::string_view text);

// Several files: all are written, or none is changed and no folder made. Creates missing folders.
struct NewFile {
    std::filesystem::path path;
    std::string_view text;
};
std::optional<Error> write_all(const std::vector<NewFile>&);

// Renames a file that cannot be read to PATH.broken, or .broken2 and so on where there is one already, so that it is
// reported once and its text is kept. Returns the new name; nullopt if it cannot be renamed.
std::optional<std::filesystem::path> set_aside(const std::filesystem::path&);

// The first file of the form STEM-001.EXTENSION that the folder does not hold. `extension`: with its dot.
std::filesystem::path free_name(const std::filesystem::path& folder, std::string_view stem, std::string_view extension);

}  // namespace braitenlab
