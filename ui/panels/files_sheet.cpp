// The window's own browser of files: what ships, what was open lately, and folders; for opening and for saving.
#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include <imgui.h>

#include "ui/imgui_compat.h"
#include "ui/panels/panels.h"
#include "ui/panels/translated.h"
#include "ui/strings.h"
#include "ui/theme.h"
#include "ui/widgets/button.h"
#include "ui/widgets/card.h"
#include "ui/widgets/item.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/sheet.h"

namespace braitenlab {

namespace {

// Layout pixels. `taken`: by the sheet's heading and buttons, and the least margin round it.
constexpr float sheet_width = 680, body_height = 490, least_body = 200, least_list = 80, taken = 170;

std::string_view kind_key(FileKind kind) {
    constexpr std::array<std::string_view, file_kinds> keys{"files.scene", "files.exercise", "files.brain",
                                                            "files.run"};
    return keys[static_cast<std::size_t>(kind)];
}

std::string file_name(const std::string& path) { return path.substr(path.find_last_of('/') + 1); }
std::string folder_of(const std::string& path) {
    return path.substr(0, std::max<std::size_t>(1, path.find_last_of('/')));
}

// A row of the list: an icon, what it is called, what more there is to say below or at the right end.
struct Row {
    std::string id, words, below, aside;
    std::string_view icon;
    bool current = false, broken = false;
};

bool list_row(Ui& ui, const Row& row, std::string_view how) {
    const float height =
        line_height(ui, Face::text) + (row.below.empty() ? 0 : line_height(ui, Face::small)) + ui.px(12);
    const Item at = item(ui, row.id, {card_width(ui), height});
    fill_box(ui, at.rect, ui.palette.line.with_alpha(std::max(0.6f * at.warmth, at.focused ? 0.6f : 0.0f)));
    if (row.current)
        fill_box(ui, {at.rect.x, at.rect.y + ui.px(6), ui.px(3), height - ui.px(12)}, ui.palette.accent, 2);
    const Palette& p = ui.palette;
    const Colour quiet = row.broken ? legible(p.warning, p.panel, p.text) : p.second_text;
    float x = at.rect.x + ui.px(12);
    const float y = at.rect.y + ui.px(5);
    if (!row.icon.empty() && has_icons(ui)) {
        put_icon(ui, {x + ui.px(7), y + line_height(ui, Face::text) / 2}, row.icon, quiet);
        x += ui.px(26);
    }
    const float aside = text_width(ui, Face::small, row.aside);
    put_right(ui, {at.right() - ui.px(12), y + ui.px(2)}, row.aside, quiet, Face::small);
    const float room = at.right() - ui.px(20) - x - (aside > 0 ? aside + ui.px(12) : 0);
    const std::string words = shortened(ui, row.words, Face::strong, room);
    const std::string below = shortened(ui, row.below, Face::small, at.right() - ui.px(12) - x);
    put(ui, {x, y}, words, ui.palette.text, Face::strong);
    put(ui, {x, y + line_height(ui, Face::text)}, below, ui.palette.second_text, Face::small);
    // What can be read in the row is not said again.
    tooltip(ui, at, below != row.below ? std::string_view(row.below) : words != row.words ? row.words : how);
    return at.pressed;
}

void ask(FilesState& files, const LabView& view, Ui& ui, Request request) {
    ui.outbox.push_back(std::move(request));
    files.asked = true;
    files.done = view.files ? view.files->done : 0;
}

// Down to where the sheet's buttons are, wherever it begins. `contents` names what is listed: another list starts at
// its top.
void begin_list(FilesState& files, Ui& ui, std::string_view contents, float bottom) {
    const float height = std::max(ui.px(least_list), bottom - ImGui::GetCursorPosY());
    compat::begin_child("list", {card_width(ui), height}, ImGuiWindowFlags_NoNav);
    if (files.listed != contents || !files.begun) files.listed = contents, ImGui::SetScrollY(0);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, ui.px(2)});
}

void end_list() {
    ImGui::PopStyleVar();
    ImGui::EndChild();
}

void shipped(const LabView& view, FilesState& files, Ui& ui, float bottom) {
    begin_list(files, ui, "shipped", bottom);
    for (const bool exercises : {true, false}) {
        subheading(ui, ui.strings(exercises ? "open.exercises" : "open.scenes"));
        if (view.catalogue)
            for (const CatalogueEntry& entry : *view.catalogue) {
                if ((entry.number > 0) != exercises) continue;
                const std::string title(translated(ui, entry.title));
                const std::string words = exercises ? std::to_string(entry.number) + "  " + title : title;
                const Row row{"open." + entry.name,     words, std::string(translated(ui, entry.story)), "", {},
                              entry.name == view.opened};
                if (list_row(ui, row, ui.strings("files.open_how"))) ask(files, view, ui, OpenRequest{entry.path});
                if (row.current && !files.begun) ImGui::SetScrollHereY();
            }
        gap(ui, 8);
    }
    end_list();
}

