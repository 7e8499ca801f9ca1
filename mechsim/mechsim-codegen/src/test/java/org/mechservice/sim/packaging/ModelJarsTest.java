package org.mechservice.sim.packaging;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.ByteArrayInputStream;
import java.io.File;
import java.io.IOException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalDateTime;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.jar.Attributes;
import java.util.jar.JarEntry;
import java.util.jar.JarFile;
import java.util.jar.JarInputStream;
import java.util.jar.Manifest;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.mechservice.guard.SolverClasses;
import org.mechservice.guard.UserCode;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.resolve.MechmlReader;
import org.mechservice.sim.compile.ReachableClasses;
import org.mechservice.sim.model.BuildOptions;
import org.mechservice.sim.model.CompiledModel;
import org.mechservice.sim.model.KeptRows;
import org.mechservice.sim.model.ModelFactory;
import org.mechservice.sim.model.Scenes;
import org.mechservice.sim.user.PushedCart;
import org.mechservice.sim.user.UserClasses;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.api.run.RunControl;
import org.mechservice.solver.api.run.RunRequest;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.IntegrationMethod;
import org.mechservice.solver.ode.adams.De;
import org.mechservice.solver.simulation.RuntimeSolver;
import org.mechservice.solver.simulation.Simulation;
import org.mechservice.solver.text.Sha256;

@Tag("slow")
class ModelJarsTest {
  private static final String SHA = "0123456789abcdef".repeat(4);
  private static final String MODEL = "org/mechservice/model/FiveBarPendulum.class";
  private static final String SOLVER = "org/mechservice/solver/";
  private static final String DE = SOLVER + "ode/adams/De.class";

  private static boolean isClassFile(String name) {
    return name.endsWith(".class");
  }

  private static CompiledModel pendulum(String integrator) {
    RunSettings settings = new RunSettings(0, 3, 0.01, integrator, 1e-5, 1e-5);
    BuildOptions options = new BuildOptions("auto", Set.of(ColumnGroup.ENERGY), settings);
    MechmlModel model = Scenes.model(Scenes.pendulum());
    return ModelFactory.compile(model, options, ModelFactory.generate(model, options));
  }

  private static SortedMap<String, byte[]> entries(JarImage jar) throws IOException {
    SortedMap<String, byte[]> entries = new TreeMap<>();
    try (JarInputStream stream = new JarInputStream(new ByteArrayInputStream(jar.bytes()))) {
      for (JarEntry entry = stream.getNextJarEntry();
          entry != null;
          entry = stream.getNextJarEntry()) {
        entries.put(entry.getName(), stream.readAllBytes());
      }
    }
    return entries;
  }

  private static Attributes manifest(JarImage jar) throws IOException {
    try (JarInputStream stream = new JarInputStream(new ByteArrayInputStream(jar.bytes()))) {
      Manifest manifest = stream.getManifest();
      return manifest.getMainAttributes();
    }
  }

  @Test
  void theModelJarHoldsTheModelAndNothingElse() throws IOException {
    JarImage jar = ModelJars.model(pendulum("DE"), SHA);
    assertThat(entries(jar).keySet()).containsExactly("META-INF/modelDescription.xml", MODEL);
    assertThat(jar.fileName()).isEqualTo("FiveBarPendulum.jar");
    assertThat(jar.mainClass()).isEqualTo("org.mechservice.model.FiveBarPendulum");
    assertThat(jar.sha256()).isEqualTo(Sha256.of(jar.bytes()));
  }

  /** The pendulum's classes take at most 4 KB. */
  @Test
  void thePendulumsClassIsSmall() {
    assertThat(ModelJars.model(pendulum("DE"), SHA).modelBytes()).isLessThan(4096);
  }

  @Test
  void thePendulumsClassNamesNothingItDoesNotNeed() throws IOException {
    byte[] bytes = entries(ModelJars.model(pendulum("DE"), SHA)).get(MODEL);
    String constants = new String(bytes, StandardCharsets.ISO_8859_1);
    assertThat(constants)
        .contains(
            "org/mechservice/solver/spatial/SinCos",
            "org/mechservice/solver/api/capability/Energies")
        .doesNotContain("BodyPoses", "Quaternion", "EulerParameters", "poses", "sqrt", "List")
        .doesNotContain("StringConcatFactory", "LineNumberTable", "LocalVariableTable");
  }

