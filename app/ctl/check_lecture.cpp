// braitenctl check for lectures.
#include <cmath>
#include <iostream>

#include "app/ctl/ctl.h"
#include "app/files/data.h"
#include "app/terminal.h"
#include "core/io/checked_json.h"
#include "core/lesson/lecture.h"
#include "core/scene/file_kind.h"

namespace braitenlab {

namespace {

// Of the key `minutes` of the lecture, from 1.
std::size_t line_of_minutes(std::string_view text) {
    std::size_t line = 1;
    for (; !text.starts_with("minutes") && text.find('\n') != text.npos; ++line)
        text.remove_prefix(text.find('\n') + 1);
    return line;
}

}  // namespace

int check_lecture(const std::filesystem::path& path, bool json) {
    constexpr float tolerated = 0.1f;  // of the lecture's minutes
    const auto data = data_folder();
    if (!data) return complain(data.error());
    const auto text = read_text(path);
    if (!text) return complain(text.error());
    const std::vector<Error> errors = errors_of_lecture(*text, path, *data / "exercises");
    if (!errors.empty()) return complain_of_all(errors);
    const auto lecture = parse_lecture(*text, path, *data / "exercises");
    if (!lecture) return complain(lecture.error());
    const float sum = minutes_of_pages(*lecture);
    const bool fits = std::fabs(sum - lecture->minutes) <= tolerated * lecture->minutes;
    std::vector<std::size_t> long_questions;  // numbers of pages
    for (std::size_t i = 0; i < lecture->pages.size(); ++i)
        if (is_long(lecture->pages[i].question)) long_questions.push_back(i + 1);
    if (json) {
        std::cout << io::json_text(nlohmann::ordered_json{{"lecture", lecture->id},
                                                          {"pages", lecture->pages.size()},
                                                          {"minutes", lecture->minutes},
                                                          {"minutes_of_pages", sum},
                                                          {"long_questions", long_questions},
                                                          {"sound", fits}},
                                   2)
                  << "\n";
    } else {
        for (const std::size_t page : long_questions)
            std::cout << format_lines(
                "{}: warning: page {}: a window of 1024x768 cannot show all options of the question without "
                "scrolling; use fewer or shorter ones\n",
                path.string(), page);
        std::cout << format_lines("{}: {} pages can be opened; they take {:g} of {:g} minutes: {}\n", lecture->id,
                                  lecture->pages.size(), sum, lecture->minutes, fits ? "good" : "wrong");
        if (!fits)
            std::cout << format_lines(
                "{}:{}: write minutes = {:g}, or change the minutes of the pages; the sum may differ by a tenth\n",
                path.string(), line_of_minutes(*text), sum);
    }
    return fits ? exit_code::done : exit_code::failed;
}

}  // namespace braitenlab
