// The sheet that exports the selected vehicle's brain to a robot: which one, files or the reason against them, folder.
#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>

#include <imgui.h>

#include "ui/panels/panels.h"
#include "ui/panels/robots/robot_state.h"
#include "ui/panels/sheets.h"
#include "ui/widgets/button.h"
#include "ui/widgets/card.h"
#include "ui/widgets/item.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/theme.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

namespace {

// Layout pixels: of the body; what a sheet as high as the window has besides.
constexpr float robot_height = 440, around_body = 148;
struct RobotSheet {
    const LabView& view;
    PanelState& panels;
    RobotState& state;
    Ui& ui;

    std::string_view words(std::string_view key) const { return ui.strings(key); }
    std::string_view words_of(std::string_view stem) const {
        return words(std::string(stem) + std::string(state.robot->word()));
    }
    bool is_written() const { return state.asked && view.documents.files->done > state.done; }
    Colour warning_colour() const { return legible(ui.palette.warning, ui.palette.panel, ui.palette.text); }

    void make_files(const VehicleView& vehicle) const {
        const auto& brain = brain_of(*view.now, vehicle);
        if (state.made && state.brain == brain && state.robot_of_made == state.robot) return;
        state.brain = brain, state.robot_of_made = state.robot;
        const robots::BrainToExport exported = brain_to_export(view, vehicle);
        state.made = std::make_shared<const Result<std::vector<robots::ExportedFile>>>(
            robots::export_brain(exported, state.robot->target, *state.robot));
        state.warnings = *state.made ? robots::export_warnings(exported, *state.robot) : std::vector<Error>{};
    }

    void choice(const robots::Robot& robot) const {
        const std::string name(robot.word());
        if (!radio_row(ui, "robot.target." + name, words("robot.to_" + name), state.robot == &robot, true,
                       words("robot.target_how")))
            return;
        state.robot = &robot;
        state.asked = false;
        state.replacing.clear();
    }

    void targets() const {
        subheading(ui, words("robot.target"));
        ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, ui.px(spacing::tight)});
        for (const robots::Robot& robot : robots::robots().subspan(1)) choice(robot);
        choice(robots::robots().front());  // the C header is for those who know what to do with it
        ImGui::PopStyleVar();
        gap(ui, 8);
    }

    void files() const {
        subheading(ui, words("robot.files"));
        if (!*state.made) return paragraph(ui, text_of(state.made->error(), ui.strings), warning_colour());
        // In one paragraph, so that a sheet of several warnings has room for the folder.
        // A name stays in one line.
        std::string names, line;
        for (const robots::ExportedFile& file : **state.made) {
            const bool is_full =
                !line.empty() && text_width(ui, Face::text, line + ", " + file.name + ",") > card_width(ui);
            if (is_full) names += std::exchange(line, {}) + ",\n";
            line += (line.empty() ? "" : ", ") + file.name;
        }
        paragraph(ui, names + line, ui.palette.text);
        for (const Error& warning : state.warnings) {
            gap(ui, 8);
            paragraph(ui, text_of(warning, ui.strings), warning_colour());
        }
    }

    void folder() const {
        gap(ui, 8);
        subheading(ui, words("robot.folder"));
        text_field(ui, state.folder, "robot.folder", card_width(ui), suggested_folder(view, *state.robot),
                   words("robot.folder_how"));
        const bool is_path =
            std::filesystem::path(state.folder.text).is_absolute() || state.folder.text.starts_with('~');
        if (view.program.uploads || !is_path)
            paragraph(ui, view.program.uploads ? words("robot.downloads") : view.documents.files->listing.folder,
                      ui.palette.second_text, Face::small);
    }

    // Why the files were not written; empty: nothing is wrong.
    std::string problem() const {
        const bool is_refused = state.asked && !is_written() && view.documents.files->refused;
        return is_refused ? text_of(*view.documents.files->refused, ui.strings) : std::string();
    }

    void written() const {
        gap(ui, 8);
        paragraph(ui, fill(words("robot.written"), {view.documents.files->exported_to}), ui.palette.text);
        gap(ui, 8);
        paragraph(ui, words_of("robot.next_"), ui.palette.second_text);
    }

    std::string wanted_folder() const {
        return state.folder.text.empty() ? suggested_folder(view, *state.robot) : state.folder.text;
    }
    // The last request was refused because files of it exist, and the next one replaces them.
    bool replaces() const { return state.asked && view.documents.files->refused && state.replacing == wanted_folder(); }

    void write() const {
        const bool replace = replaces();
        state.replacing = wanted_folder();
        state.asked = true;
        state.done = view.documents.files->done;
        // The files are a part of `made`, which stays alive with them.
        ui.outbox.push_back(WriteFilesRequest{
            wanted_folder(), std::shared_ptr<const std::vector<robots::ExportedFile>>(state.made, &**state.made),
            replace});
    }

    void buttons() const {
        if (is_written()) {
            const Item close = button(ui, "robot.close", {{}, words("robot.close"), Emphasis::primary});
            if (close.pressed) panels.sheet = Sheet::none;
            if (view.program.uploads) return;  // a browser has downloaded the files
            ImGui::SameLine(0, ui.px(spacing::small));
            if (push_button(ui, "robot.open_folder", {{}, words("robot.open_folder")}, words("robot.open_folder_how"),
                            ""))
                ui.outbox.push_back(OpenFolderRequest{view.documents.files->exported_to});
            return;
        }
        ButtonLook look{{}, words(replaces() ? "robot.replace" : "robot.export"), Emphasis::primary};
        look.enabled = static_cast<bool>(*state.made);
        const bool yes =
            push_button(ui, "robot.export", look, words("robot.export_how"), key_name({key::enter}, ui.strings));
        if (look.enabled && (yes || state.folder.entered)) write();
        ImGui::SameLine(0, ui.px(spacing::small));
        if (push_button(ui, "robot.cancel", {{}, words("files.cancel")}, words("robot.cancel_how"),
                        key_name({key::escape}, ui.strings)))
            panels.sheet = Sheet::none;
    }
};

