// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <vector>

namespace romascope::gltf {

struct Property;

/// What a value in a JSON file may be. Made by the functions below.
struct Rule {
    enum class Kind { boolean, text, number, integer, index, list, map, object };
    Kind kind = Kind::object;
    double low = -std::numeric_limits<double>::infinity(); ///< of numbers, inclusive
    double high = std::numeric_limits<double>::infinity();
    bool above_low = false;         ///< `low` itself is refused
    uint64_t factor = 1;            ///< integers must be multiples of it
    std::vector<std::string> words; ///< all that a text may be; empty: any
    std::vector<int64_t> codes;     ///< all that an integer may be; empty: any in the range
    std::string target;             ///< of an index: the list that it counts in
    size_t shortest = 0, longest = std::numeric_limits<size_t>::max(); ///< of a list
    std::vector<Rule> element;                                         ///< of lists and maps: one
    std::vector<Property> properties;                                  ///< of objects
};

struct Property {
    std::string name;
    Rule rule;
    bool required = false;
};

Rule boolean();
Rule text(std::vector<std::string> words = {});
Rule number(double low = -std::numeric_limits<double>::infinity());
Rule number_above(double low);
Rule integer(double low, double high, uint64_t factor = 1);
Rule code(std::vector<int64_t> codes);
/// A position in the list of the file that is called `target`.
Rule index(std::string target);
Rule list(Rule element, size_t shortest = 0, size_t longest = std::numeric_limits<size_t>::max());
/// An object with names of the file's own choice.
Rule map_of(Rule element);
Rule object(std::vector<Property> properties);

/// Checks `value` and cleans it: integers written as floats (1.0, 10e-1) become integers,
/// properties without a rule go. `counts`: how many there are in each list that indices name.
/// Throws Error (kBadInput) with the path of the first value at fault.
void check(nlohmann::json& value, const Rule& rule, const std::map<std::string, size_t>& counts);

} // namespace romascope::gltf
