// SPDX-License-Identifier: MIT
#include "renderer/scene/gltf/rules.h"

#include "renderer/scene/gltf/message.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace romascope::gltf {

using nlohmann::json;

namespace {

/// Integers up to here are exact in a double, and a few of them add up without overflow.
constexpr double kLargestInteger = 9007199254740991.0;

/// Where a value stands; becomes text only for a message.
struct Place {
    const Place* parent = nullptr;
    const std::string* name = nullptr; ///< null: `index`
    size_t index = 0;

    std::string path() const {
        if (!parent)
            return {};
        const std::string before = parent->path();
        if (!name)
            return before + fmt::format("[{}]", index);
        return before.empty() ? *name : before + "." + *name;
    }
};

[[noreturn]] void fail(const Place& place, const std::string& reason) {
    refuse(place.parent ? place.path() : "JSON", reason);
}

[[noreturn]] void wrong_type(const Place& place, const char* wanted, const json& value) {
    fail(place, fmt::format("must be {}, but is {}", wanted,
                            value.is_structured() || value.is_null() ? value.type_name()
                                                                     : value.dump().substr(0, 60)));
}

class Checker {
public:
    explicit Checker(const std::map<std::string, size_t>& counts) : counts_(counts) {}
    void check(json& value, const Rule& rule, const Place& place) const;

private:
    void check_text(const json& value, const Rule& rule, const Place& place) const;
    void check_integer(json& value, const Rule& rule, const Place& place) const;
    void check_list(json& value, const Rule& rule, const Place& place) const;
    void check_object(json& value, const Rule& rule, const Place& place) const;

    const std::map<std::string, size_t>& counts_;
};

void check_range(double value, const Rule& rule, const Place& place) {
    if (!(value >= rule.low && value <= rule.high && !(rule.above_low && value == rule.low)))
        fail(place, fmt::format(
                        "{} is not {} {}{}", value, rule.above_low ? "above" : "at least", rule.low,
                        std::isfinite(rule.high) ? fmt::format(" and at most {}", rule.high) : ""));
}

/// Replaces a float without a fraction; everything that is not negative becomes unsigned.
bool make_integer(json& value) {
    if (value.is_number_float()) {
        const double number = value.get<double>();
        if (!(std::abs(number) <= kLargestInteger) || std::floor(number) != number)
            return false;
        value = static_cast<int64_t>(number);
    }
    if (value.is_number_unsigned())
        return true;
    if (!value.is_number_integer())
        return false;
    if (const auto number = value.get<int64_t>(); number >= 0)
        value = static_cast<uint64_t>(number);
    return true;
}

void Checker::check_text(const json& value, const Rule& rule, const Place& place) const {
    if (!value.is_string())
        wrong_type(place, "a string", value);
    const auto& string = value.get_ref<const std::string&>();
    if (!rule.words.empty() && std::ranges::find(rule.words, string) == rule.words.end())
        fail(place, fmt::format("'{}' is not one of {}", string.substr(0, 60),
                                fmt::join(rule.words, ", ")));
}

void Checker::check_integer(json& value, const Rule& rule, const Place& place) const {
    if (!value.is_number() || !make_integer(value))
        wrong_type(place, "an integer", value);
    if (rule.kind == Rule::Kind::index) {
        const auto found = counts_.find(rule.target);
        const size_t count = found == counts_.end() ? 0 : found->second;
        if (!value.is_number_unsigned() || value.get<uint64_t>() >= count)
            fail(place, fmt::format("{} does not exist, there are {}", value.dump(), count));
    } else if (!rule.codes.empty()) {
        if (std::ranges::none_of(rule.codes, [&](int64_t code) { return value == code; }))
            fail(place,
                 fmt::format("{} is not one of {}", value.dump(), fmt::join(rule.codes, ", ")));
    } else {
        const double number = value.get<double>();
        if (!(number >= rule.low && number <= rule.high))
            fail(place,
                 fmt::format("{} is not from {:.0f} to {:.0f}", value.dump(), rule.low, rule.high));
        if (value.get<uint64_t>() % rule.factor != 0)
            fail(place, fmt::format("{} is not a multiple of {}", value.dump(), rule.factor));
    }
}

void Checker::check_list(json& value, const Rule& rule, const Place& place) const {
    if (!value.is_array())
        wrong_type(place, "an array", value);
    if (value.size() < rule.shortest || value.size() > rule.longest)
        fail(place, rule.shortest == rule.longest
                        ? fmt::format("has {} elements instead of {}", value.size(), rule.shortest)
                        : fmt::format("has {} elements, too {}", value.size(),
                                      value.size() < rule.shortest ? "few" : "many"));
    for (size_t i = 0; i < value.size(); ++i)
        check(value[i], rule.element[0], {&place, nullptr, i});
}

void Checker::check_object(json& value, const Rule& rule, const Place& place) const {
    if (!value.is_object())
        wrong_type(place, "an object", value);
    auto& members = value.get_ref<json::object_t&>();
    if (rule.kind == Rule::Kind::map) {
        for (auto& [name, member] : members)
            check(member, rule.element[0], {&place, &name});
        return;
    }
    std::erase_if(members, [&](const auto& member) {
        return std::ranges::find(rule.properties, member.first, &Property::name) ==
               rule.properties.end();
    });
    for (const Property& property : rule.properties) {
        const Place at{&place, &property.name};
        const auto member = members.find(property.name);
        if (member != members.end())
            check(member->second, property.rule, at);
        else if (property.required)
            fail(at, "is missing");
    }
}

void Checker::check(json& value, const Rule& rule, const Place& place) const {
    switch (rule.kind) {
    case Rule::Kind::boolean:
        if (!value.is_boolean())
            wrong_type(place, "true or false", value);
        return;
    case Rule::Kind::text:
        return check_text(value, rule, place);
    case Rule::Kind::number:
        if (!value.is_number())
            wrong_type(place, "a number", value);
        return check_range(value.get<double>(), rule, place);
    case Rule::Kind::integer:
    case Rule::Kind::index:
        return check_integer(value, rule, place);
    case Rule::Kind::list:
        return check_list(value, rule, place);
    case Rule::Kind::map:
    case Rule::Kind::object:
        return check_object(value, rule, place);
    }
}

Rule of_kind(Rule::Kind kind) {
    Rule rule;
    rule.kind = kind;
    return rule;
}

} // namespace

