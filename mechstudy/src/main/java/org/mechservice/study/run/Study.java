package org.mechservice.study.run;

import com.google.gson.JsonObject;
import java.io.IOException;
import java.nio.file.Path;
import org.mechservice.study.PointEvaluation;

/** Runs a study, or a part of it, and writes its table. */
public final class Study {
  private final StudyPlan plan;
  private final StudyPart part;
  private final OrderedChunks<String> chunks;

  /** How far a study is. */
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
   * How a study ended.
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
    chunks = new OrderedChunks<>(point -> plan.row(point, evaluation.run(plan.values(point))));
  }

  /** Lets {@link #run} return soon, the finished rows in its journal. */
  public void stop() {
    chunks.stop();
  }

  /**
   * Runs the points that no earlier process has finished, and writes the table.
   *
   * @param file the table, .csv; the journal stands beside it
   * @param threads runs at once
   * @throws IOException if a file cannot be written, S-181 if the journal is that of another study
   * @throws InterruptedException if the thread is interrupted
   */
  public Result run(Path file, int threads, Progress progress)
      throws IOException, InterruptedException {
    int from = part.from(plan.points());
    int to = part.to(plan.points());
    StudyStatistics statistics = new StudyStatistics(plan.outputs());
    JsonObject identity = plan.identity().deepCopy();
    identity.addProperty("part", part.toString());
    StudyTable table = new StudyTable(plan.factors().size(), plan.outputs().size());
    Path journalFile = file.resolveSibling(file.getFileName() + ".unfinished");
    try (StudyJournal journal =
        StudyJournal.open(
            journalFile, identity.toString(), line -> table.addTo(statistics, line))) {
      int before = statistics.rows();
      boolean[] ended = {part.isWhole() && plan.stop().ends(statistics)};
      if (!ended[0] && from + before < to) {
        chunks.run(
            from + before,
            to,
            threads,
            (first, rows) -> {
              StringBuilder lines = new StringBuilder();
              for (String row : rows) {
                if (!ended[0]) {
                  lines.append(row);
                  table.addTo(statistics, row.substring(0, row.length() - 1));
                  ended[0] = part.isWhole() && plan.stop().ends(statistics);
                }
              }
              journal.append(lines.toString());
              progress.at(statistics.rows(), before, to - from);
              return !ended[0];
            });
      }
      boolean complete = ended[0] || statistics.rows() == to - from;
      if (complete) {
        StudyTable.write(
            file,
            plan.header(),
            StudyTable.provenance(plan.identity(), part, statistics),
            journal::rows);
        journal.delete();
      }
      return new Result(statistics, to - from, before, complete, ended[0]);
    }
  }
}
