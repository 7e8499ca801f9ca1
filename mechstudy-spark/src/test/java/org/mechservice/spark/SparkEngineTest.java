package org.mechservice.spark;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.apache.spark.SparkConf;
import org.apache.spark.api.java.JavaSparkContext;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.mechservice.study.run.Study;
import org.mechservice.study.run.StudyPart;
import org.mechservice.study.run.StudyPlan;
import org.mechservice.study.run.StudyReader;

/** A study on Spark, with two executor threads in this process: the bytes of threads. */
@Tag("slow")
class SparkEngineTest {
  private static final String STUDY =
      """
      <study model='seat.xml'>
        <factor name='damping' from='-500' to='4500'/>
        <factor name='stiffness' distribution='normal' mean='20000' deviation='1000'/>
        <design kind='sobol' points='300'/>
        <output name='lowest' of='min(height.q)' unit='mm'/>
        <output of='crossing(height.q, 0)'/>%s
      </study>
      """;

  private static JavaSparkContext spark;

  @TempDir private Path folder;

  @BeforeAll
  static void start() {
    spark =
        new JavaSparkContext(
            new SparkConf()
                .setMaster("local[2]")
                .setAppName("test")
                .set("spark.ui.enabled", "false")
                .set("spark.driver.host", "127.0.0.1")
                .set("spark.driver.bindAddress", "127.0.0.1"));
  }

  @AfterAll
  static void stop() {
    spark.close();
  }

  @BeforeEach
  void copyModel() throws Exception {
    Files.copy(Path.of("../examples/sweep/seat.xml"), folder.resolve("seat.xml"));
  }

  private Path study(String more) throws Exception {
    return Files.writeString(folder.resolve("study.xml"), STUDY.formatted(more));
  }

  private Path byThreads(StudyPlan plan) throws Exception {
    Path table = folder.resolve("threads.csv");
    new Study(plan, StudyPart.WHOLE, plan.model()).run(table, 2, (done, before, all) -> {});
    return table;
  }

  private Path bySpark(Path study, StudyPlan plan) throws Exception {
    Path table = folder.resolve("spark.csv");
    new SparkEngine(spark, study, plan, table.toUri().toString()).run((done, all) -> {});
    return table;
  }

  private void assertSameBytes(Path study) throws Exception {
    StudyPlan plan = StudyReader.read(study);
    Path threads = byThreads(plan);
    Path sparks = bySpark(study, plan);

    assertThat(sparks).hasSameBinaryContentAs(threads);
    assertThat(folder.resolve("spark.study.json"))
        .hasSameBinaryContentAs(folder.resolve("threads.study.json"));
    try (Stream<Path> files = Files.list(folder)) {
      assertThat(files.map(file -> file.getFileName().toString()))
          .containsExactlyInAnyOrder(
              "seat.xml",
              "study.xml",
              "spark.csv",
              "spark.study.json",
              "threads.csv",
              "threads.study.json");
    }
  }

  @Test
  void bytesAreThoseOfThreads() throws Exception {
    assertSameBytes(study(""));
  }

  @Test
  void stopRuleEndsTheTableAtTheSameRow() throws Exception {
    assertSameBytes(study("<stop output='lowest' error='0.9'/>"));
  }

  /** A driver that was killed leaves files of rows, also of chunks that overlap. */
  @Test
  void filesOfAnEarlierDriverAreUsed() throws Exception {
    Path study = study("");
    StudyPlan plan = StudyReader.read(study);
    List<String> rows = Files.readAllLines(byThreads(plan));
    Path left = folder.resolve("spark.csv.unfinished");
    String identity = org.mechservice.study.run.StudyFiles.of(study, plan).identity();
    try (RowFiles files =
        new RowFiles(left.toUri().toString(), spark.hadoopConfiguration(), identity)) {
      for (Chunk chunk : List.of(new Chunk(10, 40), new Chunk(30, 50), new Chunk(200, 230))) {
        List<String> part = rows.subList(chunk.first() + 1, chunk.end() + 1);
        files.write(chunk, String.join("\n", part) + "\n");
      }
    }
    Files.writeString(left.resolve(".60-70.rows.growing"), "half a fi");

    assertSameBytes(study);
  }

  @Test
  void filesOfAnotherStudyAreRefused() throws Exception {
    Path study = study("");
    StudyPlan plan = StudyReader.read(study);
    Path left = Files.createDirectory(folder.resolve("spark.csv.unfinished"));
    Files.writeString(left.resolve("0-1.rows"), "another\n1,2\n");

    assertThatThrownBy(() -> bySpark(study, plan)).hasMessageContaining("S-181");
  }
}
