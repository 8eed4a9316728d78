#include "app/ctl/table_file.h"

#include <filesystem>
#include <iostream>

#include "app/ctl/ctl.h"
#include "core/io/csv.h"

namespace braitenlab {

TableFile::TableFile(const std::string& path) : path_(path) {
    std::error_code none;
    if (path == standard_output)
        stream_ = &std::cout;
    else if (std::filesystem::exists(path, none) && !std::filesystem::is_regular_file(path, none))
        stream_ = &device_.emplace(path);
    else
        file_.emplace(path);
}

void TableFile::write(std::string_view text) {
    if (file_)
        file_->write(text);
    else
        *stream_ << text;
}

std::optional<Error> TableFile::close() {
    if (file_) return file_->commit();
    stream_->flush();
    if (*stream_) return std::nullopt;
    if (path_ == standard_output)
        return Error{"standard output could not be written; check that it has room", "--csv -"};
    return Error{"could not be written; check that the folder exists, may be written to and has room", path_};
}

std::string table_for_excel(std::string_view csv, std::string_view language) {
    const bool has_decimal_comma = language != "en";
    return std::string(byte_order_mark) + (has_decimal_comma ? io::with_semicolons(csv) : std::string(csv));
}

}  // namespace braitenlab
