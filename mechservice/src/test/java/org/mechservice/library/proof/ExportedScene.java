package org.mechservice.library.proof;

import java.io.ByteArrayInputStream;
import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipInputStream;
import org.mechservice.library.MechModel;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.sim.fmu.FmiVersion;
import org.mechservice.sim.fmu.FmuArchive;
import org.mechservice.sim.fmu.FmuModel;
import org.mechservice.sim.model.BuildOptions;
import org.mechservice.sim.model.ModelFactory;
import org.mechservice.solver.api.run.RunSettings;

/** Scenes that run outside of this process: as standalone JARs and as units for Co-Simulation. */
final class ExportedScene {
  private static final Pattern CODE = Pattern.compile("\\b[MNS]-\\d{3}\\b");
  private static final Pattern TOKEN = Pattern.compile("guid=\"([^\"]+)\"");
  private static final Pattern VARIABLE =
      Pattern.compile("<ScalarVariable\\b[^>]*?name=\"([^\"]+)\"[^>]*?valueReference=\"(\\d+)\"");

  private ExportedScene() {}

  /** Runs a scene as {@code java -jar}. */
  static SceneRun jar(Scene scene, Path folder)
      throws IOException, MechmlException, InterruptedException {
    Path jar = folder.resolve("scene.jar");
    Path csv = folder.resolve("scene.csv");
    Files.deleteIfExists(csv);
    MechModel.of("m.xml", scene.text()).writeJar(jar);
    Path java = Path.of(System.getProperty("java.home"), "bin", "java");
    String output =
        output(
            folder,
            java.toString(),
            "-XX:TieredStopAtLevel=1",
            "-jar",
            jar.toString(),
            "--out",
            csv.toString());
    SortedSet<String> said = codes(output);
    if (!Files.exists(csv)) {
      return SceneRun.judged(scene, column -> Double.NaN, said);
    }
    List<String> lines = Files.readAllLines(csv);
    List<String> names = List.of(lines.get(0).split(",", -1));
    String[] last = lines.get(lines.size() - 1).split(",", -1);
    boolean ended = Double.parseDouble(last[0]) > 0;
    return SceneRun.judged(
        scene,
        column -> ended ? Double.parseDouble(last[names.indexOf(column)]) : Double.NaN,
        said);
  }

  /**
   * Runs a scene as a unit for Co-Simulation in a host written in C.
   *
   * @param steps equal steps of communication
   */
  static SceneRun unit(Scene scene, int steps, Path folder)
      throws IOException, MechmlException, InterruptedException {
    MechModel read = MechModel.of("m.xml", scene.text());
    MechmlModel model = read.content();
    // the method that every unit has
    RunSettings run = model.settings().run().withIntegrator("ode113");
    BuildOptions options = new BuildOptions("auto", read.columns(), run);
    FmuModel unit = FmuModel.of(ModelFactory.inC(model, options), run);
    Map<String, byte[]> files = new HashMap<>();
    try (ZipInputStream zip =
        new ZipInputStream(
            new ByteArrayInputStream(FmuArchive.build(unit, FmiVersion.FMI_2).bytes()))) {
      for (ZipEntry entry = zip.getNextEntry(); entry != null; entry = zip.getNextEntry()) {
        files.put(entry.getName(), zip.readAllBytes());
      }
    }
    String description = new String(files.get("modelDescription.xml"), StandardCharsets.UTF_8);
    Path library = folder.resolve("unit.so");
    for (Map.Entry<String, byte[]> file : files.entrySet()) {
      if (file.getKey().matches("binaries/.*\\.(so|dylib)")) {
        Files.write(library, file.getValue());
      }
    }
    Matcher token = TOKEN.matcher(description);
    if (!token.find()) {
      throw new IllegalStateException("the description has no token");
    }
    Map<String, String> references = new HashMap<>();
    Matcher variable = VARIABLE.matcher(description);
    while (variable.find()) {
      references.put(variable.group(1), variable.group(2));
    }
    List<String> command = new ArrayList<>();
    command.add(host(folder).toString());
    command.add(library.toString());
    command.add(token.group(1));
    command.add(Double.toString(model.settings().run().tEnd()));
    command.add(Integer.toString(steps));
    scene.expected().forEach(e -> command.add(references.get(e.column())));
    String output = output(folder, command.toArray(String[]::new));
    Map<String, Double> ends = new HashMap<>();
    SortedSet<String> said = new TreeSet<>();
    int i = 0;
    for (String line : output.lines().toList()) {
      if (line.startsWith("value ")) {
        ends.put(
            scene.expected().get(i++).column(),
            Double.parseDouble(line.substring("value ".length())));
      } else {
        said.add(line);
      }
    }
    return SceneRun.judged(scene, column -> ends.getOrDefault(column, Double.NaN), said);
  }

  /** Returns whether units can be compiled on this machine. */
  static boolean hasCompiler() {
    return Stream.of(System.getenv().getOrDefault("PATH", "").split(File.pathSeparator))
        .anyMatch(folder -> Files.isExecutable(Path.of(folder, "cc")));
  }

  /** Returns the host, compiled once for a folder. */
  private static Path host(Path folder) throws IOException, InterruptedException {
    Path program = folder.resolve("host");
    if (!Files.exists(program)) {
      Path source = folder.resolve("host.c");
      try (var in = ExportedScene.class.getResourceAsStream("host.c")) {
        Files.write(source, in.readAllBytes());
      }
      String said =
          output(folder, "cc", "-O1", "-o", program.toString(), source.toString(), "-ldl", "-lm");
      if (!Files.exists(program)) {
        throw new IOException("the host is not compiled: " + said);
      }
    }
    return program;
  }

  private static SortedSet<String> codes(String text) {
    SortedSet<String> codes = new TreeSet<>();
    Matcher matcher = CODE.matcher(text);
    while (matcher.find()) {
      codes.add(matcher.group());
    }
    return codes;
  }

  private static String output(Path folder, String... command)
      throws IOException, InterruptedException {
    Path output = folder.resolve("output.txt");
    Process process =
        new ProcessBuilder(command)
            .redirectErrorStream(true)
            .redirectOutput(output.toFile())
            .start();
    if (!process.waitFor(10, TimeUnit.MINUTES)) {
      process.destroyForcibly();
      throw new IOException("no end after ten minutes: " + String.join(" ", command));
    }
    return Files.readString(output);
  }
}
