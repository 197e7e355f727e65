#include "components/goalnet/network/name_table.h"

#include <algorithm>
#include <bit>

namespace goalnet::inference::network {
namespace {

std::size_t hash_of(std::string_view text) {
  std::uint64_t hash = 0xcbf29ce484222325ull;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ull;
  return static_cast<std::size_t>(hash ^ (hash >> 32));
}

}  // namespace

NameTable::NameTable(const Lexicon& lexicon, const Matrix& word_vectors)
    : lexicon_(lexicon), vectors_(word_vectors) {}

int NameTable::slot(std::string_view name) {
  const auto found = slots_.find(name);
  if (found != slots_.end()) return found->second;
  const SplitName split = split_name(name);
  NameEntry entry;
  entry.class_id = lexicon_.class_of(split.class_name);
  entry.instance = split.instance;
  entry.word_count = split.words.size();
  entry.unit = Vector::Zero(vectors_.cols());
  for (const std::string& word : split.words) {
    const int id = lexicon_.word(word);
    if (id < 0) continue;
    entry.words.push_back(id);
    entry.unit += vectors_.row(id).transpose();
  }
  const float length = entry.unit.norm();
  if (length > 0) entry.unit /= length;
  const int slot = static_cast<int>(entries_.size());
  entries_.push_back(std::move(entry));
  slots_.emplace(name, slot);
  return slot;
}

void NameTable::clear() {
  entries_.clear();
  slots_.clear();
}

void NameIndex::rebuild(std::span<const std::string> names) {
  names_ = names;
  const std::size_t wanted = std::bit_ceil(names.size() * 2 + 2);
  if (buckets_.size() < wanted) buckets_.resize(wanted);
  std::fill(buckets_.begin(), buckets_.end(), -1);
  for (std::size_t i = 0; i < names.size(); ++i) {
    std::size_t place = hash_of(names[i]) & (buckets_.size() - 1);
    while (buckets_[place] >= 0 && names_[static_cast<std::size_t>(buckets_[place])] != names[i]) {
      place = (place + 1) & (buckets_.size() - 1);
    }
    if (buckets_[place] < 0) buckets_[place] = static_cast<int>(i);
  }
}

int NameIndex::find(std::string_view name) const {
  if (buckets_.empty()) return -1;
  for (std::size_t place = hash_of(name) & (buckets_.size() - 1); buckets_[place] >= 0;
       place = (place + 1) & (buckets_.size() - 1)) {
    if (names_[static_cast<std::size_t>(buckets_[place])] == name) return buckets_[place];
  }
  return -1;
}

}  // namespace goalnet::inference::network