Rule boolean() { return of_kind(Rule::Kind::boolean); }

Rule text(std::vector<std::string> words) {
    Rule rule = of_kind(Rule::Kind::text);
    rule.words = std::move(words);
    return rule;
}

Rule number(double low) {
    Rule rule = of_kind(Rule::Kind::number);
    rule.low = low;
    return rule;
}

Rule number_above(double low) {
    Rule rule = number(low);
    rule.above_low = true;
    return rule;
}

Rule integer(double low, double high, uint64_t factor) {
    Rule rule = of_kind(Rule::Kind::integer);
    rule.low = low;
    rule.high = std::min(high, kLargestInteger);
    rule.factor = factor;
    return rule;
}

Rule code(std::vector<int64_t> codes) {
    Rule rule = of_kind(Rule::Kind::integer);
    rule.codes = std::move(codes);
    return rule;
}

Rule index(std::string target) {
    Rule rule = of_kind(Rule::Kind::index);
    rule.target = std::move(target);
    return rule;
}

Rule list(Rule element, size_t shortest, size_t longest) {
    Rule rule = of_kind(Rule::Kind::list);
    rule.element.push_back(std::move(element));
    rule.shortest = shortest;
    rule.longest = longest;
    return rule;
}

Rule map_of(Rule element) {
    Rule rule = of_kind(Rule::Kind::map);
    rule.element.push_back(std::move(element));
    return rule;
}

Rule object(std::vector<Property> properties) {
    Rule rule = of_kind(Rule::Kind::object);
    rule.properties = std::move(properties);
    return rule;
}

void check(json& value, const Rule& rule, const std::map<std::string, size_t>& counts) {
    Checker(counts).check(value, rule, Place());
}

} // namespace romascope::gltf
