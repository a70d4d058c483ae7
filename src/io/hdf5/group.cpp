#include "group.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "carom/base/error.hpp"

namespace carom::io {
namespace {

constexpr hsize_t kMostInAttribute = 1 << 16;
constexpr double kMostInChunk = 0x1p28;

template <typename Number>
hid_t one_of(hid_t of_double, hid_t of_signed, hid_t of_unsigned, hid_t of_index) {
  if constexpr (std::is_same_v<Number, double>) return of_double;
  if constexpr (std::is_same_v<Number, std::int64_t>) return of_signed;
  if constexpr (std::is_same_v<Number, std::uint64_t>) return of_unsigned;
  return of_index;
}

bool is_hard_link(hid_t group, const std::string& name) {
  H5L_info_t about;
  return H5Lexists(group, name.c_str(), H5P_DEFAULT) > 0 &&
         H5Lget_info(group, name.c_str(), &about, H5P_DEFAULT) >= 0 && about.type == H5L_TYPE_HARD;
}

Handle object_type(hid_t id) { return {id, H5Tclose}; }

/// A fixed-size type for a text; empty texts take one byte, as the library has no type of none.
Handle text_type(std::size_t length) {
  Handle type = object_type(H5Tcopy(H5T_C_S1));
  H5Tset_size(type.id(), std::max<std::size_t>(length, 1));
  H5Tset_strpad(type.id(), H5T_STR_NULLPAD);
  H5Tset_cset(type.id(), H5T_CSET_UTF8);
  return type;
}

Handle space_of(const std::vector<hsize_t>& extents) {
  const hid_t id = extents.empty() ? H5Screate(H5S_SCALAR)
                                   : H5Screate_simple(static_cast<int>(extents.size()), extents.data(), nullptr);
  return {id, H5Sclose};
}

std::vector<hsize_t> extents_of(hid_t space) {
  const int rank = H5Sget_simple_extent_ndims(space);
  std::vector<hsize_t> extents(static_cast<std::size_t>(std::max(rank, 0)));
  H5Sget_simple_extent_dims(space, extents.data(), nullptr);
  return extents;
}

/// Numbers of up to 64 bits, of the two kinds that are read here.
bool is_number(hid_t type) {
  const H5T_class_t kind = H5Tget_class(type);
  return (kind == H5T_INTEGER || kind == H5T_FLOAT) && H5Tget_size(type) <= 8;
}

/// Datasets that do not say when they were made: the same numbers give the same bytes.
Handle timeless() {
  Handle creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  H5Pset_obj_track_times(creation.id(), false);
  return creation;
}

void write_to_attribute(hid_t group, const std::string& name, hid_t stored, hid_t given,
                        const std::vector<hsize_t>& extents, const void* values, const std::string& file) {
  const Handle space = space_of(extents);
  const Handle attribute = opened(H5Acreate2(group, name.c_str(), stored, space.id(), H5P_DEFAULT, H5P_DEFAULT),
                                  H5Aclose, file, "an attribute cannot be written");
  require(H5Awrite(attribute.id(), given, values) >= 0, file, "an attribute cannot be written");
}

}  // namespace

template <typename Number>
hid_t file_type() {
  return one_of<Number>(H5T_IEEE_F64LE, H5T_STD_I64LE, H5T_STD_U64LE, H5T_STD_U32LE);
}

template <typename Number>
hid_t memory_type() {
  return one_of<Number>(H5T_NATIVE_DOUBLE, H5T_NATIVE_INT64, H5T_NATIVE_UINT64, H5T_NATIVE_UINT32);
}

hsize_t ArrayShape::count() const noexcept {
  hsize_t count = 1;
  for (const hsize_t extent : extents) count *= extent;
  return count;
}

Group::Group(const Handle& file, std::string name) : name_(std::move(name)) {
  group_ = opened(H5Gopen2(file.id(), "/", H5P_DEFAULT), H5Gclose, name_, "cannot be read");
}

Group::Group(Handle group, std::string name, std::string path)
    : group_(std::move(group)), name_(std::move(name)), path_(std::move(path)) {}

std::string Group::described(std::string_view member) const { return fmt::format("'{}/{}'", path_, member); }

void Group::fail(std::string_view what) const { throw Error(std::string(what), {name_}); }

bool Group::has(const std::string& path) const {
  for (std::size_t end = path.find('/'); end != std::string::npos; end = path.find('/', end + 1)) {
    if (!is_hard_link(id(), path.substr(0, end)) || !is_group(path.substr(0, end))) return false;
  }
  return is_hard_link(id(), path);
}

bool Group::has_attribute(const std::string& name) const { return H5Aexists(id(), name.c_str()) > 0; }

bool Group::is_group(const std::string& name) const {
  H5O_info_t about;
  return H5Oget_info_by_name2(id(), name.c_str(), &about, H5O_INFO_BASIC, H5P_DEFAULT) >= 0 &&
         about.type == H5O_TYPE_GROUP;
}

Group Group::below(const std::string& path) const {
  if (!has(path) || !is_group(path)) fail(fmt::format("the group {} is missing", described(path)));
  Handle group = opened(H5Gopen2(id(), path.c_str(), H5P_DEFAULT), H5Gclose, name_, "a group cannot be read");
  return {std::move(group), name_, path_ + '/' + path};
}

Group Group::create(const std::string& name) const {
  Handle group = opened(H5Gcreate2(id(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose, name_,
                        "a group cannot be written");
  return {std::move(group), name_, path_ + '/' + name};
}

std::vector<std::string> Group::names(std::size_t most) const {
  H5G_info_t about;
  require(H5Gget_info(id(), &about) >= 0, name_, "a group cannot be read");
  if (about.nlinks > most) fail(fmt::format("the group '{}' has {} members", path_, about.nlinks));
  std::vector<std::string> names;
  const auto take = [](hid_t, const char* name, const H5L_info_t*, void* into) -> herr_t {
    static_cast<std::vector<std::string>*>(into)->emplace_back(name);
    return 0;
  };
  hsize_t next = 0;
  require(H5Literate(id(), H5_INDEX_NAME, H5_ITER_INC, &next, take, &names) >= 0, name_, "a group cannot be read");
  return names;
}

void Group::write_text(const std::string& name, std::string_view text) const {
  const Handle type = text_type(text.size());
  const Handle space = space_of({});
  const Handle data =
      opened(H5Dcreate2(id(), name.c_str(), type.id(), space.id(), H5P_DEFAULT, timeless().id(), H5P_DEFAULT), H5Dclose,
             name_, "a text cannot be written");
  const std::string ended(text);
  require(H5Dwrite(data.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, ended.c_str()) >= 0, name_,
          "a text cannot be written");
}

void Group::write_attribute(const std::string& name, double value) const {
  write_to_attribute(id(), name, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, {}, &value, name_);
}

void Group::write_attribute(const std::string& name, std::uint64_t value) const {
  write_to_attribute(id(), name, H5T_STD_U64LE, H5T_NATIVE_UINT64, {}, &value, name_);
}

void Group::write_attribute(const std::string& name, const std::vector<double>& values) const {
  write_to_attribute(id(), name, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, {values.size()}, values.data(), name_);
}

void Group::write_attribute(const std::string& name, const std::vector<std::int64_t>& values) const {
  write_to_attribute(id(), name, H5T_STD_I64LE, H5T_NATIVE_INT64, {values.size()}, values.data(), name_);
}

void Group::write_attribute(const std::string& name, std::string_view text) const {
  const Handle type = text_type(text.size());
  const std::string ended(text);
  write_to_attribute(id(), name, type.id(), type.id(), {}, ended.c_str(), name_);
}

void Group::write_attribute(const std::string& name, const std::vector<std::string>& texts) const {
  std::size_t longest = 1;
  for (const std::string& text : texts) longest = std::max(longest, text.size());
  std::string packed;
  for (const std::string& text : texts) packed += text + std::string(longest - text.size(), '\0');
  const Handle type = text_type(longest);
  write_to_attribute(id(), name, type.id(), type.id(), {texts.size()}, packed.data(), name_);
}

template <typename Number>
void Group::write_array(const std::string& name, const std::vector<Number>& values) const {
  const Handle space = space_of({values.size()});
  const Handle data =
      opened(H5Dcreate2(id(), name.c_str(), file_type<Number>(), space.id(), H5P_DEFAULT, timeless().id(), H5P_DEFAULT),
             H5Dclose, name_, "an array cannot be written");
  if (values.empty()) return;
  require(H5Dwrite(data.id(), memory_type<Number>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) >= 0, name_,
          "an array cannot be written");
}

Handle Group::open_attribute(const std::string& name, ArrayShape& shape) const {
  if (!has_attribute(name)) fail(fmt::format("the attribute {} is missing", described(name)));
  Handle attribute = opened(H5Aopen(id(), name.c_str(), H5P_DEFAULT), H5Aclose, name_, "an attribute cannot be read");
  const Handle space(H5Aget_space(attribute.id()), H5Sclose);
  const H5S_class_t kind = H5Sget_simple_extent_type(space.id());
  if (kind != H5S_SCALAR && kind != H5S_SIMPLE) fail(fmt::format("the attribute {} is empty", described(name)));
  shape.extents = extents_of(space.id());
  hsize_t count = 1;
  for (const hsize_t extent : shape.extents) {
    if (extent > kMostInAttribute) fail(fmt::format("the attribute {} is too large", described(name)));
    count *= extent;
  }
  if (count > kMostInAttribute) fail(fmt::format("the attribute {} is too large", described(name)));
  return attribute;
}

std::vector<double> Group::read_numbers(const std::string& name, std::size_t count) const {
  ArrayShape shape;
  const Handle attribute = open_attribute(name, shape);
  const Handle type = object_type(H5Aget_type(attribute.id()));
  if (!is_number(type.id()) || shape.count() != count) {
    fail(fmt::format("the attribute {} is not {}", described(name),
                     count == 1 ? std::string("a number") : fmt::format("{} numbers", count)));
  }
  std::vector<double> values(count);
  require(H5Aread(attribute.id(), H5T_NATIVE_DOUBLE, values.data()) >= 0, name_, "an attribute cannot be read");
  return values;
}

double Group::read_number(const std::string& name) const { return read_numbers(name, 1).front(); }

std::uint64_t Group::read_count(const std::string& name) const {
  ArrayShape shape;
  const Handle attribute = open_attribute(name, shape);
  const Handle type = object_type(H5Aget_type(attribute.id()));
  if (H5Tget_class(type.id()) != H5T_INTEGER || H5Tget_size(type.id()) > 8 || shape.count() != 1) {
    fail(fmt::format("the attribute {} is not a whole number", described(name)));
  }
  std::uint64_t value = 0;
  require(H5Aread(attribute.id(), H5T_NATIVE_UINT64, &value) >= 0, name_, "an attribute cannot be read");
  return value;
}

std::vector<std::string> Group::read_texts(const std::string& name, std::size_t most) const {
  ArrayShape shape;
  const Handle attribute = open_attribute(name, shape);
  const Handle type = object_type(H5Aget_type(attribute.id()));
  const std::size_t size = H5Tget_size(type.id());
  if (H5Tget_class(type.id()) != H5T_STRING || shape.count() > most || size > kMostInAttribute) {
    fail(fmt::format("the attribute {} is not a text", described(name)));
  }
  std::vector<std::string> texts;
  if (H5Tis_variable_str(type.id()) > 0) {
    std::vector<char*> pointers(shape.count(), nullptr);
    const Handle space(H5Aget_space(attribute.id()), H5Sclose);
    require(H5Aread(attribute.id(), type.id(), pointers.data()) >= 0, name_, "an attribute cannot be read");
    for (const char* const text : pointers) texts.emplace_back(text != nullptr ? text : "");
    H5Dvlen_reclaim(type.id(), space.id(), H5P_DEFAULT, pointers.data());
    return texts;
  }
  std::string packed(size * shape.count(), '\0');
  require(H5Aread(attribute.id(), type.id(), packed.data()) >= 0, name_, "an attribute cannot be read");
  for (std::size_t k = 0; k < shape.count(); ++k) {
    const std::string text = packed.substr(k * size, size);
    texts.push_back(text.substr(0, text.find('\0')));
  }
  return texts;
}

std::string Group::read_text_attribute(const std::string& name) const {
  const std::vector<std::string> texts = read_texts(name, 1);
  return texts.empty() ? std::string() : texts.front();
}

std::string Group::read_text(const std::string& name, std::size_t most) const {
  if (!has(name) || is_group(name)) fail(fmt::format("the text {} is missing", described(name)));
  const Handle data = opened(H5Dopen2(id(), name.c_str(), H5P_DEFAULT), H5Dclose, name_, "a text cannot be read");
  const Handle type = object_type(H5Dget_type(data.id()));
  const Handle space(H5Dget_space(data.id()), H5Sclose);
  const Handle creation(H5Dget_create_plist(data.id()), H5Pclose);
  const std::size_t size = H5Tget_size(type.id());
  const bool sound = H5Tget_class(type.id()) == H5T_STRING && H5Tis_variable_str(type.id()) <= 0 && size <= most &&
                     H5Sget_simple_extent_type(space.id()) == H5S_SCALAR &&
                     H5Pget_layout(creation.id()) != H5D_VIRTUAL && H5Pget_external_count(creation.id()) == 0;
  if (!sound) fail(fmt::format("{} is not a text", described(name)));
  std::string text(size, '\0');
  require(H5Dread(data.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data()) >= 0, name_,
          "a text cannot be read");
  return text.substr(0, text.find('\0'));
}

Handle Group::open_array(const std::string& path, ArrayShape& shape, double most) const {
  if (!has(path) || is_group(path)) fail(fmt::format("the array {} is missing", described(path)));
  Handle data = opened(H5Dopen2(id(), path.c_str(), H5P_DEFAULT), H5Dclose, name_, "an array cannot be read");
  const Handle creation(H5Dget_create_plist(data.id()), H5Pclose);
  const H5D_layout_t layout = H5Pget_layout(creation.id());
  if (layout == H5D_VIRTUAL || H5Pget_external_count(creation.id()) > 0) {
    fail(fmt::format("{} keeps its numbers in another file, which is not followed", described(path)));
  }
  const Handle type = object_type(H5Dget_type(data.id()));
  if (!is_number(type.id())) fail(fmt::format("{} does not hold numbers", described(path)));
  shape.integers = H5Tget_class(type.id()) == H5T_INTEGER;
  const Handle space(H5Dget_space(data.id()), H5Sclose);
  if (H5Sget_simple_extent_type(space.id()) != H5S_SIMPLE) fail(fmt::format("{} is no array", described(path)));
  shape.extents = extents_of(space.id());
  double count = 1;
  for (const hsize_t extent : shape.extents) count *= static_cast<double>(extent);
  if (count > most) {
    fail(
        fmt::format("{} is said to have {:.3g} numbers: there cannot be so many in this file", described(path), count));
  }
  if (layout == H5D_CHUNKED) {
    std::vector<hsize_t> chunk(shape.extents.size());
    H5Pget_chunk(creation.id(), static_cast<int>(chunk.size()), chunk.data());
    double in_chunk = 1;
    for (const hsize_t extent : chunk) in_chunk *= static_cast<double>(extent);
    if (in_chunk > kMostInChunk) fail(fmt::format("{} has chunks of {:.3g} numbers", described(path), in_chunk));
  }
  return data;
}

std::size_t Group::length_of(const std::string& path, double most) const {
  ArrayShape shape;
  const Handle data = open_array(path, shape, most);
  if (shape.extents.size() != 1) fail(fmt::format("{} is not a row of numbers", described(path)));
  return shape.extents[0];
}

template <typename Number>
std::vector<Number> Group::read_array(const std::string& path, std::size_t count) const {
  ArrayShape shape;
  const Handle data = open_array(path, shape, static_cast<double>(count));
  if (shape.extents.size() != 1 || shape.extents[0] != count) {
    fail(fmt::format("{} has {} numbers where {} belong", described(path), shape.count(), count));
  }
  if (shape.integers != std::is_integral_v<Number>) {
    fail(fmt::format("{} has numbers of another kind", described(path)));
  }
  std::vector<Number> values(count);
  if (count == 0) return values;
  require(H5Dread(data.id(), memory_type<Number>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) >= 0, name_,
          "an array cannot be read");
  return values;
}

template hid_t file_type<double>();
template hid_t file_type<std::int64_t>();
template hid_t file_type<std::uint64_t>();
template hid_t file_type<std::uint32_t>();
template hid_t memory_type<double>();
template hid_t memory_type<std::int64_t>();
template hid_t memory_type<std::uint64_t>();
template hid_t memory_type<std::uint32_t>();
template void Group::write_array(const std::string&, const std::vector<double>&) const;
template void Group::write_array(const std::string&, const std::vector<std::int64_t>&) const;
template void Group::write_array(const std::string&, const std::vector<std::uint64_t>&) const;
template void Group::write_array(const std::string&, const std::vector<std::uint32_t>&) const;
template std::vector<double> Group::read_array(const std::string&, std::size_t) const;
template std::vector<std::int64_t> Group::read_array(const std::string&, std::size_t) const;
template std::vector<std::uint64_t> Group::read_array(const std::string&, std::size_t) const;
template std::vector<std::uint32_t> Group::read_array(const std::string&, std::size_t) const;

}  // namespace carom::io
