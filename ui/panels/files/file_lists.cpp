#include "ui/panels/files/file_lists.h"

#include <algorithm>
#include <array>

#include <imgui.h>

#include "core/plain_letters.h"
#include "ui/imgui_compat.h"
#include "ui/panels/exercise_names.h"
#include "ui/widgets/card.h"
#include "ui/widgets/item.h"
#include "ui/widgets/keyboard.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/whole_lines.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

namespace {

constexpr float least_list = 80, row_picture = 72;  // layout pixels
constexpr std::size_t most_name_lines = 3;

// True if the words of the entry have every word of the search: those shown, its subjects, and the name of the file, of
// an exercise from the beginning, as in the documentation: "05-a". The title of an exercise that tells its outcome is
// not searched until it is shown; a lecturer searches it in the chosen language and in English.
bool matches(const LabView& view, const Ui& ui, const CatalogueEntry& entry, const std::string& search) {
    if (entry.name.starts_with(search)) return true;
    std::string words = entry_words(view, ui, entry) + " ";
    words += entry.exercise ? translated(ui, entry.exercise->goal) : translated(ui, entry.story);
    if (view.lecture) words += " " + std::string(translated(ui, entry.title)) + " " + entry.title;
    words += " " + std::string(ui.strings.find("search." + entry.name, ""));
    if (!entry.exercise) words += " " + entry.name;
    words = plain_letters(words, Umlauts::as_vowels);
    for (std::size_t from = 0; from < search.size();) {
        const std::size_t end = std::min(search.find(' ', from), search.size());
        if (words.find(search.substr(from, end - from)) == std::string::npos) return false;
        from = end + 1;
    }
    return true;
}

std::string row_anchor(const CatalogueEntry& entry) { return (entry.number > 0 ? "gallery." : "open.") + entry.name; }

// How well the title has the search: as a whole, at its beginning, at that of a word, inside; 0: only the text below. A
// file name, which is not shown, counts less than the beginning of a title. In a lecture the title of an exercise
// counts less than that of a scene, and a title counts also while it is hidden: asking first opens the same.
int hit_of(const LabView& view, const Ui& ui, const CatalogueEntry& entry, const std::string& search) {
    const std::string title = plain_letters(searched_words(view, ui, entry), Umlauts::as_vowels);
    const auto has = [&](const std::string& words) { return title.find(words) != std::string::npos; };
    const bool is_number = entry.number > 0 && number_words(view, entry.number, entry.name) == search;
    const int of_title = title == search ? 4 : title.starts_with(search) ? 3 : has(" " + search) ? 2 : has(search);
    const int of_name = is_number ? 4 : entry.name.starts_with(search) ? 2 : 0;
    return std::max(view.lecture && entry.number > 0 ? std::min(of_title, 1) : of_title, of_name);
}

// After a change of the search the focus is on the entry with the best hit; of several on the first one, in a lecture
// on the first scene.
void focus_best_hit(const LabView& view, const Ui& ui, const std::vector<CatalogueEntry>& listed,
                    const std::vector<CatalogueEntry>& lectures, const std::string& search, Keyboard& keyboard) {
    const CatalogueEntry* best = nullptr;
    std::pair most{-1, false};
    for (const auto* entries : {&listed, &lectures})
        for (const CatalogueEntry& entry : *entries)
            if (const std::pair hit{hit_of(view, ui, entry, search), view.lecture && entry.number == 0}; hit > most)
                most = hit, best = &entry;
    if (!best) return;
    keyboard.focus = row_anchor(*best);
    keyboard.revealed = keyboard.shown = true;
}

// What is searched for, or how to search. While a lecture asks first, a dot stands for each letter.
void search_row(const LabView& view, const FilesState& files, Ui& ui) {
    std::string typed = files.search;
    if (hides_titles(view)) {
        typed.clear();
        for (std::size_t i = 0; i < files.search.size(); ++i) typed += "•";
    }
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const Rect box{at.x, at.y, card_width(ui), ui.px(28)};
    const bool empty = files.search.empty();
    const ImVec2 words{box.x + ui.px(spacing::small), box.y + (box.h - line_height(ui, Face::text)) / 2};
    line_box(ui, box, empty ? ui.palette.line : ui.palette.second_text);
    if (files.search_selected && !empty)
        fill_box(ui, {words.x, words.y, text_width(ui, Face::text, typed), line_height(ui, Face::text)},
                 ui.palette.accent.with_alpha(0.4f), Corner::square);
    put(ui, words,
        empty ? shortened(ui, ui.strings("files.search_how"), Face::text, box.w - 2 * ui.px(spacing::small)) : typed,
        empty ? ui.palette.second_text : ui.palette.text);
    mark(ui, "files.search", box);
    ImGui::Dummy({box.w, box.h});
}

std::string without_folder(const std::string& path) { return path.substr(path.find_last_of('/') + 1); }
std::string folder_of(const std::string& path) {
    return path.substr(0, std::max<std::size_t>(1, path.find_last_of('/')));
}

// A row of a list: icon, name, a second line, and a note at the right end.
struct FileRow {
    std::string id, words, below, aside;
    std::string_view icon;
    bool current = false, broken = false;
    std::string path{};     // of the scene or exercise whose picture is shown; empty: none
    bool is_story = false;  // the second line may be two lines
};

bool list_row(const LabView& view, Ui& ui, const FileRow& row, std::string_view how) {
    const bool has_picture = view.documents.pictures && !row.path.empty();
    const std::size_t lines_below = row.below.empty() ? 0 : row.is_story ? 2 : 1;
    const float picture = ui.px(row_picture), picture_height = picture * picture_share;
    const float aside = text_width(ui, Face::small, row.aside);
    const bool has_icon = !has_picture && !row.icon.empty() && has_icons(ui);
    const float left = ui.px(12) + (has_picture ? picture + ui.px(6) : has_icon ? ui.px(26) : 0);
    const float room = card_width(ui) - ui.px(20) - left - (aside > 0 ? aside + ui.px(12) : 0);
    const std::vector<std::string> name = lines_of_words(ui, row.words, Face::strong, room);
    const std::size_t name_lines = std::clamp<std::size_t>(name.size(), 1, most_name_lines);
    const bool is_name_whole =
        name.size() <= most_name_lines && std::all_of(name.begin(), name.end(), [&](const std::string& line) {
            return text_width(ui, Face::strong, line) <= room;
        });
    const float name_height = static_cast<float>(name_lines) * line_height(ui, Face::text);
    const float words_height =
        name_height + static_cast<float>(lines_below) * line_height(ui, Face::small) + ui.px(spacing::medium);
    const float height =
        std::max(ui.px(ui.finger), has_picture ? std::max(words_height, picture_height + ui.px(8)) : words_height);
    const Item at = item(ui, row.id, {card_width(ui), height});
    fill_box(ui, at.rect, ui.palette.line.with_alpha(std::max(0.6f * at.warmth, at.focused ? 0.6f : 0.0f)));
    if (row.current)
        fill_box(ui, {at.rect.x, at.rect.y + ui.px(6), ui.px(3), height - ui.px(12)}, ui.palette.accent, Corner::bar);
    const Palette& p = ui.palette;
    const Colour quiet = row.broken ? legible(p.warning, p.panel, p.text) : p.second_text;
    float x = at.rect.x + ui.px(12);
    const float y = at.rect.y + (height - words_height) / 2 + ui.px(5);
    if (has_picture) {
        const Rect place{x - ui.px(4), at.rect.y + (height - picture_height) / 2, picture, picture_height};
        if (ImGui::IsRectVisible({at.rect.x, at.rect.y}, {at.right(), at.bottom()}) &&
            !put_scene_picture(view, ui, row.path, place))
            fill_box(ui, place, mix(p.raised, p.line, 0.5f), Corner::box);  // until it is rendered
    } else if (has_icon) {
        put_icon(ui, {x + ui.px(7), y + line_height(ui, Face::text) / 2}, row.icon, quiet);
    }
    x = at.rect.x + left;
    put_right(ui, {at.right() - ui.px(12), y + ui.px(2)}, row.aside, quiet, Face::small);
    put_lines(ui, {x, y}, row.words, ui.palette.text, Face::strong, room, name_lines);
    const bool is_whole = lines_below == 0 || put_lines(ui, {x, y + name_height}, row.below, ui.palette.second_text,
                                                        Face::small, at.right() - ui.px(12) - x, lines_below);
    // No tooltip for words that are fully visible in the row.
    tooltip(ui, at, !is_whole ? std::string_view(row.below) : is_name_whole ? how : std::string_view(row.words));
    return at.pressed;
}

// A list from the cursor down to the sheet's buttons. `contents` identifies the list: a new one is scrolled to its top.
void begin_list(FilesState& files, Ui& ui, std::string_view contents, float bottom, const char* id = "list",
                float width = 0) {
    const float height = std::max(ui.px(least_list), bottom - ImGui::GetCursorPosY());
    compat::begin_child(id, {width > 0 ? width : card_width(ui), height}, ImGuiWindowFlags_NoNav);
    if (files.listed != contents || !files.begun) files.listed = contents, ImGui::SetScrollY(0);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, ui.px(spacing::hair)});
}

