// SPDX-License-Identifier: MIT
// The few things Hackle does with HDF5, with errors that say what failed.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <hdf5.h>

namespace hackle {

// Owns an identifier of HDF5 and closes it.
class Hdf5Handle {
 public:
  using Close = herr_t (*)(hid_t);

  Hdf5Handle() = default;
  Hdf5Handle(hid_t id, Close close) : id_(id), close_(close) {}
  Hdf5Handle(Hdf5Handle&& other) noexcept
      : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Hdf5Handle& operator=(Hdf5Handle&& other) noexcept;
  ~Hdf5Handle() { reset(); }

  hid_t get() const { return id_; }
  // Closes it. Returns false when that failed, as closing a file on a full disk does.
  bool reset();

 private:
  hid_t id_ = -1;
  Close close_ = nullptr;
};

// Numbers in a file, one row a node.
struct Dataset {
  std::string name;
  hid_t file_type;             // how they are stored
  std::vector<hsize_t> shape;  // rows, or rows and columns
  std::string units, long_name;
};

// What HDF5 says went wrong last.
std::string cause_of_failure();

// Before anything else is asked of HDF5: errors are thrown, not printed. At the end of the program
// the library leaves alone what it could not close, which it would not survive.
void begin_hdf5();

// How files are opened: without the locks of the library, which keep readers and writers apart.
Hdf5Handle without_locks();

// A file being written. Every function throws Error (files) with the reason that HDF5 gives.
class Hdf5File {
 public:
  // Replaces a file that is there. It may be read while it is written.
  explicit Hdf5File(const std::filesystem::path& path);

  void attribute(const std::string& name, const std::string& text);
  void attribute(const std::string& name, long long number);  // replaces an old value

  // A group for at most `members` things, that cannot be found yet: when it is filled and flushed,
  // name() puts it where it belongs. The names of its members are kept in one block of that size,
  // so that a process killed while one is added leaves the others readable.
  Hdf5Handle group(unsigned members);
  void name(const Hdf5Handle& group, const std::string& name);

  // A dataset of single values that grows by append().
  Hdf5Handle series(const std::string& name, hid_t type, const std::string& units,
                    const std::string& long_name);
  // Appends a value as number `index`.
  void append(const Hdf5Handle& series, hsize_t index, hid_t type, const void* value);
  // A dataset written at once, each column compressed by itself: what lies side by side in one is
  // alike, and packs better and in less time. `values`, of `memory_type`, may have fewer columns:
  // those that are missing read as 0 and take no room.
  void write(const Hdf5Handle& group, const Dataset& dataset, hid_t memory_type, hsize_t columns,
             const void* values);
  // A text of any length as a dataset of its own; attributes end at 64 KiB.
  void write_text(const std::string& name, const std::string& text, const std::string& long_name);
  const Hdf5Handle& root() const { return file_; }
  void flush();
  void close();

 private:
  hid_t checked(hid_t result, const std::string& doing) const;
  void describe(hid_t object, const std::string& name, const std::string& text);

  std::filesystem::path path_;
  Hdf5Handle file_;
};

}  // namespace hackle
