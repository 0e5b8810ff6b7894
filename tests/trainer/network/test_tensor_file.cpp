#include <torch/types.h>

#include <catch2/catch.hpp>
#include <cstdlib>
#include <fstream>

#include "files/files.h"
#include "tests/temporary_folder.h"
#include "trainer/network/tensor_file.h"
#include "trainer/network/weights.h"
#include "trainer/network/zip_archive.h"

using namespace cps;

namespace {

NamedTensors some_tensors() {
  return {{"a.weight", torch::arange(24, torch::kFloat).reshape({2, 3, 4})},
          {"a.transposed", torch::arange(6, torch::kDouble).reshape({2, 3}).t()},
          {"bytes", torch::arange(300, torch::kLong).to(torch::kByte)},
          {"count", torch::tensor(7, torch::kLong)},
          {"half", torch::tensor({.5f, -2.f, 65504.f, 6e-8f}).to(torch::kHalf)},
          {"none", torch::empty({0, 3})}};
}

void check_equal(const NamedTensors& a, const NamedTensors& b) {
  REQUIRE(a.size() == b.size());
  for (const auto& [name, tensor] : a) {
    INFO(name);
    REQUIRE(b.contains(name));
    CHECK(b.at(name).dtype() == tensor.dtype());
    CHECK(torch::equal(b.at(name), tensor));
  }
}

/// Puts other bytes into an entry of a file of weights, with a valid checksum.
void replace_entry(const std::string& file, const std::string& name, const std::string& bytes) {
  const std::string whole = read_file(file);
  std::vector<std::pair<std::string, std::string_view>> entries;
  for (const auto& [entry, data] : unzip_stored(whole))
    entries.emplace_back(entry, entry == name ? std::string_view(bytes) : data);
  write_file(file, zip_stored(entries));
}

void run_python(const std::filesystem::path& folder, const std::string& program) {
  write_file(folder / "program.py", program);
  REQUIRE(std::system(("cd " + folder.string() + " && /usr/bin/python3 program.py").c_str()) == 0);
}

}  // namespace

TEST_CASE("tensors come back as they were, and the same tensors make the same bytes") {
  const TemporaryFolder folder;
  save_tensors(some_tensors(), folder.path / "a.pt");
  check_equal(some_tensors(), load_tensors(folder.path / "a.pt"));
  save_tensors(some_tensors(), folder.path / "b.pt");
  CHECK(read_file(folder.path / "a.pt") == read_file(folder.path / "b.pt"));
}

TEST_CASE("a file of weights that is cut short is refused in one line") {
  const TemporaryFolder folder;
  save_tensors(some_tensors(), folder.path / "a.pt");
  const std::string whole = read_file(folder.path / "a.pt"), file = (folder.path / "b.pt").string();
  for (std::size_t length = 0; length < whole.size(); length += 37) {
    write_file(file, std::string_view(whole).substr(0, length));
    CHECK_THROWS_WITH(load_tensors(file), Catch::StartsWith(file + ": ") && !Catch::Contains("\n"));
  }
}

TEST_CASE("a file of weights with one changed byte is refused, or read as it was") {
  const TemporaryFolder folder;
  const std::string file = (folder.path / "a.pt").string();
  save_tensors(some_tensors(), file);
  const std::string whole = read_file(file);
  int refused = 0;
  for (std::size_t at = 0; at < whole.size(); ++at)
    for (const int mask : {0x01, 0x5a, 0xff}) {
      std::string changed = whole;
      changed[at] = static_cast<char>(changed[at] ^ mask);
      std::ofstream(file, std::ios::binary) << changed;  // write_file() would wait for the disk each time
      INFO("byte " << at << " of " << whole.size() << ", mask " << mask);
      NamedTensors read;
      try {
        read = load_tensors(file);
      } catch (const std::runtime_error& error) {
        ++refused;
        if (!std::string(error.what()).starts_with(file + ": ")) FAIL(error.what());
        continue;
      }
      check_equal(some_tensors(), read);
    }
  // At least wherever a tensor's bytes or its description are hit.
  CHECK(refused > 3 * (24 * 4 + 6 * 8 + 300 + 8));
}

TEST_CASE("a storage with more or fewer numbers than its description says is refused") {
  const TemporaryFolder folder;
  const std::string file = (folder.path / "a.pt").string(), entry = "archive/data/0";
  for (const torch::ScalarType type : {torch::kHalf, torch::kFloat}) {
    const NamedTensors six{{"w", torch::arange(6, torch::kFloat).to(type)}};
    save_tensors(six, file);
    const std::string whole = read_file(file), data(unzip_stored(whole).at(entry));
    REQUIRE(data.size() == 6 * torch::elementSize(type));
    replace_entry(file, entry, data);
    check_equal(six, load_tensors(file));
    const std::string byte_less = data.substr(1), number_less = data.substr(torch::elementSize(type));
    for (const std::string& other : {byte_less, number_less, data + data, std::string()}) {
      INFO(other.size() << " bytes");
      replace_entry(file, entry, other);
      CHECK_THROWS_WITH(load_tensors(file), Catch::StartsWith(file + ": ") && Catch::Contains("storage"));
    }
  }
}

