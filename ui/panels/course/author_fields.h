// Fields that the pages of the author's sheet share, and the pages in author_goals.cpp.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "ui/panels/panels.h"
#include "ui/widgets/record_fields.h"
#include "ui/widgets/ui.h"

namespace braitenlab::ui {

struct AuthorFields {
    const LabView& view;
    PanelState& panels;
    AuthorState& state;
    Ui& ui;

    const Scene& scene() const { return *view.now->scene; }
    std::string_view words(std::string_view key) const { return ui.strings(key); }

    // A heading and a text field below it, which shows the hint `how` while it is empty.
    void field(std::string_view name, TextField&, std::string_view id, std::string_view how) const;
    // Switches side by side, wrapped at the sheet's edge: `x` is the end of the one before, 0 for the first. True if
    // pressed.
    bool toggle(const std::string& id, std::string_view label, bool on, std::string_view how, float& x) const;
    // One of several names; the index pressed, or −1.
    int choice(const std::string& id, const std::vector<std::string>& names, std::string_view chosen,
               std::string_view how) const;
    // A slider; its value after this frame.
    float number(const std::string& id, std::string_view label, std::string_view how, float value,
                 const NumberField&) const;
};

void author_steps_page(const AuthorFields&);       // goals, graded runs
void author_prediction_page(const AuthorFields&);  // question, answers, what the run shows
void author_wrong_page(const AuthorFields&);       // brains that must fail

}  // namespace braitenlab::ui
