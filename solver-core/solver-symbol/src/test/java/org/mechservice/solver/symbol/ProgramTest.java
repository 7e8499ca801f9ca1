package org.mechservice.solver.symbol;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class ProgramTest {
  @Test
  void whatNoOutputNeedsIsNotPartOfTheProgram() {
    Program program = new Program();
    program.section("one section", "s");
    Scalar x = program.expressions().input(0);
    Scalar used = x.times(x);
    Scalar unused = used.plus(x);
    program.output(0, used);
    assertThat(program.operationCount()).isEqualTo(1);
    assertThat(program.uses()[unused.id()]).isZero();
    assertThat(program.uses()[x.id()]).isEqualTo(2);
  }

  @Test
  void theFirstGuardThatFailsEndsTheProgram() {
    Program program = new Program();
    program.section("guarded", "s");
    Expressions expressions = program.expressions();
    program.guard(new Program.Guard(expressions.input(0), expressions.zero(), 4, "x > 0"));
    program.section("after it", "s");
    program.output(0, expressions.input(0));
    double[] out = {7};
    assertThat(program.evaluate(new double[] {0}, out)).isEqualTo(4);
    assertThat(out).containsExactly(7);
    assertThat(program.evaluate(new double[] {2}, out)).isEqualTo(-1);
    assertThat(out).containsExactly(2);
  }

  @Test
  void aNameIsGivenToTheValueBehindASign() {
    Program program = new Program();
    Scalar product = program.expressions().input(0).times(program.expressions().input(1));
    program.named("p", product.negated());
    assertThat(program.nameOf(product)).contains("minus_p");
  }
}
