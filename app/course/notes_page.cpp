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
  color: var(--text); background: var(--ground); margin: 0 auto; max-width: 1000px; padding: 24px; }
h1 { font-size: 30px; margin: 8px 0 16px; } p { margin: 12px 0; overflow-wrap: anywhere; }
.quiet { color: var(--second); font-size: 20px; font-variant-numeric: tabular-nums; }
)";
constexpr const char* dark_colours = ":root { --text: #e6eaf0; --ground: #14171c; --second: #a9b4c0; }\n";
constexpr const char* light_colours = ":root { --text: #14171c; --ground: #ffffff; --second: #4a5562; }\n";

constexpr const char* notes_script = "setTimeout(() => location.reload(), 1000);\n";

std::string_view translated_text(const Strings& strings, const std::string& text) { return strings.find(text, text); }

std::string page_of(const std::string& language, std::string_view title, std::string_view body, Theme theme) {
    const std::string style = std::string(theme == Theme::light ? light_colours : dark_colours) + notes_style;
    return html::page(language, title, style, body, notes_script);
}

std::string page_after_lecture(const Strings& strings, const std::string& language, Theme theme) {
    const std::string_view words = strings("lecture.is_over");
    return page_of(language, words, html::element("p", words) + "\n", theme);
}

}  // namespace

std::string notes_page(const LectureView& at, const Strings& strings, const std::string& language, Theme theme) {
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
    return page_of(language, translated_text(strings, at.lecture->title), body, theme);
}

void follow_notes_page(Lab& lab, const Strings& strings, const std::string& language,
                       const std::filesystem::path& folder, bool (*open)(const std::filesystem::path&)) {
    const bool opens = std::exchange(lab.window.opens_notes, false);
    if (folder.empty() || (!opens && lab.lectures.notes_written.empty())) return;
    const Theme theme = lab.preferences.theme;
    const std::string page =
        lab.pages ? notes_page(*lab.pages, strings, language, theme) : page_after_lecture(strings, language, theme);
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
    if (is_open && lab.pages) lab.pages->notes = false;
    if (is_open && saves_by_download()) return say(lab, {NoticeKind::done, "notice.notes_page"});
    if (saves_by_download()) return say(lab, {NoticeKind::notice, "notice.notes_page_refused"});
    lab.window.to_copy = file.string();  // also where a browser was opened: the system does not tell whether it appears
    is_open ? say(lab, {NoticeKind::done, "notice.notes_page_opened"})
            : say(lab, {NoticeKind::notice, "notice.notes_page_at"});
}

}  // namespace braitenlab
