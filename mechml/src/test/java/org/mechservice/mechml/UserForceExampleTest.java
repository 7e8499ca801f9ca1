package org.mechservice.mechml;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.mechml.resolve.MechmlReader;
import org.mechservice.solver.force.ForceSet;
import org.mechservice.solver.force.user.UserForceSource;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;
import org.mechservice.solver.mechanism.Mechanism;

/** The force classes of the examples do what elements of MechML do that were written apart. */
class UserForceExampleTest {
  private static final Path EXAMPLES = Path.of("..", "examples");
  private static final int STATES = 20;

  /** Rounding of forces of the size of the largest one, through a chain of a dozen links. */
  private static final double ROUNDING = 1e-12;

  @TempDir Path classes;

  /** Forces at one state: wrenches on bodies, joint forces, and their derivatives. */
  private static final class Loads {
    final double[] wrench;
    final double[] tau;
    final CollectedJacobian jacobian;

    Loads(Mechanism mechanism, UserForceSource source, double t, double[] y) {
      TreeGeometry tree = new TreeGeometry(mechanism);
      TreeMotion motion = new TreeMotion(tree);
      ForceSet forces = new ForceSet(motion, source);
      wrench = new double[6 * tree.linkCount];
      tau = new double[tree.velocityCount];
      jacobian = new CollectedJacobian(tree);
      motion.sweep(t, y);
      assertThat(forces.apply(t, wrench, tau)).isEqualTo(ForceSet.REGULAR);
      assertThat(forces.linearise(t, jacobian)).isEqualTo(ForceSet.REGULAR);
    }
  }

  @CsvSource({
    "driver, driver-c0.xml, variants/driver-c0-elements.xml, 1e-12",
    "driver, driver-ck100.xml, variants/driver-ck100-elements.xml, 1e-12",
    // The classes give no derivatives: differences of some seven digits.
    "five-point-suspension, five-point-suspension.xml, variants/elements.xml, 1e-5"
  })
  @ParameterizedTest
  void classesDoWhatElementsDo(String folder, String file, String variant, double derivatives)
      throws Exception {
    UserForceSource source = CompiledSources.compile(EXAMPLES.resolve(folder), classes);
    Mechanism withClasses = read(folder, file);
    Mechanism withElements = read(folder, variant);
    long seed = 20030214;
    Random random = new Random(seed);
    for (int i = 0; i < STATES; i++) {
      double[] y = nearStart(withElements, random);
      if (folder.equals("driver")) {
        slowDown(withElements, y, random);
      }
      double t = random.nextDouble();
      Loads expected = new Loads(withElements, UserForceSource.NONE, t, y);
      Loads actual = new Loads(withClasses, source, t, y);
      assertClose(actual.wrench, expected.wrench, ROUNDING);
      assertClose(actual.tau, expected.tau, ROUNDING);
      assertClose(actual.jacobian.numbers(), expected.jacobian.numbers(), derivatives);
    }
  }

  private static Mechanism read(String folder, String file) throws IOException, MechmlException {
    byte[] content = Files.readAllBytes(EXAMPLES.resolve(folder).resolve(file));
    return MechmlReader.read(file, content).mechanism();
  }

  private static double[] nearStart(Mechanism mechanism, Random random) {
    double[] y = new double[mechanism.positionCount() + mechanism.velocityCount()];
    mechanism.initialState(y);
    for (int i = 0; i < y.length; i++) {
      y[i] += 0.1 * random.nextGaussian();
    }
    return y;
  }

  /**
   * Sets velocities at which no damper takes away half of a push: c v &lt; k ε/2 with c/k = 0.01 s
   * and ε = 2 mm in the driver's forces. The classes have the law of the reference, whose damper
   * can turn the force around; the elements are bounded at zero.
   */
  private static void slowDown(Mechanism mechanism, double[] y, Random random) {
    for (int i = mechanism.positionCount(); i < y.length; i++) {
      y[i] = 0.01 * random.nextGaussian();
    }
  }

  private static void assertClose(double[] actual, double[] expected, double tolerance) {
    double size = Arrays.stream(expected).map(Math::abs).max().orElse(0);
    for (int i = 0; i < expected.length; i++) {
      assertThat(Math.abs(actual[i] - expected[i]))
          .as("component %d: %s, expected %s", i, actual[i], expected[i])
          .isLessThanOrEqualTo(tolerance * size);
    }
  }
}
