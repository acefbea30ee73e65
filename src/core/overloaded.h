// One function from several, one for each alternative of a variant: std::visit(Overloaded{...}, variant).
// Uses nothing.
#pragma once

namespace airlight {

template <class... F>
struct Overloaded : F... {
    using F::operator()...;
};
template <class... F>
Overloaded(F...) -> Overloaded<F...>;

}  // namespace airlight
