#include "app/files/pages.h"

#include <system_error>

#include "app/files/data.h"
#include "app/platform/platform.h"
#include "ui/panels/course/pages.h"

namespace braitenlab {

void open_or_copy(Lab& lab, bool is_there, const std::filesystem::path& path, const Opened& opened) {
    if (is_there && open_with_system(path)) return say(lab, {NoticeKind::done, "notice.page_opened", opened.name});
    lab.window.to_copy = opened.copied;
    say(lab, {NoticeKind::notice, "notice.page_copied", opened.copied});
}

void open_folder(Lab& lab, const std::string& folder) {
    std::error_code problem;
    const std::filesystem::path path(folder);
    open_or_copy(lab, std::filesystem::is_directory(path, problem), path, {path.filename().string(), folder});
}

void open_page(Lab& lab, const std::string& page) {
    const auto named = ui::pages_in(page);
    if (named.size() != 1 || named.front() != page) return;
    const auto data = data_folder();
    const std::filesystem::path file = data ? *data / page : std::filesystem::path(page);
    std::error_code problem;
    const bool exists = std::filesystem::is_regular_file(file, problem);
    open_or_copy(lab, exists, file, {page, exists ? file.string() : page});
}

}  // namespace braitenlab
