package org.mechservice.sim.model;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.EnumSet;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Random;
import java.util.TreeMap;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Named;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.sim.emit.TermsClass;
import org.mechservice.sim.scene.FormulationChoice;
import org.mechservice.solver.api.capability.Energies;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.capability.LinearisedModel;
import org.mechservice.solver.api.capability.ModelParts;
import org.mechservice.solver.api.capability.PowerInput;
import org.mechservice.solver.api.capability.ResidualModel;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.closure.ClosedMechanism;
import org.mechservice.solver.links.Links;
import org.mechservice.solver.mechanism.Mechanism;

/**
 * How far code for a mechanism with loops differs from the same closures driven by data: largest
 * differences over the largest element and no less than the terms it is made of, nothing where
 * there is no value.
 *
 * <p>Of accelerations, what is beyond ten times what they feel of the last digit of the state.
 *
 * @param projection accelerations by projection where the loops are closed, at the start
 * @param reduced residual by projection there, if both have chosen the same freedoms
 * @param penalty accelerations by penalty at a random state: Φ and Φ' push
 * @param residual of the stabilised equations there, with random multipliers
 * @param reducedStep change of an implicit step by projection where the loops are closed
 * @param step the same of the stabilised equations, with random multipliers
 * @param energy energies, power and turnover at a random state
 */
