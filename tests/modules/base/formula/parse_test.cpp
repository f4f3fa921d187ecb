#include "formula_support.hpp"

#include <cmath>
#include <numbers>

using namespace scree;
using namespace scree::test;

namespace {

std::string refused(const std::string& text) {
  return refusal_of([&] { formula::parse(text); });
}

}  // namespace

TEST_CASE("signs bind as in mathematics", "[formula]") {
  CHECK(computed("p.a + p.b * p.c") == a + b * c);
  CHECK(computed("p.a * p.b + p.c") == a * b + c);
  CHECK(computed("p.a - p.b / p.c") == a - b / c);
  CHECK(computed("p.a * p.c ^ 3") == a * std::pow(c, 3));
  CHECK(computed("p.c ^ 3 * p.a") == std::pow(c, 3) * a);
  CHECK(computed("p.a ^ 2 + p.c ^ 3") == std::pow(a, 2) + std::pow(c, 3));
  CHECK(computed("(p.a + p.b) * p.c") == (a + b) * c);
  CHECK(computed("p.a / (p.b * p.c)") == a / (b * c));
  CHECK(computed("((p.a))") == a);
}

TEST_CASE("equal signs are read from the left, powers from the right", "[formula]") {
  CHECK(computed("p.a - p.b - p.c") == (a - b) - c);
  CHECK(computed("p.a - p.b + p.c") == (a - b) + c);
  CHECK(computed("p.a / p.b / p.c") == (a / b) / c);
  CHECK(computed("p.a / p.b * p.c") == (a / b) * c);
  CHECK(computed("p.a ^ p.c ^ 2") == std::pow(a, std::pow(c, 2)));
  CHECK(computed("2 ^ 3 ^ 2") == 512);
}

TEST_CASE("the minus sign is stronger than products and weaker than powers", "[formula]") {
  CHECK(computed("-p.a ^ 2") == -(a * a));
  CHECK(computed("(-p.a) ^ 2") == Approx(a * a).epsilon(1e-15));  // round-off of the power
  CHECK(computed("-p.a + p.c") == -a + c);
  CHECK(computed("-p.a * p.c") == -a * c);
  CHECK(computed("p.a * -p.c") == a * -c);
  CHECK(computed("p.a - -p.c") == a + c);
  CHECK(computed("--p.a") == a);
  CHECK(computed("2 ^ -1 + 0 * p.a") == 0.5);
  CHECK(computed("2 ^ -p.c ^ 2") == std::pow(2, -std::pow(c, 2)));
}

TEST_CASE("numbers, pi, time and names", "[formula]") {
  CHECK(computed("1e3 + .5 - 2. + 1.5E-1") == 1e3 + .5 - 2. + 1.5e-1);
  CHECK(computed("0.1") == 0.1);
  CHECK(computed("pi") == std::numbers::pi);
  CHECK(computed("2*time") == 0.5);
  CHECK(computed(" \tp.a\n*  p.a ") == a * a);
  CHECK(computed("min ( p.a , 1 )") == 1);
  const formula::Formula formula = formula::parse("box.x_1 + 'top-wall.force x' * box.x_1 / pi.2.b");
  REQUIRE(formula.names.size() == 3);
  CHECK(formula.names[0].text == "box.x_1");
  CHECK(formula.names[1].text == "top-wall.force x");
  CHECK(formula.names[1].at == 10);
  CHECK(formula.names[2].text == "pi.2.b");
}

