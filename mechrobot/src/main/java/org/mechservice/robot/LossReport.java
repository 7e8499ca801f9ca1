package org.mechservice.robot;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.mechservice.mechml.diagnosis.Diagnostic;

/**
 * What an import has left out, for a reader: one line with the counts, then the losses. Equal
 * losses of several elements are one line.
 */
public final class LossReport {
  private final String file;
  private final List<Diagnostic> losses;
  private final Map<LossGrade, Long> counts = new EnumMap<>(LossGrade.class);

  /**
   * @param file name of the robot's file
   * @param losses what is left out, in file order
   */
  public LossReport(String file, List<Diagnostic> losses) {
    this.file = file;
    this.losses = List.copyOf(losses);
    for (LossGrade grade : LossGrade.values()) {
      counts.put(grade, losses.stream().filter(one -> one.code() == grade.code()).count());
    }
  }

  /** Returns the number of losses of a grade. */
  public long count(LossGrade grade) {
    return counts.getOrDefault(grade, 0L);
  }

  /**
   * Returns the lines: a summary, then the losses.
   *
   * @param all whether to list all of them; otherwise those that change the motion
   */
  public List<String> lines(boolean all) {
    if (losses.isEmpty()) {
      return List.of();
    }
    List<String> grades = new ArrayList<>();
    for (LossGrade grade : LossGrade.values()) {
      if (count(grade) > 0) {
        grades.add(grade.counted(count(grade)));
      }
    }
    long unlisted = count(LossGrade.CONTACT) + count(LossGrade.PICTURE);
    List<String> lines = new ArrayList<>();
    lines.add(
        file
            + ": left out: "
            + String.join(", ", grades)
            + (all || unlisted == 0 ? "" : " (--losses all lists them)"));
    for (LossGrade grade : all ? LossGrade.values() : new LossGrade[] {LossGrade.MOTION}) {
      lines.addAll(of(grade));
    }
    return lines;
  }

  private List<String> of(LossGrade grade) {
    Map<String, List<Diagnostic>> alike = new LinkedHashMap<>();
    for (Diagnostic loss : losses) {
      if (loss.code() == grade.code()) {
        alike.computeIfAbsent(sentence(loss.message()), key -> new ArrayList<>()).add(loss);
      }
    }
    return alike.values().stream()
        .map(
            same ->
                same.get(0)
                    + (same.size() == 1 ? "" : " (" + (same.size() - 1) + " more of the same)"))
        .toList();
  }

  /** Returns a message without the names of the elements around, which may hold colons. */
  private static String sentence(String message) {
    return message.replaceAll("\"(?:[^\"\\\\]|\\\\.)*\": ", ": ");
  }
}