// True if the file has this brain, of a kind or of a vehicle, or if the file is unknown.
bool is_in_file(const LabView& view, const BrainGraph& brain) {
    if (!view.file) return true;
    const auto is_same = [&](const auto& owner) { return owner.brain == brain; };
    return std::any_of(view.file->kinds.begin(), view.file->kinds.end(), is_same) ||
           std::any_of(view.file->starts.begin(), view.file->starts.end(), is_same) ||
           std::any_of(view.file->members.begin(), view.file->members.end(), is_same);
}

// As braitenctl names what it exports: by the file.
const std::string& name_of_file(const LabView& view) {
    return view.documents.files ? view.documents.files->suggested : view.documents.opened;
}

}  // namespace

void begin_robot(RobotState& state) {
    state.begun = state.asked = false;
    state.replacing.clear();
    state.folder.text.clear();
    state.made.reset();
}

robots::BrainToExport brain_to_export(const LabView& view, const VehicleView& vehicle) {
    const Kind& kind = kind_of(*view.now, vehicle);
    const BrainGraph& brain = *brain_of(*view.now, vehicle);
    const std::string changed = is_in_file(view, brain) ? "" : ", changed";
    const std::string& file = name_of_file(view);
    return {(file.empty() ? view.now->scene->title : file) + ", " + kind.name + changed,
            brain,
            kind.sensors,
            kind.body.length,
            kind.body.width,
            view.now->scene->arena.ambient,
            view.now->scene->arena.lux};
}

std::string suggested_folder(const LabView& view, const robots::Robot& robot) {
    const std::string& name = name_of_file(view);
    return (name.empty() ? "robot" : name) + "-" + std::string(robot.word());
}

void robot_sheet(const LabView& view, PanelState& panels, Ui& ui, Rect window) {
    RobotState& state = panels.sheets.robot;
    const VehicleView* vehicle = selected_vehicle(view);
    if (!view.documents.files || !vehicle) {
        panels.sheet = Sheet::none;
        return;
    }
    if (!state.begun) ui.outbox.push_back(BrowseRequest{});
    const RobotSheet parts{view, panels, state, ui};
    parts.make_files(*vehicle);
    SheetState& sheet = open_sheet(panels, ui, Sheet::robot, window);
    const float bottom =
        ImGui::GetCursorPosY() + std::min(ui.px(robot_height), window.h - ui.px(around_body)) - sheet.footer;
    if (!parts.is_written()) parts.targets();
    parts.files();
    parts.is_written() ? parts.written() : parts.folder();
    if (!parts.is_written() && ImGui::GetCursorPosY() < bottom) ImGui::Dummy({1, bottom - ImGui::GetCursorPosY()});
    sheet_buttons(ui, sheet, parts.problem());
    parts.buttons();
    if (!state.begun && ui.keyboard)
        ui.keyboard->focus = "robot.target." + std::string(state.robot->word()), ui.keyboard->revealed = true;
    state.begun = true;
    if (end_sheet(sheet)) panels.sheet = Sheet::none;
}

}  // namespace braitenlab::ui
