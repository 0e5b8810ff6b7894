#include "trainer/network/tensor_file.h"

#include <cstring>
#include <stdexcept>

#include "files/files.h"
#include "trainer/network/pickle.h"
#include "trainer/network/zip_archive.h"

namespace cps {
namespace {

struct Storage {
  const char* name;
  torch::ScalarType type;
};
constexpr Storage storages[] = {{"FloatStorage", torch::kFloat},
                                {"HalfStorage", torch::kHalf},
                                {"DoubleStorage", torch::kDouble},
                                {"LongStorage", torch::kLong},
                                {"ByteStorage", torch::kByte}};

// Writing: pickle protocol 2, as torch.save does.

void put(std::string& out, std::uint64_t value, int bytes) {
  for (int i = 0; i < bytes; ++i) out += static_cast<char>(value >> 8 * i & 0xff);
}

void put_text(std::string& out, const std::string& text) {
  out += 'X';
  put(out, text.size(), 4);
  out += text;
}

void put_integer(std::string& out, std::int64_t value) {
  out += '\x8a';
  out += '\x08';
  put(out, static_cast<std::uint64_t>(value), 8);
}

void put_tuple(std::string& out, torch::IntArrayRef values) {
  out += '(';
  for (std::int64_t v : values) put_integer(out, v);
  out += 't';
}

/// _rebuild_tensor_v2(storage, offset, size, stride, requires_grad, hooks)
void put_tensor(std::string& out, const torch::Tensor& tensor, const std::string& key) {
  const Storage* storage = nullptr;
  for (const Storage& s : storages)
    if (s.type == tensor.scalar_type()) storage = &s;
  if (!storage) throw std::runtime_error("a tensor has an element type that cannot be written");
  out += "ctorch._utils\n_rebuild_tensor_v2\n((";
  put_text(out, "storage");
  out += std::string("ctorch\n") + storage->name + "\n";
  put_text(out, key);
  put_text(out, "cpu");
  put_integer(out, tensor.numel());
  out += "tQ";
  put_integer(out, 0);
  put_tuple(out, tensor.sizes());
  put_tuple(out, tensor.strides());
  out +=
      "\x89"
      "ccollections\nOrderedDict\n)RtR";
}

// Reading.

[[noreturn]] void no_dictionary() {
  throw std::runtime_error("is not a dictionary of tensors");
}

template <typename T>
const T& as(const PickleRef& value) {
  const T* scalar = std::get_if<T>(&value->scalar);
  if (!scalar) no_dictionary();
  return *scalar;
}

std::vector<std::int64_t> integers(const PickleRef& tuple) {
  std::vector<std::int64_t> values;
  for (const PickleRef& item : tuple->items) values.push_back(as<std::int64_t>(item));
  return values;
}

torch::Tensor tensor_of(const PickleCall& call, const std::map<std::string, std::string_view>& entries,
                        const std::string& prefix) {
  const std::vector<PickleRef>& arguments = call.arguments->items;
  if (arguments.size() < 4) no_dictionary();
  const std::vector<PickleRef>& id =
      as<PicklePersistent>(arguments[0]).id->items;  // "storage", class, key, device, count of numbers
  if (id.size() < 5) no_dictionary();
  const std::string& type = as<PickleGlobal>(id[1]).name;
  const Storage* storage = nullptr;
  for (const Storage& s : storages)
    if (type == std::string("torch ") + s.name) storage = &s;
  if (!storage) throw std::runtime_error("holds an element type that cannot be read, " + type);
  const auto data = entries.find(prefix + "data/" + as<std::string>(id[2]));
  if (data == entries.end()) no_dictionary();

  const std::vector<std::int64_t> sizes = integers(arguments[2]), strides = integers(arguments[3]);
  const std::int64_t offset = as<std::int64_t>(arguments[1]);
  if (sizes.size() != strides.size()) no_dictionary();
  std::int64_t last = offset, count = 1;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    if (sizes[i] < 0 || strides[i] < 0 || sizes[i] > (1 << 30) || strides[i] > (1 << 30)) no_dictionary();
    last += (sizes[i] - 1) * strides[i];
    count *= sizes[i];
  }
  const std::size_t element_bytes = torch::elementSize(storage->type);
  const std::int64_t held = as<std::int64_t>(id[4]);
  if (data->second.size() % element_bytes != 0 ||
      held != static_cast<std::int64_t>(data->second.size() / element_bytes))
    throw std::runtime_error("has a storage that does not hold as many numbers as it should");
  if (offset < 0 || (count > 0 && last >= held)) throw std::runtime_error("is cut short");
  torch::Tensor flat = torch::empty({held}, storage->type);
  if (held > 0) std::memcpy(flat.data_ptr(), data->second.data(), data->second.size());
  return flat.as_strided(sizes, strides, offset).contiguous();
}

}  // namespace

void save_tensors(const NamedTensors& tensors, const std::filesystem::path& file) {
  std::vector<torch::Tensor> kept;
  std::string pickle = "\x80\x02}(";
  for (const auto& [name, tensor] : tensors) {
    // Flat first: contiguous() leaves the strides of kernels of one pixel as a channels-last layout had them.
    kept.push_back(tensor.detach().cpu().contiguous().flatten().view(tensor.sizes()));
    put_text(pickle, name);
    put_tensor(pickle, kept.back(), std::to_string(kept.size() - 1));
  }
  pickle += "u.";
  std::vector<std::pair<std::string, std::string_view>> entries{{"archive/data.pkl", pickle}};
  for (std::size_t i = 0; i < kept.size(); ++i)
    entries.emplace_back("archive/data/" + std::to_string(i),
                         std::string_view(static_cast<const char*>(kept[i].data_ptr()), kept[i].nbytes()));
  entries.emplace_back("archive/version", "3\n");
  write_file(file, zip_stored(entries));
}

NamedTensors load_tensors(const std::filesystem::path& file) {
  const std::string bytes = read_file(file);
  try {
    const auto entries = unzip_stored(bytes);
    std::string prefix;
    for (const auto& [name, data] : entries)
      if (name.ends_with("/data.pkl")) prefix = name.substr(0, name.size() - 8);
    if (prefix.empty()) no_dictionary();
    NamedTensors tensors;
    const PickleRef dictionary = read_pickle(entries.at(prefix + "data.pkl"));
    for (const auto& [key, value] : dictionary->entries) {
      const auto* name = std::get_if<std::string>(&key->scalar);
      const auto* call = std::get_if<PickleCall>(&value->scalar);
      if (name && call && call->function == "torch._utils _rebuild_tensor_v2")
        tensors[*name] = tensor_of(*call, entries, prefix);
    }
    if (tensors.empty()) no_dictionary();
    return tensors;
  } catch (const std::exception& error) {
    throw std::runtime_error(file.string() + ": " + error.what() + ": restore it or train again");
  }
}

}  // namespace cps