void end_list(const Ui& ui) {
    shade_edges(ui);
    ImGui::PopStyleVar();
    compat::end_child();
}

bool is_exercise(const CatalogueEntry& entry) { return entry.number > 0; }

// The anchor of the first scene, else of the first lecture; empty: none.
std::string first_of_right_list(const std::vector<CatalogueEntry>& listed,
                                const std::vector<CatalogueEntry>& lectures) {
    const auto scene = std::find_if_not(listed.begin(), listed.end(), is_exercise);
    if (scene != listed.end()) return row_anchor(*scene);
    return lectures.empty() ? std::string{} : row_anchor(lectures.front());
}

// Left of the scenes and lectures are the exercises.
void leave_right_list(const std::vector<CatalogueEntry>& listed, Ui& ui) {
    if (!ui.keyboard || !ui.keyboard->focus.starts_with("open.") || !take(*ui.keyboard, key::left)) return;
    const auto exercise = std::find_if(listed.begin(), listed.end(), is_exercise);
    if (exercise == listed.end()) return;
    ui.keyboard->focus = "gallery." + exercise->name;
    ui.keyboard->revealed = true;
}

void list_heading(Ui& ui, std::string_view key) {
    subheading(ui, ui.strings(key));
    gap(ui, 12);  // room for the focus ring of the first row
}

