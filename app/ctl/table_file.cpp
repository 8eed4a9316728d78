#include "app/ctl/table_file.h"

#include <filesystem>
#include <iostream>

#include "app/ctl/ctl.h"

namespace braitenlab {

TableFile::TableFile(const std::string& path, const io::CsvStyle& style) : path_(path), style_(style) {
    std::error_code none;
    if (path == standard_output)
        stream_ = &std::cout;
    else if (std::filesystem::exists(path, none) && !std::filesystem::is_regular_file(path, none))
        stream_ = &device_.emplace(path);
    else
        file_.emplace(path);
    if (style_.has_byte_order_mark) put(io::byte_order_mark);
}

void TableFile::write(std::string_view lines) { put(io::in_style(lines, style_)); }

void TableFile::put(std::string_view text) {
    if (file_)
        file_->write(text);
    else
        *stream_ << text;
}

std::optional<Error> TableFile::close() {
    if (file_) return file_->commit();
    if (path_ == standard_output) return std::nullopt;  // end_with() looks at it
    stream_->flush();
    if (*stream_) return std::nullopt;
    return Error{"could not be written; check that the folder exists, may be written to and has room", path_};
}

std::optional<Error> write_table(const std::string& path, const io::CsvStyle& style, std::string_view lines) {
    if (path.empty()) return std::nullopt;
    TableFile table(path, style);
    table.write(lines);
    return table.close();
}

Result<io::CsvStyle> style_of(const TableOptions& options) {
    if (!options.for_excel) return io::CsvStyle{};
    const auto strings = strings_of(options.language);
    if (!strings) return strings.error();
    const bool has_comma = decimal_mark(*strings) == ',';
    return io::CsvStyle{has_comma ? ';' : ',', has_comma ? ',' : '.', true};
}

}  // namespace braitenlab
