package org.mechservice.sim.emit.c;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalDate;
import java.time.ZoneOffset;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.ReadOptions;
import org.mechservice.mechml.resolve.MechmlReader;
import org.mechservice.sim.model.BuildOptions;
import org.mechservice.sim.model.GeneratedModel;
import org.mechservice.sim.model.ModelFactory;
import org.mechservice.sim.model.RandomMechmlForces;
import org.mechservice.sim.model.RandomMechmlTrees;
import org.mechservice.sim.model.Scenes;
import org.mechservice.sim.scene.ModelBuildException;
import org.mechservice.solver.api.capability.BodyPoses;
import org.mechservice.solver.api.capability.Energies;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.capability.ModelParts;
import org.mechservice.solver.api.capability.ResultColumns;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.mechanism.Mechanism;

/** A model in C computes the bits of the class that runs on the Java machine. */
@Tag("slow")
class SameBitsInCTest {
  private static final int FEW_SCENES = 4;
  private static final int MANY_SCENES = 500;
  private static final int STATES = 100;
  private static final int CHECKED_SCENES = 100;

  /** Of so many scenes of the page one is compiled with optimisation, as users compile. */
  private static final int OPTIMISED = 10;

  private static final Path PAGE = Path.of("..", "..", "docs", "reports", "c-bits.md");
  private static final RunSettings SETTINGS = new RunSettings(0, 3, 0.01, "DE", 1e-5, 1e-5);

  @TempDir private Path folder = Path.of("");

  /** Numbers that were compared, and those whose bits differ. */
  private static final class Count {
    private long compared;
    private long different;
    private int failures;
    private final List<String> found = new ArrayList<>();

    void compare(String what, double actual, double expected) {
      compared++;
      if (Double.doubleToLongBits(actual) != Double.doubleToLongBits(expected)) {
        different++;
        if (found.size() < 5) {
          found.add(what + ": C " + actual + ", Java " + expected);
        }
      }
    }
  }

  private static Mechanism scene(int seed) {
    int bodies = 2 + seed % 7;
    Mechanism tree =
        seed % 3 == 0
            ? RandomMechmlTrees.driven(seed, bodies)
            : seed % 3 == 1
                ? RandomMechmlTrees.ofAllJoints(seed, bodies)
                : RandomMechmlTrees.tree(seed, bodies);
    return seed % 4 == 0 ? tree : RandomMechmlForces.on(tree, seed);
  }

  private static BuildOptions options(int seed) {
    EnumSet<ColumnGroup> columns =
        EnumSet.of(ColumnGroup.BODIES, ColumnGroup.ENERGY, ColumnGroup.FORCES);
    return new BuildOptions(seed % 2 == 0 ? "DTR" : "DSR", columns, SETTINGS);
  }

  /** A program that reads times and states and writes the result, x' and the outputs of each. */
  private static String driver(String name) {
    return """
    #include "MODEL.h"
    #include <stdio.h>

    int main(void) {
      static MODEL_t m;
      static double given[MODEL_NX + 1], y[MODEL_NY + 1], dx[MODEL_NX + 1];
      MODEL_init(&m);
      while (fread(given, sizeof(double), MODEL_NX + 1, stdin) == MODEL_NX + 1) {
        double result = MODEL_derivatives(&m, given[0], given + 1, dx);
        MODEL_outputs(&m, given[0], given + 1, y);
        fwrite(&result, sizeof(double), 1, stdout);
        fwrite(dx, sizeof(double), MODEL_NX, stdout);
        fwrite(y, sizeof(double), MODEL_NY, stdout);
      }
      return 0;
    }
    """
        .replace("MODEL", name);
  }

