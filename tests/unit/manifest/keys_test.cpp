// The one table of keys, and what is made from it.
#include "host/manifest/keys.hpp"

#include <fmt/format.h>

#include <set>
#include <sstream>

#include "host/manifest/document.hpp"
#include "tests/unit/manifest/fake_catalogue.hpp"

namespace riffle::test {
namespace {

class Keys : public ManifestTest {
 protected:
  static std::string file(const std::string& name) {
    const std::filesystem::path path = std::filesystem::path(RIFFLE_TEST_DATA) / "../../.." / name;
    std::ifstream stream(path);
    std::stringstream text;
    text << stream.rdbuf();
    return text.str();
  }
};

TEST_F(Keys, AreNamedOnceAndDocumented) {
  std::set<std::string> seen;
  for (const ManifestKey& key : manifest_keys()) {
    EXPECT_TRUE(seen.insert(key.path()).second) << key.path();
    EXPECT_FALSE(key.value.doc.empty()) << key.path();
  }
  EXPECT_THROW(static_cast<void>(manifest_key("time.ende")), std::logic_error);
}

// A key with a default may be left out or set to that default: nothing changes.
TEST_F(Keys, TheReaderTakesEveryKeyAtItsDefault) {
  const std::string expected = read(dam_break).effective;
  int checked = 0;
  for (const ManifestKey& key : manifest_keys()) {
    const bool plain = key.form == ManifestKey::Form::single && !key.optional && !key.value.required;
    if (!plain || key.table == "plugins" || key.table == "reference" || key.table == "surface" ||
        key.path() == "case.title")
      continue;
    const bool word = key.value.type == ParameterType::choice;
    const bool boolean = key.value.type == ParameterType::boolean;
    const std::string value = word ? key.value.fallback_text : boolean ? "true" : fmt::format("{}", key.value.fallback);
    EXPECT_EQ(read(dam_break, {key.path() + '=' + value}).effective, expected) << key.path();
    ++checked;
  }
  EXPECT_GE(checked, 15);
}

TEST_F(Keys, TheDocumentationHoldsTheTableOfKeysAsItIs) {
  const std::string page = file("docs/manifest.md");
  std::istringstream rows(keys_in_markdown());
  for (std::string row; std::getline(rows, row);) {
    EXPECT_NE(page.find(row + '\n'), std::string::npos) << "docs/manifest.md lacks the row\n" << row;
  }
}

TEST_F(Keys, EveryExampleOfTheDocumentationIsToml) {
  const std::string page = file("docs/manifest.md");
  const std::string open = "```toml\n";
  int examples = 0;
  for (std::size_t at = page.find(open); at != std::string::npos; at = page.find(open, at + 1), ++examples) {
    const std::size_t begin = at + open.size();
    EXPECT_NO_THROW(read_toml(page.substr(begin, page.find("```", begin) - begin), "docs/manifest.md"));
  }
  EXPECT_GE(examples, 3);
}

}  // namespace
}  // namespace riffle::test
