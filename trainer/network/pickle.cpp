#include "trainer/network/pickle.h"

#include <bit>
#include <stdexcept>

namespace cps {
namespace {

/// The stack machine that a pickle is a program for: a stack, marks in it, and a memo.
class Unpickler {
 public:
  explicit Unpickler(std::string_view bytes) : bytes_(bytes) {}

  PickleRef run() {
    for (;;) {
      const char instruction = take(1)[0];
      if (instruction == '.') return pop();
      step(instruction);
    }
  }

 private:
  std::string_view take(std::size_t count) {
    if (bytes_.size() - at_ < count) throw std::runtime_error("its pickle is cut short");
    at_ += count;
    return bytes_.substr(at_ - count, count);
  }
  std::uint64_t number(int count) {
    std::uint64_t value = 0;
    const std::string_view raw = take(count);
    for (int i = 0; i < count; ++i)
      value |= static_cast<std::uint64_t>(static_cast<unsigned char>(raw[i])) << 8 * i;
    return value;
  }
  /// Two's complement of `count` ≤ 8 bytes; no bytes are 0.
  std::int64_t signed_number(int count) {
    const int unused_bits = 64 - 8 * count;
    if (count == 0) return 0;
    return static_cast<std::int64_t>(number(count) << unused_bits) >> unused_bits;
  }
  std::string line() {
    const std::size_t end = bytes_.find('\n', at_);
    if (end == std::string_view::npos) throw std::runtime_error("its pickle is cut short");
    const std::string text(bytes_.substr(at_, end - at_));
    at_ = end + 1;
    return text;
  }

  template <typename T>
  void push(T&& scalar) {
    stack_.push_back(std::make_shared<PickleValue>());
    stack_.back()->scalar = std::forward<T>(scalar);
  }
  PickleRef pop() {
    if (stack_.empty()) throw std::runtime_error("its pickle is damaged");
    PickleRef top = stack_.back();
    stack_.pop_back();
    return top;
  }
  PickleValue& top() {
    if (stack_.empty()) throw std::runtime_error("its pickle is damaged");
    return *stack_.back();
  }
  std::vector<PickleRef> pop_to_mark() {
    if (marks_.empty() || marks_.back() > stack_.size()) throw std::runtime_error("its pickle is damaged");
    std::vector<PickleRef> items(stack_.begin() + static_cast<std::ptrdiff_t>(marks_.back()), stack_.end());
    stack_.resize(marks_.back());
    marks_.pop_back();
    return items;
  }
  void push_tuple(std::size_t count) {
    auto tuple = std::make_shared<PickleValue>();
    tuple->items.resize(count);
    for (std::size_t i = count; i > 0; --i) tuple->items[i - 1] = pop();
    stack_.push_back(tuple);
  }
  void set_items(const std::vector<PickleRef>& items) {
    for (std::size_t i = 0; i + 1 < items.size(); i += 2) top().entries.emplace_back(items[i], items[i + 1]);
  }
  void recall(std::uint64_t index) {
    const auto found = memo_.find(index);
    if (found == memo_.end()) throw std::runtime_error("its pickle is damaged");
    stack_.push_back(found->second);
  }
  void remember(std::uint64_t index) {
    top();
    memo_[index] = stack_.back();
  }

  void step(char instruction) {
    switch (static_cast<unsigned char>(instruction)) {
      case 0x80:
        number(1);
        break;  // PROTO
      case 0x95:
        number(8);
        break;  // FRAME
      case '(':
        marks_.push_back(stack_.size());
        break;
      case '}':
      case ']':
      case ')':
        stack_.push_back(std::make_shared<PickleValue>());
        break;
      case 'N':
        push(std::monostate{});
        break;
      case 0x88:
        push(true);
        break;
      case 0x89:
        push(false);
        break;
      case 'K':
        push(static_cast<std::int64_t>(number(1)));
        break;
      case 'M':
        push(static_cast<std::int64_t>(number(2)));
        break;
      case 'J':
        push(signed_number(4));
        break;
      case 0x8a: {  // LONG1
        const int count = static_cast<int>(number(1));
        if (count > 8) throw std::runtime_error("its pickle holds a number of more than 64 bits");
        push(signed_number(count));
        break;
      }
      case 'G': {  // big-endian double
        std::uint64_t bits = 0;
        for (char c : take(8)) bits = bits << 8 | static_cast<unsigned char>(c);
        push(std::bit_cast<double>(bits));
        break;
      }
      case 'X':
        push(std::string(take(number(4))));
        break;
      case 0x8c:
        push(std::string(take(number(1))));
        break;
      case 'c': {
        const std::string module = line();
        push(PickleGlobal{module + " " + line()});
        break;
      }
      case 0x93: {  // STACK_GLOBAL
        const PickleRef name = pop(), module = pop();
        const auto *m = std::get_if<std::string>(&module->scalar),
                   *n = std::get_if<std::string>(&name->scalar);
        if (!m || !n) throw std::runtime_error("its pickle is damaged");
        push(PickleGlobal{*m + " " + *n});
        break;
      }
      case 'q':
        remember(number(1));
        break;
      case 'r':
        remember(number(4));
        break;
      case 0x94:
        remember(memo_.size());
        break;
      case 'h':
        recall(number(1));
        break;
      case 'j':
        recall(number(4));
        break;
      case 't': {
        auto tuple = std::make_shared<PickleValue>();
        tuple->items = pop_to_mark();
        stack_.push_back(tuple);
        break;
      }
      case 0x85:
        push_tuple(1);
        break;
      case 0x86:
        push_tuple(2);
        break;
      case 0x87:
        push_tuple(3);
        break;
      case 'Q': {
        const PickleRef id = pop();
        push(PicklePersistent{id});
        break;
      }
      case 'R': {
        const PickleRef arguments = pop(), function = pop();
        const auto* name = std::get_if<PickleGlobal>(&function->scalar);
        if (!name) throw std::runtime_error("its pickle is damaged");
        push(PickleCall{name->name, arguments});
        break;
      }
      case 'b':
        pop();
        break;  // BUILD: attributes, such as a state_dict's _metadata
      case 's': {
        const PickleRef value = pop(), key = pop();
        set_items({key, value});
        break;
      }
      case 'u': {
        const std::vector<PickleRef> items = pop_to_mark();
        set_items(items);
        break;
      }
      case 'a': {
        const PickleRef item = pop();
        top().items.push_back(item);
        break;
      }
      case 'e': {
        const std::vector<PickleRef> items = pop_to_mark();
        top().items.insert(top().items.end(), items.begin(), items.end());
        break;
      }
      default:
        throw std::runtime_error("its pickle has an instruction that weight files do not need");
    }
  }

  std::string_view bytes_;
  std::size_t at_ = 0;
  std::vector<PickleRef> stack_;
  std::vector<std::size_t> marks_;
  std::map<std::uint64_t, PickleRef> memo_;
};

}  // namespace

PickleRef read_pickle(std::string_view bytes) {
  return Unpickler(bytes).run();
}

}  // namespace cps
