#include "app/autosave.h"

#include <algorithm>
#include <ctime>
#include <fstream>
#include <iterator>
#include <sstream>

#include <fmt/format.h>
#include <toml++/toml.h>

#include "app/safe_file.h"
#include "core/world/run_file.h"

namespace braitenlab {

namespace fs = std::filesystem;

namespace {

constexpr const char* ending = ".autosave";

std::string now_in_words() {
    const std::time_t now = std::time(nullptr);
    char text[32] = {};
    if (const std::tm* local = std::localtime(&now)) std::strftime(text, sizeof text, "%Y-%m-%d %H:%M:%S", local);
    return text;
}

std::string text_in(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

Result<toml::table> read_table(std::string_view text, const std::string& file_name) {
    try {
        auto table = toml::parse(text, file_name);
        if (table["format"].value<int>() == 1) return table;
        return Error{"is no autosave of this lab's", file_name, 1};
    } catch (const toml::parse_error& error) {
        return Error{std::string(error.description()), file_name, static_cast<int>(error.source().begin.line)};
    }
}

void set_aside(const fs::path& path) {
    std::error_code none;
    fs::path aside = path;
    aside += ".broken";
    fs::rename(path, aside, none);
}

fs::path lock_of(fs::path file) { return file.replace_extension(".lock"); }

}  // namespace

std::string write_autosave(const Lab& lab, std::string_view when) {
    toml::table table{{"format", 1},
                      {"when", when},
                      {"name", lab.name},
                      {"path", lab.path.string()},
                      {"run", write_run(lab.session.save())}};
    if (lab.lesson)
        table.insert("exercise", toml::table{{"prediction", lab.lesson->view.prediction},
                                             {"has_run", lab.lesson->view.has_run},
                                             {"hints_shown", lab.lesson->view.hints_shown}});
    std::ostringstream out;
    out << "# Kept by the lab while it runs, for the case that it crashes.\n" << table << "\n";
    return out.str();
}

Result<Lab> open_autosave(std::string_view text, std::string file_name) {
    const auto table = read_table(text, file_name);
    if (!table) return table.error();
    auto run = read_run((*table)["run"].value_or(std::string()), file_name);
    if (!run) return run.error();
    const fs::path path = (*table)["path"].value_or(std::string());
    const toml::table* lesson = (*table)["exercise"].as_table();
    if (!lesson) {
        Lab lab = resume(std::move(*run));
        lab.path = path;
        lab.name = (*table)["name"].value_or(std::string());
        return lab;
    }
    auto lab = open_lab(path, std::nullopt, {});
    if (!lab) return lab.error();
    lab->session = Session::resume(std::move(*run));
    if (lab->lesson) {
        LessonView& view = lab->lesson->view;
        view.prediction = (*lesson)["prediction"].value_or(-1);
        view.has_run = (*lesson)["has_run"].value_or(false);
        view.hints_shown =
            std::clamp((*lesson)["hints_shown"].value_or(0), 0, static_cast<int>(lab->lesson->exercise->hints.size()));
    }
    return lab;
}

Autosave::Autosave(fs::path folder, std::vector<Error>& complaints) : folder_(std::move(folder)) {
    std::error_code problem;
    if (folder_.empty()) return;
    for (const auto& entry : fs::directory_iterator(folder_, problem)) {
        const fs::path file = entry.path();
        if (file.extension() != ending || !lock_file(lock_of(file))) continue;  // of a lab that is running
        const std::string text = text_in(file);
        const auto opened = open_autosave(text, file.string());
        if (!opened) {
            Error error = opened.error();
            error.what += "; the work that it kept cannot be recovered, the file is kept as " +
                          file.filename().string() + ".broken";
            complaints.push_back(std::move(error));
            set_aside(file);
            continue;
        }
        const auto table = read_table(text, file.string());
        const RecoveryOffer offer{opened->name, (*table)["when"].value_or(std::string())};
        if (!leftover_ || leftover_->offer.when < offer.when) leftover_ = Leftover{file, offer};
    }
}

Result<Lab> Autosave::recover() const {
    if (!leftover_) return Error{"there is nothing to recover"};
    return open_autosave(text_in(leftover_->file), leftover_->file.string());
}

void Autosave::forget() {
    if (!leftover_) return;
    std::error_code none;
    fs::remove(leftover_->file, none);
    fs::remove(lock_of(leftover_->file), none);
    leftover_.reset();
}

bool Autosave::begin() {
    if (lock_) return true;
    std::error_code problem;
    fs::create_directories(folder_, problem);
    // The time too: a process number comes again, and must not meet what an earlier one left.
    file_ = folder_ / fmt::format("{}-{}{}", std::time(nullptr), process_number(), ending);
    lock_ = lock_file(lock_of(file_));
    return lock_.has_value();
}

std::optional<Error> Autosave::keep(const Lab& lab, double wall_seconds, bool now) {
    if (folder_.empty()) return std::nullopt;
    const bool turned = std::exchange(mode_, lab.mode) != lab.mode;
    if (lab.work == lab.saved_work) {
        if (kept_ != 0) finish();
        return std::nullopt;
    }
    if (lab.work == kept_) return std::nullopt;
    if (dirty_since_ < 0) dirty_since_ = wall_seconds;
    if (!now && !turned && wall_seconds - dirty_since_ < period) return std::nullopt;
    dirty_since_ = -1;
    kept_ = lab.work;
    std::optional<Error> error;
    if (begin())
        error = write_whole(file_, write_autosave(lab, now_in_words()));
    else
        error = Error{"nothing can be kept here for the case of a crash; check that the folder may be written to",
                      folder_.string()};
    if (!error) failed_ = false;
    return error && !std::exchange(failed_, true) ? error : std::nullopt;
}

void Autosave::finish() {
    kept_ = 0;
    dirty_since_ = -1;
    if (!lock_) return;
    std::error_code none;
    fs::remove(file_, none);
    fs::remove(lock_of(file_), none);
    lock_.reset();
}

}  // namespace braitenlab
