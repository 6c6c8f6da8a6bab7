// SPDX-License-Identifier: MIT
#include "console/prompt/completion.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "base/units.hpp"
#include "console/lua/lua_tokens.hpp"
#include "console/prompt/cursor.hpp"
#include "console/prompt/file_names.hpp"
#include "console/reference/raw_value.hpp"
#include "console/reference/reference.hpp"
#include "console/reference/vocabulary.hpp"
#include "console/schema/object_type.hpp"
#include "console/session.hpp"

namespace hackle {
namespace {

using Candidates = std::vector<Candidate>;

// Returns the text typed after the name of a function before its first argument.
std::string call_form(const FunctionDoc& doc) {
  if (doc.call == Call::values && doc.options.empty() && doc.leading.empty()) return "()";
  const bool table = doc.call == Call::options && doc.leading.empty();
  return table || doc.leading.starts_with('{') ? " { " : "(";
}

void add_methods(const TypeDoc& type, Candidates& list) {
  for (const Function& method : type.methods)
    list.push_back({std::string(method.doc->name), call_form(*method.doc)});
}

// After a dot: adds fields, or if there are none methods, as in help(p.crack).
void add_fields(const TypeDoc& type, std::string_view word, Candidates& list) {
  for (const Property& field : type.fields)
    if (field.name.starts_with(word)) list.push_back({std::string(field.name), ""});
  if (!list.empty()) return;
  for (const Function& method : type.methods) list.push_back({std::string(method.doc->name), ""});
}

void add_keys(lua_State* L, int table, char access, Candidates& list) {
  for (const Key& key : keys_of(L, table))
    if (key.is_function || access != ':')
      list.push_back({std::string(key.name), key.is_function ? "(" : ""});
}

Candidates members(lua_State* L, const Cursor& cursor) {
  Candidates list;
  const RawValue value = raw_value(L, cursor.object);
  if (value.type != nullptr && cursor.access == ':') add_methods(*value.type, list);
  if (value.type != nullptr && cursor.access == '.') add_fields(*value.type, cursor.word, list);
  if (value.table != 0) add_keys(L, value.table, cursor.access, list);
  if (value.field != nullptr)
    for (const std::string_view key : value.field->keys) list.push_back({std::string(key), ""});
  // A local, or the result of a call, may be any of our objects.
  const std::string_view root = cursor.object.names.front();
  const bool unknown = root.empty() || std::ranges::count(cursor.locals, root) > 0;
  if (!value.known() && unknown && cursor.access == ':')
    for (const TypeDoc* type : all_types()) add_methods(*type, list);
  return list;
}

// Returns whether a global, on top of the stack, is still the unit constant of its name.
bool is_unit(lua_State* L, std::string_view name) {
  return std::ranges::any_of(units(), [&](const Unit& unit) {
    return unit.name == name && lua_type(L, -1) == LUA_TNUMBER &&
           lua_tonumber(L, -1) == unit.factor;
  });
}

// Returns the globals for an unfinished word; without a word, only those of the user and of Hackle.
Candidates globals(lua_State* L, const Cursor& cursor) {
  Candidates list;
  lua_pushglobaltable(L);
  const int table = lua_gettop(L);
  for (const Key& key : keys_of(L, table)) {
    push_text(L, key.name);
    lua_rawget(L, table);
    const FunctionDoc* doc = doc_of_global(L, -1);
    const std::string form = key.is_function ? "(" : "";
    if (!cursor.word.empty() || !is_unit(L, key.name))
      list.push_back({std::string(key.name), doc != nullptr ? call_form(*doc) : form});
    lua_pop(L, 1);
  }
  for (const std::string_view name : cursor.locals) list.push_back({std::string(name), ""});
  if (!cursor.word.empty())
    for (const std::string_view word : lua_keywords()) list.push_back({std::string(word), ""});
  return list;
}

// The candidates inside quotes.
struct Quoted {
  const Option* option = nullptr;
  bool material = false;
  bool topic = false;
};

const Option* positional(const FunctionDoc& doc, std::size_t place) {
  for (const Option& option : doc.options)
    if (option.positional && place-- == 0) return &option;
  return nullptr;
}

Quoted quoted_at(const FunctionDoc* doc, const OpenCall& call) {
  if (doc == nullptr) return {};
  const bool first = !call.in_braces && call.nameless == 0;
  if (first && doc->name == "help") return {.topic = true};
  if (first && doc->name == "material") return {.material = true};
  const Option* option =
      call.option.empty() ? positional(*doc, call.nameless) : find_option(*doc, call.option);
  return {.option = option, .material = option != nullptr && option->type == OptionType::material};
}

std::vector<std::string> values_of(lua_State* L, const Quoted& quoted) {
  std::vector<std::string> values;
  if (quoted.material)
    for (const KnownMaterial& known : session_of(L).materials().list()) values.push_back(known.key);
  if (quoted.topic) values = topics();
  if (quoted.option != nullptr)
    values.insert(values.end(), quoted.option->choices.begin(), quoted.option->choices.end());
  return values;
}

// Returns the folder in which completion looks for files: for a mask picture that of the script,
// which is the current one; for all others the output folder.
std::filesystem::path folder_of_files(lua_State* L, const FunctionDoc* doc) {
  const bool reads = doc == nullptr || doc->owner == "p";
  return reads ? std::filesystem::path() : session_of(L).settings.output_folder;
}

Completion in_quotes(lua_State* L, const Cursor& cursor) {
  const FunctionDoc* doc = cursor.call ? doc_of(L, cursor.call->callee) : nullptr;
  const Quoted quoted = cursor.call ? quoted_at(doc, *cursor.call) : Quoted{};
  Completion completion{cursor.word.size(), {}};
  const std::vector<std::string> values = values_of(L, quoted);
  for (const std::string& value : values)
    completion.candidates.push_back({value, std::string(1, cursor.quote)});
  if (!values.empty()) return completion;
  const FileNames files = file_names(cursor.word, folder_of_files(L, doc));
  for (const std::string& name : files.names)
    completion.candidates.push_back(
        {name, name.ends_with('/') ? "" : std::string(1, cursor.quote)});
  completion.typed = files.typed;
  return completion;
}

// Returns the names of options that are not yet given.
Candidates option_names(const FunctionDoc& doc, const OpenCall& call) {
  Candidates list;
  for (const Option& option : doc.options) {
    const bool given =
        std::ranges::count(call.given, option.name) > 0 || (option.positional && call.nameless > 0);
    if (!given) list.push_back({std::string(option.name), " = "});
  }
  return list;
}

// Returns candidates if a call expects something specific; otherwise nothing.
Candidates in_call(lua_State* L, const Cursor& cursor) {
  if (!cursor.call) return {};
  const FunctionDoc* doc = doc_of(L, cursor.call->callee);
  if (doc == nullptr || doc->call != Call::options) return {};
  if (cursor.call->at_name && cursor.call->in_braces) return option_names(*doc, *cursor.call);
  Candidates list;
  if (!cursor.word.empty() || cursor.call->option.empty()) return list;
  for (const std::string& value : values_of(L, quoted_at(doc, *cursor.call)))
    list.push_back({'"' + value + '"', ""});
  return list;
}

bool fits(const Candidate& candidate, std::string_view word) {
  return candidate.text.starts_with(word);
}

// Keeps the candidates that begin with the word, sorted, without duplicates.
void keep_fitting(Candidates& list, std::string_view word) {
  std::erase_if(list, [&](const Candidate& candidate) { return !fits(candidate, word); });
  std::ranges::sort(list, {}, &Candidate::text);
  const auto alike = [](const Candidate& a, const Candidate& b) { return a.text == b.text; };
  list.erase(std::unique(list.begin(), list.end(), alike), list.end());
}

Completion of_word(lua_State* L, const Cursor& cursor) {
  Completion completion{cursor.word.size(), {}};
  Candidates& list = completion.candidates;
  list = cursor.access != 0 ? members(L, cursor) : in_call(L, cursor);
  keep_fitting(list, cursor.word);
  if (list.empty() && cursor.access == 0) list = globals(L, cursor);
  return completion;
}

// Returns the number of bytes that two texts have in common, without splitting a UTF-8 character.
std::size_t common_size(std::string_view one, std::string_view other) {
  const auto differ = std::ranges::mismatch(one, other);
  auto size = static_cast<std::size_t>(differ.in1 - one.begin());
  const auto continues = [&](char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; };
  while (size > 0 && size < one.size() && continues(one[size])) --size;
  return size;
}

}  // namespace

std::string Completion::insertion() const {
  if (candidates.empty()) return "";
  std::string_view common = candidates.front().text;
  for (const Candidate& candidate : candidates)
    common = common.substr(0, common_size(common, candidate.text));
  std::string rest(common.substr(std::min(typed, common.size())));
  return candidates.size() == 1 ? rest + candidates.front().after : rest;
}

Completion complete(lua_State* L, std::string_view text) {
  const int top = lua_gettop(L);
  const Cursor cursor = cursor_at_end(text);
  if (cursor.silent) return {};
  Completion completion = cursor.in_quotes ? in_quotes(L, cursor) : of_word(L, cursor);
  const std::string_view typed = cursor.word.substr(cursor.word.size() - completion.typed);
  keep_fitting(completion.candidates, typed);
  lua_settop(L, top);
  return completion;
}

std::string in_columns(const std::vector<Candidate>& candidates, std::size_t width,
                       std::size_t max) {
  const std::size_t shown = std::min(candidates.size(), max);
  std::size_t widest = 1;
  for (std::size_t k = 0; k < shown; ++k) widest = std::max(widest, candidates[k].text.size());
  const std::size_t columns = std::max<std::size_t>(1, width / (widest + 2));
  const std::size_t rows = (shown + columns - 1) / columns;
  std::string text;
  for (std::size_t row = 0; row < rows; ++row) {
    std::string line;
    for (std::size_t k = row; k < shown; k += rows)
      line += fmt::format("{:<{}}", candidates[k].text, widest + 2);
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  if (shown < candidates.size()) text += fmt::format("... {} more\n", candidates.size() - shown);
  return text;
}

}  // namespace hackle