void shipped_row(const LabView& view, const CatalogueEntry& entry, FileRow row, FilesState& files, Ui& ui) {
    row.id = row_anchor(entry);
    if (list_row(view, ui, row, ui.strings("files.open_how"))) request_file(view, files, ui, OpenRequest{entry.path});
    if (row.current && !files.begun) ImGui::SetScrollHereY();
}

void shipped_scenes(const LabView& view, const std::vector<CatalogueEntry>& listed, FilesState& files, Ui& ui) {
    if (std::all_of(listed.begin(), listed.end(), is_exercise)) return;
    list_heading(ui, "open.scenes");
    for (const CatalogueEntry& entry : listed) {
        if (is_exercise(entry)) continue;
        FileRow row;
        row.words = exercise_words(view, ui, entry), row.below = told_of(view, ui, entry), row.is_story = true;
        row.current = entry.name == view.documents.opened, row.path = entry.path;
        shipped_row(view, entry, std::move(row), files, ui);
    }
    gap(ui, 8);
}

void shipped_lectures(const LabView& view, const std::vector<CatalogueEntry>& listed, FilesState& files, Ui& ui) {
    if (listed.empty()) return;
    list_heading(ui, "open.lectures");
    for (const CatalogueEntry& entry : listed) {
        FileRow row;
        row.icon = icon::play;
        row.current = view.pages && entry.path == view.pages->lecture->path.string();
        row.words = translated(ui, entry.title);
        shipped_row(view, entry, std::move(row), files, ui);
    }
    gap(ui, 8);
}

// The entries with the words of the search.
std::vector<CatalogueEntry> found(const LabView& view, const Ui& ui, const std::vector<CatalogueEntry>* all,
                                  const std::string& search) {
    std::vector<CatalogueEntry> listed;
    if (all)
        for (const CatalogueEntry& entry : *all)
            if (search.empty() || matches(view, ui, entry, search)) listed.push_back(entry);
    return listed;
}

bool is_shown(const FilesState& files, const FileEntry& entry) {
    if (entry.is_folder) return true;
    return files.saving ? entry.kind == files.kind : !files.only || *files.only == entry.kind;
}

std::string_view tooltip_key(const FilesState& files, const FileEntry& entry) {
    if (entry.is_folder) return "files.folder_how";
    if (files.saving) return "files.take_name";
    return entry.broken ? "files.broken_how" : "files.open_how";
}

}  // namespace

void begin_files(FilesState& files, bool saving, FileKind kind) {
    files.saving = saving;
    files.kind = kind;
    files.begun = files.asked = false;
    files.typed = files.title = files.story = {};
    files.search.clear();
    files.searched.clear();
    files.replacing.clear();
    files.creating.clear();
}