TEST_CASE("what is wrong with a formula is said where it stands", "[formula]") {
  const std::string columns = "; give the name of a probe, a dot and one of its columns";
  CHECK(refused("") ==
        "0: the formula is empty; give an expression such as \"box.stress_xx / box.stress_zz\"");
  CHECK(refused("  ").starts_with("2: the formula is empty; "));
  CHECK(refused("2 * sqr(p.a)") == "4: no function 'sqr'; did you mean 'sqrt'?");
  CHECK(refused("sinh(p.a)") == "0: no function 'sinh'; did you mean 'sin'?");
  CHECK(
      refused("erfc(p.a)") ==
      "0: no function 'erfc'; there are: sqrt, abs, exp, log, log10, sin, cos, tan, asin, acos, atan, min, max");
  CHECK(refused("2 * sqrt") == "4: the function 'sqrt' has no arguments; write sqrt(...)");
  CHECK(refused("min + 1") == "0: the function 'min' has no arguments; write min(...)");
  CHECK(refused("sqrt()") == "0: sqrt has 0 arguments; give it 1");
  CHECK(refused("sqrt(1, 2)") == "0: sqrt has 2 arguments; give it 1");
  CHECK(refused("1 + min(1)") == "4: min has 1 argument; give it 2");
  CHECK(refused("1 + (2 * (p.a)") == "4: this '(' is not closed; add ')'");
  CHECK(refused("sin(p.a") == "3: this '(' is not closed; add ')'");
  CHECK(refused("p.a)") == "3: no '(' belongs to this ')'; remove it, or add '(' before");
  CHECK(refused("stress / 2") == "0: 'stress' is not <probe>.<column>" + columns);
  CHECK(refused("1 + box.") == "4: 'box.' is not <probe>.<column>" + columns);
  CHECK(refused("''") == "0: '' is not <probe>.<column>" + columns);
  CHECK(refused("1 + '.x'") == "4: '.x' is not <probe>.<column>" + columns);
  CHECK(refused("1 + 'p.a") == "4: the quote is not closed; add ' behind the name");
  CHECK(refused("p.a +") == "5: a number or column is missing at the end; add it, or remove the sign");
  CHECK(refused("(p.a + )") == "7: a number or column is missing before ')'; add it, or remove the sign");
  CHECK(refused("/ 2") == "0: a number or column is missing before '/'; add it, or remove the sign");
  CHECK(refused("min(, 2)") == "4: a number or column is missing before ','; add it, or remove the sign");
  CHECK(refused("p.a**2") == "4: a number or column is missing before '*'; write ^ for a power");
  CHECK(refused("2 p.a") == "2: no sign before 'p.a'; write +, -, *, / or ^ between two numbers");
  CHECK(refused("2(3)") == "1: no sign before '(3)'; write +, -, *, / or ^ between two numbers");
  CHECK(refused("p.a 'p.b'").starts_with("4: no sign before ''p.b''; "));
  CHECK(refused("1,5") == "1: a comma is outside of min() and max(); write '.' in numbers, such as 0.5");
  CHECK(refused("(1,5)").starts_with("2: a comma is outside "));
  const std::string allowed =
      " does not belong in a formula; write numbers, +, -, *, /, ^, parentheses, functions and columns as "
      "<probe>.<column>";
  CHECK(refused("x = 3") == "0: 'x' is not <probe>.<column>" + columns);
  CHECK(refused("p.a = 3") == "4: '='" + allowed);
  CHECK(refused("p.a + \u00b5") == "6: '\u00b5' is not <probe>.<column>" + columns);
  CHECK(refused("p.a $") == "4: '$'" + allowed);
  CHECK(refused("+ p.a") == "0: a number or column is missing before '+'; add it, or remove the sign");
  CHECK(refused("& p.a") == "0: '&'" + allowed);
  CHECK(refused("1e999 + 1") ==
        "0: '1e999' is beyond the range of a number; give a number from 1e-307 to 1e308");
  CHECK(refused(".") == "0: '.' is no number; write it with digits, such as 0.5");
}

TEST_CASE("a formula is nested as deep as the stack allows", "[formula]") {
  const auto nested = [](std::size_t levels) {
    return std::string(levels, '(') + "1" + std::string(levels, ')');
  };
  CHECK(computed(nested(99)) == 1);
  CHECK(refused(nested(100)) ==
        "100: the formula is nested more than 100 levels deep; divide it into several quantities");
  CHECK(refused(std::string(1000000, '-')).find("more than 100 levels") != std::string::npos);
  std::string power = "1";
  for (int k = 0; k < 1000; ++k) power += "^1";
  CHECK(refused(power).find("more than 100 levels") != std::string::npos);
  std::string sum = "1";
  for (int k = 0; k < 10000; ++k) sum += "+1";
  CHECK(computed(sum) == 10001);
}
