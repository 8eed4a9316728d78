#!/bin/bash
# Dear ImGui 1.90.1, the version of Debian 13: SetKeyboardFocusHere() does not reach a text field of a child window.
#
# Guess before the first run: a field of a child window gets the keyboard as one of its parent does, a frame after the call, as in 1.86.
# Seen: it never gets it, also if it is asked for in each frame, because the request is looked for in the scope of the window that
# has the focus, and SetKeyboardFocusHere() makes the child the window of navigation but not its scope. SetWindowFocus() before
# the call does. No assertion says so. 1.90.2 corrects it ("different scope"); 1.86 and 1.92.2b give the keyboard.
set -euo pipefail
dir=$(mktemp -d) && trap 'rm -rf "$dir"' EXIT && cd "$dir"

# expect WHAT SEEN WANTED: a difference means that the behaviour has changed.
expect() {
    printf '%-58s %s\n' "$1" "$2"
    [ "$2" = "$3" ] || { echo "changed: it was $3"; exit 1; }
}

# The source package of Debian 13, from the mirror that the system's packages come from.
mirror=$(apt-get indextargets --format '$(ORIGIN) $(REPO_URI) $(COMPONENT)' 'Created-By: Packages' |
    sed -n 's/^Debian \(.*\) main$/\1/p' | grep -v security | sort -u | head -n 1)
python3 -c 'import sys, urllib.request as u; u.urlretrieve(sys.argv[1] + "/pool/main/i/imgui/imgui_1.90.1+ds.orig.tar.xz", "source.tar.xz")' \
    "${mirror%/}"
mkdir imgui && tar -xf source.tar.xz -C imgui --strip-components=1
cat > ask.cpp <<'CODE'
#include <cstdio>
#include <cstring>
#include "imgui.h"
// ask PLACE HOW: 1 if the field has the keyboard after six frames in which it is asked for.
int main(int, char** argument) {
    const bool in_child = !std::strcmp(argument[1], "child"), focus = !std::strcmp(argument[2], "focus");
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr, io.DisplaySize = {400, 300}, io.DeltaTime = 1 / 60.0f;
    unsigned char* pixels;
    int width, height;
    io.Fonts->GetTexDataAsAlpha8(&pixels, &width, &height);
    char text[8] = "";
    bool active = false;
    for (int frame = 0; frame < 8; ++frame) {
        ImGui::NewFrame();
        ImGui::Begin("window");
        if (in_child) ImGui::BeginChild("part");
        if (frame > 1 && !active && focus) ImGui::SetWindowFocus();
        if (frame > 1 && !active) ImGui::SetKeyboardFocusHere();
        ImGui::InputText("field", text, sizeof text);
        active = ImGui::IsItemActive();
        if (in_child) ImGui::EndChild();
        ImGui::End();
        ImGui::Render();
    }
    std::printf("%d\n", active);
}
CODE
for unit in imgui/imgui.cpp imgui/imgui_draw.cpp imgui/imgui_tables.cpp imgui/imgui_widgets.cpp ask.cpp; do
    printf '%s\n' "$unit"
done | xargs -P "$(nproc)" -I UNIT g++ -std=c++17 -O0 -w -I imgui -c UNIT
g++ ./*.o -o ask
echo "Dear ImGui $(sed -n 's/^#define IMGUI_VERSION  *"\(.*\)"/\1/p' imgui/imgui.h)"
expect "a field of a window has the keyboard" "$(./ask window plain)" 1
expect "a field of a child window has the keyboard" "$(./ask child plain)" 0
expect "  after SetWindowFocus()" "$(./ask child focus)" 1
