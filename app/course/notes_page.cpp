#include "app/course/notes_page.h"

#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "app/files/safe_file.h"
#include "app/lab.h"
#include "app/reports/html.h"
#include "ui/panels/course/lecture_time.h"

namespace braitenlab {

namespace {

constexpr const char* notes_style = R"(body { font: 26px/1.45 "Noto Sans", "Segoe UI", Helvetica, Arial, sans-serif;
  color: #e6eaf0; background: #14171c; margin: 0 auto; max-width: 1000px; padding: 24px; }
h1 { font-size: 30px; margin: 8px 0 16px; } p { margin: 12px 0; overflow-wrap: anywhere; }
.quiet { color: #a9b4c0; font-size: 20px; font-variant-numeric: tabular-nums; }
)";

constexpr const char* notes_script = "setTimeout(() => location.reload(), 1000);\n";

std::string_view translated_text(const Strings& strings, const std::string& text) { return strings.find(text, text); }

}  // namespace

std::string notes_page(const LectureView& at, const Strings& strings, const std::string& language) {
    const auto& pages = at.lecture->pages;
    const auto next = static_cast<std::size_t>(at.page) + 1;
    const std::string place = fmt::format("{}/{} · {}", at.page + 1, pages.size(), ui::time_words(at, strings));
    std::string body = html::element("p", place, "quiet") + "\n" +
                       html::element("h1", translated_text(strings, at.current().caption)) + "\n" +
                       html::element("p", translated_text(strings, at.current().notes)) + "\n";
    if (next < pages.size())
        body += html::element("p", fill(strings("lecture.next_page"), {translated_text(strings, pages[next].caption)}),
                              "quiet") +
                "\n";
    return html::page(language, translated_text(strings, at.lecture->title), notes_style, body, notes_script);
}

void follow_notes_page(Lab& lab, const Strings& strings, const std::string& language,
                       const std::filesystem::path& folder, bool (*open)(const std::filesystem::path&)) {
    const bool opens = std::exchange(lab.window.opens_notes, false);
    if (folder.empty() || !lab.pages || (!opens && lab.lectures.notes_written.empty())) return;
    const std::string page = notes_page(*lab.pages, strings, language);
    if (!opens && page == lab.lectures.notes_written) return;
    const std::filesystem::path file = folder / "notes.html";
    std::error_code problem;
    std::filesystem::create_directories(folder, problem);  // writing reports it
    FileWriter writer(file, false);
    writer.write(page);
    lab.lectures.notes_written = page;
    if (const auto error = writer.commit()) return say(lab, *error);
    if (!opens) return;
    const bool is_open = open(file);
    if (is_open && saves_by_download()) return say(lab, {NoticeKind::done, "notice.notes_page"});
    if (is_open) return say(lab, {NoticeKind::done, "notice.notes_page_opened", file.string()});  // as the system says
    if (saves_by_download()) return say(lab, {NoticeKind::notice, "notice.notes_page_refused"});
    lab.window.to_copy = file.string();
    say(lab, {NoticeKind::notice, "notice.notes_page_at", file.string()});
}

}  // namespace braitenlab
