#include "study/plan/checksum.hpp"

#include <gtest/gtest.h>

namespace pedzone::study {
namespace {

TEST(Checksum, is_that_of_the_standard) {
  // FIPS 180-2, appendix B.1 and B.2; the empty text: NIST's SHA256ShortMsg vectors.
  EXPECT_EQ(sha256_hex(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256_hex("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256_hex("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
}

}  // namespace
}  // namespace pedzone::study
