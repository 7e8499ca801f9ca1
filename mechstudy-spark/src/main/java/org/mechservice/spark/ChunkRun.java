package org.mechservice.spark;

import java.io.IOException;
import org.apache.spark.api.java.function.Function;
import org.apache.spark.broadcast.Broadcast;
import org.apache.spark.util.SerializableConfiguration;
import org.mechservice.study.run.StudyFiles;
import org.mechservice.study.run.StudyPlan;
import org.mechservice.study.run.StudyRows;

/** The task of an executor: runs the points of a chunk and writes their rows to a file. */
final class ChunkRun implements Function<Chunk, ChunkRun.Speed> {
  private static final long serialVersionUID = 1L;

  private final Broadcast<StudyFiles> study;
  private final Broadcast<SerializableConfiguration> hadoop;
  private final String folder;

  /**
   * The speed of a chunk.
   *
   * @param points how many were run
   * @param seconds how long they took
   */
  record Speed(int points, double seconds) implements java.io.Serializable {}

  /**
   * @param hadoop configuration of the job's file system
   * @param folder of the files of rows, with the scheme of its file system
   */
  ChunkRun(
      Broadcast<StudyFiles> study, Broadcast<SerializableConfiguration> hadoop, String folder) {
    this.study = study;
    this.hadoop = hadoop;
    this.folder = folder;
  }

  @Override
  public Speed call(Chunk chunk) throws IOException {
    StudyFiles files = study.value();
    StudyPlan plan = ExecutorPlan.of(files);
    long begun = System.nanoTime();
    StringBuilder lines = new StringBuilder();
    for (int point = chunk.first(); point < chunk.end(); point++) {
      lines.append(StudyRows.line(plan, point, plan.model()));
    }
    double seconds = (System.nanoTime() - begun) * 1e-9;
    try (RowFiles rows = new RowFiles(folder, hadoop.value().value(), files.identity())) {
      rows.write(chunk, lines.toString());
    }
    return new Speed(chunk.size(), seconds);
  }
}
