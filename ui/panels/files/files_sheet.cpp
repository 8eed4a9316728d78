// The file browser, for opening and for saving: shipped files, recent files and folders.
#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <imgui.h>

#include "ui/imgui_compat.h"
#include "ui/panels/exercise_names.h"
#include "ui/panels/files/file_lists.h"
#include "ui/panels/panels.h"
#include "ui/panels/sheets.h"
#include "ui/widgets/button.h"
#include "ui/widgets/card.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/theme.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

namespace {

// Layout pixels. `taken`: height of the sheet's heading, buttons and least margin.
constexpr float sheet_width = 680, gallery_width = 1280, body_height = 490, gallery_height = 720,
                least_body_height = 200, taken = 170;

// The existing file with the typed name, which saving would replace, or null. "scene" also matches "scene.toml".
const FileEntry* existing_file(const FilesState& files, const FolderListing& listing) {
    for (const FileEntry& entry : listing.entries)
        if (entry.name == files.typed.text || entry.name == files.typed.text + ".toml" ||
            entry.name == files.typed.text + ".run")
            return &entry;
    return nullptr;
}

// The text of a field of a scene where it differs from the text shown in the lab.
std::optional<std::string> changed_text(const FilesState& files, const TextField& field, std::string_view shown) {
    if (files.kind != FileKind::scene || field.text == shown) return {};
    return field.text;
}

// True if the last save was refused because the folder in the name does not exist; the next one creates it.
bool asks_for_folder(const LabView& view, const FilesState& files) {
    return view.documents.files && files.asked && !view.documents.files->new_folder.empty() &&
           files.creating == files.typed.text;
}

void save_file(const LabView& view, FilesState& files, Ui& ui) {
    if (files.typed.text.empty()) return;
    const FileEntry* there = existing_file(files, view.documents.files->listing);
    if (there && there->is_folder) {
        ui.outbox.push_back(BrowseRequest{files.typed.text});
        files.typed.text.clear();
    } else if (there && files.replacing != files.typed.text) {
        files.replacing = files.typed.text;
    } else {
        const bool create = asks_for_folder(view, files);
        files.creating = files.typed.text;
        const Scene& scene = *view.now->scene;
        request_file(
            view, files, ui,
            SaveRequest{files.typed.text, files.kind, changed_text(files, files.title, translated(ui, scene.title)),
                        create, changed_text(files, files.story, translated(ui, scene.story))});
    }
}

// A search that is a path: the field of the path goes on with it.
void take_typed_path(const LabView& view, FilesState& files, Ui& ui) {
    const bool is_path = files.search.find_first_of("/\\") != std::string::npos;
    if (files.saving || files.place != FilesPlace::shipped || !view.documents.files || !is_path) return;
    files.place = FilesPlace::folder;
    files.typed.text = std::exchange(files.search, {});
    files.typed.at_end = true;
    ui.outbox.push_back(BrowseRequest{});
    if (ui.keyboard) ui.keyboard->focus = "files.path", ui.keyboard->revealed = true;
}

// Opens what is typed. A word that is no file of the folder is searched for among what ships, if it is found there.
void open_typed(const LabView& view, FilesState& files, Ui& ui) {
    const std::string& typed = files.typed.text;
    const bool is_word = typed.find_first_of("/\\") == std::string::npos;
    if (!is_word || existing_file(files, view.documents.files->listing) || !finds_shipped(view, ui, typed))
        return request_file(view, files, ui, OpenRequest{typed});
    files.place = FilesPlace::shipped;
    files.search = std::exchange(files.typed, {}).text;
    files.asked = false;
}

// The part above the list: the place to open from, or kind and name to save.
void opening_head(const LabView& view, FilesState& files, Ui& ui) {
    const std::array<std::string_view, 3> places{ui.strings("files.shipped"), ui.strings("files.recent"),
                                                 ui.strings("files.folder")};
    const int clicked = segments(ui, "files.place", places, static_cast<int>(files.place), card_width(ui),
                                 ui.strings("files.place_how"));
    if (clicked >= 0) files.place = static_cast<FilesPlace>(clicked);
    if (clicked == static_cast<int>(FilesPlace::folder)) ui.outbox.push_back(BrowseRequest{});
    if (files.place != FilesPlace::folder || !view.documents.files) return;
    files.typed.is_masked = hides_titles(view);
    text_field(ui, files.typed, "files.path", card_width(ui), ui.strings("files.path"), ui.strings("files.path_how"));
    if (files.typed.entered) open_typed(view, files, ui);
    std::vector<std::string_view> kinds{ui.strings("files.all")};
    for (int kind = 0; kind < file_kinds; ++kind) kinds.push_back(ui.strings(kind_key(static_cast<FileKind>(kind))));
    const int only = segments(ui, "files.only", kinds, files.only ? static_cast<int>(*files.only) + 1 : 0,
                              card_width(ui), ui.strings("files.only_how"));
    if (only == 0) files.only.reset();
    if (only > 0) files.only = static_cast<FileKind>(only - 1);
}

// A text field with its name to the left. All texts are string keys; `anchor` is an anchor.
void named_field(Ui& ui, std::string_view name, TextField& field, std::string_view anchor, std::string_view what,
                 std::string_view how) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    float aside = 0;
    for (const char* each : {"files.name_label", "files.title", "files.story"})
        aside = std::max(aside, text_width(ui, Face::text, ui.strings(each)) + ui.px(12));
    put(ui, {at.x, at.y + (ui.px(ui.tall(button_height)) - line_height(ui, Face::text)) / 2}, ui.strings(name),
        ui.palette.second_text);
    ImGui::SetCursorScreenPos({at.x + aside, at.y});
    text_field(ui, field, anchor, card_width(ui) - aside, ui.strings(what), ui.strings(how));
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
    named_field(ui, "files.name_label", files.typed, "files.path", "files.name", "files.path_how");
    if (files.kind == FileKind::scene) {
        named_field(ui, "files.title", files.title, "files.title", "files.title_empty", "files.title_how");
        named_field(ui, "files.story", files.story, "files.story", "files.story_empty", "files.story_how");
    }
    if (files.typed.text != files.replacing) files.replacing.clear();
    if (files.typed.entered || files.title.entered || files.story.entered) save_file(view, files, ui);
}

