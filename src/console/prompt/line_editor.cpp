// SPDX-License-Identifier: MIT
// While a line is edited the terminal sends no signals: Ctrl-C and Ctrl-Z arrive as keys. So no
// signal handler ever interferes with libedit.
#include "console/prompt/line_editor.hpp"

#include <cerrno>
#include <clocale>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cwchar>
#include <exception>
#include <string_view>
#include <utility>

#include <histedit.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "base/terminal.hpp"

namespace hackle {
namespace {

constexpr int longest_history = 2000;
constexpr std::size_t longest_list = 100;  // candidates

// Returns whether text is being pasted: it arrives faster than a person presses Tab twice.
bool is_pasted() {
  int waiting = 0;
  return ioctl(STDIN_FILENO, FIONREAD, &waiting) == 0 && waiting > 1;
}

}  // namespace

struct LineEditor::Parts {
  explicit Parts(std::filesystem::path file_) : file(std::move(file_)) {
    HistEvent event;
    history(lines, &event, H_SETSIZE, longest_history);
    history(lines, &event, H_SETUNIQUE, 1);
    if (!file.empty()) history(lines, &event, H_LOAD, file.c_str());
    el_set(editor, EL_CLIENTDATA, this);
    el_set(editor, EL_PROMPT, show_prompt);
    el_set(editor, EL_EDITOR, "emacs");
    el_set(editor, EL_HIST, history, lines);
    el_set(editor, EL_GETCFN, next_key);
    bind_keys();
    el_source(editor, nullptr);  // the user's ~/.editrc
    el_set(editor, EL_SETTY, "-d", "-isig", nullptr);
  }
  ~Parts() {
    el_end(editor);
    history_end(lines);
  }
  Parts(const Parts&) = delete;
  Parts& operator=(const Parts&) = delete;

  static EditLine* begin() {
    std::setlocale(LC_CTYPE, "");  // for letters beyond ASCII; numbers keep their form
    return el_init("hackle", stdin, stdout, stderr);
  }

  void bind_keys() {
    el_set(editor, EL_ADDFN, "hackle-clear", "Drops the line", clear);
    el_set(editor, EL_ADDFN, "hackle-suspend", "Goes to the background", suspend);
    el_set(editor, EL_ADDFN, "hackle-complete", "Completes the word", tab);
    el_set(editor, EL_BIND, "^I", "hackle-complete", nullptr);
    el_set(editor, EL_BIND, "^C", "hackle-clear", nullptr);
    el_set(editor, EL_BIND, "^Z", "hackle-suspend", nullptr);
    el_set(editor, EL_BIND, "^R", "em-inc-search-prev", nullptr);
  }

  static Parts& of(EditLine* editor) {
    Parts* parts = nullptr;
    el_get(editor, EL_CLIENTDATA, &parts);
    return *parts;
  }
  // libedit is C, so its callbacks must not throw.
  static char* show_prompt(EditLine* editor) noexcept { return of(editor).prompt.data(); }
  static unsigned char clear(EditLine* editor, int) noexcept {
    const LineInfo* typed = el_line(editor);
    of(editor).dropped.assign(typed->buffer, typed->lastchar);
    of(editor).cleared = true;
    return CC_EOF;
  }
  static unsigned char suspend(EditLine* editor, int) noexcept {
    el_set(editor, EL_PREP_TERM, 0);
    std::raise(SIGTSTP);
    el_set(editor, EL_PREP_TERM, 1);
    return CC_REDISPLAY;
  }

  // Replaces libedit's function, and lets others work before a key is pressed. Their exceptions end
  // the line, and read() rethrows them.
  static int next_key(EditLine* editor, wchar_t* key) noexcept {
    try {
      return give_others_their_turn(editor) ? read_character(key) : 0;
    } catch (...) {
      of(editor).failure = std::current_exception();
      return 0;
    }
  }

  // Returns false if the program is asked to leave.
  static bool give_others_their_turn(EditLine* editor) {
    const Parts& parts = of(editor);
    bool has_spoken = false;
    const auto make_room = [&] {
      if (!std::exchange(has_spoken, true)) std::fputs("\r\033[K", stdout);
      std::fflush(stdout);
    };
    const auto idle = [&](const MakeRoom& room) {
      const bool more = parts.idle && parts.idle(room);
      std::fflush(stdout);
      if (std::exchange(has_spoken, false)) el_set(editor, EL_REFRESH);
      return more;
    };
    return wait_for_input(idle, make_room);
  }

