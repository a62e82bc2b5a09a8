#include "host/output/hdf5_file.hpp"

#include <algorithm>

namespace riffle::hdf5 {
namespace {

void check(herr_t status, const char* what) {
  if (status < 0) throw Error(std::string("HDF5 cannot ") + what);
}

template <class T>
struct Types;
template <>
struct Types<double> {
  static hid_t file() { return H5T_IEEE_F64LE; }
  static hid_t memory() { return H5T_NATIVE_DOUBLE; }
};
template <>
struct Types<std::int64_t> {
  static hid_t file() { return H5T_STD_I64LE; }
  static hid_t memory() { return H5T_NATIVE_INT64; }
};
template <>
struct Types<std::uint8_t> {
  static hid_t file() { return H5T_STD_U8LE; }
  static hid_t memory() { return H5T_NATIVE_UINT8; }
};

// Values in one chunk of a packed dataset: large enough to compress well, small enough for HDF5's chunk cache.
constexpr hsize_t chunk = 65536;

template <class T>
void write_values(hid_t group, const std::string& name, std::span<const T> values, hsize_t width, bool packed) {
  const hsize_t columns = std::max<hsize_t>(width, 1);
  const hsize_t extent[2] = {values.size() / columns, columns};
  const Handle space(H5Screate_simple(width > 0 ? 2 : 1, extent, nullptr), H5Sclose, "make a data space");
  const Handle options(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, "make a property list");
  // Files of the same content are the same bytes, whenever they are written.
  check(H5Pset_obj_track_times(options.id(), false), "leave times out");
  if (packed && !values.empty() && H5Zfilter_avail(H5Z_FILTER_DEFLATE) > 0) {
    const hsize_t size[2] = {std::min(extent[0], chunk), columns};
    check(H5Pset_chunk(options.id(), width > 0 ? 2 : 1, size), "set chunks");
    check(H5Pset_shuffle(options.id()), "set a filter");
    check(H5Pset_deflate(options.id(), 1), "set a filter");
  }
  Handle set(H5Dcreate2(group, name.c_str(), Types<T>::file(), space.id(), H5P_DEFAULT, options.id(), H5P_DEFAULT),
             H5Dclose, "make a data set");
  if (!values.empty()) {
    check(H5Dwrite(set.id(), Types<T>::memory(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), "write a data set");
  }
  set.close();
}

template <class T>
std::vector<T> read_values(hid_t group, const std::string& name, H5T_class_t kind, std::uintmax_t most) {
  const Handle set(H5Dopen2(group, name.c_str(), H5P_DEFAULT), H5Dclose, "open a data set");
  const Handle type(H5Dget_type(set.id()), H5Tclose, "tell a type");
  const Handle space(H5Dget_space(set.id()), H5Sclose, "tell an extent");
  if (H5Tget_class(type.id()) != kind || H5Tget_size(type.id()) != sizeof(T)) throw Error(name + " has another type");
  hsize_t count = 0;
  if (H5Sget_simple_extent_ndims(space.id()) != 1) throw Error(name + " is not a list");
  check(H5Sget_simple_extent_dims(space.id(), &count, nullptr), "tell an extent");
  if (count > most) throw Error(name + " is longer than its file");
  std::vector<T> values(count);
  if (count > 0) {
    check(H5Dread(set.id(), Types<T>::memory(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), "read a data set");
  }
  return values;
}

Handle memory_access() {
  Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "make a property list");
  check(H5Pset_fapl_core(access.id(), std::size_t{1} << 20, 0), "keep a file in memory");
  return access;
}

Handle create_in_memory() {
  return {H5Fcreate("in-memory", H5F_ACC_TRUNC, H5P_DEFAULT, memory_access().id()), H5Fclose, "make a file"};
}

herr_t append_name(hid_t, const char* name, const H5L_info_t*, void* list) {
  static_cast<std::vector<std::string>*>(list)->emplace_back(name);
  return 0;
}

}  // namespace

void Handle::close() {
  check(close_(std::exchange(id_, -1)), "write a file");
}

Silence::Silence() {
  H5Eget_auto2(H5E_DEFAULT, &function_, &data_);
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

Silence::~Silence() {
  H5Eset_auto2(H5E_DEFAULT, function_, data_);
}

MemoryFile::MemoryFile() : file_(create_in_memory()) {}

std::string MemoryFile::image(std::size_t room) const {
  check(H5Fflush(file_.id(), H5F_SCOPE_GLOBAL), "flush a file");
  const ssize_t size = H5Fget_file_image(file_.id(), nullptr, 0);
  if (size < 0) throw Error("HDF5 cannot tell the size of a file");
  std::string bytes(room + static_cast<std::size_t>(size), '\0');
  if (H5Fget_file_image(file_.id(), bytes.data() + room, static_cast<std::size_t>(size)) != size) {
    throw Error("HDF5 cannot copy a file");
  }
  return bytes;
}

Handle open_image(std::string_view bytes) {
  const Handle access = memory_access();
  // HDF5 copies the bytes; the cast is its interface's.
  check(H5Pset_file_image(access.id(), const_cast<char*>(bytes.data()), bytes.size()), "take a file from memory");
  return {H5Fopen("in-memory", H5F_ACC_RDONLY, access.id()), H5Fclose, "open a file"};
}

Handle create_group(hid_t parent, const std::string& name) {
  return {H5Gcreate2(parent, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose, "make a group"};
}

Handle open_group(hid_t parent, const std::string& name) {
  return {H5Gopen2(parent, name.c_str(), H5P_DEFAULT), H5Gclose, "open a group"};
}

void write(hid_t group, const std::string& name, std::span<const double> values, hsize_t width) {
  write_values(group, name, values, width, false);
}

void write(hid_t group, const std::string& name, std::span<const std::int64_t> values, bool packed) {
  write_values(group, name, values, 0, packed);
}

void write(hid_t group, const std::string& name, std::span<const std::uint8_t> values, bool packed) {
  write_values(group, name, values, 0, packed);
}

void write_attribute(hid_t group, const std::string& name, std::span<const std::int64_t> values) {
  const hsize_t extent = values.size();
  const Handle space(H5Screate_simple(1, &extent, nullptr), H5Sclose, "make a data space");
  const Handle attribute(H5Acreate2(group, name.c_str(), H5T_STD_I64LE, space.id(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
                         "make an attribute");
  check(H5Awrite(attribute.id(), H5T_NATIVE_INT64, values.data()), "write an attribute");
}

void write_attribute(hid_t group, const std::string& name, const std::string& text) {
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose, "make a data space");
  const Handle type(H5Tcopy(H5T_C_S1), H5Tclose, "make a type");
  check(H5Tset_size(type.id(), text.size()), "set the length of a text");
  check(H5Tset_strpad(type.id(), H5T_STR_NULLPAD), "set the end of a text");
  const Handle attribute(H5Acreate2(group, name.c_str(), type.id(), space.id(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
                         "make an attribute");
  check(H5Awrite(attribute.id(), type.id(), text.data()), "write an attribute");
}

std::vector<double> read_reals(hid_t group, const std::string& name, std::uintmax_t most) {
  return read_values<double>(group, name, H5T_FLOAT, most);
}

std::vector<std::int64_t> read_integers(hid_t group, const std::string& name, std::uintmax_t most) {
  return read_values<std::int64_t>(group, name, H5T_INTEGER, most);
}

std::vector<std::uint8_t> read_bytes(hid_t group, const std::string& name, std::uintmax_t most) {
  return read_values<std::uint8_t>(group, name, H5T_INTEGER, most);
}

std::vector<std::string> names(hid_t group) {
  std::vector<std::string> list;
  check(H5Literate(group, H5_INDEX_NAME, H5_ITER_INC, nullptr, append_name, &list), "list a group");
  return list;
}

}  // namespace riffle::hdf5
