// SPDX-License-Identifier: MIT
#include "app/facts.h"

#include "app/build_facts.h"
#include "renderer/frame/technique.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

namespace romascope {

std::string program_fact() { return fmt::format("romascope {} ({})", kVersion, kCommit); }

std::string processor_fact() {
    std::ifstream facts("/proc/cpuinfo");
    for (std::string line; std::getline(facts, line);)
        if (line.starts_with("model name"))
            return line.substr(std::min(line.find(':') + 2, line.size()));
    return "unknown processor";
}

std::string settings_fact(const Settings& settings) {
    std::string text;
    for (const KnobBase* knob : settings.table().all())
        if (!settings.is_default(*knob) && knob != &kTracer && knob != &kFrames)
            text += fmt::format("{}{}={}", text.empty() ? "" : " ", knob->key(),
                                to_text(settings.value(*knob)));
    return text.empty() ? "defaults" : text;
}

std::string fact_lines(const Facts& facts, const std::string& before) {
    std::string text;
    for (const auto& [name, value] : facts)
        text += fmt::format("{}{}: {}\n", before, name, value);
    return text;
}

std::string csv_field(const std::string& text) {
    if (text.find_first_of(",\"\n") == std::string::npos)
        return text;
    std::string quoted = "\"";
    for (const char c : text)
        quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + '"';
}

} // namespace romascope
