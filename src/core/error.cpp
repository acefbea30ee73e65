#include "core/error.h"

#include <algorithm>
#include <sstream>
#include <vector>

namespace airlight {

std::string Error::message() const {
    std::string text = where.empty() ? what : where + ": " + what;
    if (!remedy.empty()) text += "\n  " + remedy;
    return text;
}

Error at(std::string_view where, Error error) {
    error.where = error.where.empty() ? std::string(where) : std::string(where) + ": " + error.where;
    return error;
}

namespace {

// Levenshtein's distance: insertions, deletions and replacements that turn `a` into `b`.
std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    for (std::size_t j = 0; j < row.size(); ++j) row[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
            diagonal = row[j];
            row[j] = std::min({replaced, row[j] + 1, row[j - 1] + 1});
        }
    }
    return row.back();
}

}  // namespace

std::string nearest_word(std::string_view word, std::string_view candidates) {
    std::istringstream words{std::string(candidates)};
    std::string best;
    std::size_t least = word.size() / 3 + 2;  // further than this is another word, not a slip
    for (std::string candidate; words >> candidate;) {
        const std::size_t distance = edit_distance(word, candidate);
        if (distance < least) {
            least = distance;
            best = candidate;
        }
    }
    return best;
}

}  // namespace airlight
