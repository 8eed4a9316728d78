#include "app/autosave.h"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <fstream>
#include <iterator>
#include <sstream>
#include <utility>

#include <fmt/format.h>
#include <toml++/toml.h>

#include "app/safe_file.h"
#include "core/io/run_file.h"

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

Error cannot_keep(Error reason) {
    reason.what =
        fmt::format("your work cannot be kept for the case of a crash, save it yourself (Ctrl+S): {}", reason.what);
    return reason;
}

}  // namespace

Draft draft_of(const Lab& lab) {
    Draft draft{lab.document.name, lab.document.path, lab.document.session.save(), std::nullopt};
    if (lab.document.lesson) {
        const LessonView& view = lab.document.lesson->view;
        draft.exercise = Draft::Progress{view.prediction, view.hints_shown, view.has_run};
    }
    return draft;
}

std::string write_autosave(const Draft& draft, std::string_view when, bool ended) {
    toml::table table{{"format", 1},
                      {"when", when},
                      {"ended", ended},
                      {"name", draft.name},
                      {"path", draft.path.string()},
                      {"run", io::write_run(draft.run)}};
    if (draft.exercise)
        table.insert("exercise", toml::table{{"prediction", draft.exercise->prediction},
                                             {"has_run", draft.exercise->has_run},
                                             {"hints_shown", draft.exercise->hints_shown}});
    std::ostringstream out;
    out << "# Kept by the lab while it runs, for the case that it crashes.\n" << table << "\n";
    return out.str();
}

Result<Document> open_autosave(std::string_view text, std::string file_name) {
    const auto table = read_table(text, file_name);
    if (!table) return table.error();
    auto run = io::read_run((*table)["run"].value_or(std::string()), file_name);
    if (!run) return run.error();
    const fs::path path = (*table)["path"].value_or(std::string());
    const toml::table* lesson = (*table)["exercise"].as_table();
    if (!lesson) {
        Document document = resume_document(std::move(*run));
        document.path = path;
        document.on_disk = mark_of(path);
        document.name = (*table)["name"].value_or(std::string());
        return document;
    }
    auto document = open_document(path, std::nullopt, {});
    if (!document) return document.error();
    document->session = Session::resume(std::move(*run));
    if (document->lesson) {
        LessonView& view = document->lesson->view;
        const auto hints = static_cast<int>(document->lesson->exercise->hints.size());
        view.prediction = (*lesson)["prediction"].value_or(-1);
        view.has_run = (*lesson)["has_run"].value_or(false);
        view.hints_shown = std::clamp((*lesson)["hints_shown"].value_or(0), 0, hints);
    }
    return document;
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
        const RecoveryOffer offer{opened->name, (*table)["when"].value_or(std::string()),
                                  (*table)["ended"].value_or(false)};
        if (!leftover_ || leftover_->offer.when < offer.when) leftover_ = Leftover{file, offer};
    }
}

Result<Document> Autosave::recover() const {
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

std::optional<Error> Autosave::settle() {
    if (!writing_.valid()) return std::nullopt;
    const std::optional<Error> error = writing_.get();
    if (!error) return failed_ = false, std::nullopt;
    kept_ = {};  // it is tried again
    return std::exchange(failed_, true) ? std::nullopt : error;
}

std::optional<Error> Autosave::keep(const Lab& lab, double wall_seconds, Occasion occasion) {
    if (folder_.empty()) return std::nullopt;
    const bool now = occasion != Occasion::frame;
    due_ |= std::exchange(mode_, lab.playback.mode) != lab.playback.mode;
    const bool busy = writing_.valid() && writing_.wait_for(std::chrono::seconds(0)) != std::future_status::ready;
    if (busy && !now) return std::nullopt;
    const auto told = settle();
    const Reached here{lab.document.edits, lab.document.session.snapshot().tick};
    if (here == Reached{lab.document.saved_edits, lab.document.saved_tick}) {
        finish();
        return told;
    }
    if (here == kept_ && occasion != Occasion::end) return told;
    if (dirty_since_ < 0) dirty_since_ = wall_seconds;
    if (!now && !due_ && wall_seconds < std::max(dirty_since_ + soon, written_at_ + period)) return told;
    dirty_since_ = -1;
    written_at_ = wall_seconds;
    due_ = false;
    kept_ = here;
    write(lab, occasion == Occasion::end);
    return now ? settle() : told;
}

void Autosave::write(const Lab& lab, bool ended) {
    if (begin()) {
        writing_ =
            std::async(std::launch::async,
                       [file = file_, draft = draft_of(lab), when = now_in_words(), ended]() -> std::optional<Error> {
                           if (auto error = write_whole(file, write_autosave(draft, when, ended)))
                               return cannot_keep(*error);
                           return std::nullopt;
                       });
        return;
    }
    std::promise<std::optional<Error>> refused;
    refused.set_value(cannot_keep({"check that the folder may be written to and has room", folder_.string()}));
    writing_ = refused.get_future();
}

void Autosave::finish() {
    (void)settle();
    kept_ = {};
    dirty_since_ = -1;
    written_at_ = -period;
    due_ = false;
    if (!lock_) return;
    std::error_code none;
    fs::remove(file_, none);
    fs::remove(lock_of(file_), none);
    lock_.reset();
}

}  // namespace braitenlab
