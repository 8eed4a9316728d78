#include "ui/panels/cards.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include "ui/panels/map/map_parts.h"
#include "ui/panels/offered.h"
#include "ui/panels/panels.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/theme.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

namespace {

constexpr float between_cards = spacing::medium, title_width = 150, around_title = 56;  // layout pixels
constexpr float four_sliders = 200;  // layout pixels: heading, name and the weights of the brain
constexpr float folded_row = 24;     // layout pixels, of a folded card below an open one

#define CARD(id, draws, ...) {.card = Card::id, .draw = draws, __VA_ARGS__},

constexpr CardTraits card_traits[]{
#include "ui/panels/card_table.def"
};
static_assert(std::size(card_traits) == card_count);

// A folded card of a lecture covers part of the scene: it is only as wide as its heading.
Rect lecture_place(const LabView& view, const Ui& ui, const CardTraits& row, bool folded, Rect r) {
    if (!view.lecture || !folded) return r;
    const float words = row.heading.empty() ? 0 : text_width(ui, Face::small, ui.strings(row.heading));
    const float w = std::min(r.w, std::max(ui.px(title_width), words + ui.px(around_title)));
    return {row.column == Column::right ? r.x + r.w - w : r.x, r.y, w, r.h};
}

// The cards of one column that are shown now, with the heights that the table gives them.
struct Stack {
    const CardTraits* rows[card_count]{};
    std::size_t count = 0;
};

Stack stack_of(Column column, const LabView& view, IsGuest is_guest) {
    Stack stack;
    for (const CardTraits& card : card_traits)
        if ((card.column == column || (is_guest && is_guest(card))) && card.shown(view))
            stack.rows[stack.count++] = &card;
    return stack;
}

// In a lecture the guests leave the cards below them their least heights; none of the cards folds.
bool shares_column(const LabView& view, IsGuest is_guest) { return view.lecture && is_guest; }

float wanted_of(const Ui& ui, PanelState& state, const CardTraits& card, Rect column) {
    return std::min(wanted_height(ui, state.card(card.card)), card.most * column.h);
}

// The height that remains for this card where the cards above it leave less.
float least_of(const Ui& ui, PanelState& state, const CardTraits& card, Rect column) {
    const float wanted = wanted_of(ui, state, card, column);
    if (card.most < 1) return wanted;  // not squeezed by cards below
    return std::min(wanted, std::max(ui.px(card.least), card.least_share * column.h));
}

// In a low column the first card, which keeps its least height elsewhere, and the cards that the user has opened below
// it get half of the column each.
void share_low_column(const Ui& ui, PanelState& state, const Stack& stack, Rect column, std::span<float> least) {
    constexpr float low = 600, share = 0.5f;  // layout pixels; of the column
    if (column.h >= ui.px(low)) return;
    for (std::size_t i = 1; i < stack.count; ++i) {
        const CardState& card = state.card(stack.rows[i]->card);
        if (card.folded || !card.opened_by_user) continue;
        least[i] = std::min(wanted_of(ui, state, *stack.rows[i], column), std::max(least[i], share * column.h));
        least[0] = std::min(least[0], share * column.h - ui.px(between_cards));
    }
}

// The heights of the cards. Where the column is too low for all of them, a card gets what those above and the least
// heights of those below leave.
std::array<float, card_count> heights_of(const Ui& ui, PanelState& state, const Stack& stack, Rect column,
                                         bool is_shared) {
    std::array<float, card_count> heights{};
    const std::span<float> least(heights.data(), stack.count);
    // A lecture shows the weights below the exercise that asks for them.
    const bool shows_weights = is_shared && stack.count > 0 && stack.rows[0]->card == Card::exercise;
    for (std::size_t i = 0; i < stack.count; ++i) {
        least[i] = least_of(ui, state, *stack.rows[i], column);
        if (shows_weights && stack.rows[i]->card == Card::brain)
            least[i] = std::min(wanted_of(ui, state, *stack.rows[i], column), ui.px(four_sliders));
    }
    float room = column.h - ui.px(between_cards) * static_cast<float>(stack.count > 0 ? stack.count - 1 : 0);
    if (!is_shared && stack.count > 1) share_low_column(ui, state, stack, column, least);
    const bool keeps_least = stack.count > 0 && stack.rows[0]->keeps_least && !is_shared;
    const std::size_t kept = keeps_least ? 1 : 0;  // the first card only
    cut_to_fit(least.subspan(kept), folded_height(ui), room - (kept > 0 ? least[0] : 0));
    for (std::size_t i = 0; i < stack.count; ++i) {
        const float below = std::accumulate(least.begin() + static_cast<std::ptrdiff_t>(i) + 1, least.end(), 0.0f);
        const float wanted = wanted_of(ui, state, *stack.rows[i], column);
        heights[i] = std::max(heights[i], std::min(wanted, room - below));
        room -= heights[i];
    }
    return heights;
}

// What the heights of the cards below that of the exercise depend on.
std::size_t reasons_of(const Stack& stack, const LabView& view, PanelState& state, Rect column) {
    std::size_t all = view.run_id * 31 + static_cast<std::size_t>(view.settings.selection.vehicle + 1);
    const auto add = [&](std::size_t value) { all = all * 1000003 + value; };
    for (std::size_t i = 0; i < stack.count; ++i)
        add(2 * static_cast<std::size_t>(stack.rows[i]->card) + (state.card(stack.rows[i]->card).folded ? 1 : 0));
    for (const float each : {column.x, column.y, column.w, column.h}) add(static_cast<std::size_t>(std::lround(each)));
    for (const bool each : {view.may.outcome, view.may.brains, view.may.why, view.mode == Mode::wiring})
        add(each ? 1 : 0);
    return all;
}

// Below the open card of the exercise, whose text grows, the other cards are at the bottom of the column and keep their
// heights until one of them unfolds, as the slots do with the numbers of their runs; the exercise has all that is left.
// So none of their rows and none of its buttons moves under the pointer.
void fix_heights(const Ui& ui, const LabView& view, PanelState& state, const Stack& stack, Rect column,
                 std::array<float, card_count>& heights) {
    const bool is_exercise = stack.count > 0 && stack.rows[0]->card == Card::exercise;
    if (!is_exercise || state.card(Card::exercise).folded || view.lecture) return;
    constexpr int frames = 4;      // until all contents are measured
    constexpr float unfolds = 44;  // layout pixels: more than the two lines by which a text changes
    CardsBelowExercise& below = state.exercise.below;
    const std::size_t reasons = reasons_of(stack, view, state, column);
    bool changes = std::exchange(below.depends_on, reasons) != reasons;
    std::array<float, card_count> wanted{};
    for (std::size_t i = 1; i < stack.count; ++i) {
        wanted[i] = wanted_of(ui, state, *stack.rows[i], column);
        changes |= std::fabs(wanted[i] - below.wanted[i]) > ui.px(unfolds);
    }
    if (changes) below.settling = frames;
    if (below.settling > 0) --below.settling, below.heights = heights, below.wanted = wanted;
    float rest = column.h;
    for (std::size_t i = 1; i < stack.count; ++i) {
        heights[i] = below.heights[i];
        rest -= heights[i] + ui.px(between_cards);
    }
    heights[0] = std::max(rest, folded_height(ui));
}

// Folds the card with folds_when_cramped for this frame, if the column is too low for all cards. Null if there is none.
const CardTraits* fold_when_cramped(const Ui& ui, PanelState& state, const Stack& stack, Rect column) {
    float above = 0;
    for (std::size_t i = 0; i < stack.count; ++i) {
        const CardTraits& row = *stack.rows[i];
        CardState& card = state.card(row.card);
        const bool measured = i > 0 && state.card(stack.rows[i - 1]->card).content > 0;
        const bool gives_way = row.folds_when_cramped && !card.folded && !card.opened_by_user && measured;
        if (gives_way && above + least_of(ui, state, row, column) > column.h) {
            card.folded = true;
            return &row;
        }
        above += wanted_of(ui, state, row, column) + ui.px(between_cards);
    }
    return nullptr;
}

// In an upright window one column has all cards.
bool has_all_cards(const LabView& view, IsGuest is_guest) {
    return !view.lecture && is_guest && is_guest(traits(Card::scene));
}

const CardTraits* find_row(const Stack& stack, auto&& wanted) {
    const auto end = stack.rows + stack.count, found = std::find_if(stack.rows, end, wanted);
    return found == end ? nullptr : *found;
}

// The rows of `stack` that are folded, or those that are open.
Stack cards_where(PanelState& state, const Stack& stack, bool folded) {
    Stack some;
    for (const CardTraits* row : std::span(stack.rows, stack.count))
        if (state.card(row->card).folded == folded) some.rows[some.count++] = row;
    return some;
}

// Below an open card the folded ones are in rows of two, lower than their headings elsewhere.
float height_of_folded(const Ui& ui, std::size_t count) {
    const float rows = std::ceil(static_cast<float>(count) / 2);
    return rows == 0 ? 0 : ui.px(spacing::small - spacing::tight) + rows * ui.px(ui.tall(folded_row) + spacing::tight);
}

float heading_width(const LabView& view, const Ui& ui, const CardTraits& row) {
    return text_width(ui, Face::small,
                      row.card == Card::exercise ? exercise_heading(view, ui) + "  0/0"
                      : row.heading.empty()      ? std::string_view{}
                                                 : ui.strings(row.heading));
}

bool closes_by_fold(const CardTraits& row) { return row.card == Card::map || row.card == Card::reality; }

// True for a card that replaces the open one as soon as it is shown: the exercise, and what is asked for.
bool opens_when_shown(const CardTraits& row) {
    return row.card == Card::exercise || row.card == Card::values || closes_by_fold(row);
}

// The card that stays open where there is room for one: that which has just been opened, what the user has opened,
// the exercise, the brain.
const CardTraits* card_to_keep(PanelState& state, const Stack& stack) {
    const auto is = [](const CardTraits* row, Card card) { return row->card == card; };
    const auto is_open = [&](const CardTraits* row) { return !state.card(row->card).folded; };
    const auto is_new = [&](const CardTraits* row) { return is_open(row) && !state.card(row->card).was_open; };
    const CardTraits* kept = find_row(stack, [&](auto* row) { return is_new(row) && opens_when_shown(*row); });
    if (!kept) kept = find_row(stack, [&](auto* row) { return is_new(row) && is(row, Card::brain); });
    if (!kept) kept = find_row(stack, is_new);
    if (!kept) kept = find_row(stack, [&](auto* row) { return is_open(row) && state.card(row->card).opened_by_user; });
    if (!kept) kept = find_row(stack, [&](auto* row) { return is_open(row) && is(row, Card::exercise); });
    if (!kept) kept = find_row(stack, [&](auto* row) { return is_open(row) && is(row, Card::brain); });
    return kept;
}

void forget_way(PanelState& state) {
    for (const CardTraits& row : card_traits) state.card(row.card).gave_way = false;
}

// Folds cards until the open ones have room; `kept` stays open.
void fold_for_room(const Ui& ui, PanelState& state, const Stack& stack, Rect column, const CardTraits* kept) {
    constexpr float useful = 220, useful_brain = 340;  // layout pixels; with the sums
    const auto needed = [&] {
        const Stack open = cards_where(state, stack, false);
        float sum = height_of_folded(ui, stack.count - open.count) - ui.px(between_cards);
        for (const CardTraits* row : std::span(open.rows, open.count)) {
            const bool is_measured = state.card(row->card).content > 0;
            const float most = ui.px(row->card == Card::brain ? useful_brain : useful);
            const float wanted = is_measured ? std::min(wanted_of(ui, state, *row, column), most) : most;
            sum += ui.px(between_cards) + std::max(least_of(ui, state, *row, column), wanted);
        }
        return sum;
    };
    while (needed() > column.h) {
        const CardTraits* next =
            find_row(stack, [&](auto* row) { return row != kept && !state.card(row->card).folded; });
        if (!next) return;
        forget_way(state);
        state.card(next->card).gave_way = true;
        state.card(next->card).folded = true, state.card(next->card).opened_by_user = false;
    }
}

// Where the only open card is no longer shown, the one that gave way to it opens again, unless the user has folded it.
void open_after(PanelState& state, const Stack& stack) {
    const auto is_folded_now = [&](const CardTraits* row) {
        return state.card(row->card).folded && state.card(row->card).was_open;
    };
    if (cards_where(state, stack, false).count > 0) return;
    if (find_row(stack, is_folded_now)) return forget_way(state);
    const CardTraits* next = find_row(stack, [&](auto* row) { return state.card(row->card).gave_way; });
    if (!next) return;
    state.card(next->card).folded = false;
    state.is_unsettled = true;  // the layout of this frame has no open card
}

// Draws the folded cards at the end of the column, and takes their room from it. One that is pressed opens, and others
// fold for it.
void draw_folded(const LabView& view, PanelState& state, Ui& ui, const Stack& stack, Rect& column) {
    const Stack folded = cards_where(state, stack, true);
    const Rect whole = column;
    column.h -= height_of_folded(ui, folded.count);
    const float space = ui.px(spacing::small), height = ui.px(ui.tall(folded_row));
    Rect place{column.x, column.y + column.h + space, 0, height};
    for (std::size_t i = 0; i < folded.count; ++i) {
        const bool is_first = i % 2 == 0, is_last = !is_first || i + 1 == folded.count;
        const float right = column.x + column.w;
        if (is_last) {
            place.w = right - place.x;
        } else {  // both have the same room around their words
            const float more = heading_width(view, ui, *folded.rows[i]) - heading_width(view, ui, *folded.rows[i + 1]);
            place.w = (column.w - space + more) / 2;
        }
        CardState& card = state.card(folded.rows[i]->card);
        folded.rows[i]->draw(view, state, ui, place, whole);
        place = is_last ? Rect{column.x, place.y + height + ui.px(spacing::tight), 0, height}
                        : Rect{place.x + place.w + space, place.y, 0, height};
        if (card.folded || closes_by_fold(*folded.rows[i])) continue;
        card.opened_by_user = true;
        fold_for_room(ui, state, stack, whole, folded.rows[i]);
        state.is_unsettled = true;  // it is open in the place of its heading
    }
}

// One column has all cards: there is room for one or two open ones. A card that is not shown counts as open, so that it
// folds nothing when it appears, unless it is to open then. The card that has just been opened wins over those opened
// before it, also where they have room beside it at first.
void keep_open_cards(const Ui& ui, PanelState& state, const Stack& stack, Rect column) {
    open_after(state, stack);
    const CardTraits* kept = card_to_keep(state, stack);
    const bool is_new = kept && !state.card(kept->card).was_open;
    for (const CardTraits* row : std::span(stack.rows, stack.count))
        if (is_new && row != kept) state.card(row->card).opened_by_user = false;
    fold_for_room(ui, state, stack, column, kept);
    for (const CardTraits& row : card_traits) state.card(row.card).was_open = !opens_when_shown(row);
    for (const CardTraits* row : std::span(stack.rows, stack.count))
        state.card(row->card).was_open = closes_by_fold(*row) || !state.card(row->card).folded;
}

}  // namespace

