package org.mechservice.sim.model;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.sim.scene.forecast.RunForecast;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.capability.ModelParts;
import org.mechservice.solver.dynamics.LinearisedResidualModel;
import org.mechservice.solver.force.user.UserForceSource;
import org.mechservice.solver.symbol.MathFunction;

/**
 * Each function of expressions works at every stage from the model file to the run: reader,
 * forecast, data-driven evaluation, class file and compiled source, value and derivatives. The
 * scene is the block of {@link BranchesNotTakenTest}.
 */
class EveryFunctionTest {
  private static final double Q = 0.3;
  private static final double V = 0.7;

  /** Writes a force of half a function of the position, and of the velocity if it takes two. */
  private static String force(String prefix, MathFunction function) {
    String arguments = function.arity() == 1 ? "s.q" : "s.q, s.v";
    return "<jointForce name=\"f\" joint=\"s\" expression=\"0.5*"
        + (prefix + function.symbol() + "(" + arguments + ")")
        + "\"/>";
  }

  static List<MathFunction> functions() {
    return MathFunction.inFormulas();
  }

  private static Model data(MechmlModel file) {
    return new LinearisedResidualModel(
        file.mechanism(),
        BranchesNotTakenTest.OPTIONS.settings(),
        UserForceSource.NONE,
        LinearisedResidualModel.Mode.FULL);
  }

  private static double acceleration(Model model) {
    double[] rates = new double[2];
    ((ExplicitModel) ModelParts.of(model).equations()).derivative(0, new double[] {Q, V}, rates);
    return rates[1];
  }

  @MethodSource("functions")
  @ParameterizedTest
  void dataAndCodeGiveTheSameBits(MathFunction function) throws Exception {
    MechmlModel file = BranchesNotTakenTest.scene(force("", function));
    GeneratedModel generated = ModelFactory.generate(file, BranchesNotTakenTest.OPTIONS);
    Model code = ModelFactory.compile(file, BranchesNotTakenTest.OPTIONS, generated).newInstance();
    Model compiled =
        ModelFactory.compileSource(file, BranchesNotTakenTest.OPTIONS, generated).newInstance();

    double expected = acceleration(data(file));

    assertThat(generated.operations()).isPositive();
    assertThat(expected).isCloseTo(0.5 * function.value(Q, V), within(1e-15));
    assertThat(acceleration(code)).isEqualTo(expected);
    assertThat(acceleration(compiled)).isEqualTo(expected);
  }

  @MethodSource("functions")
  @ParameterizedTest
  void derivativesOfDataAndCodeAgree(MathFunction function) throws Exception {
    MechmlModel file = BranchesNotTakenTest.scene(force("", function));
    GeneratedModel generated = ModelFactory.generate(file, BranchesNotTakenTest.OPTIONS);
    Model code = ModelFactory.compile(file, BranchesNotTakenTest.OPTIONS, generated).newInstance();

    double[] expected = BranchesNotTakenTest.step(data(file), Q, V);

    assertThat(BranchesNotTakenTest.step(code, Q, V)).containsExactly(expected, within(1e-13));
  }

  @MethodSource("functions")
  @ParameterizedTest
  void readerTakesThePrefixOfJava(MathFunction function) throws Exception {
    MechmlModel plain = BranchesNotTakenTest.scene(force("", function));
    MechmlModel prefixed = BranchesNotTakenTest.scene(force("Math.", function));

    assertThat(acceleration(data(prefixed))).isEqualTo(acceleration(data(plain)));
  }

  @MethodSource("functions")
  @ParameterizedTest
  void forecastKnowsTheFunction(MathFunction function) throws Exception {
    MechmlModel file = BranchesNotTakenTest.scene(force("", function));

    assertThatCode(() -> RunForecast.of(file, "auto", "auto", file.settings().run()))
        .doesNotThrowAnyException();
  }
}