  @Test
  void theManifestSaysWhatTheModelIs() throws IOException {
    JarImage jar = ModelJars.model(pendulum("ode113"), SHA);
    Attributes manifest = manifest(jar);
    assertThat(manifest.getValue("Mech-Model")).isEqualTo("org.mechservice.model.FiveBarPendulum");
    assertThat(manifest.getValue("Mech-Api-Version")).isEqualTo("1");
    assertThat(manifest.getValue("Mech-Formulation")).isEqualTo("DTR");
    assertThat(manifest.getValue("Mech-Integrator")).isEqualTo("ode113");
    assertThat(manifest.getValue("Mech-Columns")).isEqualTo("joints,accelerations,energy");
    assertThat(manifest.getValue("Mech-Model-SHA-256")).isEqualTo(SHA);
    assertThat(manifest.getValue("Mech-Left-Out")).contains("poses of the bodies");
    jar.manifest().forEach((key, value) -> assertThat(manifest.getValue(key)).isEqualTo(value));
  }

  @Test
  void theManifestSaysWhatDataComputeAndWhy() {
    MechmlModel file = Scenes.model(Scenes.pendulum());
    BuildOptions options = new BuildOptions("DTR", Set.of(ColumnGroup.REACTIONS), Scenes.SETTINGS);
    CompiledModel model = ModelFactory.compile(file, options, ModelFactory.generate(file, options));
    assertThat(ModelJars.model(model, SHA).manifest())
        .containsEntry(
            "Mech-From-Data",
            "reactions (one sweep over the mechanism gives them once for each row of results)");
    assertThat(ModelJars.model(pendulum("DE"), SHA).manifest()).doesNotContainKey("Mech-From-Data");
  }

  @Test
  void theDescriptionListsVariablesWithUnitsAndStart() throws IOException {
    byte[] xml = entries(ModelJars.model(pendulum("DE"), SHA)).get("META-INF/modelDescription.xml");
    assertThat(new String(xml, StandardCharsets.UTF_8))
        .contains("<joint name=\"j3\" type=\"R\"><state name=\"q\" unit=\"rad\" start=\"0\"/>")
        .contains("<output name=\"a\" unit=\"rad/s^2\"/>")
        .contains("tEnd=\"3\"", "integrator=\"DE\"");
  }

  @Test
  void theSameModelGivesTheSameBytes() {
    assertThat(ModelJars.model(pendulum("DE"), SHA).bytes())
        .isEqualTo(ModelJars.model(pendulum("DE"), SHA).bytes());
    assertThat(ModelJars.standalone(pendulum("DE"), SHA).bytes())
        .isEqualTo(ModelJars.standalone(pendulum("DE"), SHA).bytes());
  }

  @Test
  void theStandaloneJarHoldsOnlyWhatItReaches() throws IOException {
    JarImage jar = ModelJars.standalone(pendulum("DE"), SHA);
    Set<String> names = entries(jar).keySet();
    long solver =
        SolverClasses.files().keySet().stream().filter(ModelJarsTest::isClassFile).count();
    assertThat(names.stream().filter(name -> name.startsWith(SOLVER)).count())
        .isLessThan(solver / 3);
    assertThat(names)
        .contains(MODEL, "org/mechservice/model/FiveBarPendulumMain.class")
        .contains("org/mechservice/solver/standalone/Standalone.class")
        .contains("org/mechservice/solver/ode/adams/De.class")
        .noneMatch(name -> name.startsWith("org/mechservice/solver/dynamics/"))
        .noneMatch(name -> name.startsWith("org/mechservice/solver/mechanism/"))
        .noneMatch(name -> name.contains("ode15s") || name.contains("Ode15s"));
    assertThat(manifest(jar).getValue("Main-Class")).isEqualTo(jar.mainClass());
    assertThat(jar.mainClass()).isEqualTo("org.mechservice.model.FiveBarPendulumMain");
  }

