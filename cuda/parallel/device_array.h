// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "parallel/error.h"

namespace foam::cuda {

/// An array in the device's memory. Its elements are as they happen to be until they are written.
template <class T> class DeviceArray {
public:
  DeviceArray() = default;
  explicit DeviceArray(std::size_t size) { resize(size); }
  explicit DeviceArray(const std::vector<T>& values) { upload(values); }
  DeviceArray(DeviceArray&& other) noexcept { swap(other); }
  DeviceArray& operator=(DeviceArray&& other) noexcept {
    swap(other);
    return *this;
  }
  DeviceArray(const DeviceArray&) = delete;
  DeviceArray& operator=(const DeviceArray&) = delete;
  ~DeviceArray() { cudaFree(data_); } // a failure here is that of an earlier call

  T* data() { return data_; }
  const T* data() const { return data_; }
  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }

  /// Loses the elements where the array has to grow.
  void resize(std::size_t size) {
    if (size > capacity_) {
      check(cudaFree(data_), "cudaFree");
      data_ = nullptr;
      capacity_ = 0;
      check(cudaMalloc(reinterpret_cast<void**>(&data_), size * sizeof(T)), "cudaMalloc");
      capacity_ = size;
    }
    size_ = size;
  }

  void upload(const std::vector<T>& values) {
    resize(values.size());
    copy(data_, values.data(), cudaMemcpyHostToDevice);
  }
  void download(std::vector<T>& values) const {
    values.resize(size_);
    copy(values.data(), data_, cudaMemcpyDeviceToHost);
  }
  void copy_from(const DeviceArray& other) {
    resize(other.size_);
    copy(data_, other.data_, cudaMemcpyDeviceToDevice);
  }

private:
  void copy(T* to, const T* from, cudaMemcpyKind kind) const {
    if (size_ > 0) {
      check(cudaMemcpy(to, from, size_ * sizeof(T), kind), "cudaMemcpy");
    }
  }
  void swap(DeviceArray& other) noexcept {
    std::swap(data_, other.data_);
    std::swap(size_, other.size_);
    std::swap(capacity_, other.capacity_);
  }

  T* data_ = nullptr;
  std::size_t size_ = 0;
  std::size_t capacity_ = 0;
};

/// The elements of an array, in the processor's memory (core/parallel/host.h).
template <class T> std::vector<T> fetch(const DeviceArray<T>& array) {
  std::vector<T> values;
  array.download(values);
  return values;
}

} // namespace foam::cuda
