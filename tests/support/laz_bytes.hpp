#pragma once
/// LAZ files of format 0 as bytes: a second implementation of their coding, the other way round.
#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "tests/support/cloud_bytes.hpp"

namespace clast {

/// Adaptive frequencies of symbols.
struct LazModel {
  explicit LazModel(std::size_t symbols) : counts(symbols, 1), begins(symbols), cycle(symbols) {
    update();
    left = cycle = (symbols + 6) / 2;
  }
  void update() {
    total += cycle;
    if (total > 1u << 15) {
      total = 0;
      for (std::uint64_t& count : counts) total += (count = (count + 1) / 2);
    }
    const std::uint64_t scale = (1u << 31) / total;
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < counts.size(); ++i) {
      begins[i] = (scale * sum) >> 16;
      sum += counts[i];
    }
    left = cycle = std::min<std::uint64_t>(5 * cycle / 4, (counts.size() + 6) * 8);
  }

  std::vector<std::uint64_t> counts, begins;
  std::uint64_t total = 0, cycle, left = 0;
};

/// Adaptive frequency of a bit.
struct LazBit {
  std::uint64_t zeros = 1, total = 2, probability = 1u << 12, cycle = 4, left = 4;
};

/// Arithmetic encoder (A. Said, HPL-2004-76).
class LazEncoder {
 public:
  void symbol(LazModel& model, std::size_t value) {
    const std::uint64_t unit = length_ >> 15, begin = model.begins[value] * unit;
    const bool last = value + 1 == model.begins.size();
    narrow(begin, (last ? length_ : model.begins[value + 1] * unit) - begin);
    ++model.counts[value];
    if (--model.left == 0) model.update();
  }
  void bit(LazBit& model, bool value) {
    const std::uint64_t begin = model.probability * (length_ >> 13);
    if (value) narrow(begin, length_ - begin);
    if (!value) {
      narrow(0, begin);
      ++model.zeros;
    }
    if (--model.left > 0) return;
    if ((model.total += model.cycle) > 1u << 13) {
      model.total = (model.total + 1) / 2;
      model.zeros = (model.zeros + 1) / 2;
      if (model.zeros == model.total) ++model.total;
    }
    model.probability = (((1u << 31) / model.total) * model.zeros) >> 18;
    model.left = model.cycle = std::min<std::uint64_t>(5 * model.cycle / 4, 64);
  }
  void bits(std::uint32_t value, unsigned count) {
    if (count > 19) {
      bits(value & 0xFFFF, 16);
      bits(value >> 16, count - 16);
      return;
    }
    narrow(value * (length_ >> count), length_ >> count);
  }
  /// The code, with zeros behind it that a decoder may read ahead.
  std::string done() {
    narrow(length_ / 2, 1);
    return bytes_ + std::string(4, '\0');
  }

 private:
  void narrow(std::uint64_t begin, std::uint64_t length) {
    base_ += begin;
    length_ = length;
    if (base_ >> 32 != 0) {
      for (std::size_t i = bytes_.size(); ++bytes_[--i] == 0;) {
      }
      base_ &= 0xFFFFFFFF;
    }
    for (; length_ < 1u << 24; length_ <<= 8) {
      bytes_ += static_cast<char>(base_ >> 24);
      base_ = base_ << 8 & 0xFFFFFFFF;
    }
  }

  std::string bytes_;
  std::uint64_t base_ = 0, length_ = 0xFFFFFFFF;
};

/// Whole numbers as differences to predictions.
struct LazIntegers {
  explicit LazIntegers(std::size_t contexts) : widths(contexts, LazModel(33)) {
    for (unsigned k = 1; k <= 32; ++k) correctors.emplace_back(std::size_t{1} << std::min(k, 8u));
  }
  void encode(LazEncoder& encoder, std::int32_t prediction, std::int32_t value,
              std::size_t context) {
    const auto difference = static_cast<std::int32_t>(static_cast<std::uint32_t>(value) -
                                                      static_cast<std::uint32_t>(prediction));
    const std::int64_t c = difference;
    // The narrowest width whose numbers, -(2^width - 1) to 2^width, contain the difference.
    for (width = 0; c > std::int64_t{1} << width || c <= -(std::int64_t{1} << width);) ++width;
    encoder.symbol(widths[context], width);
    if (width == 0) return encoder.bit(single, c == 1);
    if (width == 32) return;
    const auto code =
        static_cast<std::uint32_t>(c > 0 ? c - 1 : c + (std::int64_t{1} << width) - 1);
    const unsigned raw = width > 8 ? width - 8 : 0;
    encoder.symbol(correctors[width - 1], code >> raw);
    if (raw > 0) encoder.bits(code & ((1u << raw) - 1), raw);
  }

  std::vector<LazModel> widths, correctors;
  LazBit single;
  unsigned width = 0;  ///< of the last difference
};

/// Running median of five numbers.
struct LazMedian {
  std::array<std::int32_t, 5> sorted = {};
  bool replaces_highest = true;

  void add(std::int32_t value) {
    const std::int32_t middle = sorted[2];
    sorted[replaces_highest ? 4 : 0] = value;
    std::sort(sorted.begin(), sorted.end());
    replaces_highest = replaces_highest ? value < middle : value <= middle;
  }
};