  /**
   * A JAR holds ordinary class files with line numbers and names; that of a pendulum does not carry
   * the whole solver.
   */
  @Test
  void theStandaloneJarOfThePendulumIsAFractionOfTheWholeSolver() {
    int whole = RuntimeJar.current().bytes().length;
    assertThat(ModelJars.standalone(pendulum("DE"), SHA).bytes().length).isLessThan(whole / 3);
  }

  /** As jdeps would: no class of the JAR names a class of the product that is missing there. */
  @Test
  void everyClassThatTheStandaloneJarNamesIsInItOrInJava() throws IOException {
    SortedMap<String, byte[]> files = entries(ModelJars.standalone(pendulum("DE"), SHA));
    Set<String> missing = new TreeSet<>();
    for (Map.Entry<String, byte[]> file : files.entrySet()) {
      if (isClassFile(file.getKey())) {
        for (String name : ReachableClasses.namesIn(file.getValue())) {
          if (!files.containsKey(name + ".class") && !name.startsWith("java/")) {
            missing.add(name + ".class");
          }
        }
      }
    }
    // The model was built without these columns and joints: their classes are never loaded.
    assertThat(missing).isSubsetOf(ChosenClasses.paths());
  }

  @Test
  void everyEntryOfAJarIsReadAndVerifiedByJava(@TempDir Path folder) throws Exception {
    for (JarImage image :
        List.of(
            ModelJars.model(pendulum("DE"), SHA),
            ModelJars.standalone(pendulum("switching"), SHA),
            RuntimeJar.current())) {
      Path file = Files.write(folder.resolve(image.fileName()), image.bytes());
      try (JarFile jar = new JarFile(file.toFile(), true)) {
        for (JarEntry entry : jar.stream().toList()) {
          // The stream checks length and CRC at its end.
          byte[] content = jar.getInputStream(entry).readAllBytes();
          assertThat(content).as(entry.getName()).hasSize((int) entry.getSize());
          assertThat(entry.getTimeLocal()).isEqualTo(LocalDateTime.of(1980, 2, 1, 0, 0));
        }
        assertThat(jar.getManifest().getMainAttributes()).isNotEmpty();
      }
    }
  }

  /** Java verifies a class when it initialises it. */
  @Test
  void everyClassOfAStandaloneJarIsValid(@TempDir Path folder) throws Exception {
    JarImage image = ModelJars.standalone(pendulum("switching"), SHA);
    Path file = Files.write(folder.resolve(image.fileName()), image.bytes());
    try (URLClassLoader loader =
        new URLClassLoader(
            new URL[] {file.toUri().toURL()}, ClassLoader.getPlatformClassLoader())) {
      List<String> paths =
          entries(image).keySet().stream().filter(ModelJarsTest::isClassFile).toList();
      assertThat(paths).contains(MODEL);
      for (String path : paths) {
        String name = path.substring(0, path.length() - ".class".length()).replace('/', '.');
        assertThat(Class.forName(name, true, loader).getName()).isEqualTo(name);
      }
    }
  }

  @Test
  void classesOfTheSolverKeepWhatDebuggersRead() throws IOException {
    byte[] file = entries(ModelJars.standalone(pendulum("DE"), SHA)).get(DE);
    assertThat(new String(file, StandardCharsets.ISO_8859_1))
        .contains("LineNumberTable", "SourceFile", "LocalVariableTable");
  }