  // Returns 1, or 0 at the end of the input.
  static int read_character(wchar_t* character) {
    std::mbstate_t state{};
    char byte = 0;
    for (;;) {
      const ssize_t count = ::read(STDIN_FILENO, &byte, 1);
      if (count < 0 && errno == EINTR) continue;
      if (count != 1) return 0;
      const std::size_t length = std::mbrtowc(character, &byte, 1, &state);
      constexpr auto incomplete = static_cast<std::size_t>(-2);
      if (length <= 1) return 1;
      if (length != incomplete) state = {};  // not a character: dropped
    }
  }

  std::string before_cursor() const {
    const LineInfo* info = el_line(editor);
    return {info->buffer, info->cursor};
  }
  static unsigned char tab(EditLine* editor, int) noexcept {
    if (is_pasted() || !of(editor).completer)
      return el_insertstr(editor, "  ") == 0 ? CC_REFRESH : CC_ERROR;
    try {
      return of(editor).complete();
    } catch (...) {
      return CC_ERROR;
    }
  }
  // The first Tab inserts the unambiguous part; a second one, with nothing to insert, shows the
  // choices.
  unsigned char complete() {
    const Completion completion = completer(before_cursor());
    const std::string added = completion.insertion();
    const bool again = std::exchange(tried, before_cursor() + added) == before_cursor();
    if (!added.empty()) return el_insertstr(editor, added.c_str()) == 0 ? CC_REFRESH : CC_ERROR;
    if (!again || completion.candidates.size() < 2) return CC_ERROR;
    std::fputc('\n', stdout);
    std::fputs(
        in_columns(completion.candidates, terminal_columns(STDOUT_FILENO), longest_list).c_str(),
        stdout);
    return CC_REDISPLAY;
  }

  void remember(const std::string& line) {
    HistEvent event;
    history(lines, &event, H_ENTER, line.c_str());
    if (file.empty()) return;
    std::error_code ignored;
    std::filesystem::create_directories(file.parent_path(), ignored);
    history(lines, &event, H_SAVE, file.c_str());
  }

  std::filesystem::path file;
  std::string prompt;
  std::string dropped;
  Completer completer;
  std::string tried = "\t";  // the line after the last Tab
  bool cleared = false;
  Idle idle;
  std::exception_ptr failure;
  EditLine* editor = begin();
  History* lines = history_init();
};

LineEditor::LineEditor(std::filesystem::path history)
    : parts_(std::make_unique<Parts>(std::move(history))) {
}

LineEditor::~LineEditor() = default;

void LineEditor::complete_with(Completer complete) {
  parts_->completer = std::move(complete);
}

LineEnd LineEditor::read(const std::string& prompt, std::string& line, const Idle& idle) {
  parts_->prompt = prompt;
  parts_->idle = idle;
  parts_->cleared = false;
  parts_->tried = "\t";
  int count = 0;
  const char* text = el_gets(parts_->editor, &count);
  if (parts_->failure) std::rethrow_exception(std::exchange(parts_->failure, nullptr));
  if (parts_->cleared) {
    std::fputs("^C\n", stdout);
    line = parts_->dropped;
    return LineEnd::cleared;
  }
  if (text == nullptr || count <= 0) {
    std::fputc('\n', stdout);
    return LineEnd::end_of_input;
  }
  line.assign(text, static_cast<std::size_t>(count));
  while (line.ends_with('\n') || line.ends_with('\r')) line.pop_back();
  if (!line.empty()) parts_->remember(line);
  return LineEnd::entered;
}

std::filesystem::path history_file() {
  const char* state = std::getenv("XDG_STATE_HOME");
  if (state != nullptr && *state == '/') return std::filesystem::path(state) / "hackle/history";
  const char* home = std::getenv("HOME");
  if (home == nullptr || *home == '\0') return {};
  return std::filesystem::path(home) / ".local/state/hackle/history";
}

}  // namespace hackle
