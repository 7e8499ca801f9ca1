package org.mechservice.sim.packaging;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.jar.JarEntry;
import java.util.jar.JarInputStream;
import org.mechservice.guard.SolverClasses;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.mechml.resolve.MechmlReader;
import org.mechservice.sim.compile.ReachableClasses;
import org.mechservice.sim.model.BuildOptions;
import org.mechservice.sim.model.CompiledModel;
import org.mechservice.sim.model.ModelFactory;
import org.mechservice.sim.model.Omission;
import org.mechservice.sim.model.StandaloneMain;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.api.run.RunSettings;

/** Tables of the sizes of generated models and of what their generation takes. */
final class CodeSizes {
  /** Bytes of manifest and description that a JAR may have beside its classes. */
  static final int OVERHEAD = 1536;

  /**
   * A model whose size has a bound.
   *
   * @param file among the examples
   * @param formulation for which it is built, with DE; with ode15sR for RR
   * @param compact whether as data
   * @param bound bytes of its classes, compressed; {@link Integer#MAX_VALUE}: listed only
   * @param paper the paper's tcc + t1s, ms
   */
  record Row(String file, String formulation, boolean compact, int bound, int paper) {
    @Override
    public String toString() {
      return file + (compact ? ", compact, " : ", ") + formulation;
    }
  }

  private static final String PENDULUM = "pendulum/pendulum.xml";
  private static final String SUSPENSION = "five-point-suspension/variants/elements.xml";
  private static final String DRIVER = "driver/driver-free-c0.xml";
  private static final String SOLVER = "org/mechservice/solver/";
  private static final int LISTED = Integer.MAX_VALUE;

  /**
   * Bounds: pendulum 2.2 KB and 4 KB, driver 11.8 KB and 30 KB, suspension 7.1 KB; the compact ones
   * are the sizes in Table I of Rodríguez et al. 2003.
   */
  static final List<Row> ROWS =
      List.of(
          new Row(PENDULUM, "DTR", true, 2252, 290),
          new Row(PENDULUM, "DTR", false, 4096, 290),
          new Row(PENDULUM, "DSR", false, 4096, 290),
          new Row(PENDULUM, "RR", false, LISTED, 290),
          new Row(PENDULUM, "RR-JF", false, LISTED, 290),
          new Row(SUSPENSION, "DSR", true, 7270, 340),
          new Row(SUSPENSION, "DSR", false, LISTED, 340),
          new Row(SUSPENSION, "RR", false, LISTED, 340),
          new Row(SUSPENSION, "RR-JF", false, LISTED, 340),
          new Row(DRIVER, "DTR", true, 12083, 540),
          new Row(DRIVER, "DTR", false, 30 * 1024, 540),
          new Row(DRIVER, "DSR", false, LISTED, 540),
          new Row(DRIVER, "RR", false, LISTED, 540),
          new Row(DRIVER, "RR-JF", false, LISTED, 540));

  private final List<String> lines = new ArrayList<>();

  /** Returns the tables. */
  List<String> lines() throws Exception {
    sizes();
    standalone();
    return lines;
  }

  static MechmlModel model(Row row) throws IOException, MechmlException {
    Path path = Path.of("..", "..", "examples").resolve(row.file());
    return MechmlReader.read(path.getFileName().toString(), Files.readAllBytes(path));
  }

  static BuildOptions options(Row row) {
    return options(row.formulation(), row.compact());
  }

  static BuildOptions options(String formulation, boolean compact) {
    String integrator = formulation.startsWith("RR") ? "ode15sR" : "DE";
    RunSettings settings = new RunSettings(0, 1, 0.01, integrator, 1e-5, 1e-5);
    return new BuildOptions(formulation, "auto", compact, Set.of(ColumnGroup.ENERGY), settings);
  }

  /** Builds the model of a row. */
  static CompiledModel built(Row row) throws IOException, MechmlException {
    return throughBytes(model(row), options(row));
  }

  static JarImage jar(CompiledModel model) {
    return ModelJars.model(model, "0".repeat(64));
  }

  /** Generates, writes the class file and loads it. */
  static CompiledModel throughBytes(MechmlModel model, BuildOptions options) {
    return ModelFactory.compile(model, options, ModelFactory.generate(model, options));
  }

  /** Returns the least time of some runs, ms. */
  static double leastTime(int seconds, Runnable run) {
    long best = Long.MAX_VALUE;
    long end = System.nanoTime() + seconds * 1_000_000_000L;
    for (int i = 0; i < 1 || (i < 40 && System.nanoTime() < end); i++) {
      long start = System.nanoTime();
      run.run();
      best = Math.min(best, System.nanoTime() - start);
    }
    return best * 1e-6;
  }

