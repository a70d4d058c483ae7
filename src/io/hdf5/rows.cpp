#include "rows.hpp"

#include <libdeflate.h>

#include <algorithm>
#include <bit>
#include <memory>

#include "carom/base/error.hpp"

namespace carom::io {
namespace {

constexpr hsize_t kEntriesPerChunk = 65536;
constexpr hsize_t kNumbersPerChunk = 512;
constexpr int kLevel = 1;  // most bits of positions and velocities are random: trying harder gains little

static_assert(std::endian::native == std::endian::little, "chunks are written as they lie in memory");

/// The extents of a chunk: of one row, or of many where rows are single numbers.
std::vector<hsize_t> chunk_of(const std::vector<hsize_t>& row) {
  if (row.empty()) return {kNumbersPerChunk};
  std::vector<hsize_t> chunk{1};
  chunk.insert(chunk.end(), row.begin(), row.end());
  chunk[1] = std::min(chunk[1], kEntriesPerChunk);
  return chunk;
}

/// zlib streams, made faster than HDF5's own filter makes them. One per thread.
class Compressor {
 public:
  Compressor() : compressor_(libdeflate_alloc_compressor(kLevel)) {
    if (compressor_ == nullptr) throw std::bad_alloc();
  }
  ~Compressor() { libdeflate_free_compressor(compressor_); }
  Compressor(const Compressor&) = delete;
  Compressor& operator=(const Compressor&) = delete;

  /// Valid until the next call.
  std::span<const unsigned char> compressed(std::span<const unsigned char> bytes) {
    buffer_.resize(libdeflate_zlib_compress_bound(compressor_, bytes.size()));
    const std::size_t size =
        libdeflate_zlib_compress(compressor_, bytes.data(), bytes.size(), buffer_.data(), buffer_.size());
    return {buffer_.data(), size};
  }