  /** Compares one scene in random states. */
  private void compare(int seed, int states, List<String> flags, Count count) throws IOException {
    MechmlModel model = Scenes.model(scene(seed));
    BuildOptions options = options(seed);
    CModel inC = ModelFactory.inC(model, options);
    Path place = Files.createDirectory(folder.resolve("scene" + seed));
    Path program = CCode.compiled(inC, place, flags, driver(inC.name()));
    GeneratedModel generated = ModelFactory.generate(model, options);
    ExplicitModel java =
        (ExplicitModel)
            ModelParts.of(ModelFactory.compile(model, options, generated).newInstance())
                .equations();
    int size = inC.states().size();
    Random random = new Random(seed);
    double[] given = new double[states * (size + 1)];
    for (int i = 0; i < given.length; i++) {
      given[i] = 4 * random.nextDouble() - 2;
    }
    double[] written = CCode.run(program, List.of(), given);
    int row = 1 + size + inC.outputs().size();
    assertThat(written).hasSize(states * row);
    for (int i = 0; i < states; i++) {
      double[] state = new double[size];
      System.arraycopy(given, i * (size + 1) + 1, state, 0, size);
      compare(java, given[i * (size + 1)], state, inC, written, i * row, count);
    }
    delete(place);
  }

  private static void compare(
      ExplicitModel java,
      double t,
      double[] x,
      CModel inC,
      double[] written,
      int first,
      Count count) {
    double[] dx = new double[x.length];
    int result = java.derivative(t, x, dx);
    count.compare(inC.name() + " result", written[first], result == ExplicitModel.REGULAR ? 0 : -1);
    if (result == ExplicitModel.REGULAR) {
      for (int i = 0; i < dx.length; i++) {
        count.compare(inC.name() + " x'[" + i + "]", written[first + 1 + i], dx[i]);
      }
    } else {
      count.failures++;
    }
    double[] y = outputs(java, t, x, inC);
    for (int i = 0; i < y.length; i++) {
      String name = inC.name() + " " + inC.outputs().get(i).name();
      count.compare(name, written[first + 1 + dx.length + i], y[i]);
    }
  }

  private static double[] outputs(ExplicitModel java, double t, double[] x, CModel inC) {
    int forces =
        java instanceof ResultColumns columns ? columns.columns(ColumnGroup.FORCES).size() : 0;
    double[] y = new double[inC.outputs().size()];
    double[] poses = new double[y.length - 2 - forces];
    ((BodyPoses) ModelParts.of(java).equations()).poses(t, x, poses);
    System.arraycopy(poses, 0, y, 0, poses.length);
    double[] energy = new double[2];
    ((Energies) ModelParts.of(java).equations()).energy(t, x, energy);
    System.arraycopy(energy, 0, y, poses.length, 2);
    if (forces > 0) {
      ((ResultColumns) java).values(ColumnGroup.FORCES, t, x, y, poses.length + 2);
    }
    return y;
  }

  private static void delete(Path place) throws IOException {
    try (Stream<Path> files = Files.list(place)) {
      for (Path file : files.toList()) {
        Files.delete(file);
      }
    }
  }

  @Test
  void randomScenesHaveTheBitsOfJava() throws IOException {
    CCode.compiler();
    Count count = new Count();
    for (int seed = 1; seed <= FEW_SCENES; seed++) {
      compare(seed, 20, seed % 2 == 0 ? CCode.FAST : CCode.PLAIN, count);
    }
    assertThat(count.found).isEmpty();
  }

  @Test
  void noSceneHasUndefinedBehaviour() throws IOException {
    CCode.compiler();
    assumeTrue(CCode.hasSanitizers(folder), "this C compiler has no sanitizers");
    Count count = new Count();
    compare(1, 20, CCode.CHECKED, count);
    assertThat(count.found).isEmpty();
  }

  private List<String> exampleOf(MechmlModel model, BuildOptions options, String end)
      throws IOException {
    CCode.compiler();
    Path place = Files.createTempDirectory(folder, "example");
    List<Path> sources = new ArrayList<>();
    for (Map.Entry<String, String> file : ModelFactory.inC(model, options).files().entrySet()) {
      Path path = place.resolve(file.getKey());
      Files.writeString(path, file.getValue());
      if (file.getKey().endsWith(".c")) {
        sources.add(path);
      }
    }
    Path program = CCode.compiled(place, CCode.FAST, sources);
    return CCode.lines(program, List.of(end, "1e-2"));
  }

  @Test
  void exampleProgramRunsAsItIs() throws IOException {
    assertThat(exampleOf(Scenes.model(Scenes.pendulum()), options(1), "0.1")).hasSize(10);
  }