  private void sizes() throws Exception {
    lines.add("## Sizes, and generation with compilation");
    lines.add("");
    lines.add(
        "Compressed classes for one formulation and its integrator (DE; ode15sR for RR and RR-JF),"
            + " energy among the columns; behind a slash what they may be. A JAR has a manifest and"
            + " a description of the model beside its classes, at most "
            + OVERHEAD
            + " B. Generation and compilation, warm: the least of up to 40 in 2 s, through source"
            + " in 6 s; the paper's are tcc + t1s.");
    lines.add("");
    lines.add(
        "| model | formulation | operations | classes [B] | JAR [B] | beside classes [B] | through"
            + " class bytes [ms] | through source [ms] | paper [ms] |");
    lines.add("|---|---|---:|---:|---:|---:|---:|---:|---:|");
    List<String> fromData = new ArrayList<>();
    for (Row row : ROWS) {
      lines.add(line(row, fromData));
    }
    lines.add("");
    if (!fromData.isEmpty()) {
      lines.addAll(fromData);
      lines.add("");
    }
    int runtime = RuntimeJar.current().bytes().length;
    lines.add("Runtime JAR, the whole solver: " + runtime + " B.");
    lines.add("");
  }

  private static String line(Row row, List<String> fromData) throws Exception {
    MechmlModel model = model(row);
    BuildOptions options = options(row);
    CompiledModel compiled = throughBytes(model, options);
    for (Omission omission : compiled.generated().fromData()) {
      fromData.add("- " + row + ": " + omission.what() + " from data, " + omission.why() + ".");
    }
    JarImage jar = jar(compiled);
    long beside = jar.bytes().length - jar.modelBytes();
    assertThat(jar.modelBytes()).as(row.toString()).isLessThanOrEqualTo(row.bound());
    if (row.bound() != LISTED) {
      assertThat(beside).as(row.toString()).isLessThanOrEqualTo(OVERHEAD);
    }
    String source =
        row.compact()
            ? ""
            : String.format(Locale.ROOT, "%.0f", leastTime(6, () -> throughSource(model, options)));
    return String.format(
        Locale.ROOT,
        "| %s | %s | %s | %d%s | %d | %d | %.1f | %s | %d |",
        row.file(),
        row.formulation() + (row.compact() ? ", compact" : ""),
        row.compact() ? "" : compiled.generated().operations(),
        jar.modelBytes(),
        row.bound() == LISTED ? "" : " / " + row.bound(),
        jar.bytes().length,
        beside,
        leastTime(2, () -> throughBytes(model, options)),
        source,
        row.paper());
  }

  private static CompiledModel throughSource(MechmlModel model, BuildOptions options) {
    return ModelFactory.compileSource(model, options, ModelFactory.generate(model, options));
  }

  private void standalone() throws Exception {
    lines.add("## Standalone JARs");
    lines.add("");
    lines.add("They start with `java -jar` and hold the solver's classes that the model reaches.");
    lines.add("");
    lines.add("| model | formulation | JAR [B] | solver, compressed [B] | classes of the solver |");
    lines.add("|---|---|---:|---:|---|");
    for (Row row : ROWS) {
      if (row.bound() != LISTED) {
        lines.add(standalone(row));
      }
    }
  }

  private static String standalone(Row row) throws Exception {
    CompiledModel model = built(row);
    JarImage jar = ModelJars.standalone(model, "0".repeat(64));
    long solver = 0;
    try (JarInputStream in = new JarInputStream(new ByteArrayInputStream(jar.bytes()))) {
      for (JarEntry entry = in.getNextJarEntry(); entry != null; entry = in.getNextJarEntry()) {
        in.readAllBytes();
        in.closeEntry();
        solver += entry.getName().startsWith(SOLVER) ? entry.getCompressedSize() : 0;
      }
    }
    return String.format(
        Locale.ROOT,
        "| %s | %s | %d | %d | %s |",
        row.file(),
        row.formulation() + (row.compact() ? ", compact" : ""),
        jar.bytes().length,
        solver,
        solverClasses(model));
  }

  /** Returns how many classes of each of the solver's packages a model reaches. */
  private static String solverClasses(CompiledModel model) {
    SortedMap<String, byte[]> reached =
        ReachableClasses.from(StandaloneMain.classFiles(model), SolverClasses::file);
    Map<String, Integer> counts = new TreeMap<>();
    for (String file : reached.keySet()) {
      String folder = file.substring(0, file.lastIndexOf('/'));
      counts.merge(folder.replace(SOLVER, ""), 1, Integer::sum);
    }
    List<String> told = new ArrayList<>();
    counts.forEach((folder, count) -> told.add(folder + " " + count));
    return reached.size() + ": " + String.join(", ", told);
  }
}
