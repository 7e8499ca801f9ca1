package org.mechservice.robot;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.diagnosis.Diagnostic;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.closure.ClosedMechanism;
import org.mechservice.solver.closure.model.ProjectionModel;
import org.mechservice.solver.dynamics.DataDrivenModel;
import org.mechservice.solver.force.user.UserForceSource;
import org.mechservice.solver.mechanism.Mechanism;

/**
 * Small MJCF files, each with one thing that the import could lose, accelerate as in MuJoCo: the
 * comment before each of mjcf/NAME.xml has positions, velocities and the accelerations that MuJoCo
 * 4.0.0 computes (mj_forward without contacts), in the order of MechML's coordinates; of muscles
 * also the activations and their rates.
 */
class MjcfMotionTest {
  /**
   * MuJoCo keeps its own meshes in single precision, and turns their axes to the principal ones:
   * 1e-6 of the largest acceleration; everything else agrees to rounding.
   */
  private static final double MESH = 1e-6;

  private static final double ROUNDING = 1e-12;

  static Stream<String> names() throws IOException {
    return text("mjcf").lines().filter(f -> f.endsWith(".xml"));
  }

  @ParameterizedTest
  @MethodSource("names")
  void fileAcceleratesAsInItsOwnEngine(String name) throws IOException, MechmlException {
    String text = text("mjcf/" + name);
    RobotImport robot = RobotImport.of(name, text.getBytes(StandardCharsets.UTF_8));
    assertThat(robot.losses()).extracting(Diagnostic::code).doesNotContain(LossGrade.MOTION.code());
    Mechanism mechanism = robot.model().mechanism();
    double[] q = numbers(text, "q");
    double[] v = numbers(text, "v");
    double[] expected = numbers(text, "a");
    double[] y = new double[mechanism.stateCount()];
    assertThat(q).hasSize(mechanism.positionCount());
    System.arraycopy(q, 0, y, 0, q.length);
    System.arraycopy(v, 0, y, q.length, v.length);
    Optional<double[]> activations = optional(text, "s");
    activations.ifPresent(s -> System.arraycopy(s, 0, y, y.length - s.length, s.length));
    double[] rate = new double[y.length];
    derivative(robot.model(), y, rate);
    double scale = Arrays.stream(expected).map(Math::abs).max().orElse(1);
    double bound = (name.startsWith("mesh") ? MESH : ROUNDING) * scale;
    for (int i = 0; i < expected.length; i++) {
      assertThat(rate[q.length + i]).as(name).isCloseTo(expected[i], within(bound));
    }
    double[] rates = optional(text, "r").orElse(new double[0]);
    for (int i = 0; i < rates.length; i++) {
      assertThat(rate[y.length - rates.length + i])
          .as("rate of an activation in %s", name)
          .isCloseTo(rates[i], within(ROUNDING * (1 + Math.abs(rates[i]))));
    }
  }

  private static void derivative(MechmlModel robot, double[] y, double[] rate) {
    Mechanism mechanism = robot.mechanism();
    RunSettings settings = robot.settings().run();
    if (mechanism.closures().isEmpty()) {
      new DataDrivenModel(mechanism, settings).derivative(0, y, rate);
    } else {
      ClosedMechanism closed = new ClosedMechanism(mechanism, "DSR", settings);
      new ProjectionModel(closed, UserForceSource.NONE).derivative(0, y, rate);
    }
  }

  private static Optional<double[]> optional(String text, String what) {
    return text.contains(" " + what + ": ") ? Optional.of(numbers(text, what)) : Optional.empty();
  }

  private static double[] numbers(String text, String what) {
    Matcher found =
        Pattern.compile("\\b" + what + ": ([^a-z]*?)\\s*(?:[vasr]:|-->)")
            .matcher(text.replace("e-", "E-"));
    assertThat(found.find()).isTrue();
    return List.of(found.group(1).split(" ", -1)).stream()
        .mapToDouble(Double::parseDouble)
        .toArray();
  }

  private static String text(String name) throws IOException {
    try (InputStream stream =
        Objects.requireNonNull(MjcfMotionTest.class.getResourceAsStream(name), name)) {
      return new String(stream.readAllBytes(), StandardCharsets.UTF_8);
    }
  }
}
