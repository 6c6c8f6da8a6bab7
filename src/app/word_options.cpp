// SPDX-License-Identifier: MIT
#include "app/word_options.hpp"

#include <filesystem>
#include <stdexcept>
#include <system_error>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/text.hpp"
#include "console/console.hpp"
#include "console/reference/vocabulary.hpp"
#include "console/schema/shell_value.hpp"

namespace hackle {
namespace {

bool is_quoted(const std::string& value) {
  return value.size() > 1 && (value.front() == '"' || value.front() == '\'') &&
         value.back() == value.front();
}

std::string value_text(const Option& option, const std::string& value) {
  const bool text = option.type == OptionType::text || option.type == OptionType::caption ||
                    option.type == OptionType::choice;
  if (!text) return shell_expression(value);
  return is_quoted(value) ? value : quoted(value);
}

[[noreturn]] void refuse_name(std::string_view command, const FunctionDoc& doc,
                              const std::string& name) {
  std::vector<std::string_view> names;
  for (const Option& option : doc.options) names.push_back(option.name);
  throw Error(ErrorKind::refused,
              fmt::format("{}: {} has no option '{}'{}", command, doc.name, name,
                          did_you_mean(name, names)),
              "options: " + comma_list(names));
}

const Option& known_option(std::string_view command, const FunctionDoc& doc,
                           const std::string& name) {
  const Option* option = find_option(doc, name);
  if (option == nullptr) refuse_name(command, doc, name);
  return *option;
}

}  // namespace

bool is_option(const std::string& word) {
  std::error_code ignored;
  const std::size_t equals = word.find('=');
  return equals != std::string::npos && equals > 0 && !std::filesystem::exists(word, ignored);
}

std::pair<std::string, std::string> option_in(const std::string& word) {
  const std::size_t equals = word.find('=');
  return {word.substr(0, equals), word.substr(equals + 1)};
}

std::string quoted(const std::string& text) {
  std::string all = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') all += '\\';
    all += c == '\n' ? std::string("\\n") : std::string(1, c);
  }
  return all + '"';
}

const FunctionDoc& doc_of(std::string_view owner, std::string_view name) {
  for (const FunctionDoc* doc : all_docs())
    if (doc->owner == owner && doc->name == name) return *doc;
  throw std::logic_error("no such function");
}

std::string lua_text(std::string_view command, const WordOptions& options, const FunctionDoc& doc) {
  std::string text;
  for (const auto& [name, value] : options)
    text += fmt::format(", {} = {}", name, value_text(known_option(command, doc, name), value));
  return text;
}

void check_values(Console& console, std::string_view command, const WordOptions& options,
                  const FunctionDoc& doc) {
  for (const auto& [name, value] : options) {
    const Option& option = known_option(command, doc, name);
    try {
      console.evaluate(fmt::format("_ = {}", value_text(option, value)));
    } catch (const Error& error) {
      throw Error(ErrorKind::usage, fmt::format("{}: {}={} is no value", command, name, value),
                  "expected " + expectation(option) + ", as in a script");
    }
  }
}

}  // namespace hackle
