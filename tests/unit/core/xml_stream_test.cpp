#include "core/xml_stream.hpp"

#include <gmock/gmock.h>
#include <zlib.h>

#include <filesystem>
#include <fstream>

namespace pedzone {
namespace {

using ::testing::HasSubstr;

class XmlStream : public ::testing::Test {
 protected:
  void TearDown() override { std::filesystem::remove(file_); }

  void write(const std::string& text) { std::ofstream(file_, std::ios::binary) << text; }

  /// Names with their depths and `v` attributes; or the error.
  std::string visited(std::string_view root = {}) {
    std::string told;
    try {
      visit_elements(file_, root, [&](const XmlElement& element) {
        told += std::to_string(element.depth()) + std::string(element.name());
        if (const auto value = element.value("v")) told += "=" + std::string(*value);
        told += " ";
      });
    } catch (const InputError& error) {
      return error.what();
    }
    return told;
  }

  /// Its own for each test: they run side by side.
  std::string file_ = testing::TempDir() + "pedzone_xml_stream_test." +
                      testing::UnitTest::GetInstance()->current_test_info()->name() + ".xml";
};

TEST_F(XmlStream, visits_opening_tags_with_their_attributes) {
  write("<?xml version=\"1.0\"?><!-- <no v='1'/> --><a><b v='x &amp; &#10;y'/><c><d/></c></a>");
  EXPECT_EQ(visited("a"), "0a 1b=x & \ny 1c 2d ");
}

TEST_F(XmlStream, reads_compressed_files_and_tells_how_far_it_is) {
  std::string text = "<a>";
  for (int i = 0; i < 100000; ++i) text += "<b v='" + std::to_string(i) + "'/>";
  text += "</a>";
  const gzFile out = gzopen(file_.c_str(), "wb");
  gzwrite(out, text.data(), static_cast<unsigned>(text.size()));
  gzclose(out);
  int count = 0;
  std::vector<double> shares;
  visit_elements(
      file_, "a", [&](const XmlElement&) { ++count; },
      [&](double share) { shares.push_back(share); });
  EXPECT_EQ(count, 100001);
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
  EXPECT_EQ(shares.back(), 1.0);
}

TEST_F(XmlStream, follows_includes_from_where_they_stand) {
  const std::string other = file_ + ".other";
  const std::string name = std::filesystem::path(other).filename().string();
  std::ofstream(other) << "<b><c v='1'/></b>";
  write("<a><before/><include href='" + name + "'/><after/></a>");
  EXPECT_EQ(visited("a"), "0a 1before 0b 1c=1 1after ");
  std::ofstream(other) << "<b><include href='" << name << "'/></b>";
  EXPECT_THAT(visited("a"), HasSubstr("includes a file that includes it"));
  std::filesystem::remove(other);
  EXPECT_THAT(visited("a"), HasSubstr("cannot be opened"));
}

TEST_F(XmlStream, names_what_is_wrong) {
  EXPECT_THAT(visited(), HasSubstr("cannot be opened"));
  write("");
  EXPECT_THAT(visited(), HasSubstr("not well-formed"));
  write("<a>\n<b>\n</a>");
  EXPECT_THAT(visited(), HasSubstr(".xml:3: is not well-formed"));
  write("<a>\n<b/>\n");  // broken off
  EXPECT_THAT(visited(), HasSubstr("not well-formed"));
  write("\n<a/>");
  EXPECT_THAT(visited("z"), HasSubstr(".xml:2: document element: 'a' is not"));
  write("\x1f\x8b\x08 no gzip");
  EXPECT_THAT(visited(), HasSubstr("cannot be read"));
}

TEST_F(XmlStream, refuses_entities_that_grow_without_bound) {
  std::string text = "<!DOCTYPE a [<!ENTITY e0 'xxxxxxxxxx'>";
  for (int i = 1; i < 12; ++i) {
    text += "<!ENTITY e" + std::to_string(i) + " '";
    for (int k = 0; k < 10; ++k) text += "&e" + std::to_string(i - 1) + ";";
    text += "'>";
  }
  write(text + "]><a v='&e11;'/>");
  EXPECT_THAT(visited(), HasSubstr("not well-formed"));
}

TEST_F(XmlStream, checks_attributes) {
  write("<a>\n<b id='&lt;x&gt;' v='-3' w='' u='u'/></a>");
  const auto problem = [&](const std::function<void(const XmlElement&)>& read) -> std::string {
    try {
      visit_elements(file_, "a", [&](const XmlElement& element) {
        if (element.name() == "b") read(element);
      });
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(problem([](const XmlElement& b) { EXPECT_EQ(b.number("v", {-5, 0}), -3.0); }), "");
  EXPECT_THAT(
      problem([](const XmlElement& b) {
        b.number("v", {0, 9});
      }),
      HasSubstr(".xml:2: <b id=\"<x>\"> attribute v: '-3' is out of range; allowed: 0 to 9"));
  EXPECT_THAT(problem([](const XmlElement& b) {
                b.number("u", {0, 9});
              }),
              HasSubstr("'u' is not a number; allowed: 0 to 9"));
  EXPECT_THAT(problem([](const XmlElement& b) { b.required("w"); }), HasSubstr("w: is empty"));
  EXPECT_THAT(problem([](const XmlElement& b) { b.required("z"); }), HasSubstr("z: is missing"));
}

}  // namespace
}  // namespace pedzone