std::string_view kind_key(FileKind kind) {
    constexpr std::array<std::string_view, file_kinds> keys{
        "files.scene", "files.exercise", "files.brain", "files.run", "files.lecture", "files.study", "files.breeding"};
    return keys[static_cast<std::size_t>(kind)];
}

bool search_by_typing(FilesState& files, KeyPress press) {
    constexpr std::size_t longest = 40;
    if (files.saving || files.place != FilesPlace::shipped) return false;
    if (press.ctrl && press.key == 'A') return files.search_selected = !files.search.empty();
    if (press.ctrl) return false;
    if (press.key == key::escape || press.key == key::backspace) {
        if (files.search.empty()) return false;
        const bool all = std::exchange(files.search_selected, false) || press.key == key::escape;
        all ? files.search.clear() : files.search.pop_back();
        return true;
    }
    const bool is_space = press.key == ' ' && !files.search.empty();
    if (!is_space && (press.key <= ' ' || press.key > '~')) return false;
    const char typed = static_cast<char>(press.key);
    if (std::exchange(files.search_selected, false)) files.search.clear();
    if (files.search.size() < longest)
        files.search += typed >= 'A' && typed <= 'Z' && !press.shift ? static_cast<char>(typed - 'A' + 'a') : typed;
    return true;
}

std::string recent_words(const LabView& view, const Ui& ui, const std::vector<RecentFile>& all, const RecentFile& file,
                         float width) {
    std::string name = without_folder(file.path);
    if (hides_titles(view)) {
        const std::string number = std::to_string(std::find(all.begin(), all.end(), file) - all.begin() + 1);
        const std::string title = known_title(view, ui, file.title);
        return shortened(ui, title.empty() ? fill(ui.strings("open.file"), {number}) : title, Face::text, width);
    }
    const std::string title = file.title.empty() ? std::string{} : known_title(view, ui, file.title);
    if (title.empty()) return shortened(ui, name, Face::text, width);
    const auto same = [&](const RecentFile& other) { return other.title == file.title; };
    if (std::count_if(all.begin(), all.end(), same) < 2) return shortened(ui, title, Face::text, width);
    const bool is_ambiguous = std::count_if(all.begin(), all.end(), [&](const RecentFile& other) {
                                  return same(other) && without_folder(other.path) == name;
                              }) > 1;
    if (is_ambiguous) name = without_folder(folder_of(file.path)) + "/" + name;
    const std::string apart = " (" + name + ")";
    const float room = width - text_width(ui, Face::text, apart);
    if (room < width / 4) return shortened(ui, name, Face::text, width);
    return shortened(ui, title, Face::text, room) + apart;
}

void request_file(const LabView& view, FilesState& files, Ui& ui, Request request) {
    ui.outbox.push_back(std::move(request));
    files.asked = true;
    files.done = view.documents.files ? view.documents.files->done : 0;
}

std::string chapter_title(const Ui& ui, int chapter) {
    const std::string number = std::to_string(chapter);
    return number + " · " + std::string(ui.strings.find("chapter." + number, ui.strings("chapter.other")));
}

bool finds_shipped(const LabView& view, const Ui& ui, const std::string& search) {
    const std::string plain = plain_letters(search, Umlauts::as_vowels);
    return !found(view, ui, view.documents.catalogue, plain).empty() ||
           !found(view, ui, view.documents.lectures, plain).empty();
}

