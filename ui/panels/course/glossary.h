// The glossary: one sentence and one moving picture for each term of the course. Terms in the text of a card are
// underlined by dots; a click opens the term beside its word. The sheet shows all terms.
//
// Texts: glossary.TERM.name, .text and .forms in the strings; `forms` are the words of a text that mean the term, with
// commas between them, in any letter case.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ui/widgets/ui.h"

namespace braitenlab {
struct LabView;
}

namespace braitenlab::ui {

struct PanelState;

// Draws a term into a rectangle, on the draw list of the current window. `seconds`: time of the motion, which repeats.
using DrawTerm = void (*)(const Ui&, Rect, double seconds);

struct GlossaryTerm {
    std::string_view id;  // "weight"; in string keys and anchors
    DrawTerm draw;
};

// In the order of the list; in glossary_pictures.cpp.
std::span<const GlossaryTerm> terms();

// The term with this id, or null.
const GlossaryTerm* find_term(std::string_view id);

// A term where a text mentions it: bytes [begin, end).
struct Mention {
    const GlossaryTerm* term = nullptr;
    std::size_t begin = 0, end = 0;
};

// The first whole word of each term that the text has, in the order of the text. Of several forms at one place, the
// longest. `but`: ids of terms to leave out.
std::vector<Mention> mentions_in(const Strings&, std::string_view text, const std::vector<std::string>& but = {});

// View state of the glossary.
struct GlossaryState {
    std::string shown;                   // id of the term of which the sheet shows text and picture
    std::string open;                    // id of the term that is open beside its word; empty: none
    Rect word;                           // that word, window pixels
    bool just_opened = false;            // in this frame: the click does not close it again
    std::vector<std::string> mentioned;  // ids of the terms underlined in this frame
};

// The picture and the sentence of a term at the cursor, one below the other, `width` window pixels wide. Still where
// motion is reduced. The anchor of the picture is glossary.picture.
void draw_entry(const LabView&, Ui&, const GlossaryTerm&, float width);

// As paragraph(), with the first mention of each term in this frame underlined by dots: a click, or Enter, opens it.
void paragraph_with_terms(Ui&, GlossaryState&, std::string_view, Colour);

// The card of the term that is open, beside its word; Escape or a click elsewhere closes it. Call after all cards.
void term_card(const LabView&, PanelState&, Ui&, Rect window);

}  // namespace braitenlab::ui
