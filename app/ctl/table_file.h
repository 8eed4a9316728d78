// The destination of a table: a file, a pipe, a device, or standard output.
#pragma once

#include <fstream>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>

#include "app/files/safe_file.h"
#include "core/io/csv.h"
#include "core/result.h"

namespace braitenlab {

// The path that stands for standard output.
inline constexpr std::string_view standard_output = "-";

// Takes a table in pieces. A regular file is replaced as a whole by close(); without close(), or if anything fails, the
// old file stays as it was. A pipe, a device and standard output are written directly.
class TableFile {
public:
    explicit TableFile(const std::string& path, const io::CsvStyle& = {});
    TableFile(const TableFile&) = delete;
    TableFile& operator=(const TableFile&) = delete;

    // Whole lines as core/io/csv.h writes them.
    void write(std::string_view lines);

    // Call it once, after the last write(). Fails with the first error of all calls; for standard output, end_with()
    // in app/ctl/outputs.h fails in its place.
    std::optional<Error> close();

private:
    void put(std::string_view text);

    std::string path_;
    io::CsvStyle style_;
    std::optional<FileWriter> file_;
    std::optional<std::ofstream> device_;
    std::ostream* stream_ = nullptr;  // standard output or `device_`; null for a regular file
};

// A table of one piece; without a path nothing is written.
std::optional<Error> write_table(const std::string& path, const io::CsvStyle&, std::string_view lines);

// The options --excel and --lang of a table.
struct TableOptions {
    bool for_excel = false;
    std::string language = "en";
};

// The style in which a double click opens a table in the Excel of the language: with a byte order mark, and with
// semicolons and decimal commas where the language writes these. Without for_excel the plain style. Fails for a
// language that the program does not speak.
Result<io::CsvStyle> style_of(const TableOptions&);

}  // namespace braitenlab
