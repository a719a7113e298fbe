// SPDX-License-Identifier: MIT
// How figures came about, and what tables of figures have in common.
#pragma once

#include "renderer/settings/settings.h"

#include <string>
#include <utility>
#include <vector>

namespace romascope {

/// A name and a text.
using Facts = std::vector<std::pair<std::string, std::string>>;

/// "romascope VERSION (COMMIT)".
std::string program_fact();
/// The processor's model.
std::string processor_fact();
/// What differs from the program's own defaults, as --set takes it, or "defaults". Without the
/// tracer and the frames, which have places of their own.
std::string settings_fact(const Settings& settings);

/// A line "name: text" for each, after `before`.
std::string fact_lines(const Facts& facts, const std::string& before = "");

/// A text as a field of a line of CSV.
std::string csv_field(const std::string& text);

} // namespace romascope