void recent(const LabView& view, FilesState& files, Ui& ui, float bottom) {
    begin_list(files, ui, "recent", bottom);
    int number = 0;
    if (view.recent)
        for (const std::string& path : *view.recent)
            if (list_row(ui, {"recent." + std::to_string(++number), file_name(path), folder_of(path), "", icon::file},
                         ui.strings("files.open_how")))
                ask(files, view, ui, OpenRequest{path});
    if (number == 0) paragraph(ui, ui.strings("files.no_recent"), ui.palette.second_text);
    end_list();
}

bool is_shown(const FilesState& files, const FileEntry& entry) {
    if (entry.is_folder) return true;
    return files.saving ? entry.kind == files.kind : !files.only || *files.only == entry.kind;
}

std::string_view use_of(const FilesState& files, const FileEntry& entry) {
    if (entry.is_folder) return "files.folder_how";
    if (files.saving) return "files.take_name";
    return entry.broken ? "files.broken_how" : "files.open_how";
}

void folder(const LabView& view, FilesState& files, Ui& ui, float bottom) {
    const FolderListing& listing = view.files->listing;
    begin_list(files, ui, listing.folder, bottom);
    const std::string up = folder_of(listing.folder), below = listing.folder == "/" ? "/" : listing.folder + "/";
    if (listing.folder != "/" &&
        list_row(ui, {"file.up", "..", "", std::string(ui.strings("files.up")), icon::folder}, up))
        ui.outbox.push_back(BrowseRequest{up});
    bool any = false;
    for (const FileEntry& entry : listing.entries) {
        if (!is_shown(files, entry)) continue;
        any = true;
        Row row{"file." + entry.name, entry.name, "", "", entry.is_folder ? icon::folder : icon::file};
        if (!entry.is_folder) row.aside = ui.strings(entry.broken ? "files.broken" : kind_key(entry.kind));
        if (entry.broken) row.icon = icon::warning, row.broken = true;
        if (!list_row(ui, row, ui.strings(use_of(files, entry)))) continue;
        if (entry.is_folder)
            ui.outbox.push_back(BrowseRequest{below + entry.name});
        else if (files.saving)
            files.typed.text = entry.name;
        else
            ask(files, view, ui, OpenRequest{below + entry.name});
    }
    if (!listing.problem.empty()) paragraph(ui, listing.problem, ui.palette.text);
    if (!any && listing.problem.empty()) paragraph(ui, ui.strings("files.nothing"), ui.palette.second_text);
    end_list();
}

// "scene.toml" for "scene" as well: what would be replaced, or null.
const FileEntry* in_the_way(const FilesState& files, const FolderListing& listing) {
    for (const FileEntry& entry : listing.entries)
        if (entry.name == files.typed.text || entry.name == files.typed.text + ".toml" ||
            entry.name == files.typed.text + ".run")
            return &entry;
    return nullptr;
}

void save(const LabView& view, FilesState& files, Ui& ui) {
    if (files.typed.text.empty()) return;
    const FileEntry* there = in_the_way(files, view.files->listing);
    if (there && there->is_folder) {
        ui.outbox.push_back(BrowseRequest{files.typed.text});
        files.typed.text.clear();
    } else if (there && files.replacing != files.typed.text) {
        files.replacing = files.typed.text;
    } else {
        ask(files, view, ui, SaveRequest{files.typed.text, files.kind});
    }
}

// Above the list: where from, or what to save and under which name.
void opening_head(const LabView& view, FilesState& files, Ui& ui) {
    const std::array<std::string_view, 3> places{ui.strings("files.shipped"), ui.strings("files.recent"),
                                                 ui.strings("files.folder")};
    const int clicked = segments(ui, "files.place", places, static_cast<int>(files.place), card_width(ui),
                                 ui.strings("files.place_how"));
    if (clicked >= 0) files.place = static_cast<FilesPlace>(clicked);
    if (clicked == static_cast<int>(FilesPlace::folder)) ui.outbox.push_back(BrowseRequest{});
    if (files.place != FilesPlace::folder || !view.files) return;
    text_field(ui, files.typed, "files.path", card_width(ui), ui.strings("files.path"), ui.strings("files.path_how"));
    if (files.typed.entered) ask(files, view, ui, OpenRequest{files.typed.text});
    std::vector<std::string_view> kinds{ui.strings("files.all")};
    for (int kind = 0; kind < file_kinds; ++kind) kinds.push_back(ui.strings(kind_key(static_cast<FileKind>(kind))));
    const int only = segments(ui, "files.only", kinds, files.only ? static_cast<int>(*files.only) + 1 : 0,
                              card_width(ui), ui.strings("files.only_how"));
    if (only == 0) files.only.reset();
    if (only > 0) files.only = static_cast<FileKind>(only - 1);
}

