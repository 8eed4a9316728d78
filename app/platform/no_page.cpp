#include "app/platform/page.h"

namespace braitenlab {

void repeat(std::function<bool()> turn) {
    while (turn()) {
    }
}

bool is_on_page() { return false; }

bool prefers_light() { return false; }

std::string page_address() { return {}; }

void tell_page(const DocumentOnPage&) {}

void take_reload_key(bool) {}

void work_between_turns(std::function<bool()>) {}

void choose_files() {}

void when_page_is_left(std::function<void()>) {}

void offer_to_page(const std::string&, std::function<std::string()>) {}

}  // namespace braitenlab
