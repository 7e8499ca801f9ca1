package org.mechservice.study.run;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import java.io.IOException;
import java.io.OutputStream;
import java.util.List;
import org.mechservice.study.PointEvaluation;
import org.mechservice.study.PointOutcome;

/**
 * The table of a study, or of a part of it, as it arises: the lines taken so far in the order of
 * the points, what they say, and whether the stop rule ends it.
 *
 * <p>Lines may be computed anywhere ({@link #line}): they depend on the plan and the point only.
 * Where they are taken decides nothing but the moment of the end.
 */
public final class StudyRows {
  private final StudyPlan plan;
  private final StudyPart part;
  private final StudyTable table;
  private final StudyStatistics statistics;
  private boolean ended;

  public StudyRows(StudyPlan plan, StudyPart part) {
    this.plan = plan;
    this.part = part;
    table = new StudyTable(plan.factors().size(), plan.outputs().size());
    statistics =
        new StudyStatistics(
            plan.outputs(), part.isWhole() ? factorsOfIndices(plan.identity()) : List.of());
  }

  /** Returns the factors of a study whose design is one of indices; empty for others. */
  static List<String> factorsOfIndices(JsonObject identity) {
    JsonArray design = identity.getAsJsonArray("design");
    boolean isOfIndices =
        !design.isEmpty()
            && design.get(0).getAsJsonObject().get("kind").getAsString().strip().equals("indices");
    return isOfIndices ? List.copyOf(identity.getAsJsonObject("units").keySet()) : List.of();
  }

  /** Returns what the lines depend on, as one line: equal for equal bytes. */
  public String identity() {
    JsonObject identity = plan.identity().deepCopy();
    identity.addProperty("part", part.toString());
    return identity.toString();
  }

  /** Returns the first point, from 0. */
  public int from() {
    return part.from(plan.points());
  }

  /** Returns the point after the last. */
  public int to() {
    return part.to(plan.points());
  }

  /** Returns the first line of the table, with its line break. */
  public String header() {
    return plan.header();
  }

  /**
   * Runs a point.
   *
   * @return its line, with its line break
   * @throws IOException if the point could not be run for reasons of its surroundings
   */
  public static String line(StudyPlan plan, int point, PointEvaluation evaluation)
      throws IOException {
    return computed(plan, point, evaluation).line();
  }

  /**
   * A row that was computed here.
   *
   * @param line its line, with its line break
   * @param failed whether the point has failed
   * @param values the numbers in the cells of the outputs, NaN for empty ones
   */
  @SuppressWarnings("ArrayRecordComponent") // never compared
  record Row(String line, boolean failed, double[] values) {}

  /** Runs a point. */
  static Row computed(StudyPlan plan, int point, PointEvaluation evaluation) throws IOException {
    double[] values = plan.design().point(point);
    PointOutcome outcome = evaluation.run(plan.values(values));
    double[] shown = plan.shown(outcome);
    return new Row(
        plan.row(point, values, outcome, shown), outcome instanceof PointOutcome.Failed, shown);
  }

  /**
   * Takes the line of the next point.
   *
   * @param line without its line break
   */
  public void take(String line) {
    table.addTo(statistics, line);
    judge();
  }

  /** Takes the row of the next point: the shortest decimals in its line are its numbers. */
  void take(Row row) {
    statistics.add(row.failed, row.values);
    judge();
  }

  private void judge() {
    ended = ended || (part.isWhole() && plan.stop().ends(statistics));
  }

  /** Returns how many lines were taken. */
  public int taken() {
    return statistics.rows();
  }

  /** Returns whether the stop rule has ended the study. */
  public boolean isEndedByRule() {
    return ended;
  }

  /** Returns whether no line is missing. */
  public boolean isComplete() {
    return ended || taken() == to() - from();
  }

  StudyTable table() {
    return table;
  }

  /**
   * Writes the table in Parquet.
   *
   * @param lines hands out the lines that were taken
   * @throws IOException if it cannot be written
   */
  public void writeParquet(OutputStream out, Lines lines) throws IOException {
    table.writeParquet(out, header(), provenance(), row -> lines.each(row::take));
  }

  /** Lines of the table, once more. */
  public interface Lines {
    /** Hands out all lines without their line breaks, in the order of the points. */
    void each(LineReader reader) throws IOException;
  }

  /** Receives lines. */
  public interface LineReader {
    /** Takes a line without its line break. */
    void take(String line) throws IOException;
  }

  public StudyStatistics statistics() {
    return statistics;
  }

  /** Returns what the file beside the table says: identity, counts and statistics, as JSON. */
  public String provenance() {
    return StudyTable.text(StudyTable.provenance(plan.identity(), part, statistics));
  }
}
