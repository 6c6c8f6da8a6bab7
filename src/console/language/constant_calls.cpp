// SPDX-License-Identifier: MIT
#include "console/language/constant_calls.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <vector>

#include <fmt/format.h>

#include "console/language/chart_docs.hpp"
#include "console/language/recording_docs.hpp"
#include "console/language/simulation_docs.hpp"
#include "console/lua/error_object.hpp"
#include "console/lua/lua_tokens.hpp"
#include "console/schema/arguments.hpp"
#include "output/files/output_names.hpp"

namespace hackle {
namespace {

// A method that writes a file: of a simulation, and perhaps also of a recording.
struct Method {
  const FunctionDoc* of_simulation;
  const FunctionDoc* of_recording;
  FileKind kind;
};
constexpr std::array methods{Method{&frame_doc, &recorded_frame_doc, FileKind::picture},
                             Method{&run_chart_doc, &recorded_chart_doc, FileKind::picture},
                             Method{&movie_doc, &recorded_movie_doc, FileKind::movie},
                             Method{&record_doc, nullptr, FileKind::run_file}};

using TokenSpan = std::span<const Token>;

const Method* method_named(const Token& token) {
  const auto found = std::ranges::find_if(
      methods, [&](const Method& method) { return token.is(method.of_simulation->name); });
  return found == methods.end() ? nullptr : &*found;
}

// Returns the tokens from a brace to the one that closes it; empty if none does.
TokenSpan table_at(TokenSpan tokens) {
  int depth = 0;
  for (std::size_t k = 0; k < tokens.size(); ++k) {
    if (tokens[k].is("{")) ++depth;
    if (tokens[k].is("}") && --depth == 0) return tokens.first(k + 1);
  }
  return {};
}

class ConstantCalls {
 public:
  ConstantCalls(lua_State* L, std::string_view text, const std::string& script_name)
      : L_(L), text_(text), script_name_(script_name), tokens_(tokens_of(text).list) {}

  Problems problems() const {
    Problems problems;
    const TokenSpan all = tokens_;
    for (std::size_t k = 2; k < all.size(); ++k)
      if (all[k].is("{") && all[k - 2].is(":"))
        if (const Method* method = method_named(all[k - 1]))
          check(*method, table_at(all.subspan(k)), problems);
    return problems;
  }

 private:
  // Whether the script makes a variable of this name somewhere.
  bool makes(std::string_view name) const {
    for (std::size_t k = 0; k + 1 < tokens_.size(); ++k)
      if (tokens_[k].is(name) && (tokens_[k + 1].is("=") || (k > 0 && tokens_[k - 1].is("local"))))
        return true;
    return false;
  }

  bool is_number(std::string_view name) const {
    push_text(L_, name);
    lua_pushglobaltable(L_);
    lua_insert(L_, -2);
    lua_rawget(L_, -2);
    const bool number = lua_type(L_, -1) == LUA_TNUMBER;
    lua_pop(L_, 2);
    return number && !makes(name);
  }

  bool is_constant(TokenSpan table) const {
    constexpr std::array<std::string_view, 7> calls{"(", ")", ".", ":", "[", "]", "..."};
    constexpr std::array<std::string_view, 3> values{"true", "false", "nil"};
    for (std::size_t k = 0; k < table.size(); ++k) {
      const Token& token = table[k];
      const bool key = k + 1 < table.size() && table[k + 1].is("=");
      if (token.kind == Token::Kind::name && !key && !is_number(token.word)) return false;
      if (token.kind == Token::Kind::keyword &&
          std::ranges::find(values, token.word) == values.end())
        return false;
      if (token.kind == Token::Kind::symbol && std::ranges::find(calls, token.word) != calls.end())
        return false;
    }
    return !table.empty();
  }

  // [-0, +1] Returns false, and pushes nothing, if it has no value.
  bool push_value(TokenSpan table) const {
    const char* begin = table.front().word.data();
    const std::string code = "return " + std::string(begin, &table.back().word.back() + 1);
    if (luaL_loadbufferx(L_, code.data(), code.size(), "=constant", "t") == LUA_OK &&
        lua_pcall(L_, 0, 1, 0) == LUA_OK)
      return true;
    lua_pop(L_, 1);
    return false;
  }

  void check(const Method& method, TokenSpan table, Problems& problems) const {
    if (!is_constant(table) || !push_value(table)) return;
    const auto line = 1 + std::count(text_.data(), table.front().word.data(), '\n');
    const std::string place = fmt::format("{}:{}: ", script_name_, line);
    for (const Problem& problem : problems_of_value(method))
      problems.add(place + problem.what, problem.remedy);
    lua_pop(L_, 1);
  }

  // Of the table on top; none if a recording would take it.
  std::vector<Problem> problems_of_value(const Method& method) const {
    const Arguments arguments = read(*method.of_simulation);
    if (method.of_recording != nullptr && read(*method.of_recording).problems.list().empty())
      return {};
    if (!arguments.problems.list().empty()) return arguments.problems.list();
    try {
      check_ending(std::string(method.of_simulation->name), arguments.text("file"), method.kind);
    } catch (const Error& error) {
      return error.problems();
    }
    return {};
  }

  Arguments read(const FunctionDoc& doc) const {
    return Arguments::from_table(L_, lua_gettop(L_), doc);
  }

  lua_State* L_;
  std::string_view text_;
  const std::string& script_name_;
  std::vector<Token> tokens_;
};

}  // namespace

Problems problems_of_constant_calls(lua_State* L, std::string_view text,
                                    const std::string& script_name) {
  return ConstantCalls(L, text, script_name).problems();
}

}  // namespace hackle
