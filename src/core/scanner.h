// Text of a fixed form, read from its front piece by piece.
// Each call takes what it asks for, or takes nothing and says so. Uses nothing.
#pragma once

#include <algorithm>
#include <optional>
#include <string_view>

namespace airlight {

class Scanner {
public:
    explicit Scanner(std::string_view text) : rest_(text) {}

    bool empty() const { return rest_.empty(); }
    std::string_view rest() const { return rest_; }
    bool at_digit() const { return !rest_.empty() && is_digit(rest_.front()); }

    bool skip(std::string_view word) {
        if (!rest_.starts_with(word)) return false;
        rest_.remove_prefix(word.size());
        return true;
    }

    // `count` characters.
    std::optional<std::string_view> take(std::size_t count) {
        if (rest_.size() < count) return {};
        const std::string_view taken = rest_.substr(0, count);
        rest_.remove_prefix(count);
        return taken;
    }

    // A number of exactly `count` digits, at most 9.
    std::optional<int> digits(std::size_t count) {
        if (rest_.size() < count || !std::all_of(rest_.begin(), rest_.begin() + count, is_digit)) return {};
        int value = 0;
        for (char c : rest_.substr(0, count)) value = value * 10 + (c - '0');
        rest_.remove_prefix(count);
        return value;
    }

    // A number of `least` to `most` digits, as many as there are.
    std::optional<int> digits(std::size_t least, std::size_t most) {
        std::size_t count = 0;
        while (count < most && count < rest_.size() && is_digit(rest_[count])) ++count;
        if (count < least) return {};
        return digits(count);
    }

    static bool is_digit(char c) { return c >= '0' && c <= '9'; }

private:
    std::string_view rest_;
};

}  // namespace airlight
