package org.mechservice.sim.model;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.File;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Random;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.jar.Attributes;
import java.util.jar.JarEntry;
import java.util.jar.JarInputStream;
import java.util.jar.Manifest;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.sim.jar.LeanClass;
import org.mechservice.sim.jar.Packing;
import org.mechservice.sim.jar.ReproducibleJar;
import org.mechservice.sim.jar.Sha256;
import org.mechservice.sim.jar.SolidClasses;
import org.mechservice.solver.api.ColumnGroup;
import org.mechservice.solver.api.RunSettings;
import org.mechservice.solver.pack.PackedClasses;
import org.mechservice.solver.standalone.Launcher;

class ModelJarsTest {
  private static final String SHA = "0123456789abcdef".repeat(4);
  private static final String MODEL = "org/mechservice/model/FiveBarPendulum.class";

  private static CompiledModel pendulum(String integrator) {
    RunSettings settings = new RunSettings(0, 3, 0.01, integrator, 1e-5, 1e-5);
    BuildOptions options = new BuildOptions("auto", Set.of(ColumnGroup.ENERGY), settings);
    MechmlModel model = Scenes.model(Scenes.pendulum());
    return ModelFactory.compile(model, options, ModelFactory.generate(model, options));
  }

  private static SortedMap<String, byte[]> entries(PackedJar jar) throws IOException {
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

  private static Attributes manifest(PackedJar jar) throws IOException {
    try (JarInputStream stream = new JarInputStream(new ByteArrayInputStream(jar.bytes()))) {
      Manifest manifest = stream.getManifest();
      return manifest.getMainAttributes();
    }
  }

  @Test
  void theModelJarHoldsTheModelAndNothingElse() throws IOException {
    PackedJar jar = ModelFactory.modelJar(pendulum("DE"), SHA, Packing.SMALLEST);
    assertThat(entries(jar).keySet()).containsExactly("META-INF/modelDescription.xml", MODEL);
    assertThat(jar.fileName()).isEqualTo("FiveBarPendulum.jar");
    assertThat(jar.mainClass()).isEqualTo("org.mechservice.model.FiveBarPendulum");
    assertThat(jar.sha256()).isEqualTo(Sha256.of(jar.bytes()));
  }

  /** Issue 2: the pendulum's classes take at most 4 KB. */
  @Test
  void thePendulumsClassIsSmall() {
    assertThat(ModelFactory.modelJar(pendulum("DE"), SHA, Packing.SMALLEST).modelBytes())
        .isLessThan(4096);
  }

  @Test
  void thePendulumsClassNamesNothingItDoesNotNeed() throws IOException {
    byte[] bytes = entries(ModelFactory.modelJar(pendulum("DE"), SHA, Packing.SMALLEST)).get(MODEL);
    String constants = new String(bytes, StandardCharsets.ISO_8859_1);
    assertThat(constants)
        .contains("org/mechservice/solver/spatial/SinCos", "org/mechservice/solver/api/Energies")
        .doesNotContain("BodyPoses", "Quaternion", "EulerParameters", "poses", "sqrt", "List")
        .doesNotContain("StringConcatFactory", "LineNumberTable", "LocalVariableTable");
  }

  @Test
  void theManifestSaysWhatTheModelIs() throws IOException {
    PackedJar jar = ModelFactory.modelJar(pendulum("ode113"), SHA, Packing.SMALLEST);
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
    assertThat(ModelFactory.modelJar(model, SHA, Packing.QUICK).manifest())
        .containsEntry(
            "Mech-From-Data",
            "reactions (one sweep over the mechanism gives them once for each row of results)");
    assertThat(ModelFactory.modelJar(pendulum("DE"), SHA, Packing.QUICK).manifest())
        .doesNotContainKey("Mech-From-Data");
  }

  @Test
  void theDescriptionListsVariablesWithUnitsAndStart() throws IOException {
    byte[] xml =
        entries(ModelFactory.modelJar(pendulum("DE"), SHA, Packing.SMALLEST))
            .get("META-INF/modelDescription.xml");
    assertThat(new String(xml, StandardCharsets.UTF_8))
        .contains("<joint name=\"j3\" type=\"R\"><state name=\"q\" unit=\"rad\" start=\"0\"/>")
        .contains("<output name=\"a\" unit=\"rad/s^2\"/>")
        .contains("tEnd=\"3\"", "integrator=\"DE\"");
  }

  @Test
  void theSameModelGivesTheSameBytes() {
    assertThat(ModelFactory.modelJar(pendulum("DE"), SHA, Packing.SMALLEST).bytes())
        .isEqualTo(ModelFactory.modelJar(pendulum("DE"), SHA, Packing.SMALLEST).bytes());
    assertThat(ModelFactory.standaloneJar(pendulum("DE"), SHA, Packing.SMALLEST).bytes())
        .isEqualTo(ModelFactory.standaloneJar(pendulum("DE"), SHA, Packing.SMALLEST).bytes());
  }

  /** Issue 2: at most 125 KB. */
  @Test
  void theRuntimeJarHoldsTheSolverInLittleRoom() throws IOException {
    PackedJar runtime = ModelFactory.runtimeJar();
    assertThat(runtime.bytes().length).isLessThan(125 * 1024);
    assertThat(ModelFactory.runtimeJar()).isSameAs(runtime);
    assertThat(entries(runtime).keySet())
        .containsExactly(
            PackedClasses.ENTRY, "META-INF/services/org.mechservice.solver.api.Solver");
    assertThat(runtimeClasses())
        .containsKey("org/mechservice/solver/simulation/Simulation.class")
        .containsKey("org/mechservice/solver/dynamics/ArticulatedBody.class");
    assertThat(runtimeClasses().keySet())
        .allMatch(name -> name.startsWith("org/mechservice/solver/"))
        .noneMatch(name -> name.startsWith("org/mechservice/solver/pack/"));
  }

  /** Unpacked once for all tests, which leave it as it is. */
  private static final class Unpacked {
    private static final SortedMap<String, byte[]> CLASSES = classes();

    private static SortedMap<String, byte[]> classes() {
      try {
        return PackedClasses.unpack(packedClasses());
      } catch (IOException e) {
        throw new UncheckedIOException(e);
      }
    }
  }

  private static SortedMap<String, byte[]> runtimeClasses() {
    return Unpacked.CLASSES;
  }

  private static byte[] packedClasses() throws IOException {
    return Objects.requireNonNull(entries(ModelFactory.runtimeJar()).get(PackedClasses.ENTRY));
  }

  /** Unpacks the classes of a runtime JAR. */
  static SortedMap<String, byte[]> classesOf(PackedJar runtime) throws IOException {
    return PackedClasses.unpack(Objects.requireNonNull(entries(runtime).get(PackedClasses.ENTRY)));
  }

  /** Written anew, a class has its constants in the order of their use: then bytes can be equal. */
  @Test
  void packingLeavesTheSolversCodeAsItIs() throws IOException {
    runtimeClasses()
        .forEach(
            (path, unpacked) ->
                assertThat(LeanClass.of(unpacked))
                    .as(path)
                    .isEqualTo(SolverFiles.lean().get(path)));
  }

  @Test
  void packedClassesAreTheSameFromWhateverOrderOfTheirConstants() throws IOException {
    byte[] packed = packedClasses();
    assertThat(PackedClasses.pack(runtimeClasses())).isEqualTo(packed);
  }

  /** Every class is verified when it is initialised. */
  @Test
  void unpackedClassesAreValid() throws Exception {
    SortedMap<String, byte[]> byName = new TreeMap<>();
    runtimeClasses()
        .forEach(
            (path, bytes) ->
                byName.put(path.substring(0, path.length() - 6).replace('/', '.'), bytes));
    ClassLoader loader =
        new ClassLoader(ClassLoader.getPlatformClassLoader()) {
          @Override
          protected Class<?> findClass(String name) throws ClassNotFoundException {
            byte[] bytes = byName.get(name);
            if (bytes == null) {
              throw new ClassNotFoundException(name);
            }
            return defineClass(name, bytes, 0, bytes.length);
          }
        };
    for (String name : byName.keySet()) {
      assertThat(Class.forName(name, true, loader).getName()).isEqualTo(name);
    }
  }

  @Test
  void damagedPackedClassesAreRefused() throws IOException {
    SortedMap<String, byte[]> some =
        runtimeClasses().headMap("org/mechservice/solver/closure/Partition.class");
    byte[] packed = PackedClasses.pack(some);
    Random random = new Random(5);
    for (int i = 0; i < 200; i++) {
      byte[] damaged = packed.clone();
      damaged[random.nextInt(damaged.length)] ^= (byte) (1 << random.nextInt(8));
      try {
        // What still unpacks is for the virtual machine to verify; nothing else may escape.
        assertThat(PackedClasses.unpack(damaged)).isNotNull();
      } catch (IOException e) {
        assertThat(e).hasMessageContaining("packed class");
      }
    }
  }

  @Test
  void theStandaloneJarHoldsOnlyWhatItReaches() throws IOException {
    PackedJar jar = ModelFactory.standaloneJar(pendulum("DE"), SHA, Packing.SMALLEST);
    Set<String> solver = classesIn(Objects.requireNonNull(entries(jar).get(Launcher.SOLVER)));
    assertThat(solver)
        .hasSizeLessThan(runtimeClasses().size() * 9 / 10)
        .contains("org.mechservice.solver.standalone.Standalone")
        .contains("org.mechservice.solver.ode.De")
        .noneMatch(name -> name.startsWith("org.mechservice.solver.dynamics."))
        .noneMatch(name -> name.startsWith("org.mechservice.solver.mechanism."));
    assertThat(entries(jar)).containsKey(MODEL);
    assertThat(manifest(jar).getValue("Main-Class")).isEqualTo(jar.mainClass());
  }

  private static Set<String> classesIn(byte[] solid) throws IOException {
    Map<String, byte[]> classes = new HashMap<>();
    assertThat(Launcher.read(new ByteArrayInputStream(solid), classes)).endsWith("Main");
    return classes.keySet();
  }

  /** A class's bytes are those it was packed from. */
  @Test
  void classesOfTheSolidFileComeOutAsTheyWentIn() throws IOException {
    Map<String, byte[]> classes = new HashMap<>();
    Launcher.read(new ByteArrayInputStream(SolidClasses.of("a.Main", runtimeClasses())), classes);
    assertThat(classes).hasSameSizeAs(runtimeClasses());
    runtimeClasses()
        .forEach(
            (path, bytes) ->
                assertThat(classes.get(path.substring(0, path.length() - 6).replace('/', '.')))
                    .as(path)
                    .isEqualTo(bytes));
  }

  @Test
  void theStandaloneJarRunsByItself(@TempDir Path folder) throws Exception {
    for (String integrator : List.of("DE", "ode113", "switching")) {
      PackedJar jar = ModelFactory.standaloneJar(pendulum(integrator), SHA, Packing.SMALLEST);
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
    return ModelFactory.modelJar(pendulum, SHA, Packing.SMALLEST).sha256()
        + ModelFactory.standaloneJar(pendulum, SHA, Packing.SMALLEST).sha256()
        + ModelFactory.runtimeJar().sha256();
  }

  private static String jarOf(Path directory, Path folder, int number) throws IOException {
    ReproducibleJar jar = new ReproducibleJar(Map.of(), Packing.SMALLEST);
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