std::array<CardState, card_count> initial_cards() {
    std::array<CardState, card_count> states;
    for (const CardTraits& card : card_traits) states[static_cast<std::size_t>(card.card)].folded = card.folded;
    return states;
}

std::span<const CardTraits> cards() { return card_traits; }

const CardTraits& traits(Card card) { return card_traits[static_cast<std::size_t>(card)]; }

void cut_to_fit(std::span<float> heights, float floor, float room) {
    std::vector<float> sorted(heights.begin(), heights.end());
    std::sort(sorted.begin(), sorted.end());
    float most = room;                                 // of each height
    for (std::size_t i = 0; i < sorted.size(); ++i) {  // the lower ones keep theirs
        most = room / static_cast<float>(sorted.size() - i);
        if (sorted[i] > most) break;
        room -= sorted[i];
    }
    for (float& height : heights) height = std::min(height, std::max(floor, most));
}

void draw_column(Column which, const LabView& view, PanelState& state, Ui& ui, Rect column, IsGuest is_guest) {
    if (column.w <= 0) return;
    const float space = ui.px(between_cards);
    Stack stack = stack_of(which, view, is_guest);
    const bool is_shared = shares_column(view, is_guest);
    const bool has_all = has_all_cards(view, is_guest);
    if (has_all) keep_open_cards(ui, state, stack, column);
    if (const Stack open = cards_where(state, stack, false); has_all && open.count > 0) {
        draw_folded(view, state, ui, stack, column);
        stack = open;
    }
    const CardTraits* folded_now = is_shared || has_all ? nullptr : fold_when_cramped(ui, state, stack, column);
    std::array<float, card_count> heights = heights_of(ui, state, stack, column, is_shared);
    fix_heights(ui, view, state, stack, column, heights);
    Rect rest = column;
    for (std::size_t i = 0; i < stack.count; ++i) {
        const CardTraits& row = *stack.rows[i];
        CardState& card = state.card(row.card);
        Rect place = rest;
        place.h = heights[i];
        const bool was_folded = card.folded;
        Rect room = rest;
        for (std::size_t below = i + 1; is_shared && below < stack.count; ++below)
            room.h -= least_of(ui, state, *stack.rows[below], column) + space;
        row.draw(view, state, ui, lecture_place(view, ui, row, card.folded, place), room);
        state.is_unsettled |= !card.folded && card.is_cut;
        const bool changed = card.folded != was_folded;
        if (changed) card.opened_by_user = was_folded;
        if (&row == folded_now && !changed) card.folded = false;
        rest.y += place.h + space;
        rest.h -= place.h + space;
    }
}

bool open_card(PanelState& state, Ui& ui, Card which, Rect place, std::span<HeadingButton> buttons,
               std::string_view heading) {
    const CardTraits& card = traits(which);
    return begin_card(ui, state.card(which), card.anchor, heading.empty() ? ui.strings(card.heading) : heading, place,
                      buttons);
}

void reset_cards(PanelState& state) {
    for (const CardTraits& card : card_traits) {
        CardState& shown = state.card(card.card);
        shown.folded = card.folded;
        shown.opened_by_user = false;
    }
}

}  // namespace braitenlab::ui
