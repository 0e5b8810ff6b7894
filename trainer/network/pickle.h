#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

/// As much of Python's pickle format (PEP 307, PEP 3154) as weights are written in. Nothing in it is run:
/// names of functions and classes are kept as names.
namespace cps {

struct PickleValue;
using PickleRef = std::shared_ptr<PickleValue>;

struct PickleGlobal {
  std::string name;  ///< "torch FloatStorage"
};
/// What a function or class was to be called with, and items set on the result: an OrderedDict's, say.
struct PickleCall {
  std::string function;
  PickleRef arguments;
};
struct PicklePersistent {
  PickleRef id;
};

struct PickleValue {
  std::variant<std::monostate, bool, std::int64_t, double, std::string, PickleGlobal, PickleCall,
               PicklePersistent>
      scalar;
  std::vector<PickleRef> items;                          ///< of a tuple or list
  std::vector<std::pair<PickleRef, PickleRef>> entries;  ///< of a dictionary, in their order
};

/// The pickled object. Throws std::runtime_error on what it does not know or is cut short.
PickleRef read_pickle(std::string_view bytes);

}  // namespace cps