  /**
   * The motions are parabolas between the instants, which the method of order four follows but for
   * rounding; the ends are those that the comments of the files derive.
   */
  @ParameterizedTest
  @CsvSource({
    "elements/sampled.xml, slide.q, 0.828506, 1e-6",
    "elements/sampled.xml, slide.v, 0.806854, 1e-6",
    "elements/input.xml, slide.v, 2.5, 1e-13",
    "extremes/kinked_drive.xml, hinge.v, 3, 1e-13"
  })
  void exampleProgramTakesSamplesInputsAndImpulses(
      String file, String state, double end, double tolerance) throws Exception {
    Path path = Path.of("..", "..", "examples").resolve(file);
    ReadOptions reading = ReadOptions.NONE.withInputsAsParameters();
    MechmlModel model = MechmlReader.read(file, Files.readAllBytes(path), reading);
    BuildOptions options =
        new BuildOptions("DTR", EnumSet.of(ColumnGroup.ENERGY), model.settings().run());
    String line =
        exampleOf(model, options, "1").stream()
            .filter(one -> one.startsWith(state + " = "))
            .findFirst()
            .orElseThrow();
    assertThat(Double.parseDouble(line.split(" ", -1)[2])).isCloseTo(end, within(tolerance));
  }

  @Test
  void namesThatCAlreadyHasGetAPrefix() {
    for (String name : List.of("size", "double", "example", "mech_math")) {
      Mechanism tree = Scenes.scene("pendulum5.json", name);
      assertThat(ModelFactory.inC(Scenes.model(tree), options(1)).name())
          .isEqualTo("model_" + name);
    }
  }

  @Test
  void forcesWrittenAsClassesAreRefusedByName() throws Exception {
    Path file =
        Path.of("..", "..", "examples", "five-point-suspension", "five-point-suspension.xml");
    MechmlModel model = MechmlReader.read("suspension.xml", Files.readAllBytes(file));
    assertThatThrownBy(() -> ModelFactory.inC(model, options(1)))
        .isInstanceOf(ModelBuildException.class)
        .hasMessageContaining(MessageCode.NO_C_CODE.code())
        .hasMessageContaining("fBody")
        .hasMessageContaining("mech build -o FILE.jar");
  }

  @Tag("soak")
  @Test
  void noneOfManyScenesHasUndefinedBehaviour() throws IOException {
    CCode.compiler();
    assumeTrue(CCode.hasSanitizers(folder), "this C compiler has no sanitizers");
    Count count = new Count();
    for (int seed = 1; seed <= CHECKED_SCENES; seed++) {
      compare(seed, STATES, CCode.CHECKED, count);
    }
    assertThat(count.found).isEmpty();
  }

  @Tag("soak")
  @Test
  void pageOfFiveHundredScenes() throws IOException {
    CCode.compiler();
    Count count = new Count();
    for (int seed = 1; seed <= MANY_SCENES; seed++) {
      compare(seed, STATES, seed % OPTIMISED == 0 ? CCode.FAST : CCode.PLAIN, count);
    }
    assertThat(count.found).isEmpty();
    List<String> lines = new ArrayList<>();
    lines.add("# C and Java");
    lines.add("");
    lines.add(
        "Written on "
            + LocalDate.now(ZoneOffset.UTC)
            + " by `mvn verify -Psoak`: random open chains of 2 to 8 bodies, seeds 1 to "
            + MANY_SCENES
            + ", all joint types, driven joints, forces of every kind but classes, each in "
            + STATES
            + " random states; DTR and DSR in turn. The C of `mech build --c`, compiled with"
            + " `-ffp-contract=off`, every "
            + OPTIMISED
            + "th scene with `-O2` and the others with `-O0`, against the class on the Java machine"
            + " ("
            + System.getProperty("os.name")
            + ", "
            + System.getProperty("os.arch")
            + ", Java "
            + System.getProperty("java.version")
            + "): x', poses, energies and values of forces.");
    lines.add("");
    lines.add("| scenes | states | numbers compared | of other bits | states without x' in both |");
    lines.add("|---:|---:|---:|---:|---:|");
    lines.add(
        String.format(
            Locale.ROOT,
            "| %d | %d | %d | %d | %d |",
            MANY_SCENES,
            MANY_SCENES * STATES,
            count.compared,
            count.different,
            count.failures));
    Files.writeString(PAGE, String.join("\n", lines) + "\n");
  }
}
