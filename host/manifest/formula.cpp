#include "host/manifest/formula.hpp"

#include <muParser.h>

#include <algorithm>
#include <mutex>
#include <numbers>
#include <vector>

#include "host/manifest/nearest.hpp"

namespace riffle {
namespace {

constexpr std::array<const char*, 4> variable_names{"x", "y", "z", "t"};

// A muParser object holds its variables and its stack, so that one may only be used by one thread at a time.
struct Evaluator {
  Evaluator(const std::string& text, double gravity) {
    for (std::size_t k = 0; k < at.size(); ++k) parser.DefineVar(variable_names[k], &at[k]);
    parser.DefineConst("pi", std::numbers::pi);
    parser.DefineConst("g", gravity);
    parser.SetExpr(text);
  }
  Evaluator(const Evaluator&) = delete;
  Evaluator& operator=(const Evaluator&) = delete;

  mu::Parser parser;
  std::array<double, 4> at{};
};

// Keeps as many evaluators as threads have ever asked at once.
class FormulaFunction final : public Function::Implementation {
 public:
  FormulaFunction(std::string text, double gravity, std::unique_ptr<Evaluator> first)
      : text_(std::move(text)), gravity_(gravity) {
    idle_.push_back(std::move(first));
  }

  void evaluate(std::int64_t n, const double* x, const double* y, const double* z, double t,
                double* out) const override {
    std::unique_ptr<Evaluator> evaluator = take();
    evaluator->at[3] = t;
    for (std::int64_t k = 0; k < n; ++k) {
      evaluator->at[0] = x != nullptr ? x[k] : 0;
      evaluator->at[1] = y != nullptr ? y[k] : 0;
      evaluator->at[2] = z != nullptr ? z[k] : 0;
      out[k] = evaluator->parser.Eval();
    }
    const std::lock_guard lock(mutex_);
    idle_.push_back(std::move(evaluator));
  }

 private:
  std::unique_ptr<Evaluator> take() const {
    {
      const std::lock_guard lock(mutex_);
      if (!idle_.empty()) {
        std::unique_ptr<Evaluator> evaluator = std::move(idle_.back());
        idle_.pop_back();
        return evaluator;
      }
    }
    return std::make_unique<Evaluator>(text_, gravity_);
  }

  std::string text_;
  double gravity_;
  mutable std::mutex mutex_;
  mutable std::vector<std::unique_ptr<Evaluator>> idle_;
};

// muParser would take a single "=" as an assignment to the variable.
std::optional<std::size_t> assignment(const std::string& text) {
  for (std::size_t k = 0; k < text.size(); ++k) {
    if (text[k] != '=') continue;
    if (k + 1 < text.size() && text[k + 1] == '=') {
      ++k;
    } else if (k == 0 || std::string("<>!").find(text[k - 1]) == std::string::npos) {
      return k;
    }
  }
  return std::nullopt;
}

std::vector<std::string> known_names(const mu::Parser& parser) {
  std::vector<std::string> names(variable_names.begin(), variable_names.end());
  for (const auto& [name, value] : parser.GetConst()) names.push_back(name);
  for (const auto& [name, callback] : parser.GetFunDef()) names.push_back(name);
  return names;
}

// muParser's own words, without the position, which is given as a column instead.
std::string clause(const mu::ParserError& error, const std::vector<std::string>& names) {
  std::string words = error.GetMsg();
  for (const char* tail : {" found at position", " at expression position", " at position"}) {
    const std::size_t at = words.find(tail);
    if (at != std::string::npos) words.resize(at);
  }
  while (!words.empty() && (words.back() == '.' || words.back() == '!' || words.back() == ' ')) words.pop_back();
  if (!words.empty() && words.front() >= 'A' && words.front() <= 'Z') {
    words.front() = static_cast<char>(words.front() - 'A' + 'a');
  }
  if (error.GetCode() == mu::ecUNASSIGNABLE_TOKEN) words += did_you_mean(error.GetToken(), names);
  return words;
}

}  // namespace

Formula parse_formula(const std::string& text, double gravity) {
  if (const auto at = assignment(text)) throw FormulaError("\"=\" assigns; a comparison is written \"==\"", at);
  std::unique_ptr<Evaluator> evaluator;
  Formula formula;
  try {
    evaluator = std::make_unique<Evaluator>(text, gravity);
    evaluator->parser.Eval();
    if (evaluator->parser.GetNumResults() != 1) throw FormulaError("one value is wanted, not several with commas", {});
    for (const auto& [name, address] : evaluator->parser.GetUsedVar()) {
      for (std::size_t k = 0; k < variable_names.size(); ++k) {
        if (name == variable_names[k]) formula.uses[k] = true;
      }
    }
  } catch (const mu::ParserError& error) {
    std::optional<std::size_t> at;
    // muParser reads one character past the end before it misses a parenthesis.
    if (error.GetPos() >= 0) at = std::min(static_cast<std::size_t>(error.GetPos()), text.size());
    throw FormulaError(clause(error, known_names(evaluator != nullptr ? evaluator->parser : mu::Parser())), at);
  }
  formula.implementation = std::make_shared<FormulaFunction>(text, gravity, std::move(evaluator));
  return formula;
}

}  // namespace riffle
