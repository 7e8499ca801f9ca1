package org.mechservice.study.run;

import java.io.IOException;
import java.nio.file.Path;
import org.mechservice.study.PointEvaluation;

/** Runs a study, or a part of it, and writes its table. */
public final class Study {
  private final StudyPlan plan;
  private final StudyPart part;
  private final OrderedChunks<StudyRows.Row> chunks;

  /** Receives the progress of a study. */
  public interface Progress {
    /**
     * Is told after each chunk.
     *
     * @param done points that are finished, with those of an earlier process
     * @param before those of an earlier process
     * @param all points of the study or its part
     */
    void at(int done, int before, int all);
  }

  /**
   * The result of a study.
   *
   * @param statistics over the finished points
   * @param points number of points of the study or its part
   * @param before points that an earlier process had finished
   * @param complete whether the table is written; else the journal has the rows
   * @param endedByRule whether the stop rule ended it
   */
  public record Result(
      StudyStatistics statistics, int points, int before, boolean complete, boolean endedByRule) {}

  /**
   * @param evaluation runs the points, {@link StudyPlan#model} or hosts
   */
  public Study(StudyPlan plan, StudyPart part, PointEvaluation evaluation) {
    this.plan = plan;
    this.part = part;
    chunks = new OrderedChunks<>(point -> StudyRows.computed(plan, point, evaluation));
  }

  /** Returns the file beside a table that has its rows until it is complete. */
  public static Path journal(Path table) {
    return table.resolveSibling(table.getFileName() + ".unfinished");
  }

  /** Makes {@link #run} return soon, with the finished rows in its journal. */
  public void stop() {
    chunks.stop();
  }

  /**
   * Runs the points that no earlier process has finished, and writes the table.
   *
   * @param file the table, .csv or .parquet; the journal stands beside it
   * @param threads runs at once
   * @throws IOException if a file cannot be written, S-181 if the journal is that of another study
   * @throws InterruptedException if the thread is interrupted
   */
  public Result run(Path file, int threads, Progress progress)
      throws IOException, InterruptedException {
    StudyRows rows = new StudyRows(plan, part);
    int all = rows.to() - rows.from();
    try (StudyJournal journal = StudyJournal.open(journal(file), rows.identity(), rows::take)) {
      int before = rows.taken();
      if (!rows.isComplete()) {
        chunks.run(
            rows.from() + before,
            rows.to(),
            threads,
            (first, computed) -> {
              StringBuilder lines = new StringBuilder();
              for (StudyRows.Row row : computed) {
                if (!rows.isEndedByRule()) {
                  lines.append(row.line());
                  rows.take(row);
                }
              }
              journal.append(lines.toString());
              progress.at(rows.taken(), before, all);
              return !rows.isEndedByRule();
            });
      }
      if (rows.isComplete()) {
        rows.table().write(file, rows.header(), rows.provenance(), journal::rows);
        journal.delete();
      }
      return new Result(rows.statistics(), all, before, rows.isComplete(), rows.isEndedByRule());
    }
  }
}
