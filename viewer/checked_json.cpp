#include "viewer/checked_json.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "textures/input_error.h"

namespace relievo::viewer {
namespace {

using nlohmann::json;

// Throws for a key that an object has twice, which JSON leaves open and parsers pass over.
class KeyWatch {
  public:
    explicit KeyWatch(std::string file) : file_(std::move(file)) {}

    bool operator()(int /*depth*/, json::parse_event_t event, json& parsed) {
        if (event == json::parse_event_t::object_start)
            keys_.emplace_back();
        else if (event == json::parse_event_t::object_end)
            keys_.pop_back();
        else if (event == json::parse_event_t::key &&
                 !keys_.back().insert(parsed.get<std::string>()).second)
            throw textures::InputError(
                fmt::format("{}: the key \"{}\" stands twice in one object, expected once", file_,
                            parsed.get<std::string>()));
        return true;
    }

  private:
    std::string file_;
    std::vector<std::set<std::string>> keys_;
};

// A value as a message may show it.
std::string shown(const json& value) {
    constexpr std::size_t kMost = 40;
    const std::string text = value.dump(-1, ' ', false, json::error_handler_t::replace);
    return text.size() <= kMost ? text : text.substr(0, kMost - 1) + "…";
}

}  // namespace

CheckedJson::CheckedJson(std::shared_ptr<const json> root, const json& value, std::string file,
                         std::string path)
    : root_(std::move(root)), value_(&value), file_(std::move(file)), path_(std::move(path)) {}

CheckedJson CheckedJson::readFile(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    if (!std::filesystem::is_regular_file(file) || !stream)
        throw textures::InputError(fmt::format("{}: cannot be read", file.string()));
    try {
        auto root =
            std::make_shared<const json>(json::parse(stream, KeyWatch(file.string()), true, true));
        const json& value = *root;
        return {std::move(root), value, file.string(), ""};
    } catch (const json::parse_error& error) {
        throw textures::InputError(
            fmt::format("{}: is no JSON at byte {}, expected JSON with or without comments",
                        file.string(), error.byte));
    } catch (const json::out_of_range&) {
        throw textures::InputError(fmt::format(
            "{}: has a number that is too large, expected less than 1e308", file.string()));
    }
}

std::string CheckedJson::place() const {
    return path_.empty() ? file_ : fmt::format("{}: {}", file_, path_);
}

void CheckedJson::fail(const std::string& problem) const {
    throw textures::InputError(fmt::format("{}: {}", place(), problem));
}

void CheckedJson::failChoice(const std::string& word,
                             const std::vector<std::string_view>& words) const {
    fail(fmt::format("there is no \"{}\", expected {}", word, fmt::join(words, ", ")));
}

void CheckedJson::expectKeys(std::initializer_list<std::string_view> keys) const {
    for (const auto& [key, value] : members())
        if (std::find(keys.begin(), keys.end(), key) == keys.end())
            fail(fmt::format("has the key \"{}\", expected {}", key, fmt::join(keys, ", ")));
}

bool CheckedJson::isString() const noexcept {
    return value_->is_string();
}

bool CheckedJson::has(std::string_view key) const {
    return find(key).has_value();
}

CheckedJson CheckedJson::member(std::string_view key, const json& value) const {
    return {root_, value, file_, fmt::format("{}{}{}", path_, path_.empty() ? "" : ".", key)};
}

std::optional<CheckedJson> CheckedJson::find(std::string_view key) const {
    if (!value_->is_object())
        fail(fmt::format("is {}, expected an object", shown(*value_)));
    const auto place = value_->find(key);
    if (place == value_->end())
        return std::nullopt;
    return member(key, *place);
}

CheckedJson CheckedJson::at(std::string_view key) const {
    if (const std::optional<CheckedJson> found = find(key))
        return *found;
    fail(fmt::format("has no \"{}\", expected one", key));
}

std::vector<std::pair<std::string, CheckedJson>> CheckedJson::members() const {
    if (!value_->is_object())
        fail(fmt::format("is {}, expected an object", shown(*value_)));
    std::vector<std::pair<std::string, CheckedJson>> result;
    for (const auto& [key, value] : value_->items())
        result.emplace_back(key, member(key, value));
    return result;
}

std::vector<CheckedJson> CheckedJson::elements(std::size_t least, std::size_t most) const {
    if (!value_->is_array() || value_->size() < least || value_->size() > most)
        fail(fmt::format(
            "is {}, expected an array of {}", shown(*value_),
            least == most ? fmt::format("{}", least) : fmt::format("{} to {}", least, most)));
    std::vector<CheckedJson> result;
    for (std::size_t k = 0; k < value_->size(); ++k)
        result.push_back({root_, (*value_)[k], file_, fmt::format("{}[{}]", path_, k)});
    return result;
}

double CheckedJson::number(NumberRange range) const {
    const double number = value_->is_number() ? value_->get<double>() : std::nan("");
    if (!(number >= range.least && number <= range.most))
        fail(fmt::format("is {}, expected a number from {} to {}", shown(*value_), range.least,
                         range.most));
    return number;
}

int CheckedJson::integer(int least, int most) const {
    const double number = value_->is_number() ? value_->get<double>() : std::nan("");
    if (!(number >= least && number <= most && number == std::floor(number)))
        fail(fmt::format("is {}, expected a whole number from {} to {}", shown(*value_), least,
                         most));
    return static_cast<int>(number);
}

std::string CheckedJson::text() const {
    if (!value_->is_string() || value_->get_ref<const std::string&>().empty())
        fail(fmt::format("is {}, expected a string", shown(*value_)));
    return value_->get<std::string>();
}

glm::dvec2 CheckedJson::pair(NumberRange range) const {
    const std::vector<CheckedJson> numbers = elements(2, 2);
    return {numbers[0].number(range), numbers[1].number(range)};
}

glm::dvec3 CheckedJson::triple(NumberRange range) const {
    const std::vector<CheckedJson> numbers = elements(3, 3);
    return {numbers[0].number(range), numbers[1].number(range), numbers[2].number(range)};
}

}  // namespace relievo::viewer
