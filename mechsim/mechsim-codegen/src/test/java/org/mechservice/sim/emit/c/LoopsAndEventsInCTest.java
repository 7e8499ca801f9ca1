package org.mechservice.sim.emit.c;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.api.Named;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.sim.model.BuildOptions;
import org.mechservice.sim.model.LoopAgreement;
import org.mechservice.sim.model.ModelFactory;
import org.mechservice.sim.model.RandomMechmlEvents;
import org.mechservice.sim.model.RandomMechmlTrees;
import org.mechservice.sim.model.Scenes;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.capability.ModelEvents;
import org.mechservice.solver.api.capability.ModelParts;
import org.mechservice.solver.api.capability.ProjectedStates;
import org.mechservice.solver.api.capability.StateJumps;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.kinematics.StateCoordinates;
import org.mechservice.solver.mechanism.Mechanism;

/**
 * Closed loops and events in C compute the bits of the Java machine: accelerations by penalty,
 * projection, functions of events, and the state after all events at once with the loops closed.
 */
@Tag("slow")
class LoopsAndEventsInCTest {
  private static final int FEW = 4;
  private static final int MANY = 250;
  private static final int CHECKED = 50;

  /** Reads t and x; writes x', the projected state, functions of events, the state after them. */
  private static final String DRIVER =
      """
      #include "MODEL.h"
      #include <stdio.h>
      #include <string.h>

      int main(void) {
        static MODEL_t m, fresh;
        static double given[MODEL_NX + 1], x[MODEL_NX + 1], out[MODEL_NX + MODEL_NG + 1];
        static signed char all[MODEL_NG + 1];
        double result;
        memset(all, 1, sizeof all);
        MODEL_init(&fresh);
        while (fread(given, sizeof(double), MODEL_NX + 1, stdin) == MODEL_NX + 1) {
          m = fresh;
          memset(out, 0, sizeof out);
          result = MODEL_derivatives(&m, given[0], given + 1, out);
          fwrite(&result, sizeof(double), 1, stdout);
          fwrite(out, sizeof(double), MODEL_NX, stdout);
          memcpy(x, given + 1, MODEL_NX * sizeof(double));
          result = MODEL_project(&m, given[0], x);
          fwrite(&result, sizeof(double), 1, stdout);
          fwrite(x, sizeof(double), MODEL_NX, stdout);
          MODEL_event_values(&m, given[0], given + 1, out);
          fwrite(out, sizeof(double), MODEL_NG, stdout);
          memcpy(x, given + 1, MODEL_NX * sizeof(double));
          result = MODEL_event(&m, all, given[0], x);
          fwrite(&result, sizeof(double), 1, stdout);
          fwrite(x, sizeof(double), MODEL_NX, stdout);
        }
        return 0;
      }
      """;

  @TempDir private Path folder = Path.of("");
  private long compared;
  private long close;
  private final List<String> different = new ArrayList<>();

  private void compare(String what, double actual, double expected) {
    compared++;
    if (Double.doubleToLongBits(actual) != Double.doubleToLongBits(expected)) {
      different.add(what + ": C " + actual + ", Java " + expected);
    }
  }

  private void compareScene(Mechanism mechanism, int states, List<String> flags)
      throws IOException {
    MechmlModel file = RandomMechmlEvents.on(mechanism, 1);
    BuildOptions options =
        new BuildOptions(
            "DSR",
            mechanism.closures().isEmpty() ? "auto" : "penalty",
            false,
            EnumSet.of(ColumnGroup.ENERGY),
            Scenes.SETTINGS);
    CModel inC = ModelFactory.inC(file, options);
    Path place = Files.createTempDirectory(folder, "scene");
    Path program = CCode.compiled(inC, place, flags, DRIVER.replace("MODEL", inC.name()));
    ModelParts parts =
        ModelParts.of(
            ModelFactory.compile(file, options, ModelFactory.generate(file, options))
                .newInstance());
    Model java = parts.equations();
    int size = inC.states().size();
    int row = size + 1;
    double[] start = new double[size];
    ((ExplicitModel) ModelParts.of(java).equations()).initialState(start);
    Random random = new Random(7);
    double[] given = new double[states * row];
    for (int s = 0; s < states; s++) {
      double scale = s % 2 == 0 ? 1e-4 : 0.02;
      for (int i = 0; i < size; i++) {
        given[s * row + 1 + i] = start[i] + scale * (2 * random.nextDouble() - 1);
      }
      given[s * row] = 0.1 * random.nextDouble();
    }
    double[] written = CCode.run(program, List.of(), given);
    int events = file.settings().events().size();
    assertThat(written).hasSize(states * (3 * row + events));
    for (int s = 0; s < states; s++) {
      double[] state = Arrays.copyOfRange(given, s * row + 1, (s + 1) * row);
      compareState(mechanism, parts, given[s * row], state, written, s * (3 * row + events));
    }
  }