  @Test
  void theModelRunsBesideTheRuntimeToTheSameBytesAsStandalone(@TempDir Path folder)
      throws Exception {
    for (String integrator : List.of("DE", "ode15s")) {
      CompiledModel model = pendulum(integrator);
      List<String> jars = new ArrayList<>();
      for (JarImage image : List.of(RuntimeJar.current(), ModelJars.model(model, SHA))) {
        jars.add(Files.write(folder.resolve(image.fileName()), image.bytes()).toString());
      }
      Path alone = folder.resolve("alone.jar");
      Files.write(alone, ModelJars.standalone(model, SHA).bytes());
      String classPath = String.join(File.pathSeparator, jars);
      String runModel = "org.mechservice.solver.standalone.RunModel";
      finished(java(folder, "-cp", classPath, runModel, "--out", "beside.csv"));
      finished(java(folder, "-jar", alone.toString(), "--out", "alone.csv"));
      assertThat(folder.resolve("beside.csv")).hasSameBinaryContentAs(folder.resolve("alone.csv"));
    }
  }

  private static void finished(Process process) throws Exception {
    String printed = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertThat(process.waitFor()).as(printed).isZero();
  }

  @Test
  void withoutAModelOnTheClassPathRunModelSaysWhatIsMissing(@TempDir Path folder) throws Exception {
    JarImage runtime = RuntimeJar.current();
    Path file = Files.write(folder.resolve(runtime.fileName()), runtime.bytes());
    Process process =
        java(folder, "-cp", file.toString(), "org.mechservice.solver.standalone.RunModel");
    String printed = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertThat(process.waitFor()).isEqualTo(2);
    assertThat(printed).startsWith("S-069 the class path has no model JAR");
  }

  /**
   * What formulas of a model file state needs no search; of a user's class only values are known.
   */
  @Test
  void onlyModelsWithUserClassesCarryTheSearchForUndeclaredJumps() throws Exception {
    for (IntegrationMethod method : IntegrationMethod.values()) {
      JarImage jar = ModelJars.standalone(pendulum(method.label()), SHA);
      assertThat(entries(jar).keySet())
          .as(method.label())
          .contains("org/mechservice/solver/ode/step/StepWatch.class")
          .noneMatch(name -> name.startsWith("org/mechservice/solver/ode/jumps/"));
    }
    assertThat(entries(ModelJars.standalone(pushed("3"), SHA)).keySet())
        .contains(
            "org/mechservice/solver/ode/jumps/UndeclaredJumps.class",
            "org/mechservice/solver/ode/jumps/PulseProbe.class");
  }

  /** The push begins and ends inside of a step from rest, which shows nothing of it. */
  @Test
  void shortPushByAUserClassIsFoundInEveryForm(@TempDir Path folder) throws Exception {
    CompiledModel model = pushed("state.time() > 1.31 && state.time() < 1.41 ? 3 : 0");
    RunRequest request = new RunRequest(Scenes.SETTINGS, Set.of());
    KeptRows plain = new KeptRows();
    Model equations = model.newInstance();
    new Simulation(De::new, RuntimeSolver.formOf(equations, "DE"))
        .run(equations, request, plain, new RunControl());
    assertThat(speedAtEnd(plain)).isZero();
    KeptRows searched = new KeptRows();
    new RuntimeSolver().run(model.newInstance(), request, searched, new RunControl());
    // 3 N over 0.1 s on 2 kg; a tolerance for each of the two jumps.
    assertThat(speedAtEnd(searched)).isCloseTo(0.15, within(2e-5));
    JarImage jar = ModelJars.standalone(model, SHA);
    Files.write(folder.resolve(jar.fileName()), jar.bytes());
    finished(java(folder, "-jar", jar.fileName(), "--out", "rows.csv", "--quiet"));
    List<String> rows = Files.readAllLines(folder.resolve("rows.csv"));
    String[] last = rows.get(rows.size() - 1).split(",", -1);
    assertThat(Double.parseDouble(last[2])).isEqualTo(speedAtEnd(searched));
  }

  private static double speedAtEnd(KeptRows kept) {
    return kept.rows().get(kept.rows().size() - 1)[2];
  }

  private static CompiledModel pushed(String force) throws Exception {
    String text = PushedCart.harmlessSource().replace("(slide, 3)", "(slide, " + force + ")");
    MechmlModel file = MechmlReader.read("pushed.xml", PushedCart.file());
    UserClasses user =
        UserClasses.admit(file.mechanism(), List.of(PushedCart.asSource(text)), true)
            .forThisProcess(UserCode.NONE.unconfined());
    BuildOptions options = new BuildOptions("auto", Set.of(), Scenes.SETTINGS);
    return ModelFactory.compile(file, options, ModelFactory.generate(file, options), user);
  }

