#include "app/files/study_files.h"

#include <fmt/format.h>

#include "app/files/data.h"
#include "app/files/safe_file.h"
#include "core/insight/study_table.h"
#include "core/messages.h"
#include "core/scene/file_kind.h"
#include "core/scene/toml_tree.h"

namespace braitenlab {

namespace fs = std::filesystem;
using insight::StudyRow;

namespace {

constexpr std::string_view begin_of_unfinished = "# study ";  // of an unfinished table

}  // namespace

std::vector<insight::Study> shipped_study_list() {
    std::vector<insight::Study> studies;
    for (const fs::path& path : shipped_studies())
        if (const auto text = read_text(path))
            if (auto study = insight::parse_study(*text, path.string())) studies.push_back(std::move(*study));
    return studies;
}

Result<std::shared_ptr<const insight::StudyBase>> load_study(const fs::path& path) {
    const auto text = read_text(path);
    if (!text) return text.error();
    auto study = insight::parse_study(*text, path.string());
    if (!study) return study.error();
    const auto scene = scene_at_key(path, *text, study->scene);
    if (!scene) return scene.error();
    const auto scene_text = read_text(*scene);
    if (!scene_text) return scene_text.error();
    return insight::StudyBase::create(std::move(*study), *scene_text, scene->string());
}

std::vector<Error> errors_of_study(const fs::path& path) {
    const auto text = read_text(path);
    if (!text) return {text.error()};
    auto [study, errors] = insight::read_study_fully(*text, path.string());
    const bool is_read = errors.empty();  // else the scene's errors are those of what was read
    if (!study.scene.empty()) {
        const auto scene = scene_at_key(path, *text, study.scene);
        const auto scene_text = scene ? read_text(*scene) : scene.error();
        const auto more = scene_text ? insight::errors_in_scene(study, *scene_text, scene->string())
                                     : std::vector<Error>{scene_text.error()};
        errors.insert(errors.end(), more.begin(), more.end());
    }
    if (is_read && errors.empty())
        if (const auto base = load_study(path); !base) errors.push_back(base.error());
    return in_order(std::move(errors), path.string());
}

StudyTable::StudyTable(std::shared_ptr<const insight::StudyBase> base, const std::string& path, OtherRuns other_runs)
    : base_(std::move(base)), path_(path), other_runs_(other_runs) {}

// The file is removed before the lock is released, so that no other program has locked it meanwhile; Windows removes it
// afterwards only.
HeldLock::~HeldLock() {
    std::error_code none;
    if (!fs::is_empty(path, none)) return;
    const bool is_removed = fs::remove(path, none);
    lock.reset();
    if (!is_removed) fs::remove(path, none);
}

fs::path StudyTable::unfinished() const {
    fs::path path = path_;
    if (!path.empty()) path += ".part";
    return path;
}

std::string StudyTable::name_line() const {
    return fmt::format("{}{:016x}\n", begin_of_unfinished, base_->fingerprint());
}

// The error if begin() must not replace the file at the path of the unfinished table.
std::optional<Error> StudyTable::unfinished_fault() const {
    std::error_code none;
    if (!fs::is_regular_file(unfinished(), none)) return std::nullopt;  // writing reports others
    std::string begin(name_line().size(), '\0');
    std::ifstream in(unfinished(), std::ios::binary);
    in.read(begin.data(), static_cast<std::streamsize>(begin.size()));
    begin.resize(static_cast<std::size_t>(in.gcount()));
    if (begin.empty() || begin == name_line()) return std::nullopt;
    if (!begin.starts_with(begin_of_unfinished)) return error_of(message_of("not_unfinished"), unfinished().string());
    if (other_runs_ == OtherRuns::make_room) return std::nullopt;
    return error_of(message_of("unfinished_of_other"), unfinished().string());
}

// Takes the runs of a file that begins with these lines, and returns the part of it that belongs to them.
std::string StudyTable::take_lines(const fs::path& path, const std::string& first) {
    rows_.clear();
    std::string kept = first;
    const auto read = read_text(path, std::uintmax_t{1} << 30U, "too_large");
    if (!read || !read->starts_with(kept)) return kept;
    const std::string& text = *read;
    // A run that was cut off while it was written has no complete line.
    for (std::size_t at = kept.size(), end;
         rows_.size() < base_->study().runs() && (end = text.find('\n', at)) != std::string::npos; at = end + 1) {
        const std::string line = text.substr(at, end + 1 - at);
        auto row = insight::read_study_line(*base_, rows_.size(), line);
        if (!row) break;
        rows_.push_back(std::move(*row));
        kept += line;
    }
    return kept;
}

void StudyTable::read(const std::vector<fs::path>& files_of_study) {
    std::error_code none;
    if (fs::exists(unfinished(), none)) {
        (void)take_lines(unfinished(), name_line() + insight::study_header(base_->study()));
        return;
    }
    const auto written = fs::last_write_time(path_, none);
    if (none) return;
    for (const fs::path& file : files_of_study)
        if (fs::last_write_time(file, none) > written || none) return;
    (void)take_lines(path_, insight::study_header(base_->study()));
    if (rows_.size() < base_->study().runs()) rows_.clear();
}

std::optional<Error> StudyTable::begin() {
    rows_.clear();
    if (path_.empty()) return std::nullopt;
    const fs::path lock = unfinished() += ".lock";
    std::error_code none;
    if (!lock_)
        if (auto held = lock_file(lock)) lock_ = std::make_unique<HeldLock>(lock, std::move(*held));
    if (!lock_ && fs::exists(lock, none)) return error_of(message_of("study_table_locked"), unfinished().string());
    if (auto fault = unfinished_fault()) return fault;
    const std::string kept = take_lines(unfinished(), name_line() + insight::study_header(base_->study()));
    if (auto error = write_whole(unfinished(), kept)) return error;
    file_.open(unfinished(), std::ios::binary | std::ios::app);
    if (!file_) return Error{"could not be written; check that the folder may be written to", unfinished().string()};
    return std::nullopt;
}

std::optional<Error> StudyTable::add(const std::vector<StudyRow>& rows) {
    for (const StudyRow& row : rows) {
        if (!path_.empty()) file_ << insight::study_line(*base_, rows_.size(), row);
        rows_.push_back(row);
    }
    if (!path_.empty() && !file_.flush())
        return Error{"could not be written; check that the disk has room", unfinished().string()};
    return std::nullopt;
}

std::optional<Error> StudyTable::finish(const io::CsvStyle& style) {
    if (path_.empty()) return std::nullopt;
    file_.close();
    const std::string mark(style.has_byte_order_mark ? io::byte_order_mark : "");
    if (auto error = write_whole(path_, mark + io::in_style(text(), style))) return error;
    std::error_code none;
    fs::remove(unfinished(), none);
    lock_.reset();
    return std::nullopt;
}

std::string StudyTable::text() const {
    std::string text = insight::study_header(base_->study());
    for (std::size_t run = 0; run < rows_.size(); ++run) text += insight::study_line(*base_, run, rows_[run]);
    return text;
}

Result<fs::path> write_study_files(const insight::Study& wanted, const std::string& scene_text,
                                   const fs::path& folder) {
    const auto is_free_for = [](const fs::path& path, const std::string& text) {
        std::error_code none;
        if (!fs::exists(path, none)) return true;
        const auto there = read_text(path);
        return there && *there == text;
    };
    insight::Study study = wanted;
    for (int number = 1;; ++number) {
        const std::string id = wanted.id + (number > 1 ? fmt::format("-{}", number) : "");
        study.scene = id + "-scene.toml";
        const fs::path path = folder / (id + ".toml"), scene = folder / study.scene;
        const std::string text = insight::write_study(study);
        if (!is_free_for(path, text) || !is_free_for(scene, scene_text)) continue;
        std::error_code none;
        for (const auto& [file, content] : {std::pair(scene, &scene_text), std::pair(path, &text)})
            if (!fs::exists(file, none))
                if (const auto error = write_whole(file, *content)) return *error;
        return path;
    }
}

fs::path table_of_study(const fs::path& study_file, const insight::Study& study) {
    const std::string header = insight::study_header(study);
    for (int number = 1;; ++number) {
        const std::string suffix = number > 1 ? fmt::format("-{}", number) : "";
        fs::path table = fs::path(study_file).replace_extension();
        table += suffix + ".csv";
        std::error_code none;
        if (!fs::exists(table, none)) return table;
        std::string begin(header.size(), '\0');
        if (std::ifstream in(table, std::ios::binary);
            in.read(begin.data(), static_cast<std::streamsize>(begin.size())) && begin == header)
            return table;
    }
}

}  // namespace braitenlab
