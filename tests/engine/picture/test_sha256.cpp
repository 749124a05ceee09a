// The checksum that the tests of pictures rely on.
#include <doctest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "support/sha256.hpp"

namespace {

std::string sum_of(const std::string& text) {
  const std::vector<std::uint8_t> bytes(text.begin(), text.end());
  return texmap::test::sha256(bytes);
}

}  // namespace

TEST_CASE("SHA-256 gives the published sums") {
  CHECK(sum_of("") == "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  CHECK(sum_of("abc") == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  CHECK(sum_of("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq") ==
        "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  CHECK(sum_of(std::string(1000000, 'a')) ==
        "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}
