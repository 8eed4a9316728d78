// The destination of a table: a file, a pipe, a device, or standard output.
#pragma once

#include <fstream>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>

#include "app/files/safe_file.h"
#include "core/result.h"

namespace braitenlab {

// The path that stands for standard output.
inline constexpr std::string_view standard_output = "-";

// Takes a table in pieces. A regular file is replaced as a whole by close(); without close(), or if anything fails, the
// old file stays as it was. A pipe, a device and standard output are written directly.
class TableFile {
public:
    explicit TableFile(const std::string& path);
    TableFile(const TableFile&) = delete;
    TableFile& operator=(const TableFile&) = delete;

    void write(std::string_view text);

    // Call it once, after the last write(). Fails with the first error of all calls.
    std::optional<Error> close();

private:
    std::string path_;
    std::optional<FileWriter> file_;
    std::optional<std::ofstream> device_;
    std::ostream* stream_ = nullptr;  // standard output or `device_`; null for a regular file
};

// The lines of a table so that a double click opens them in the Excel of this language, "de": with a byte order mark,
// by which it knows UTF-8, and with semicolons where the language writes a decimal comma.
std::string table_for_excel(std::string_view csv, std::string_view language);

}  // namespace braitenlab
