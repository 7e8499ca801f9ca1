package org.mechservice.cli.sweep;

import java.io.File;
import java.io.IOException;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.jar.Attributes;
import java.util.jar.JarFile;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.mechservice.cli.shell.UsageException;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.spark.SparkStudy;

/**
 * Starts a study by {@code spark-submit}, which is sought in {@code SPARK_HOME} and on the path:
 * Spark has some hundred JARs and is no part of this program.
 */
final class SparkSubmit {
  /** Spark has bindings of its own for the log. */
  private static final Pattern NOT_WANTED = Pattern.compile("slf4j-.*|logback-.*");

  private SparkSubmit() {}

  /**
   * Returns the command.
   *
   * @param environment of this process
   * @param settings of Spark, such as {@code spark.executor.memory=2g}
   * @throws UsageException S-183 if there is no Spark
   */
  static List<String> command(
      Map<String, String> environment,
      Optional<String> master,
      List<String> settings,
      List<String> study)
      throws IOException {
    List<String> words = new ArrayList<>(List.of(program(environment)));
    words.addAll(List.of("--class", SparkStudy.class.getName()));
    master.ifPresent(url -> words.addAll(List.of("--master", url)));
    settings.forEach(setting -> words.addAll(List.of("--conf", setting)));
    Path jar = jar();
    words.addAll(List.of("--jars", needed(jar)));
    words.add(jar.toString());
    words.addAll(study);
    return words;
  }

  private static String program(Map<String, String> environment) {
    Stream<String> homes =
        Optional.ofNullable(environment.get("SPARK_HOME")).map(home -> home + "/bin").stream();
    Stream<String> path =
        Stream.of(environment.getOrDefault("PATH", "").split(File.pathSeparator, -1));
    return Stream.concat(homes, path)
        .filter(folder -> !folder.isEmpty())
        .map(folder -> Path.of(folder, "spark-submit"))
        .filter(Files::isExecutable)
        .findFirst()
        .map(Path::toString)
        .orElseThrow(
            () ->
                new UsageException(
                    MessageCode.NO_SPARK
                        + " there is no spark-submit, neither in SPARK_HOME nor on the path;"
                        + " install Apache Spark 4 and set SPARK_HOME to its folder, or leave"
                        + " --engine out"));
  }

  private static Path jar() throws IOException {
    try {
      return Path.of(SparkStudy.class.getProtectionDomain().getCodeSource().getLocation().toURI());
    } catch (URISyntaxException e) {
      throw new IOException(e);
    }
  }

  /** Returns the JARs that the manifest names, which are beside it, separated by commas. */
  private static String needed(Path jar) throws IOException {
    try (JarFile file = new JarFile(jar.toFile())) {
      String names = file.getManifest().getMainAttributes().getValue(Attributes.Name.CLASS_PATH);
      return Stream.of(String.valueOf(names).split(" ", -1))
          .filter(name -> !NOT_WANTED.matcher(name).matches())
          .map(name -> jar.resolveSibling(name).toString())
          .collect(Collectors.joining(","));
    }
  }

  /**
   * Runs a command with the input and output of this process.
   *
   * @return its exit status
   */
  static int run(List<String> command) throws IOException, InterruptedException {
    Process process = new ProcessBuilder(command).inheritIO().start();
    Thread end = new Thread(process::destroy, "end-of-spark-submit");
    Runtime.getRuntime().addShutdownHook(end);
    return process.waitFor();
  }
}
