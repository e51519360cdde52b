#pragma once
// HDF5 files of named arrays, each written once and read as a whole. A failure is a std::runtime_error that
// names the operation, the file and the reason that HDF5 gives.
//
// Limitations: one thread at a time (Debian's serial HDF5); contiguous arrays of double or int in native byte
// order.
#include <hdf5.h>

#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace capstan {

/// Owns an HDF5 identifier: a file, a data set, a property list ..
class Hdf5Handle {
 public:
  using Closer = herr_t (*)(hid_t);

  Hdf5Handle(hid_t id, Closer closer) : id_(id), closer_(closer) {}
  ~Hdf5Handle() {
    if (valid()) closer_(id_);
  }
  Hdf5Handle(const Hdf5Handle&) = delete;
  Hdf5Handle& operator=(const Hdf5Handle&) = delete;

  bool valid() const { return id_ >= 0; }
  hid_t id() const { return id_; }

  /// Closes now. False if that fails; the destructor could not report it.
  bool close() { return closer_(std::exchange(id_, H5I_INVALID_HID)) >= 0; }

 private:
  hid_t id_;
  Closer closer_;
};

class Hdf5Writer {
 public:
  /// Creates an empty file, or replaces the one there. Its first `user_block` bytes (0, 512, 1024, ..) are
  /// left to the caller.
  explicit Hdf5Writer(const std::filesystem::path& path, hsize_t user_block = 0);

  /// Writes an array with rows of `columns` numbers. A '/' in the name creates groups.
  void write(const std::string& name, std::span<const double> values, hsize_t columns = 1);
  void write(const std::string& name, std::span<const int> values, hsize_t columns = 1);

  /// Passes all data to the operating system. A file that was not closed this way may be incomplete.
  void close();

 private:
  void write(const std::string& name, hid_t type, const void* values, hsize_t count, hsize_t columns);

  std::filesystem::path path_;
  Hdf5Handle file_;
};

class Hdf5Reader {
 public:
  explicit Hdf5Reader(const std::filesystem::path& path);

  /// All arrays of the file, in alphabetical order.
  std::vector<std::string> names() const;

  /// The numbers of an array, row by row.
  std::vector<double> read(const std::string& name) const;

 private:
  std::filesystem::path path_;
  Hdf5Handle file_;
};

}  // namespace capstan
