#include "app/files/pages.h"

#include <filesystem>
#include <system_error>

#include "app/files/data.h"
#include "app/platform/platform.h"
#include "ui/panels/course/pages.h"

namespace braitenlab {

void open_folder(Lab& lab, const std::string& folder) {
    std::error_code problem;
    const std::filesystem::path path(folder);
    if (std::filesystem::is_directory(path, problem) && open_with_system(path))
        return say(lab, {NoticeKind::done, "notice.page_opened", path.filename().string()});
    lab.window.to_copy = folder;
    say(lab, {NoticeKind::notice, "notice.page_copied", folder});
}

void open_page(Lab& lab, const std::string& page) {
    const auto named = ui::pages_in(page);
    if (named.size() != 1 || named.front() != page) return;
    const auto data = data_folder();
    const std::filesystem::path file = data ? *data / page : std::filesystem::path(page);
    std::error_code problem;
    const bool exists = std::filesystem::is_regular_file(file, problem);
    if (exists && open_with_system(file)) return say(lab, {NoticeKind::done, "notice.page_opened", page});
    lab.window.to_copy = exists ? file.string() : page;
    say(lab, {NoticeKind::notice, "notice.page_copied", lab.window.to_copy});
}

}  // namespace braitenlab