void saving_head(const LabView& view, FilesState& files, Ui& ui) {
    constexpr std::array<FileKind, 3> savable{FileKind::scene, FileKind::run, FileKind::brain};
    std::array<std::string_view, savable.size()> words{};
    int chosen = 0;
    for (std::size_t i = 0; i < savable.size(); ++i) {
        words[i] = ui.strings(kind_key(savable[i]));
        if (savable[i] == files.kind) chosen = static_cast<int>(i);
    }
    const int clicked = segments(ui, "files.kind", words, chosen, card_width(ui), ui.strings("files.kind_how"));
    if (clicked >= 0) files.kind = savable[static_cast<std::size_t>(clicked)];
    text_field(ui, files.typed, "files.path", card_width(ui), ui.strings("files.name"), ui.strings("files.path_how"));
    if (files.typed.text != files.replacing) files.replacing.clear();
    if (files.typed.entered) save(view, files, ui);
}

// What stands in the way, if anything does.
void trouble(const LabView& view, const FilesState& files, Ui& ui) {
    const Palette& p = ui.palette;
    const Colour colour = legible(p.warning, p.panel, p.text);
    if (!files.replacing.empty()) {
        const FileEntry* there = in_the_way(files, view.files->listing);
        paragraph(ui,
                  fill(ui.strings(there && there->comments ? "files.replace_comments" : "files.replace"),
                       {there ? there->name : files.replacing}),
                  colour);
    } else if (files.asked && view.files && !view.files->refused.empty()) {
        paragraph(ui, view.files->refused, colour);
    }
}

void buttons(const LabView& view, PanelState& state, Ui& ui) {
    FilesState& files = state.files;
    const bool typing = files.saving || files.place == FilesPlace::folder;
    if (typing) {
        const std::string_view words = ui.strings(!files.saving             ? "files.open"
                                                  : files.replacing.empty() ? "files.save"
                                                                            : "files.replace_it");
        ButtonLook look{{}, words, Emphasis::primary};
        look.enabled = !files.typed.text.empty();
        const Item at = button(ui, "files.do", look);
        tooltip(ui, at, ui.strings(files.saving ? "files.save_how" : "files.open_how"),
                key_name({key::enter}, ui.strings));
        if (at.pressed && files.saving) save(view, files, ui);
        if (at.pressed && !files.saving) ask(files, view, ui, OpenRequest{files.typed.text});
        ImGui::SameLine(0, ui.px(8));
    }
    const Item cancel = button(ui, "files.cancel", {{}, ui.strings("files.cancel")});
    tooltip(ui, cancel, ui.strings("files.cancel_how"), key_name({key::escape}, ui.strings));
    if (cancel.pressed) state.sheet = Sheet::none;
}

// The focus starts where a person will most likely go on.
void first_focus(const LabView& view, FilesState& files, Ui& ui) {
    if (files.begun || !ui.keyboard) return;
    files.begun = true;
    if (files.saving || files.place == FilesPlace::folder)
        ui.keyboard->focus = "files.path";
    else
        ui.keyboard->focus = "open." + view.opened;
    ui.keyboard->revealed = true;
}

}  // namespace

void begin_files(FilesState& files, bool saving, FileKind kind) {
    files.saving = saving;
    files.kind = kind;
    files.begun = files.asked = false;
    files.typed = {};
    files.replacing.clear();
}

void files_sheet(const LabView& view, PanelState& state, Ui& ui, Rect window) {
    if (state.sheet != Sheet::files) return;
    FilesState& files = state.files;
    if (files.asked && view.files && view.files->done > files.done) {
        state.sheet = Sheet::none;
        return;
    }
    if (files.saving && !view.files) return;
    if (!files.begun && files.saving) {
        files.typed.text = view.files->suggested;
        ui.outbox.push_back(BrowseRequest{});
    }
    const bool in_folder = files.saving || files.place == FilesPlace::folder;
    begin_sheet(ui, files.sheet, "card.open", ui.strings(files.saving ? "files.save_as" : "files.open"), sheet_width,
                window);
    // All that stands above the buttons is as high on every tab, so that no tab moves under the mouse.
    const float body = std::clamp(window.h - ui.px(taken), ui.px(least_body), ui.px(body_height));
    const float bottom = ImGui::GetCursorPosY() + body;
    if (files.saving)
        saving_head(view, files, ui);
    else
        opening_head(view, files, ui);
    if (in_folder && view.files) {
        paragraph(ui, view.files->listing.folder, ui.palette.second_text, Face::small);
        folder(view, files, ui, bottom);
    } else if (files.place == FilesPlace::recent) {
        recent(view, files, ui, bottom);
    } else {
        shipped(view, files, ui, bottom);
    }
    trouble(view, files, ui);
    sheet_buttons(ui, files.sheet);
    buttons(view, state, ui);
    first_focus(view, files, ui);
    if (end_sheet(files.sheet)) state.sheet = Sheet::none;
}

}  // namespace braitenlab
