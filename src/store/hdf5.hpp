// SPDX-License-Identifier: MIT
// A thin layer over HDF5, whose errors say what failed.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <hdf5.h>

namespace hackle {

// Owns an HDF5 identifier and closes it.
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
  // Closes the identifier. Returns false if that fails, e.g. when a file on a full disk is closed.
  bool reset();

 private:
  hid_t id_ = -1;
  Close close_ = nullptr;
};

// Numbers in a file, one row per node.
struct Dataset {
  std::string name;
  hid_t file_type;             // type in the file
  std::vector<hsize_t> shape;  // rows, or rows and columns
  std::string units, long_name;
};

// Returns the last error message of HDF5.
std::string cause_of_failure();

// Call this before any other HDF5 function: errors are thrown, not printed. At the end of the
// program the library does not touch identifiers that could not be closed, because that would crash
// it.
void begin_hdf5();

// Returns the access options: without the locks of the library, which would keep readers and
// writers apart.
Hdf5Handle without_locks();

// A file being written. Every function throws Error (files) with the reason from HDF5.
class Hdf5File {
 public:
  // Replaces an existing file. The file may be read while it is written.
  explicit Hdf5File(const std::filesystem::path& path);

  void attribute(const std::string& name, const std::string& text);
  void attribute(const std::string& name, long long number);  // replaces the old value

  // Creates a group for at most `members` members that cannot be found yet: once it is filled and
  // flushed, name() links it. The names of its members are stored in one block of that size, so
  // that a process killed while adding one leaves the others readable.
  Hdf5Handle group(unsigned members);
  void name(const Hdf5Handle& group, const std::string& name);

  // Creates a dataset of single values, numbers or texts, that grows by append().
  Hdf5Handle series(const std::string& name, hid_t type, const std::string& units,
                    const std::string& long_name);
  // Returns one that the file has.
  Hdf5Handle series(const std::string& name);
  // Appends a value as number `index`.
  void append(const Hdf5Handle& series, hsize_t index, hid_t type, const void* value);
  // Writes a dataset at once, compressing each column separately: the values of a column are alike,
  // and compress better and faster. `values`, of `memory_type`, may have fewer columns: missing
  // columns read as 0 and take no space.
  void write(const Hdf5Handle& group, const Dataset& dataset, hid_t memory_type, hsize_t columns,
             const void* values);
  // Writes a text of any length as its own dataset; attributes are limited to 64 KiB.
  void write_text(const Hdf5Handle& group, const std::string& name, const std::string& text,
                  const std::string& long_name);
  const Hdf5Handle& root() const { return file_; }
  // Gives it another name, replacing a file of that name, when the disk has all of it.
  void rename(const std::filesystem::path& path);
  void flush();
  void close();

 private:
  hid_t checked(hid_t result, const std::string& doing) const;
  void describe(hid_t object, const std::string& name, const std::string& text);

  std::filesystem::path path_;
  Hdf5Handle file_;
};

}  // namespace hackle