TEST_CASE("numbers under the name of another element type are refused") {
  const TemporaryFolder folder;
  const std::string file = (folder.path / "a.pt").string(), entry = "archive/data.pkl";
  const auto renamed = [&](const std::string& type, const std::string& other) {
    save_tensors({{"w", torch::arange(6, torch::kFloat)}, {"h", torch::zeros({5}, torch::kHalf)}}, file);
    const std::string whole = read_file(file);
    std::string pickle(unzip_stored(whole).at(entry));
    pickle.replace(pickle.find(type), type.size(), other);
    replace_entry(file, entry, pickle);
    return file;
  };
  CHECK(load_tensors(renamed("HalfStorage", "HalfStorage")).size() == 2);
  CHECK_THROWS_WITH(load_tensors(renamed("FloatStorage", "HalfStorage")), Catch::Contains("storage"));
  CHECK_THROWS_WITH(load_tensors(renamed("HalfStorage", "FloatStorage")), Catch::Contains("storage"));
  CHECK_THROWS_WITH(load_tensors(renamed("HalfStorage", "BFloat16Storage")),
                    Catch::Contains("element type") && Catch::Contains("BFloat16Storage"));
}

TEST_CASE("a network starts from weights for colour pictures") {
  torch::manual_seed(3);
  const auto network = make_resnet(*find_architecture("resnet18"), {});
  NamedTensors theirs;
  for (const auto& [name, tensor] : weights_of(*make_resnet(*find_architecture("resnet18"), {})))
    theirs[name] = tensor.detach().clone();
  theirs["conv1.weight"] = torch::randn({64, 3, 7, 7});
  theirs["fc.weight"] = torch::randn({1000, 512});
  theirs["fc.bias"] = torch::randn({1000});
  start_from(*network, theirs, "resnet18.pth");
  const NamedTensors ours = weights_of(*network);
  CHECK(torch::equal(ours.at("layer3.1.conv2.weight"), theirs.at("layer3.1.conv2.weight")));
  CHECK(ours.at("fc.weight").abs().max().item<double>() == 0);
  // A gray picture through it is the same picture in three equal channels through theirs.
  const torch::NoGradGuard no_gradients;
  const torch::Tensor gray = torch::randn({1, 1, 20, 20});
  CHECK(torch::allclose(torch::conv2d(gray, ours.at("conv1.weight")),
                        torch::conv2d(gray.expand({1, 3, 20, 20}), theirs.at("conv1.weight")), 1e-4, 1e-4));
  CHECK_THROWS_WITH(start_from(*make_resnet(*find_architecture("resnet34"), {}), theirs, "resnet18.pth"),
                    Catch::StartsWith("resnet18.pth: ") && Catch::Contains("another architecture"));
}

TEST_CASE("Python's torch reads our weights and we read its", "[slow]") {
  REQUIRE(std::system("/usr/bin/python3 -c 'import torch'") == 0);  // apt-get install python3-torch
  const TemporaryFolder folder;
  save_tensors(some_tensors(), folder.path / "ours.pt");
  run_python(folder.path, R"(
import torch
from collections import OrderedDict
d = torch.load("ours.pt", weights_only=True)
assert sorted(d) == ["a.transposed", "a.weight", "bytes", "count", "half", "none"], sorted(d)
assert torch.equal(d["a.weight"], torch.arange(24, dtype=torch.float32).reshape(2, 3, 4))
assert torch.equal(d["a.transposed"], torch.arange(6, dtype=torch.float64).reshape(2, 3).t())
assert torch.equal(d["bytes"], torch.arange(300).to(torch.uint8))
assert d["count"].item() == 7 and d["count"].dtype == torch.int64 and d["count"].shape == ()
assert d["half"].dtype == torch.float16 and d["half"].tolist() == [0.5, -2, 65504, 2**-24]
assert d["none"].shape == (0, 3)
torch.save(d, "dictionary.pt")
torch.save(OrderedDict(d), "ordered.pt")
torch.manual_seed(1)
model = torch.nn.Sequential(torch.nn.Conv2d(1, 4, 3), torch.nn.BatchNorm2d(4), torch.nn.Linear(5, 2))
torch.save(model.state_dict(), "model.pt")                    # an OrderedDict with _metadata
torch.save({k: v for k, v in model.state_dict().items()}, "plain.pt", pickle_protocol=4)
shared = torch.arange(10.0)
torch.save({"whole": shared, "part": shared[3:7], "step": 5}, "shared.pt")   # one storage, two views
)");
  check_equal(some_tensors(), load_tensors(folder.path / "dictionary.pt"));
  check_equal(some_tensors(), load_tensors(folder.path / "ordered.pt"));
  const NamedTensors model = load_tensors(folder.path / "model.pt");
  CHECK(model.size() == 9);
  check_equal(model, load_tensors(folder.path / "plain.pt"));
  CHECK(model.at("0.weight").sizes() == torch::IntArrayRef({4, 1, 3, 3}));
  const NamedTensors shared = load_tensors(folder.path / "shared.pt");
  CHECK(torch::equal(shared.at("part"), torch::tensor({3.f, 4.f, 5.f, 6.f})));
  CHECK(shared.size() == 2);

  // And back: Python finds its own model in what we wrote of it.
  save_tensors(model, folder.path / "back.pt");
  run_python(folder.path, R"(
import torch
torch.manual_seed(1)
model = torch.nn.Sequential(torch.nn.Conv2d(1, 4, 3), torch.nn.BatchNorm2d(4), torch.nn.Linear(5, 2))
theirs = {k: v.clone() for k, v in model.state_dict().items()}
model.load_state_dict(torch.load("back.pt", weights_only=True), strict=True)
for k, v in model.state_dict().items(): assert torch.equal(v, theirs[k]), k
)");
}
