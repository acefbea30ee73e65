// The description of an atmosphere as a TOML file for people: read by physical causes, written in full.
// The keys: docs/atmosphere-file.md. Uses core, units, optics, spectrum and toml++; knows nothing of light transport.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "atmosphere/atmosphere.h"
#include "core/result.h"

namespace airlight {

inline constexpr std::size_t max_atmosphere_file_bytes = std::size_t{1} << 24;

// The validated description that a file's text gives. `file` is the name that errors carry in front of the line.
// Fails at the first thing wrong: "earth.toml:14: aerosol.profile.scale_height = ...: the rule" and what to do.
Result<Atmosphere> parse_atmosphere(std::string_view toml, std::string_view file);

// The same from a file of at most max_atmosphere_file_bytes.
Result<Atmosphere> read_atmosphere(const std::filesystem::path& path);

// The description with every spectrum and table in full; it reads back to an equal one, bit for bit.
// `comments` stand at its head, one line each.
std::string atmosphere_text(const Atmosphere& atmosphere, const std::vector<std::string>& comments = {});

// Writes atmosphere_text() whole or not at all.
Result<Done> write_atmosphere(const std::filesystem::path& path, const Atmosphere& atmosphere,
                              const std::vector<std::string>& comments = {});

// What a user names on the command line: a preset (presets.h), or else a file.
Result<Atmosphere> atmosphere_named(const std::string& preset_or_path);

}  // namespace airlight