  @Test
  void stackTracesInUserForcesShowFileAndLine(@TempDir Path folder) throws Exception {
    CompiledModel model = pushed("3 / (int) Math.min(0.0, state.time())");
    Path jar = folder.resolve("pushed.jar");
    Files.write(jar, ModelJars.standalone(model, SHA).bytes());
    try (URLClassLoader loader =
        new URLClassLoader(new URL[] {jar.toUri().toURL()}, ClassLoader.getPlatformClassLoader())) {
      Class<?> force = loader.loadClass("car.Push");
      Object instance = force.getConstructor().newInstance();
      assertThatThrownBy(
              () ->
                  Stream.of(force.getMethods())
                      .filter(method -> method.getName().equals("apply"))
                      .findFirst()
                      .orElseThrow()
                      .invoke(instance, null, null))
          .cause()
          .satisfies(
              thrown ->
                  assertThat(thrown.getStackTrace()[0].toString())
                      .contains("car.Push.apply(Push.java:16)"));
    }
  }

  @Test
  void theStandaloneJarRunsByItself(@TempDir Path folder) throws Exception {
    for (String integrator : List.of("DE", "ode113", "switching")) {
      JarImage jar = ModelJars.standalone(pendulum(integrator), SHA);
      Files.write(folder.resolve(jar.fileName()), jar.bytes());
      Path results = folder.resolve(integrator + ".csv");
      Process process =
          java(folder, "-jar", jar.fileName(), "--out", results.toString(), "--quiet");
      assertThat(process.waitFor()).isZero();
      List<String> rows = Files.readAllLines(results);
      assertThat(rows).hasSize(302);
      assertThat(rows.get(0)).startsWith("t,j1.q,j2.q");
      assertThat(rows.get(301)).startsWith("3,1.85");
    }
  }

  /** From directories of classes, as here, or from JARs: the solver is found and packed alike. */
  @Test
  void jarsAreTheSameWhenEverythingRunsFromJars(@TempDir Path folder) throws Exception {
    List<String> path = new ArrayList<>();
    for (String element : System.getProperty("java.class.path").split(File.pathSeparator, -1)) {
      Path place = Path.of(element);
      path.add(Files.isDirectory(place) ? jarOf(place, folder, path.size()) : element);
    }
    Process process =
        java(folder, "-cp", String.join(File.pathSeparator, path), ModelJarsTest.class.getName());
    String printed = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertThat(process.waitFor()).as(printed).isZero();
    assertThat(printed.strip()).isEqualTo(digests());
  }

  /** Prints the digests of the pendulum's JARs. */
  public static void main(String[] args) {
    System.out.println(digests());
  }

  private static String digests() {
    CompiledModel pendulum = pendulum("DE");
    return ModelJars.model(pendulum, SHA).sha256()
        + ModelJars.standalone(pendulum, SHA).sha256()
        + RuntimeJar.current().sha256();
  }

  private static String jarOf(Path directory, Path folder, int number) throws IOException {
    ReproducibleJar jar = new ReproducibleJar(Map.of());
    try (Stream<Path> files = Files.walk(directory)) {
      for (Path file : files.filter(Files::isRegularFile).toList()) {
        String name = directory.relativize(file).toString().replace('\\', '/');
        if (!name.equals("META-INF/MANIFEST.MF")) {
          jar.add(name, Files.readAllBytes(file));
        }
      }
    }
    Path path = folder.resolve("part" + number + ".jar");
    Files.write(path, jar.bytes());
    return path.toString();
  }

  private static Process java(Path folder, String... arguments) throws IOException {
    List<String> command = new ArrayList<>();
    command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
    command.addAll(List.of(arguments));
    return new ProcessBuilder(command).directory(folder.toFile()).redirectErrorStream(true).start();
  }
}
