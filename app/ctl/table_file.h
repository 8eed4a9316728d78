// The destination of a table: a file, a pipe or a device.
#pragma once

#include <fstream>
#include <optional>
#include <string>
#include <string_view>

#include "app/files/safe_file.h"
#include "core/result.h"

namespace braitenlab {

// Takes a table in pieces. A regular file is replaced as a whole by close(); without close(), or if anything fails, the
// old file stays as it was. A pipe or a device is written directly.
class TableFile {
public:
    explicit TableFile(const std::string& path);

    void write(std::string_view text);

    // Call it once, after the last write(). Fails with the first error of all calls.
    std::optional<Error> close();

private:
    std::string path_;
    std::optional<FileWriter> file_;
    std::optional<std::ofstream> stream_;
};

}  // namespace braitenlab