public record LoopAgreement(
    OptionalDouble projection,
    OptionalDouble reduced,
    OptionalDouble penalty,
    OptionalDouble residual,
    OptionalDouble reducedStep,
    OptionalDouble step,
    OptionalDouble energy) {
  /** Other operations in another order: rounding times depth and condition. */
  public static final double PROJECTION = 1e-9;

  /** The penalty, 1e7 times the inertia, costs as many digits where equations repeat others. */
  public static final double PENALTY = 1e-7;

  /** Nothing is solved for but γ̂. */
  public static final double REDUCED = 1e-10;

  /** Nothing is solved for: rounding times depth. */
  public static final double RESIDUAL = 1e-12;

  /** Equations are solved whose condition the scale of the elements alone does not tell. */
  public static final double STEP = 1e-8;

  private static final double TIME = 0.4;

  /**
   * Masses, lengths and gravity of the scenes give terms of 1 and more, in SI units. Where loops
   * leave nothing free to move they cancel, and what is left is their rounding.
   */
  private static final double TERMS = 1;

  public static BuildOptions options(String formulation, String closure, boolean compact) {
    String integrator = formulation.startsWith("RR") ? "ode15sR" : "DE";
    RunSettings settings = new RunSettings(0, 3, 0.01, integrator, 1e-5, 1e-5);
    return new BuildOptions(
        formulation, closure, compact, EnumSet.of(ColumnGroup.ENERGY), settings);
  }

  /** Returns mechanisms with loops that close, in the order of their seeds. */
  public static Stream<Named<Mechanism>> scenes() {
    return IntStream.iterate(1, seed -> seed + 1)
        .mapToObj(seed -> Named.of("seed " + seed, scene(seed)))
        .filter(scene -> closes(scene.getPayload()));
  }

  public static Mechanism scene(int seed) {
    int bodies = 2 + seed % 6;
    Mechanism tree =
        seed % 3 == 0
            ? RandomMechmlTrees.driven(seed, bodies)
            : seed % 3 == 1
                ? RandomMechmlTrees.ofAllJoints(seed, bodies)
                : RandomMechmlTrees.tree(seed, bodies);
    Mechanism forced = seed % 2 == 0 ? tree : RandomMechmlForces.on(tree, seed);
    return RandomMechmlLoops.on(forced, seed, 1 + seed % 2);
  }

  /** Returns whether the loops can be closed at the start. */
  public static boolean closes(Mechanism mechanism) {
    return new ClosedMechanism(mechanism, "DSR", Scenes.SETTINGS).start().isAssembled();
  }

  public static <T> T code(Mechanism mechanism, String formulation, String closure, Class<T> type) {
    return model(Scenes.model(mechanism), options(formulation, closure, false), type);
  }

  public static <T> T data(Mechanism mechanism, String formulation, String closure, Class<T> type) {
    return model(Scenes.model(mechanism), options(formulation, closure, true), type);
  }

  public static <T> T model(MechmlModel file, BuildOptions options, Class<T> type) {
    return model(file, options, LoopAgreement.class.getClassLoader(), type);
  }

  private static <T> T model(
      MechmlModel file, BuildOptions options, ClassLoader users, Class<T> type) {
    GeneratedModel generated =
        options.formulation().equals("RR-JF") && !options.compact()
            ? withDerivatives(file, options)
            : ModelFactory.generate(file, options);
    if (generated.formulationReason().contains("compact form") != options.compact()) {
      throw new IllegalStateException(generated.formulationReason());
    }
    return type.cast(
        ModelParts.of(GeneratedUserForcesTest.loaded(generated, new TreeMap<>(), users))
            .equations());
  }

  /** Returns RR-JF with code for its derivatives, be they worth it or not. */
  public static GeneratedModel withDerivatives(MechmlModel file, BuildOptions options) {
    FormulationChoice choice =
        FormulationChoice.of(options.formulation(), options.closure(), options.settings(), file);
    Links links = Links.of(file.mechanism());
    TermsClass terms = LoopTermsClass.derive(file, links, options, choice);
    return new ModelAssembly(file, options, choice).looped(links, terms);
  }

  public static LoopAgreement of(Mechanism mechanism) {
    return of(mechanism, LoopAgreement.class.getClassLoader());
  }

  /** Compares the forms of a mechanism whose forces' classes a loader knows. */
  public static LoopAgreement of(Mechanism mechanism, ClassLoader users) {
    Forms<ResidualModel> reduced =
        Forms.of(mechanism, "RR", "projection", users, ResidualModel.class);
    Forms<ExplicitModel> penalty =
        Forms.of(mechanism, "DSR", "penalty", users, ExplicitModel.class);
    Forms<ResidualModel> residual =
        Forms.of(mechanism, "RR", "penalty", users, ResidualModel.class);
    double[] closed = new double[reduced.data().description().stateCount()];
    reduced.data().initialState(closed);
    double[] open = RandomMechmlTrees.state(3, mechanism);
    Forms<LinearisedModel> reducedStep =
        Forms.of(mechanism, "RR-JF", "projection", users, LinearisedModel.class);
    Forms<LinearisedModel> step =
        Forms.of(mechanism, "RR-JF", "penalty", users, LinearisedModel.class);
    return new LoopAgreement(
        accelerations(reduced.data(), reduced.code(), 0, closed),
        residuals(reduced.data(), reduced.code(), 0, closed),
        accelerations(penalty.data(), penalty.code(), TIME, open),
        residuals(residual.data(), residual.code(), TIME, open),
        steps(reducedStep.data(), reducedStep.code(), 0, closed),
        steps(step.data(), step.code(), 0, closed),
        energies(penalty.data(), penalty.code(), TIME, open));
  }

  /**
   * Fails where a difference is beyond its bound. With open loops nothing can be singular: the
   * stabilised equations are compared in every scene.
   */
  public void assertWithinBounds() {
    assertThat(penalty).isPresent();
    assertThat(residual).isPresent();
    assertThat(projection.orElse(0)).isLessThanOrEqualTo(PROJECTION);
    assertThat(reduced.orElse(0)).isLessThanOrEqualTo(REDUCED);
    assertThat(penalty.orElse(0)).isLessThanOrEqualTo(PENALTY);
    assertThat(residual.orElse(0)).isLessThanOrEqualTo(RESIDUAL);
    assertThat(reducedStep.orElse(0)).isLessThanOrEqualTo(STEP);
    assertThat(step.orElse(0)).isLessThanOrEqualTo(STEP);
    assertThat(energy.orElse(0)).isLessThanOrEqualTo(RESIDUAL);
  }

  private record Forms<T>(T data, T code) {
    static <T> Forms<T> of(
        Mechanism mechanism, String formulation, String closure, ClassLoader users, Class<T> type) {
      MechmlModel file = Scenes.model(mechanism);
      return new Forms<>(
          model(file, options(formulation, closure, true), users, type),
          model(file, options(formulation, closure, false), users, type));
    }
  }

  private static OptionalDouble energies(
      ExplicitModel data, ExplicitModel code, double t, double[] y) {
    double[] expected = energies(data, t, y);
    double[] actual = energies(code, t, y);
    return Arrays.stream(expected).allMatch(Double::isFinite)
        ? compared(ExplicitModel.REGULAR, ExplicitModel.REGULAR, actual, expected)
        : OptionalDouble.empty();
  }

  private static double[] energies(ExplicitModel model, double t, double[] y) {
    double[] energies = new double[4];
    ((Energies) ModelParts.of(model).equations()).energy(t, y, energies);
    double[] power = new double[2];
    ((PowerInput) ModelParts.of(model).equations()).power(t, y, power);
    System.arraycopy(power, 0, energies, 2, power.length);
    return energies;
  }

  private static OptionalDouble accelerations(
      ExplicitModel data, ExplicitModel code, double t, double[] y) {
    double[] expected = new double[y.length];
    double[] actual = new double[y.length];
    int result = data.derivative(t, y, expected);
    OptionalDouble difference = compared(result, code.derivative(t, y, actual), actual, expected);
    return difference.isPresent()
        ? OptionalDouble.of(Math.max(0, difference.getAsDouble() - 10 * felt(data, t, y, expected)))
        : difference;
  }

  /** By how much the accelerations feel the last digit of the state, which no form can better. */
  private static double felt(ExplicitModel data, double t, double[] y, double[] expected) {
    double largest = 0;
    for (int seed = 0; seed < 3; seed++) {
      double[] accelerations = new double[y.length];
      int result = data.derivative(t, beside(y, seed), accelerations);
      largest = Math.max(largest, compared(result, result, accelerations, expected).orElse(0));
    }
    return largest;
  }

  /** Of states followed by multipliers, if the equations have some. */
  private static OptionalDouble residuals(
      ResidualModel data, ResidualModel code, double t, double[] states) {
    double[] y = new Random(5).doubles(data.unknownCount(), -2, 2).toArray();
    System.arraycopy(states, 0, y, 0, states.length);
    double[] rates = new Random(7).doubles(y.length, -2, 2).toArray();
    double[] expected = new double[y.length];
    double[] actual = new double[y.length];
    int expectedResult = data.residual(t, y, rates, expected);
    int result = code.residual(t, y, rates, actual);
    return otherFreedoms(expected, actual)
        ? OptionalDouble.empty()
        : compared(expectedResult, result, actual, expected);
  }

  /**
   * Short and long implicit steps, which ask for M and for the derivatives by position; what is
   * beyond ten times what the solutions feel of the last digit of the state.
   */
  private static OptionalDouble steps(
      LinearisedModel data, LinearisedModel code, double t, double[] states) {
    double[] y = new Random(5).doubles(data.unknownCount(), -2, 2).toArray();
    System.arraycopy(states, 0, y, 0, states.length);
    if (residuals(data, code, t, states).isEmpty()) {
      return OptionalDouble.empty();
    }
    double largest = 0;
    for (double hGamma : new double[] {1e-4, 1e-2, 0.3}) {
      Optional<double[]> expected = solved(data, t, y, hGamma);
      Optional<double[]> actual = solved(code, t, y, hGamma);
      if (expected.isPresent() != actual.isPresent()) {
        return OptionalDouble.of(Double.POSITIVE_INFINITY);
      }
      double felt = 0;
      for (int seed = 0; expected.isPresent() && seed < 3; seed++) {
        Optional<double[]> beside = solved(data, t, beside(y, seed), hGamma);
        felt = Math.max(felt, difference(beside, expected));
      }
      largest = Math.max(largest, difference(actual, expected) - 10 * felt);
    }
    return OptionalDouble.of(largest);
  }

  private static double difference(Optional<double[]> actual, Optional<double[]> expected) {
    int regular = ExplicitModel.REGULAR;
    return actual.isPresent() && expected.isPresent()
        ? compared(regular, regular, actual.get(), expected.get()).orElse(0)
        : 0;
  }

  private static Optional<double[]> solved(
      LinearisedModel model, double t, double[] y, double hGamma) {
    double[] rates = new Random(7).doubles(y.length, -2, 2).toArray();
    double[] solution = new Random(9).doubles(y.length, -1, 1).toArray();
    if (!model.linearise(t, y, rates) || !model.factor(hGamma)) {
      return Optional.empty();
    }
    model.solve(solution);
    return Optional.of(solution);
  }

  /** Returns a state that is another in its last digits. */
  public static double[] beside(double[] y, int seed) {
    Random random = new Random(seed);
    return Arrays.stream(y).map(x -> x + random.nextInt(-1, 2) * Math.ulp(x)).toArray();
  }

  /**
   * Where two sets of freedoms suit as well, rounding decides. There are as many in both; equations
   * of the other velocities are zero.
   */
  private static boolean otherFreedoms(double[] expected, double[] actual) {
    boolean others =
        IntStream.range(0, expected.length).anyMatch(i -> (expected[i] == 0) != (actual[i] == 0));
    return others && zeros(expected) == zeros(actual);
  }

  private static long zeros(double[] values) {
    return Arrays.stream(values).filter(value -> value == 0).count();
  }

  private static OptionalDouble compared(
      int expectedResult, int result, double[] actual, double[] expected) {
    if (result != expectedResult) {
      return OptionalDouble.of(Double.POSITIVE_INFINITY);
    } else if (result != ExplicitModel.REGULAR) {
      return OptionalDouble.empty();
    }
    double scale = Arrays.stream(expected).map(Math::abs).reduce(TERMS, Math::max);
    double difference = 0;
    for (int i = 0; i < expected.length; i++) {
      difference = Math.max(difference, Math.abs(actual[i] - expected[i]));
    }
    return OptionalDouble.of(difference / scale);
  }
}
