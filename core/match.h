// Visitor for std::visit with one lambda per alternative: std::visit(Match{[](A a) {…}, [](B b) {…}}, variant).
#pragma once

namespace braitenlab {

template <class... Cases>
struct Match : Cases... {
    using Cases::operator()...;
};
template <class... Cases>
Match(Cases...) -> Match<Cases...>;

}  // namespace braitenlab
