package org.mechservice.sim.emit.plan;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.mechservice.sim.emit.method.CodeSize;
import org.mechservice.sim.emit.method.ConstantTable;
import org.mechservice.sim.emit.method.MethodSignature;
import org.mechservice.sim.emit.method.Statement;
import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.Program;
import org.mechservice.solver.symbol.Scalar;

/** The choice between a straight line and shared kernels, at its two boundaries. */
class CodeLayoutTest {
  private static final MethodSignature HEAD =
      new MethodSignature(
          "f", List.of(new MethodSignature.Argument("y", true, 0)), "out", false, true);

  private static final int OPERATIONS_OF_SECTION = 100;
  private static final int ALIKE = 100;

  /** Sections of 100 operations, some alike and others each in an order of its own. */
  private static Program program(int alike, int different) {
    Program program = new Program();
    for (int section = 0; section < alike + different; section++) {
      int order = section < alike ? 0x33333333 : 0x9E3779B9 * section;
      append(program, section, alike + different, order, OPERATIONS_OF_SECTION);
    }
    return program;
  }

  private static void append(
      Program program, int section, int sections, int order, int operations) {
    Expressions expressions = program.expressions();
    program.section("", "s");
    Scalar x = expressions.input(section);
    Scalar y = expressions.input(sections + section);
    for (int i = 0; i < operations; i++) {
      x = (order >>> i % 32 & 1) == 0 ? x.plus(y) : x.times(y);
    }
    program.output(section, x);
  }

  private static ProgramPlan chosen(Program program) {
    return CodeLayout.plan(program, HEAD, CodeForm.AUTO, new ConstantTable());
  }

  /** How many times longer the straight line is than shared kernels. */
  private static double gain(Program program) {
    ProgramPlan shared = KernelPlanner.plan(program, HEAD, new ConstantTable());
    int straight = Arrays.stream(CodeSize.ofSections(program, shared.usage())).sum();
    return (double) straight / shared.codeBytes();
  }

  /** With every section that is like no other the gain falls; on the way it passes 2. */
  @Test
  void kernelsAreSharedAsLongAsTheyHalveTheCode() {
    int few = 0;
    int many = 400;
    assertThat(gain(program(ALIKE, few))).isGreaterThan(2);
    assertThat(gain(program(ALIKE, many))).isLessThan(2);
    while (many - few > 1) {
      int middle = (few + many) / 2;
      if (gain(program(ALIKE, middle)) >= 2) {
        few = middle;
      } else {
        many = middle;
      }
    }
    assertThat(chosen(program(ALIKE, few)).isShared()).isTrue();
    assertThat(chosen(program(ALIKE, many)).isShared()).isFalse();
  }

  @Test
  void aShortProgramIsWrittenOutHoweverMuchOfItIsAlike() {
    Program shorter = program(CodeForm.LEAST_OPERATIONS / OPERATIONS_OF_SECTION - 1, 0);
    append(shorter, 99, 100, 0x33333333, OPERATIONS_OF_SECTION - 1);
    assertThat(shorter.operationCount()).isEqualTo(CodeForm.LEAST_OPERATIONS - 1);
    assertThat(chosen(shorter).isShared()).isFalse();
    Program longer = program(CodeForm.LEAST_OPERATIONS / OPERATIONS_OF_SECTION, 0);
    assertThat(longer.operationCount()).isEqualTo(CodeForm.LEAST_OPERATIONS);
    assertThat(chosen(longer).isShared()).isTrue();
  }

  @Test
  void kernelsThatAreNotTakenLeaveNoConstantsBehind() {
    ConstantTable table = new ConstantTable();
    CodeLayout.plan(program(ALIKE, 400), HEAD, CodeForm.AUTO, table);
    assertThat(table.isEmpty()).isTrue();
  }

  /** Sections that need the same sine, with what each puts out before the next. */
  private static Program ofOneAngle(boolean steps) {
    Program program = new Program();
    for (int i = 0; i < 3; i++) {
      Expressions expressions = program.expressions();
      if (steps) {
        program.step("", "s");
      } else {
        program.section("", "s");
      }
      program.output(i, expressions.sine(expressions.input(9)).times(expressions.input(i)));
    }
    return program;
  }

  private static List<Boolean> loads(ProgramPlan plan) {
    return plan.methods().get(0).statements().stream()
        .flatMap(statement -> statement instanceof Statement.Load load ? Stream.of(load) : null)
        .map(Statement.Load::again)
        .toList();
  }

  @Test
  void everyStepReadsWhatItNeedsAnew() {
    assertThat(loads(StraightLinePlanner.plan(ofOneAngle(true), new ConstantTable())))
        .containsExactly(false, true, true);
  }

  @Test
  void otherSectionsOfAMethodReadAValueOnce() {
    assertThat(loads(StraightLinePlanner.plan(ofOneAngle(false), new ConstantTable())))
        .containsExactly(false);
  }
}
