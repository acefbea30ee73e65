// The project's own page of models, docs/models.md: all models against the reference, sorted, with the reasons of the order.
// Uses a finished comparison; nothing in the page is written by hand.
#pragma once

#include <string>

#include "eval/compare.h"

namespace airlight {

// Which orders of scattering a card says that the model computes; of fitted formulas, that they are fitted.
enum class Orders { none, single, several, fitted };
Orders orders_of(const ModelCard& card);

// Markdown. `command` is what writes the page.
std::string models_page(const Comparison& comparison, const std::string& command);

}  // namespace airlight
