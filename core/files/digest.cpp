#include "core/files/digest.hpp"

#include <openssl/evp.h>

#include <array>
#include <stdexcept>

#include "core/files/text_file.hpp"

namespace clast {

struct Sha256::Impl {
  struct Free {
    void operator()(EVP_MD_CTX* context) const { EVP_MD_CTX_free(context); }
  };
  std::unique_ptr<EVP_MD_CTX, Free> context{EVP_MD_CTX_new()};

  /// Only memory or the set-up of the library can fail here, not the data.
  static void check(int result) {
    if (result != 1) throw std::runtime_error("OpenSSL could not compute a SHA-256 digest");
  }
};

Sha256::Sha256() : impl_(std::make_unique<Impl>()) {
  Impl::check(EVP_DigestInit_ex(impl_->context.get(), EVP_sha256(), nullptr));
}
Sha256::~Sha256() = default;
Sha256::Sha256(Sha256&&) noexcept = default;
Sha256& Sha256::operator=(Sha256&&) noexcept = default;

void Sha256::add(std::string_view bytes) {
  Impl::check(EVP_DigestUpdate(impl_->context.get(), bytes.data(), bytes.size()));
}

std::string Sha256::finish() {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned int size = 0;
  Impl::check(EVP_DigestFinal_ex(impl_->context.get(), digest.data(), &size));
  std::string text;
  for (unsigned int i = 0; i < size; ++i) {
    text += "0123456789abcdef"[digest[i] >> 4];
    text += "0123456789abcdef"[digest[i] & 15u];
  }
  return text;
}

std::string sha256(std::string_view bytes) {
  Sha256 digest;
  digest.add(bytes);
  return digest.finish();
}

std::string sha256_of_file(const std::filesystem::path& path) {
  Sha256 digest;
  read_file_in_chunks(path, [&](std::string_view piece) { digest.add(piece); });
  return digest.finish();
}

}  // namespace clast
