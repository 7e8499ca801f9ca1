package org.mechservice.spark;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.mechservice.study.run.Study;
import org.mechservice.study.run.StudyPart;
import org.mechservice.study.run.StudyPlan;
import org.mechservice.study.run.StudyReader;

/**
 * A study on a cluster of processes on this machine, a master and two workers with an executor
 * each, of which one is killed: the bytes of threads.
 */
@Tag("soak")
class LostExecutorTest {
  private static final String STUDY =
      """
      <study model='seat.xml'>
        <factor name='damping' from='500' to='4500'/>
        <factor name='stiffness' distribution='normal' mean='20000' deviation='1000'/>
        <design kind='sobol' points='20000'/>
        <output name='lowest' of='min(height.q)' unit='mm'/>
      </study>
      """;

  private static final int CHUNKS_BEFORE_THE_KILL = 3;
  private static final int MOST_MINUTES = 10;

  @TempDir private Path folder;

  @Test
  void executorThatIsKilledCostsNoRowAndChangesNoByte() throws Exception {
    Files.copy(Path.of("../examples/sweep/seat.xml"), folder.resolve("seat.xml"));
    Path study = Files.writeString(folder.resolve("study.xml"), STUDY);
    Path table = folder.resolve("spark.csv");
    Process driver = driver(study, table);
    try {
      killExecutor(driver, folder.resolve("spark.csv.unfinished"));
      assertThat(driver.waitFor(MOST_MINUTES, TimeUnit.MINUTES)).isTrue();
    } finally {
      driver.descendants().forEach(ProcessHandle::destroyForcibly);
      driver.destroyForcibly();
    }
    String said = Files.readString(folder.resolve("driver.log"));
    assertThat(driver.exitValue()).as(said).isZero();
    assertThat(said).contains("Lost executor");

    StudyPlan plan = StudyReader.read(study);
    Path threads = folder.resolve("threads.csv");
    new Study(plan, StudyPart.WHOLE, plan.model()).run(threads, 2, (done, before, all) -> {});
    assertThat(table).hasSameBinaryContentAs(threads);
    assertThat(folder.resolve("spark.study.json"))
        .hasSameBinaryContentAs(folder.resolve("threads.study.json"));
  }

  /** Spark's workers ask for such a folder; executors have everything on their class path. */
  private Path sparkHome() throws IOException {
    Path home = folder.resolve("spark-home");
    Files.createDirectories(home.resolve("jars"));
    Files.writeString(home.resolve("RELEASE"), "of the tests\n");
    return home;
  }

  private Process driver(Path study, Path table) throws IOException {
    String path = System.getProperty("java.class.path");
    List<String> command = new ArrayList<>();
    command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
    command.add("-Dspark.master=local-cluster[2,1,700]");
    command.add("-Dspark.executor.memory=700m");
    command.add("-Dspark.ui.enabled=false");
    command.add("-Dspark.driver.host=127.0.0.1");
    command.add("-Dspark.executor.extraClassPath=" + path);
    command.addAll(List.of("-cp", path, SparkStudy.class.getName()));
    command.addAll(List.of(study.toString(), "-o", table.toUri().toString(), "--quiet"));
    ProcessBuilder driver = new ProcessBuilder(command);
    driver.environment().put("SPARK_HOME", sparkHome().toString());
    driver.environment().put("SPARK_SCALA_VERSION", "2.13");
    driver.environment().put("SPARK_LOCAL_IP", "127.0.0.1");
    driver.directory(folder.toFile());
    driver.redirectErrorStream(true).redirectOutput(folder.resolve("driver.log").toFile());
    return driver.start();
  }

  private void killExecutor(Process driver, Path rows) throws Exception {
    while (driver.isAlive() && finished(rows) < CHUNKS_BEFORE_THE_KILL) {
      TimeUnit.MILLISECONDS.sleep(20);
    }
    Optional<ProcessHandle> executor =
        driver.descendants().filter(LostExecutorTest::isExecutor).findFirst();
    assertThat(executor).as(Files.readString(folder.resolve("driver.log"))).isPresent();
    executor.get().destroyForcibly();
  }

  private static long finished(Path rows) throws IOException {
    if (!Files.isDirectory(rows)) {
      return 0;
    }
    try (Stream<Path> files = Files.list(rows)) {
      return files.filter(file -> file.toString().endsWith(".rows")).count();
    }
  }

  private static boolean isExecutor(ProcessHandle process) {
    try {
      return Files.readString(Path.of("/proc/" + process.pid() + "/cmdline"))
          .contains("CoarseGrainedExecutorBackend");
    } catch (IOException e) {
      return false; // it has ended
    }
  }
}
