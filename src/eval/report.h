// What a comparison found, for people and for programs: one page of HTML that needs no other file and no network, CSV and JSON.
// Uses a finished comparison; computes nothing but its text.
#pragma once

#include <string>

#include "eval/compare.h"

namespace airlight {

std::string report_html(const Comparison& comparison);
// One row an air, model, condition and side of the horizon.
std::string report_csv(const Comparison& comparison);
std::string report_json(const Comparison& comparison);

// "the Monte Carlo reference", "the tables", "a measured sky".
std::string truth_text(const Comparison& comparison);
// Such as "12.3": three digits that count.
std::string percent_text(double fraction);
std::string bytes_text(std::size_t bytes);
std::string time_text(double seconds);

// Writes report.html, scores.csv and scores.json.
Result<Done> write_report(const std::filesystem::path& folder, const Comparison& comparison);

}  // namespace airlight
