#include <gtest/gtest.h>

#include "host/output/atomic_file.hpp"
#include "host/study/study_keys.hpp"

namespace riffle {
namespace {

// When this fails, put what it prints into docs/comparing.md.
TEST(StudyKeys, AreTheTableOfTheDocumentation) {
  const std::string page = read_file(std::string(RIFFLE_TEST_DATA) + "/../../../docs/comparing.md");
  EXPECT_NE(page.find(study_keys_in_markdown()), std::string::npos) << study_keys_in_markdown();
}

}  // namespace
}  // namespace riffle
