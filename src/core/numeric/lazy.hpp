// SPDX-License-Identifier: BSD-3-Clause
// A lazily computed value.
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <utility>

namespace mbncc::numeric {

/// The value is computed on first access by any thread, or by make(); copies share it.
template <class Value>
class Lazy {
 public:
  Lazy() : Lazy([] { return Value(); }) {}
  explicit Lazy(std::function<Value()> make) : shared_(std::make_shared<Shared>()) {
    shared_->make = std::move(make);
  }

  void make() const {
    std::call_once(shared_->once, [this] {
      shared_->value = shared_->make();
      shared_->make = nullptr;
    });
  }

  const Value& operator*() const {
    make();
    return shared_->value;
  }
  const Value* operator->() const { return &**this; }

 private:
  struct Shared {
    std::once_flag once;
    std::function<Value()> make;
    Value value;
  };

  std::shared_ptr<Shared> shared_;
};

}  // namespace mbncc::numeric