// The reason why the file cannot be opened or saved yet; empty if it can.
std::string problem(const LabView& view, const FilesState& files, const Ui& ui) {
    if (!files.replacing.empty()) {
        const FileEntry* there = existing_file(files, view.documents.files->listing);
        return fill(ui.strings(there && there->comments ? "files.replace_comments" : "files.replace"),
                    {there ? there->name : files.replacing});
    }
    if (asks_for_folder(view, files)) return fill(ui.strings("files.no_folder"), {view.documents.files->new_folder});
    const bool is_refused = files.asked && view.documents.files && view.documents.files->refused;
    return is_refused ? text_of(*view.documents.files->refused, ui.strings) : std::string();
}

// Height of a paragraph with the gap above it, window pixels.
float paragraph_height(const Ui& ui, const std::string& words) {
    if (words.empty()) return 0;
    compat::push_font(font(ui, Face::text));
    const float height = ImGui::CalcTextSize(words.c_str(), nullptr, false, card_width(ui)).y;
    ImGui::PopFont();
    return height + ImGui::GetStyle().ItemSpacing.y;
}

void file_buttons(const LabView& view, PanelState& state, Ui& ui) {
    FilesState& files = state.sheets.files;
    const bool typing = files.saving || files.place == FilesPlace::folder;
    if (typing) {
        const std::string_view words = ui.strings(!files.saving                  ? "files.open"
                                                  : !files.replacing.empty()     ? "files.replace_it"
                                                  : asks_for_folder(view, files) ? "files.create_it"
                                                                                 : "files.save");
        ButtonLook look{{}, words, Emphasis::primary};
        look.enabled = !files.typed.text.empty();
        const bool pressed =
            push_button(ui, "files.do", look, ui.strings(files.saving ? "files.save_how" : "files.open_how"),
                        key_name({key::enter}, ui.strings));
        if (pressed && files.saving) save_file(view, files, ui);
        if (pressed && !files.saving) open_typed(view, files, ui);
        ImGui::SameLine(0, ui.px(spacing::small));
    }
    if (view.program.uploads && !files.saving) {
        if (push_button(ui, "files.upload", {{}, ui.strings("files.upload")}, ui.strings("files.upload_how"))) {
            ui.outbox.push_back(UploadRequest{});
            state.sheet = Sheet::none;
        }
        ImGui::SameLine(0, ui.px(spacing::small));
    }
    if (push_button(ui, "files.cancel", {{}, ui.strings("files.cancel")}, ui.strings("files.cancel_how"),
                    key_name({key::escape}, ui.strings)))
        state.sheet = Sheet::none;
}

