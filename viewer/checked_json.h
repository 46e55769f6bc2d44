#pragma once

#include <array>
#include <filesystem>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <initializer_list>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace relievo::viewer {

/// The numbers that a value may be, bounds included.
struct NumberRange {
    double least;
    double most;
};

/// A value of a JSON file that knows where it is, so that every error says so: what is read from it
/// is checked, and whatever is wrong throws textures::InputError, `FILE: boxes[2].size: what is
/// wrong, what was expected`.
class CheckedJson {
  public:
    /// The value of a whole file; comments as in C++ are allowed, a key twice in an object is not.
    static CheckedJson readFile(const std::filesystem::path& file);

    /// The file and where in it the value stands, `FILE: boxes[2].size`: how every error begins.
    [[nodiscard]] std::string place() const;
    /// Throws for this value; `problem` is the rest of the sentence.
    [[noreturn]] void fail(const std::string& problem) const;

    /// Throws unless the value is an object that has no other keys than these.
    void expectKeys(std::initializer_list<std::string_view> keys) const;
    [[nodiscard]] bool has(std::string_view key) const;
    [[nodiscard]] bool isString() const noexcept;
    /// A member of the object; `at` throws without it.
    [[nodiscard]] std::optional<CheckedJson> find(std::string_view key) const;
    [[nodiscard]] CheckedJson at(std::string_view key) const;
    /// All members of an object, by name in order of their keys.
    [[nodiscard]] std::vector<std::pair<std::string, CheckedJson>> members() const;
    /// The elements of an array that has from `least` to `most` of them.
    [[nodiscard]] std::vector<CheckedJson> elements(std::size_t least, std::size_t most) const;

    [[nodiscard]] double number(NumberRange range) const;
    [[nodiscard]] int integer(int least, int most) const;
    /// A string that is not empty.
    [[nodiscard]] std::string text() const;
    /// An array of two or three numbers.
    [[nodiscard]] glm::dvec2 pair(NumberRange range) const;
    [[nodiscard]] glm::dvec3 triple(NumberRange range) const;

    /// What stands beside the value's word in a table of (word, value) pairs.
    template <typename Value, std::size_t n>
    [[nodiscard]] Value choice(
        const std::array<std::pair<std::string_view, Value>, n>& choices) const {
        const std::string word = text();
        std::vector<std::string_view> words;
        for (const auto& [name, value] : choices) {
            if (name == word)
                return value;
            words.push_back(name);
        }
        failChoice(word, words);
    }

  private:
    CheckedJson(std::shared_ptr<const nlohmann::json> root, const nlohmann::json& value,
                std::string file, std::string path);
    [[noreturn]] void failChoice(const std::string& word,
                                 const std::vector<std::string_view>& words) const;
    [[nodiscard]] CheckedJson member(std::string_view key, const nlohmann::json& value) const;

    std::shared_ptr<const nlohmann::json> root_;  // keeps value_ alive
    const nlohmann::json* value_;
    std::string file_;
    std::string path_;
};

}  // namespace relievo::viewer
