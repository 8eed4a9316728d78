// braitenctl check for lectures.
#include <cmath>
#include <iostream>

#include <fmt/format.h>

#include "app/ctl/ctl.h"
#include "app/files/data.h"
#include "app/terminal.h"
#include "core/io/checked_json.h"
#include "core/lesson/lecture.h"
#include "core/scene/file_kind.h"

namespace braitenlab {

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
    if (json)
        std::cout << io::json_text(nlohmann::ordered_json{{"lecture", lecture->id},
                                                          {"pages", lecture->pages.size()},
                                                          {"minutes", lecture->minutes},
                                                          {"minutes_of_pages", sum},
                                                          {"sound", fits}},
                                   2)
                  << "\n";
    else
        std::cout << format_lines("{}: {} pages can be opened; they take {:g} of {:g} minutes: {}\n", lecture->id,
                                  lecture->pages.size(), sum, lecture->minutes, fits ? "good" : "wrong");
    return fits ? exit_code::done : exit_code::failed;
}

}  // namespace braitenlab
