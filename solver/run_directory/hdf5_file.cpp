#include "solver/run_directory/hdf5_file.hpp"

#include <stdexcept>

namespace capstan {
namespace {

/// The innermost entry of HDF5's error stack: the message of the operating system, if there is one.
std::string hdf5_reason() {
  std::string reason;
  const auto keep_first = [](unsigned, const H5E_error2_t* entry, void* text) -> herr_t {
    auto& kept = *static_cast<std::string*>(text);
    if (kept.empty() && entry->desc) kept = entry->desc;
    return 0;
  };
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, keep_first, &reason);
  return reason.empty() ? "unknown reason" : reason;
}

/// Call before any handle is closed: every call into HDF5 clears the error stack.
[[noreturn]] void fail(const std::string& operation, const std::filesystem::path& path) {
  throw std::runtime_error(operation + " " + path.string() + ": " + hdf5_reason());
}

/// Switches off the printing of errors, which are thrown instead, and HDF5's clean-up at exit: on a full disk
/// HDF5 1.10 keeps a file that it can neither write nor close, and its clean-up crashes. All files are closed
/// by this class, so nothing else needs cleaning up.
void prepare_library() {
  H5dont_atexit();
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

/// File locks are switched off, because some cluster file systems do not support them. They are not needed:
/// readers see complete files only.
hid_t access_without_locks() {
  const hid_t access = H5Pcreate(H5P_FILE_ACCESS);
  H5Pset_file_locking(access, false, true);
  return access;
}

hid_t create_file(const std::filesystem::path& path, hsize_t user_block) {
  prepare_library();
  const Hdf5Handle creation(H5Pcreate(H5P_FILE_CREATE), H5Pclose);
  const Hdf5Handle access(access_without_locks(), H5Pclose);
  H5Pset_userblock(creation.id(), user_block);
  const hid_t file = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, creation.id(), access.id());
  if (file < 0) fail("cannot create", path);
  return file;
}

hid_t open_file(const std::filesystem::path& path) {
  prepare_library();
  const Hdf5Handle access(access_without_locks(), H5Pclose);
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, access.id());
  if (file < 0) fail("cannot open", path);
  return file;
}

/// A data space with rows of `columns` numbers; of one dimension for a single column.
hid_t create_space(hsize_t count, hsize_t columns) {
  const hsize_t shape[] = {count / columns, columns};
  return H5Screate_simple(columns == 1 ? 1 : 2, shape, nullptr);
}

herr_t append_dataset_name(hid_t, const char* name, const H5O_info_t* info, void* names) {
  if (info->type == H5O_TYPE_DATASET) static_cast<std::vector<std::string>*>(names)->emplace_back(name);
  return 0;
}

}  // namespace

Hdf5Writer::Hdf5Writer(const std::filesystem::path& path, hsize_t user_block)
    : path_(path), file_(create_file(path, user_block), H5Fclose) {}

void Hdf5Writer::write(const std::string& name, std::span<const double> values, hsize_t columns) {
  write(name, H5T_NATIVE_DOUBLE, values.data(), values.size(), columns);
}

void Hdf5Writer::write(const std::string& name, std::span<const int> values, hsize_t columns) {
  write(name, H5T_NATIVE_INT, values.data(), values.size(), columns);
}

void Hdf5Writer::write(const std::string& name, hid_t type, const void* values, hsize_t count,
                       hsize_t columns) {
  const Hdf5Handle space(create_space(count, columns), H5Sclose);
  const Hdf5Handle links(H5Pcreate(H5P_LINK_CREATE), H5Pclose);
  H5Pset_create_intermediate_group(links.id(), 1);
  const Hdf5Handle creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  H5Pset_obj_track_times(creation.id(), false);  // no time stamps: equal numbers give equal files
  Hdf5Handle dataset(
      H5Dcreate2(file_.id(), name.c_str(), type, space.id(), links.id(), creation.id(), H5P_DEFAULT),
      H5Dclose);
  if (!dataset.valid() || H5Dwrite(dataset.id(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) < 0 ||
      !dataset.close())  // writes what HDF5 still has in memory
    fail("cannot write \"" + name + "\" to", path_);
}

void Hdf5Writer::close() {
  if (H5Fflush(file_.id(), H5F_SCOPE_LOCAL) < 0 || !file_.close()) fail("cannot close", path_);
}

Hdf5Reader::Hdf5Reader(const std::filesystem::path& path) : path_(path), file_(open_file(path), H5Fclose) {}

std::vector<std::string> Hdf5Reader::names() const {
  std::vector<std::string> names;
  if (H5Ovisit(file_.id(), H5_INDEX_NAME, H5_ITER_INC, append_dataset_name, &names) < 0)
    fail("cannot list", path_);
  return names;
}

std::vector<double> Hdf5Reader::read(const std::string& name) const {
  const std::string operation = "cannot read \"" + name + "\" from";
  const Hdf5Handle dataset(H5Dopen2(file_.id(), name.c_str(), H5P_DEFAULT), H5Dclose);
  if (!dataset.valid()) fail(operation, path_);
  const Hdf5Handle space(H5Dget_space(dataset.id()), H5Sclose);
  const hssize_t count = H5Sget_simple_extent_npoints(space.id());
  if (count < 0) fail(operation, path_);
  std::vector<double> values(static_cast<size_t>(count));
  if (H5Dread(dataset.id(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) < 0)
    fail(operation, path_);
  return values;
}

}  // namespace capstan
