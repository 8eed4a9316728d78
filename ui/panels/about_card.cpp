// The sheet about the program: its version, and the licences of the libraries and fonts that it uses.
#include <array>
#include <string_view>

#include <imgui.h>

#include "ui/panels/panels.h"
#include "ui/panels/sheets.h"
#include "ui/widgets/button.h"
#include "ui/widgets/card.h"
#include "ui/widgets/paint.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

namespace {

struct UsedWork {
    std::string_view name, licence;
};

// As their sources and their Debian packages (/usr/share/doc/PACKAGE/copyright) state.
constexpr std::array<UsedWork, 14> used_works{{{"Box2D", "MIT"},
                                               {"CLI11", "BSD-3-Clause"},
                                               {"Dear ImGui", "MIT"},
                                               {"fmt", "MIT"},
                                               {"Fontconfig", "HPND"},
                                               {"FreeType", "FreeType Licence"},
                                               {"GLEW", "BSD-3-Clause, MIT"},
                                               {"GLFW", "zlib"},
                                               {"JSON for Modern C++", "MIT"},
                                               {"oneTBB", "Apache 2.0"},
                                               {"stb", "MIT"},
                                               {"toml++", "MIT"},
                                               {"Fork Awesome", "OFL 1.1"},
                                               {"Noto Sans", "OFL 1.1"}}};

}  // namespace

void about_card(const LabView& view, PanelState& state, Ui& ui, Rect window) {
    SheetState& sheet = open_sheet(state, ui, Sheet::about, window, "Braitenlab");
    paragraph(ui, fill(ui.strings("about.version"), {view.program.version}), ui.palette.text);
    paragraph(ui, ui.strings("about.what"), ui.palette.text);
    paragraph(ui, ui.strings("about.licence"), ui.palette.text);
    gap(ui, 12);
    subheading(ui, ui.strings("about.libraries"));
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float width = card_width(ui), line = line_height(ui, Face::text) + ui.px(4);
    float y = at.y;
    for (const UsedWork& work : used_works) {
        put(ui, {at.x, y}, work.name, ui.palette.text);
        put_right(ui, {at.x + width, y}, work.licence, ui.palette.second_text);
        y += line;
    }
    ImGui::Dummy({width, y - at.y});
    sheet_buttons(ui, sheet);
    const bool closed = close_button(ui, "about.close");
    if (end_sheet(sheet) || closed) state.sheet = Sheet::none;
}

}  // namespace braitenlab::ui
