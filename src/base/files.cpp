// SPDX-License-Identifier: MIT
#include "base/files.hpp"

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <fstream>
#include <vector>

#include <unistd.h>

#include "base/error.hpp"
#include "base/file_lock.hpp"

namespace hackle {
namespace fs = std::filesystem;
namespace {

// bytes: a limit, because a device may never end
constexpr std::size_t max_text = std::size_t{1} << 26U;

std::vector<fs::path> data_folders() {
  std::vector<fs::path> folders;
  if (const char* chosen = std::getenv("HACKLE_DATA")) folders.emplace_back(chosen);
  std::error_code ignored;
  const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
  if (!program.empty()) folders.push_back(program.parent_path().parent_path() / "share/hackle");
  return folders;
}

fs::path nearest_existing(fs::path folder) {
  std::error_code ignored;
  while (!fs::exists(folder, ignored) && folder.has_relative_path()) folder = folder.parent_path();
  return folder;
}

}  // namespace

std::optional<fs::path> find_data_file(const fs::path& name) {
  for (const fs::path& folder : data_folders()) {
    std::error_code ignored;
    if (fs::exists(folder / name, ignored)) return folder / name;
  }
  return std::nullopt;
}

fs::path data_file(const fs::path& name) {
  if (const auto found = find_data_file(name)) return *found;
  std::string looked;
  for (const fs::path& folder : data_folders())
    looked += (looked.empty() ? "" : ", ") + folder.string();
  throw Error(ErrorKind::files, "'" + name.string() + "' was not found in " + looked,
              "set HACKLE_DATA to the folder that holds shaders and assets");
}

std::string read_text(const fs::path& path) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored))
    throw Error(ErrorKind::files, "'" + path.string() + "' is a folder, not a file");
  std::ifstream file(path, std::ios::binary);
  if (!file)
    throw Error(ErrorKind::files, "cannot read '" + path.string() + "': " + std::strerror(errno));
  std::string text;
  std::array<char, 1 << 16> piece{};
  while (file.read(piece.data(), piece.size()) || file.gcount() > 0) {
    text.append(piece.data(), static_cast<std::size_t>(file.gcount()));
    if (text.size() > max_text)
      throw Error(ErrorKind::files, "'" + path.string() + "' is larger than 64 MiB: no text");
  }
  if (file.bad())
    throw Error(ErrorKind::files, "cannot read '" + path.string() + "': " + std::strerror(errno));
  return text;
}

void write_text(const fs::path& path, const std::string& text) {
  const fs::path partial = partial_name(path);
  const HeldFile held(partial, path);
  std::ofstream file(partial, std::ios::binary);
  file << text;
  file.close();
  if (!file)
    throw Error(ErrorKind::files, "cannot write '" + path.string() + "': " + std::strerror(errno));
  publish(path);
}

fs::path partial_name(const fs::path& path) {
  return path.parent_path() / ("." + path.stem().string() + ".partial" + path.extension().string());
}

void publish(const fs::path& path) {
  std::error_code failure;
  fs::rename(partial_name(path), path, failure);
  if (failure)
    throw Error(ErrorKind::files, "cannot create '" + path.string() + "': " + failure.message());
}

fs::path real_path(const fs::path& path) {
  constexpr int max_links = 40;  // as in the kernel
  const fs::path start = fs::current_path() / path;
  std::deque<fs::path> to_go(start.begin(), start.end());
  fs::path done = "/";
  for (int links = 0; !to_go.empty();) {
    const fs::path part = to_go.front();
    to_go.pop_front();
    std::error_code no_link;
    const fs::path target = fs::read_symlink(done / part, no_link);
    if (part == "..")
      done = done.parent_path();
    else if (!no_link && ++links > max_links)
      throw Error(ErrorKind::files, "'" + path.string() + "' leads through links in a circle");
    else if (!no_link)
      to_go.insert(to_go.begin(), target.begin(), target.end());
    else if (!part.empty() && part != ".")
      done /= part;  // "/" starts again from the root
  }
  return done;
}

void check_writable(const fs::path& path) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored))
    throw Error(ErrorKind::files, "cannot write '" + path.string() + "': it is a folder",
                "choose another file name");
  const fs::path folder = nearest_existing(fs::absolute(path).parent_path());
  const std::string named = "cannot write '" + path.string() + "': '" + folder.string() + "' ";
  if (!fs::is_directory(folder, ignored))
    throw Error(ErrorKind::files, named + "is not a folder", "choose another folder with -o");
  if (access(folder.c_str(), W_OK | X_OK) != 0)
    throw Error(ErrorKind::files, named + "is not writable: " + std::strerror(errno),
                "choose another folder with -o");
}

void make_folder_of(const fs::path& path) {
  std::error_code failure;
  fs::create_directories(fs::absolute(path).parent_path(), failure);
  if (failure)
    throw Error(
        ErrorKind::files,
        "cannot create the folder '" + path.parent_path().string() + "': " + failure.message(),
        "choose another folder with -o");
}

}  // namespace hackle