  private void compareState(
      Mechanism mechanism, ModelParts parts, double t, double[] x, double[] written, int first) {
    Model java = parts.equations();
    String name = mechanism.name();
    int at = first;
    double[] dx = new double[x.length];
    boolean regular =
        ((ExplicitModel) ModelParts.of(java).equations()).derivative(t, x, dx)
            == ExplicitModel.REGULAR;
    compare(name + " result", written[at++], regular ? 0 : -1);
    for (int i = 0; i < x.length; i++, at++) {
      if (regular) {
        compare(name + " x'[" + i + "]", written[at], dx[i]);
      }
    }
    at = compareProjection(mechanism, java, t, x, written, at);
    ModelEvents events = parts.events().orElseThrow();
    double[] g = new double[events.kinds().size()];
    events.values(t, x, g);
    for (double value : g) {
      compare(name + " event function", written[at++], value);
    }
    boolean[] all = new boolean[g.length];
    Arrays.fill(all, true);
    double[] after = x.clone();
    events.change(all, t, after);
    boolean closed =
        !(java instanceof StateJumps jumps) || jumps.jump(t, after, set(events, x.length));
    compare(name + " closed after events", written[at++] < 0 ? 0 : 1, closed ? 1 : 0);
    for (int i = 0; closed && i < x.length; i++) {
      compareClosed(name + " after events [" + i + "]", written[at++], after[i], 1e-7);
    }
  }

  /**
   * Where a force has no direction on the way to a closed state, Java takes the mass matrix from
   * the data, whose last digits differ: those of the state then do, too. After events, which move
   * the state far, each step of Newton's method passes them on.
   */
  private void compareClosed(String what, double actual, double expected, double tolerance) {
    boolean sameBits = Double.doubleToLongBits(actual) == Double.doubleToLongBits(expected);
    if (!sameBits && Math.abs(actual - expected) <= tolerance * Math.max(1, Math.abs(expected))) {
      compared++;
      close++;
    } else {
      compare(what, actual, expected);
    }
  }

  private int compareProjection(
      Mechanism mechanism, Model java, double t, double[] x, double[] written, int first) {
    double[] projected = x.clone();
    new StateCoordinates(mechanism).normalize(projected, 0);
    boolean closed = !(java instanceof ProjectedStates manifold) || manifold.project(t, projected);
    if (java instanceof ProjectedStates) {
      compare(mechanism.name() + " closed", written[first] < 0 ? 0 : 1, closed ? 1 : 0);
    }
    for (int i = 0; closed && i < x.length; i++) {
      compareClosed(
          mechanism.name() + " projected [" + i + "]", written[first + 1 + i], projected[i], 1e-15);
    }
    return first + 1 + x.length;
  }

  private static boolean[] set(ModelEvents events, int length) {
    boolean[] set = new boolean[length];
    for (int i = 0; i < length; i++) {
      for (int event = 0; event < events.kinds().size(); event++) {
        set[i] |= events.changes(event, i);
      }
    }
    return set;
  }

  private static Stream<Mechanism> trees() {
    return Stream.iterate(1, seed -> seed + 1)
        .map(
            seed ->
                seed % 2 == 0
                    ? RandomMechmlTrees.driven(seed, 2 + seed % 5)
                    : RandomMechmlTrees.ofAllJoints(seed, 2 + seed % 5));
  }

  private void compareScenes(int count, int states, List<String> flags) throws IOException {
    for (Mechanism tree : trees().limit(count).toList()) {
      compareScene(tree, states, flags);
    }
    for (Mechanism loops : LoopAgreement.scenes().limit(count).map(Named::getPayload).toList()) {
      compareScene(loops, states, flags);
    }
  }

  @Test
  void loopsAndEventsHaveTheBitsOfJava() throws IOException {
    CCode.compiler();
    // Optimising takes nearly all of the time.
    compareScenes(1, 10, CCode.FAST);
    compareScenes(FEW, 10, CCode.PLAIN);
    assertThat(different).as("of %d numbers", compared).isEmpty();
    assertThat(close).isLessThan(compared / 20);
  }

  @Test
  void noLoopHasUndefinedBehaviour() throws IOException {
    CCode.compiler();
    assumeTrue(CCode.hasSanitizers(folder), "this C compiler has no sanitizers");
    compareScene(LoopAgreement.scenes().findFirst().orElseThrow().getPayload(), 10, CCode.CHECKED);
    assertThat(different).isEmpty();
  }

  @Tag("soak")
  @Test
  void noneOfManyLoopsHasUndefinedBehaviour() throws IOException {
    CCode.compiler();
    assumeTrue(CCode.hasSanitizers(folder), "this C compiler has no sanitizers");
    compareScenes(CHECKED, 100, CCode.CHECKED);
    assertThat(different).as("of %d numbers", compared).isEmpty();
  }

  @Tag("soak")
  @Test
  void manyLoopsAndEventsHaveTheBitsOfJava() throws IOException {
    CCode.compiler();
    compareScenes(MANY, 100, CCode.PLAIN);
    assertThat(different).as("of %d numbers", compared).isEmpty();
    assertThat(close).isLessThan(compared / 20);
  }
}
