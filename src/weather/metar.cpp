#include "weather/metar.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/scanner.h"
#include "weather/humidity.h"
#include "weather/metar_groups.h"

namespace airlight {

namespace {

constexpr std::size_t longest_message = 4096;

void append_word(std::string& text, std::string_view word) {
    if (!text.empty()) text.append(1, ' ');
    text.append(word);
}

// The groups of a message and where we are in them.
struct Groups {
    std::vector<std::string> all;
    std::size_t next = 0;

    bool empty() const { return next == all.size(); }
    std::string_view front() const { return all[next]; }
    bool skip(std::string_view word) {
        if (empty() || front() != word) return false;
        ++next;
        return true;
    }
    // All from here on, with one space between.
    std::string rest() {
        std::string text;
        for (; !empty(); ++next) append_word(text, all[next]);
        return text;
    }
};

std::vector<std::string> words(std::string_view text) {
    constexpr std::string_view blank = " \t\r\n";
    std::vector<std::string> words;
    while (true) {
        text.remove_prefix(std::min(text.find_first_not_of(blank), text.size()));
        if (text.empty()) return words;
        words.emplace_back(text.substr(0, text.find_first_of(blank)));
        text.remove_prefix(words.back().size());
    }
}

// Whether the word after `group` belongs to it: "1" "1/2SM"; "WS" "TKOF" "RWY24"; "WS" "ALL" "RWY".
bool continues(std::string_view group, std::string_view next) {
    if (group.size() <= 2 && Scanner(group).at_digit()) return next.ends_with("SM") && next.find('/') != std::string_view::npos;
    if (!group.starts_with("WS")) return false;
    const bool named = group.find('R') != std::string_view::npos;
    return !named && (next == "ALL" || next == "TKOF" || next == "LDG" || next.starts_with("R"));
}

std::vector<std::string> joined(const std::vector<std::string>& words) {
    std::vector<std::string> groups;
    for (const std::string& word : words) {
        if (groups.empty() || !continues(groups.back(), word)) groups.emplace_back(word);
        else groups.back().append(1, ' ').append(word);
    }
    return groups;
}

// As much of a group as an error should show.
std::string shown(std::string_view group) {
    std::string text(group.substr(0, 24));
    for (char& c : text)
        if (c < ' ' || c > '~') c = '?';
    return group.size() > 24 ? text + "..." : text;
}

Error wrong_group(const Groups& groups, Error error) {
    if (groups.empty()) return at(fmt::format("METAR, after group {}", groups.all.size()), std::move(error));
    return at(fmt::format("METAR group {} \"{}\"", groups.next + 1, shown(groups.front())), std::move(error));
}

// The line that weather servers put before the message: "2003/10/17 19:53".
void skip_server_line(Groups& groups) {
    if (groups.all.size() < 2 || groups.all[0].size() != 10 || groups.all[1].size() != 5) return;
    if (groups.all[0][4] == '/' && groups.all[0][7] == '/' && groups.all[1][2] == ':') groups.next = 2;
}

bool is_station(std::string_view word) {
    const auto letter = [](char c) { return c >= 'A' && c <= 'Z'; };
    return word.size() == 4 && letter(word[0]) &&
           std::all_of(word.begin(), word.end(), [&](char c) { return letter(c) || Scanner::is_digit(c); });
}

Result<Done> read_time(std::string_view group, Metar& metar) {
    const char* form = "Write day of the month, hour and minute of UTC and Z: 171953Z.";
    Scanner scanner(group);
    const auto day = scanner.digits(2);
    const auto hour = scanner.digits(2);
    const auto minute = scanner.digits(2);
    if (!day || !hour || !minute || scanner.rest() != "Z") return Error{"", "is not the time of the report", form};
    if (*day < 1 || *day > 31) return Error{"", fmt::format("is not the time of the report: day {} is not 1 to 31", *day), form};
    if (*hour > 23) return Error{"", fmt::format("is not the time of the report: hour {} is not 0 to 23", *hour), form};
    if (*minute > 59) return Error{"", fmt::format("is not the time of the report: minute {} is not 0 to 59", *minute), form};
    metar.day = *day;
    metar.hour = *hour;
    metar.minute = *minute;
    return Done{};
}

// "CCA", "CCB": Canada's first, second correction.
bool skip_correction(Groups& groups) {
    if (groups.skip("COR")) return true;
    const bool canadian = !groups.empty() && groups.front().size() == 3 && groups.front().starts_with("CC");
    if (canadian) ++groups.next;
    return canadian;
}

// METAR or SPECI, COR, the station, the time, and AUTO, COR or NIL behind it.
Result<Done> read_head(Groups& groups, Metar& metar) {
    if (groups.all.empty()) return Error{"METAR", "is empty", "Give a message such as METAR EDDF 171950Z 24015KT 9999 FEW020 18/09 Q1013."};
    skip_server_line(groups);
    if (groups.skip("SPECI")) metar.kind = ReportKind::special;
    else groups.skip("METAR");
    metar.corrected = groups.skip("COR");
    if (groups.empty())
        return wrong_group(groups, {"", "no station stands there", "Begin with METAR or the station: METAR EDDF 171950Z ..."});
    if (groups.front() == "TAF") return wrong_group(groups, {"", "is a forecast, not a report", "Give a METAR or SPECI."});
    if (!is_station(groups.front()))
        return wrong_group(
            groups, {"", "is not a station", "Its indicator has four capital letters or digits, a letter first, such as EDDF or KSFO."});
    metar.station = groups.front();
    ++groups.next;
    if (groups.empty())
        return wrong_group(groups, {"", "no time stands there", "Write day of the month, hour and minute of UTC and Z: 171953Z."});
    if (const auto time = read_time(groups.front(), metar); !time) return wrong_group(groups, time.error());
    ++groups.next;
    while (!groups.empty()) {
        if (groups.skip("AUTO")) metar.automatic = true;
        else if (skip_correction(groups)) metar.corrected = true;
        else if (groups.skip("NIL")) metar.nil = true;
        else break;
    }
    return Done{};
}

bool begins_trend(std::string_view group) {
    Scanner scanner(group);
    if (scanner.skip("NOSIG") || scanner.skip("BECMG") || scanner.skip("TEMPO") || scanner.skip("INTER")) return scanner.empty();
    return (scanner.skip("PROB") && scanner.digits(2) && scanner.empty()) || (scanner.skip("FM") && scanner.digits(4) && scanner.empty());
}

Result<Done> read_body(Groups& groups, Metar& metar) {
    for (; !groups.empty() && groups.front() != "RMK" && !begins_trend(groups.front()); ++groups.next)
        if (const auto read = read_group(groups.front(), metar); !read) return wrong_group(groups, read.error());
    return Done{};
}

void read_tail(Groups& groups, Metar& metar) {
    for (; !groups.empty() && groups.front() != "RMK"; ++groups.next) append_word(metar.trend, groups.front());
    if (!groups.skip("RMK")) return;
    metar.remarks = groups.rest();
    read_remarks(metar.remarks, metar);
}

// The message without its final '='; what follows that must be blank.
Result<std::string_view> one_message(std::string_view text) {
    if (text.size() > longest_message)
        return Error{"METAR", fmt::format("is longer than {} characters", longest_message), "Give one message."};
    if (const std::size_t zero = text.find('\0'); zero != std::string_view::npos)
        return Error{"METAR", "holds a zero byte: it is not text", ""};
    const std::size_t end = text.find('=');
    if (end == std::string_view::npos) return text;
    if (!words(text.substr(end + 1)).empty()) return Error{"METAR", "goes on after its '='", "Give one message."};
    return text.substr(0, end);
}

}  // namespace

Result<Metar> parse_metar(std::string_view text) {
    const Result<std::string_view> message = one_message(text);
    if (!message) return message.error();
    Groups groups{joined(words(*message))};
    Metar metar;
    if (const auto head = read_head(groups, metar); !head) return head.error();
    if (metar.nil && !groups.empty())
        return wrong_group(groups, {"", "stands behind NIL, which says that there is no report", "End the message after NIL."});
    if (!metar.nil && groups.empty()) return wrong_group(groups, {"", "no weather stands there", "A report without weather ends in NIL."});
    if (const auto body = read_body(groups, metar); !body) return body.error();
    read_tail(groups, metar);
    return metar;
}

std::optional<double> relative_humidity(const Metar& metar) {
    if (!metar.temperature_c || !metar.dew_point_c) return {};
    return relative_humidity(*metar.temperature_c, *metar.dew_point_c);
}

}  // namespace airlight
