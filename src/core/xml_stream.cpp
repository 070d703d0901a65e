#include "core/xml_stream.hpp"

#include <expat.h>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <memory>

namespace pedzone {
namespace {

/// What the parser's callbacks share. Exceptions must not pass through its C code: the first is
/// kept, and the parser stopped.
struct Reading {
  const std::string& file;
  int includes;  ///< so many files have led here
  std::string_view root;
  const ElementVisitor& visitor;
  XML_Parser parser;
  int depth = 0;
  std::exception_ptr thrown = nullptr;
};

void visit_file(const std::string& file, std::string_view root, const ElementVisitor& visitor,
                const ReadProgress& progress, int includes);

/// As SUMO does, which takes such a name relative to the file that it stands in.
void visit_included(const XmlElement& element, const Reading& reading) {
  constexpr int kMost = 20;  // numerical: a file that includes itself ends nowhere
  const std::filesystem::path name(element.required("href"));
  if (reading.includes >= kMost) {
    throw element.error("includes a file that includes it, or too many in turn", "href",
                        name.string());
  }
  const std::filesystem::path folder = std::filesystem::path(reading.file).parent_path();
  visit_file((folder / name).string(), "", reading.visitor, {}, reading.includes + 1);
}

void visit(Reading& reading, const char* name, const char** attributes) {
  const XmlElement element(reading.file, static_cast<int>(XML_GetCurrentLineNumber(reading.parser)),
                           reading.depth, name, attributes);
  if (reading.depth == 0 && !reading.root.empty() && element.name() != reading.root) {
    throw InputError("is not the document element expected",
                     {.file = reading.file,
                      .line = static_cast<int>(XML_GetCurrentLineNumber(reading.parser)),
                      .element = "document element",
                      .value = name,
                      .allowed = std::string(reading.root)});
  }
  if (reading.depth > 0 && element.name() == "include") {
    visit_included(element, reading);
  } else {
    reading.visitor(element);
  }
}

void XMLCALL on_begin(void* data, const char* name, const char** attributes) {
  Reading& reading = *static_cast<Reading*>(data);
  if (reading.thrown) return;
  try {
    visit(reading, name, attributes);
    ++reading.depth;
  } catch (...) {
    reading.thrown = std::current_exception();
    XML_StopParser(reading.parser, XML_FALSE);
  }
}

void XMLCALL on_end(void* data, const char* /*name*/) { --static_cast<Reading*>(data)->depth; }

/// Parses what `parser` has in its buffer.
void parse(Reading& reading, int bytes, bool last) {
  const XML_Status status = XML_ParseBuffer(reading.parser, bytes, last ? 1 : 0);
  if (reading.thrown) std::rethrow_exception(reading.thrown);
  if (status == XML_STATUS_OK) return;
  throw InputError(
      std::string("is not well-formed XML (") + XML_ErrorString(XML_GetErrorCode(reading.parser)) +
          ")",
      {.file = reading.file, .line = static_cast<int>(XML_GetCurrentLineNumber(reading.parser))});
}

}  // namespace

std::optional<std::string_view> XmlElement::value(std::string_view attribute) const {
  for (const char** at = attributes_; *at != nullptr; at += 2) {
    if (attribute == at[0]) return at[1];
  }
  return std::nullopt;
}

std::string_view XmlElement::required(std::string_view attribute) const {
  const auto given = value(attribute);
  if (!given || given->empty()) throw error(given ? "is empty" : "is missing", attribute);
  return *given;
}

double XmlElement::number(std::string_view attribute, const NumberRange& range) const {
  const std::string_view given = required(attribute);
  double result = 0.0;
  if (!parse_number(given, result)) {
    throw error("is not a number", attribute, given, describe(range));
  }
  if (result < range.least || result > range.most) {
    throw error("is out of range", attribute, given, describe(range));
  }
  return result;
}

InputError XmlElement::error(const std::string& problem, std::string_view attribute,
                             std::string_view given, const std::string& allowed) const {
  std::string element = "<" + std::string(name_);
  const auto id = value("id");
  if (id && attribute != "id") element += " id=\"" + std::string(*id) + "\"";
  element += ">";
  if (!attribute.empty()) element += " attribute " + std::string(attribute);
  return InputError(problem, {.file = file_,
                              .line = line_,
                              .element = element,
                              .value = std::string(given),
                              .allowed = allowed});
}

namespace {

void visit_file(const std::string& file, std::string_view root, const ElementVisitor& visitor,
                const ReadProgress& progress, int includes) {
  GzipFile input(file);
  const std::unique_ptr<XML_ParserStruct, void (*)(XML_Parser)> parser(XML_ParserCreate(nullptr),
                                                                       XML_ParserFree);
  Reading reading{file, includes, root, visitor, parser.get()};
  XML_SetUserData(parser.get(), &reading);
  XML_SetElementHandler(parser.get(), on_begin, on_end);
  for (bool last = false; !last;) {
    void* piece = XML_GetBuffer(parser.get(), GzipFile::kPiece);
    if (piece == nullptr) throw std::bad_alloc();
    const int got = input.read(piece, GzipFile::kPiece);
    last = got < GzipFile::kPiece;
    parse(reading, got, last);
    input.tell(progress);
  }
}

}  // namespace

void visit_elements(const std::string& file, std::string_view root, const ElementVisitor& visitor,
                    const ReadProgress& progress) {
  visit_file(file, root, visitor, progress, 0);
}

}  // namespace pedzone