bool is_exercise(const LabView& view, const std::string& name) {
    return view.documents.catalogue &&
           std::any_of(view.documents.catalogue->begin(), view.documents.catalogue->end(),
                       [&](const CatalogueEntry& each) { return each.number > 0 && each.name == name; });
}

// The initial focus: the text field, or the row of the open file.
void first_focus(const LabView& view, FilesState& files, Ui& ui) {
    if (files.begun || !ui.keyboard) return;
    files.begun = true;
    if (files.saving || files.place == FilesPlace::folder)
        ui.keyboard->focus = "files.path";
    else
        ui.keyboard->focus = (is_exercise(view, view.documents.opened) ? "gallery." : "open.") + view.documents.opened;
    ui.keyboard->revealed = true;
}

}  // namespace

void files_sheet(const LabView& view, PanelState& state, Ui& ui, Rect window) {
    FilesState& files = state.sheets.files;
    if (files.asked && view.documents.files && view.documents.files->done > files.done) {
        state.sheet = Sheet::none;
        return;
    }
    if (files.saving && !view.documents.files) return;
    if (!files.begun && files.saving) {
        files.typed.text = view.documents.files->suggested;
        files.title.text = translated(ui, view.now->scene->title);
        files.story.text = view.documents.files->ships ? std::string_view{} : translated(ui, view.now->scene->story);
        ui.outbox.push_back(BrowseRequest{});
    }
    take_typed_path(view, files, ui);
    const bool in_folder = files.saving || files.place == FilesPlace::folder;
    SheetState& sheet =
        open_sheet(state, ui, Sheet::files, window, ui.strings(files.saving ? "files.save_as" : "files.open"),
                   files.saving ? sheet_width : gallery_width);
    // The part above the buttons has the same height on every tab, so that the buttons do not move.
    const float body = std::clamp(window.h - ui.px(taken), ui.px(least_body_height),
                                  ui.px(files.saving ? body_height : gallery_height));
    float bottom = ImGui::GetCursorPosY() + body;
    if (files.saving)
        saving_head(view, files, ui);
    else
        opening_head(view, files, ui);
    const std::string wrong = problem(view, files, ui);
    bottom -= paragraph_height(ui, wrong);
    if (in_folder && view.documents.files) {
        paragraph(ui, view.program.uploads ? ui.strings("files.in_browser") : view.documents.files->listing.folder,
                  ui.palette.second_text, Face::small);
        list_folder(view, files, ui, bottom);
    } else if (files.place == FilesPlace::recent) {
        list_recent(view, files, ui, bottom);
    } else {
        list_shipped(view, files, ui, bottom);
    }
    if (!wrong.empty()) paragraph(ui, wrong, legible(ui.palette.warning, ui.palette.panel, ui.palette.text));
    sheet_buttons(ui, sheet);
    file_buttons(view, state, ui);
    first_focus(view, files, ui);
    if (end_sheet(sheet)) state.sheet = Sheet::none;
}

}  // namespace braitenlab::ui
