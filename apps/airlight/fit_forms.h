// The models that `airlight fit` fits: what each is told, and the file that it gives.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fit/residual.h"
#include "fit/truth.h"

namespace airlight::cli {

// What every fit is told; what was not said is empty, and the form's own choice.
struct FitAsked {
    Atmosphere atmosphere;
    std::vector<Wavelength> wavelengths;
    std::vector<double> turbidities;
    std::vector<double> albedos;
    std::vector<double> altitudes_m;
    std::string variant;
    std::optional<double> error;
    TruthSettings truth;
};

// Work that every fit needs: who computes, where finished jobs are kept, who is told.
struct Workplace {
    Team& team;
    JobStore store;
    Progress progress;
};

// What every fit gives: the file, and how far it is from the truth.
struct Fitted {
    std::string text;
    Residuals residuals;
};

struct FitForm {
    std::string_view name;   // as people call it
    std::string_view model;  // which reads the file
    std::string_view takes;  // options beside the atmosphere's and the truth's, with spaces around each
    bool of_skies;           // or of the air alone, so that it takes no truth
    std::string_view says;   // a line of help
    Result<Fitted> (*fit)(const FitAsked& asked, const Workplace& place);
};

// All, in the order of their years.
std::span<const FitForm> fit_forms();

// By either name; fails if no form has it.
Result<const FitForm*> fit_form_named(const std::string& name);

}  // namespace airlight::cli