 private:
  libdeflate_compressor* compressor_;
  std::vector<unsigned char> buffer_;
};

}  // namespace

std::vector<unsigned char> shuffled(const unsigned char* bytes, std::size_t size, std::size_t count) {
  std::vector<unsigned char> planes(size * count);
  for (std::size_t byte = 0; byte < size; ++byte) {
    unsigned char* const plane = planes.data() + byte * count;
    for (std::size_t k = 0; k < count; ++k) plane[k] = bytes[k * size + byte];
  }
  return planes;
}

Rows::Rows(Handle data, std::vector<hsize_t> row, hsize_t count, std::string file)
    : data_(std::move(data)), row_(std::move(row)), count_(count), file_(std::move(file)) {}

template <typename Number>
Rows Rows::create(const Group& group, const std::string& name, std::vector<hsize_t> row) {
  const std::string& file = group.file_name();
  std::vector<hsize_t> extents{0};
  extents.insert(extents.end(), row.begin(), row.end());
  std::vector<hsize_t> limits = extents;
  limits[0] = H5S_UNLIMITED;
  const Handle space(H5Screate_simple(static_cast<int>(extents.size()), extents.data(), limits.data()), H5Sclose);
  const Handle creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  const std::vector<hsize_t> chunk = chunk_of(row);
  bool done = H5Pset_obj_track_times(creation.id(), false) >= 0 &&
              H5Pset_chunk(creation.id(), static_cast<int>(chunk.size()), chunk.data()) >= 0;
  if (!row.empty()) done = done && H5Pset_shuffle(creation.id()) >= 0 && H5Pset_deflate(creation.id(), kLevel) >= 0;
  require(done, file, "a dataset cannot be written");
  Handle data = opened(
      H5Dcreate2(group.id(), name.c_str(), file_type<Number>(), space.id(), H5P_DEFAULT, creation.id(), H5P_DEFAULT),
      H5Dclose, file, "a dataset cannot be written");
  return {std::move(data), std::move(row), 0, file};
}

Rows Rows::open(const Group& group, const std::string& name, std::vector<hsize_t> row) {
  ArrayShape shape;
  Handle data = group.open_array(name, shape, 0x1p62);
  const std::vector<hsize_t> found(shape.extents.begin() + (shape.extents.empty() ? 0 : 1), shape.extents.end());
  const Handle creation(H5Dget_create_plist(data.id()), H5Pclose);
  std::vector<hsize_t> chunk(shape.extents.size());
  const bool ours = !shape.extents.empty() && found == row && H5Pget_layout(creation.id()) == H5D_CHUNKED &&
                    H5Pget_chunk(creation.id(), static_cast<int>(chunk.size()), chunk.data()) >= 0 &&
                    chunk == chunk_of(row) && H5Pget_nfilters(creation.id()) == (row.empty() ? 0 : 2);
  if (!ours) group.fail("this trajectory is of another run: '" + name + "' has another shape");
  return {std::move(data), std::move(row), shape.extents[0], group.file_name()};
}

void Rows::cut_to(hsize_t count) {
  if (count >= count_) return;
  std::vector<hsize_t> extents{count};
  extents.insert(extents.end(), row_.begin(), row_.end());
  require(H5Dset_extent(data_.id(), extents.data()) >= 0, file_, "rows cannot be removed");
  count_ = count;
}

template <typename Number>
void Rows::append(std::span<const Number> row) {
  std::vector<hsize_t> extents{count_ + 1};
  extents.insert(extents.end(), row_.begin(), row_.end());
  require(H5Dset_extent(data_.id(), extents.data()) >= 0, file_, "a row cannot be added");
  if (row_.empty()) {
    write_number(row.data(), memory_type<Number>());
  } else {
    write_chunks(row);
  }
  ++count_;
}

void Rows::write_number(const void* number, hid_t type) {
  const hsize_t one = 1;
  const Handle where(H5Dget_space(data_.id()), H5Sclose);
  const Handle what(H5Screate_simple(1, &one, nullptr), H5Sclose);
  require(H5Sselect_hyperslab(where.id(), H5S_SELECT_SET, &count_, nullptr, &one, nullptr) >= 0 &&
              H5Dwrite(data_.id(), type, what.id(), where.id(), H5P_DEFAULT, number) >= 0,
          file_, "a number cannot be written");
}

template <typename Number>
void Rows::write_chunks(std::span<const Number> row) {
  static thread_local Compressor compressor;
  const hsize_t entries = std::min(row_[0], kEntriesPerChunk);
  const std::size_t width = row.size() / row_[0];
  std::vector<Number> chunk(entries * width);
  std::vector<hsize_t> offset(row_.size() + 1, 0);
  offset[0] = count_;
  for (hsize_t first = 0; first < row_[0]; first += entries) {
    const std::span<const Number> part =
        row.subspan(first * width, static_cast<std::size_t>(std::min(entries, row_[0] - first)) * width);
    std::fill(std::copy(part.begin(), part.end(), chunk.begin()), chunk.end(), Number{});
    const std::vector<unsigned char> planes =
        shuffled(reinterpret_cast<const unsigned char*>(chunk.data()), sizeof(Number), chunk.size());
    const std::span<const unsigned char> bytes = compressor.compressed(planes);
    offset[1] = first;
    require(H5Dwrite_chunk(data_.id(), H5P_DEFAULT, 0, offset.data(), bytes.size(), bytes.data()) >= 0, file_,
            "a chunk cannot be written");
  }
}

void Rows::flush() { require(H5Dflush(data_.id()) >= 0, file_, "cannot be written"); }

template Rows Rows::create<double>(const Group&, const std::string&, std::vector<hsize_t>);
template Rows Rows::create<std::int64_t>(const Group&, const std::string&, std::vector<hsize_t>);
template void Rows::append(std::span<const double>);
template void Rows::append(std::span<const std::int64_t>);

}  // namespace carom::io
