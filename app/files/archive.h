// The files of a ZIP archive, unpacked in memory. Nothing is written to the disk, so no name in an archive leads
// anywhere.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"

namespace braitenlab {

namespace limits {
inline constexpr std::size_t archive_entries = 20'000;
inline constexpr std::uint64_t archive_bytes = 256u << 20u;  // of all files together, unpacked
}  // namespace limits

// True for the first bytes of a ZIP archive.
bool is_zip(std::string_view content);
bool is_zip_file(const std::filesystem::path&);

class Archive {
public:
    struct Entry {
        std::string path;  // with '/', without one at the end; UTF-8, with '?' for bytes that are not
        bool is_folder = false;
    };

    // Reads the list of files. Fails for a file that is no ZIP archive or is damaged, and above archive_entries.
    static Result<Archive> open(const std::filesystem::path&);

    const std::vector<Entry>& entries() const;

    // The content of a file. Fails if it is damaged or needs a password, is larger than limits::file_bytes, or if all
    // files read so far are larger than archive_bytes; whatever sizes the archive states.
    Result<std::string> read(std::size_t entry);

private:
    struct Impl;
    explicit Archive(std::shared_ptr<Impl>);
    std::shared_ptr<Impl> impl_;
};

}  // namespace braitenlab