// Exercises on the left, scenes and lectures on the right. Each list scrolls; if one is empty, the other one has the
// whole width. A narrow sheet has one list of all.
void list_shipped(const LabView& view, FilesState& files, Ui& ui, float bottom) {
    search_row(view, files, ui);
    const std::string search = plain_letters(files.search, Umlauts::as_vowels);
    const std::vector<CatalogueEntry> listed = found(view, ui, view.documents.catalogue, search),
                                      lectures = found(view, ui, view.documents.lectures, search);
    const bool is_new = std::exchange(files.searched, files.search) != files.search;
    if (listed.empty() && lectures.empty()) {
        begin_list(files, ui, "no match", bottom);
        if (!search.empty())
            paragraph(ui, fill(ui.strings("files.no_match"), {std::string(ui.strings("files.folder"))}),
                      ui.palette.second_text);
        return end_list(ui);
    }
    if (ui.keyboard && is_new && !search.empty()) focus_best_hit(view, ui, listed, lectures, search, *ui.keyboard);
    constexpr float exercises_share = 0.66f;  // of the width
    constexpr float two_lists = 560;          // at least, layout pixels
    const auto exercises = std::count_if(listed.begin(), listed.end(), is_exercise);
    const bool has_others = exercises < std::ssize(listed) || !lectures.empty(), has_both = exercises > 0 && has_others;
    const bool is_one_list = has_both && card_width(ui) < ui.px(two_lists);
    const float between = ui.px(12), all = card_width(ui), left = (all - between) * exercises_share;
    const std::string before = files.listed;  // both lists are of one place
    leave_right_list(listed, ui);
    if (exercises > 0) {
        begin_list(files, ui, "shipped", bottom, "exercises", has_both && !is_one_list ? left : all);
        list_heading(ui, "open.exercises");
        exercise_gallery(view, listed, first_of_right_list(listed, lectures), files, ui);
        if (is_one_list) shipped_scenes(view, listed, files, ui), shipped_lectures(view, lectures, files, ui);
        end_list(ui);
    }
    if (is_one_list) return;
    if (has_both) ImGui::SameLine(0, between), files.listed = before;
    if (has_others) {
        begin_list(files, ui, "shipped", bottom, "scenes", has_both ? all - between - left : all);
        shipped_scenes(view, listed, files, ui);
        shipped_lectures(view, lectures, files, ui);
        end_list(ui);
    }
}

void list_recent(const LabView& view, FilesState& files, Ui& ui, float bottom) {
    begin_list(files, ui, "recent", bottom);
    int number = 0;
    if (view.documents.recent)
        for (const RecentFile& file : *view.documents.recent)
            if (list_row(
                    view, ui,
                    {"recent." + std::to_string(++number),
                     recent_words(view, ui, *view.documents.recent, file, card_width(ui) - ui.px(row_picture + 60)),
                     hides_titles(view) ? std::string{} : file.path, "", icon::file, false, false, file.path},
                    ui.strings("files.open_how")))
                request_file(view, files, ui, OpenRequest{file.path});
    if (number == 0) paragraph(ui, ui.strings("files.no_recent"), ui.palette.second_text);
    end_list(ui);
}

void list_folder(const LabView& view, FilesState& files, Ui& ui, float bottom) {
    const FolderListing& listing = view.documents.files->listing;
    begin_list(files, ui, listing.folder, bottom);
    const std::string up = folder_of(listing.folder), below = listing.folder == "/" ? "/" : listing.folder + "/";
    const bool has_folders = !files.saving || !view.program.uploads;  // a download has none
    if (has_folders && listing.folder != "/" &&
        list_row(view, ui, {"file.up", "..", "", std::string(ui.strings("files.up")), icon::folder}, up))
        ui.outbox.push_back(BrowseRequest{up});
    bool any = false;
    std::array<int, file_kinds> numbers{};  // of files so far, by kind
    for (const FileEntry& entry : listing.entries) {
        if (!is_shown(files, entry) || (entry.is_folder && !has_folders)) continue;
        any = true;
        FileRow row{"file." + entry.name, entry.name, "", "", entry.is_folder ? icon::folder : icon::file};
        if (!entry.is_folder && hides_titles(view))
            row.words = std::string(ui.strings(kind_key(entry.kind))) + " " +
                        std::to_string(++numbers[static_cast<std::size_t>(entry.kind)]);
        if (!entry.is_folder) row.aside = ui.strings(entry.broken ? "files.broken" : kind_key(entry.kind));
        const bool has_scene = entry.kind == FileKind::scene || entry.kind == FileKind::exercise;
        if (!entry.is_folder && !entry.broken && has_scene && !files.saving) row.path = below + entry.name;
        if (entry.broken) row.icon = icon::warning, row.broken = true;
        if (!list_row(view, ui, row, ui.strings(tooltip_key(files, entry)))) continue;
        if (entry.is_folder)
            ui.outbox.push_back(BrowseRequest{below + entry.name});
        else if (files.saving)
            files.typed.text = entry.name;
        else
            request_file(view, files, ui, OpenRequest{below + entry.name});
    }
    if (!listing.problem.empty())
        paragraph(ui, fill(ui.strings("files.cannot_open"), {listing.problem}), ui.palette.text);
    const bool has_files = std::any_of(listing.entries.begin(), listing.entries.end(),
                                       [](const FileEntry& entry) { return !entry.is_folder; });
    if (!any && listing.problem.empty())
        paragraph(ui, ui.strings(has_files ? "files.none_of_kind" : "files.nothing"), ui.palette.second_text);
    end_list(ui);
}

}  // namespace braitenlab::ui