/// Codes records of format 0 that differ only in coordinates and class, without numbers of returns.
inline std::string packed_chunk(const std::vector<std::string>& records) {
  LazEncoder encoder;
  LazModel changes(64);
  std::map<std::uint8_t, LazModel> classes;
  LazIntegers dx(2), dy(22), z(20);
  LazMedian x_step, y_step;
  const auto number = [](const std::string& record, std::size_t axis) {
    std::int32_t value;
    std::memcpy(&value, record.data() + 4 * axis, sizeof value);
    return value;
  };
  std::int32_t height = 0;
  for (std::size_t i = 1; i < records.size(); ++i) {
    const std::string &last = records[i - 1], &record = records[i];
    const auto last_class = static_cast<std::uint8_t>(last[15]);
    const bool changed = record[15] != last[15];
    encoder.symbol(changes, changed ? 8 : 0);
    if (changed) {
      encoder.symbol(classes.try_emplace(last_class, 256).first->second,
                     static_cast<std::uint8_t>(record[15]));
    }
    const std::int32_t x = number(record, 0) - number(last, 0);
    const std::int32_t y = number(record, 1) - number(last, 1);
    dx.encode(encoder, x_step.sorted[2], x, 0);
    dy.encode(encoder, y_step.sorted[2], y, std::min(dx.width & ~1u, 20u));
    x_step.add(x);
    y_step.add(y);
    z.encode(encoder, height, number(record, 2), std::min((dx.width + dy.width) / 2 & ~1u, 18u));
    height = number(record, 2);
  }
  return records[0] + encoder.done();
}

/// A chunk that is one point: nothing is coded but its record.
inline std::string chunk_of_one(const std::string& record, std::uint8_t format) {
  if (format < 6) return record + std::string(4, '\0');
  const std::size_t extra = record.size() - (format == 6 ? 30u : format == 7 ? 36u : 38u);
  std::string chunk = record;
  put<std::uint32_t>(chunk, chunk.size(), 1);
  // Nine layers of a point, those of its colours, one of each extra byte; only intensities are
  // coded.
  const std::string intensities = "no code";
  for (std::size_t layer = 0; layer < 9u + format - 6u + extra; ++layer) {
    put(chunk, chunk.size(), static_cast<std::uint32_t>(layer == 4 ? intensities.size() : 0));
  }
  return chunk + intensities;
}

/// Content of the record "laszip encoded" for a point format.
inline std::string packing_record(std::uint8_t format, std::size_t record_size,
                                  std::uint32_t chunk_size) {
  using Item = std::array<std::uint16_t, 2>;  // type and size
  std::vector<Item> items = {format < 6 ? Item{6, 20} : Item{10, 30}};
  if (format == 1 || format == 3) items.push_back({7, 8});
  if (format == 2 || format == 3) items.push_back({8, 6});
  if (format == 7) items.push_back({11, 6});
  if (format == 8) items.push_back({12, 8});
  std::size_t size = 0;
  for (const Item& item : items) size += item[1];
  if (record_size > size) {
    items.push_back({static_cast<std::uint16_t>(format < 6 ? 0 : 14),
                     static_cast<std::uint16_t>(record_size - size)});
  }
  const std::uint16_t version = format < 6 ? 2 : 3;
  std::string bytes(34, '\0');
  put<std::uint16_t>(bytes, 0, version);  // compressor: 2 in chunks, 3 in layers too
  put<std::uint32_t>(bytes, 12, chunk_size);
  put<std::uint16_t>(bytes, 32, static_cast<std::uint16_t>(items.size()));
  for (const Item& item : items) {
    for (const std::uint16_t word : {item[0], item[1], version}) put(bytes, bytes.size(), word);
  }
  return bytes;
}

/// The LAZ file of a LAS file.
/// @param chunk_size  points in each chunk; 1 unless the points have format 0
inline std::string packed_las(const std::string& las, std::uint32_t chunk_size) {
  const auto number = [&]<class T>(T value, std::size_t at) {
    std::memcpy(&value, las.data() + at, sizeof value);
    return std::size_t{value};
  };
  const auto format = static_cast<std::uint8_t>(las[104]);
  const std::size_t begin = number(std::uint32_t{}, 96), size = number(std::uint16_t{}, 105);
  std::string bytes = las.substr(0, begin);
  put<std::uint8_t>(bytes, 104, format | 0x80);
  put<std::uint32_t>(bytes, 100, static_cast<std::uint32_t>(number(std::uint32_t{}, 100)) + 1);
  const std::string packing = packing_record(format, size, chunk_size);
  std::string record(54, '\0');
  record.replace(2, 14, "laszip encoded");
  put<std::uint16_t>(record, 18, 22204);
  put<std::uint16_t>(record, 20, static_cast<std::uint16_t>(packing.size()));
  bytes += record + packing;
  put<std::uint32_t>(bytes, 96, static_cast<std::uint32_t>(bytes.size()));
  const std::size_t position = bytes.size();
  put<std::int64_t>(bytes, position, 0);

  LazEncoder table;
  LazIntegers sizes(2);
  std::uint32_t chunks = 0;
  std::int32_t last = 0;
  std::vector<std::string> records;
  for (std::size_t at = begin; at < las.size(); at += size) {
    records.push_back(las.substr(at, size));
    if (records.size() < chunk_size && at + size < las.size()) continue;
    const std::string chunk =
        chunk_size == 1 ? chunk_of_one(records[0], format) : packed_chunk(records);
    bytes += chunk;
    sizes.encode(table, last, static_cast<std::int32_t>(chunk.size()), 1);
    last = static_cast<std::int32_t>(chunk.size());
    ++chunks;
    records.clear();
  }
  put<std::int64_t>(bytes, position, static_cast<std::int64_t>(bytes.size()));
  put<std::uint32_t>(bytes, bytes.size(), 0);
  put<std::uint32_t>(bytes, bytes.size(), chunks);
  return bytes + table.done();
}

}  // namespace clast
