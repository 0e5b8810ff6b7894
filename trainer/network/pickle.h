#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

/// The part of Python's pickle format (PEP 307, PEP 3154) that weight files use. Executes nothing: names of
/// functions and classes stay names.
namespace cps {

struct PickleValue;
using PickleRef = std::shared_ptr<PickleValue>;

/// A function or class, by module and name.
struct PickleGlobal {
  std::string name;  ///< "torch FloatStorage"
};
/// A call that unpickling would make. Items set on the result, of an OrderedDict for instance, are the
/// value's `entries`.
struct PickleCall {
  std::string function;
  PickleRef arguments;
};
/// A reference to data outside the pickle: here, a tensor's storage.
struct PicklePersistent {
  PickleRef id;
};

/// One Python object.
struct PickleValue {
  std::variant<std::monostate, bool, std::int64_t, double, std::string, PickleGlobal, PickleCall,
               PicklePersistent>
      scalar;
  std::vector<PickleRef> items;                          ///< of a tuple or list
  std::vector<std::pair<PickleRef, PickleRef>> entries;  ///< of a dictionary, in file order
};

/// The pickled object. Throws std::runtime_error if the pickle is cut short, damaged, or uses an instruction
/// that weight files do not need.
PickleRef read_pickle(std::string_view bytes);

}  // namespace cps
