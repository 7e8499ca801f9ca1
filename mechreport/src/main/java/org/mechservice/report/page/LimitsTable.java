package org.mechservice.report.page;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.mechservice.report.measure.Point;
import org.mechservice.report.measure.SceneFindings;
import org.mechservice.report.method.SimulationMethod;

/** Which joints had steps rejected, and with which methods. */
final class LimitsTable {
  private static final int MOST_JOINTS = 8;

  /** Smallest fraction of rejected steps for the table. */
  private static final double WORTH_TELLING = 0.01;

  private final Map<String, Map<String, Long>> byMethod = new LinkedHashMap<>();
  private final Map<String, Long> byJoint = new LinkedHashMap<>();

  LimitsTable(SceneFindings found) {
    long attempts = 0;
    for (SimulationMethod method : found.methods()) {
      Map<String, Long> joints = new LinkedHashMap<>();
      for (Point point : found.pointsOf(method.name())) {
        point.first().limits().forEach((joint, count) -> joints.merge(joint, count, Long::sum));
        attempts += point.first().steps() + point.first().rejected();
      }
      joints.forEach((joint, count) -> byJoint.merge(joint, count, Long::sum));
      byMethod.put(method.name(), joints);
    }
    if (total() < WORTH_TELLING * attempts) {
      byJoint.clear();
    }
  }

  private long total() {
    return byJoint.values().stream().mapToLong(count -> count).sum();
  }

  private List<String> joints() {
    List<String> joints = new ArrayList<>(byJoint.keySet());
    joints.sort(Comparator.comparingLong((String joint) -> -byJoint.getOrDefault(joint, 0L)));
    return joints.subList(0, Math.min(MOST_JOINTS, joints.size()));
  }

  /** Returns the table; empty if no joint limited the steps. */
  String html() {
    List<String> joints = joints();
    if (joints.isEmpty()) {
      return "";
    }
    String most = joints.get(0);
    StringBuilder html = new StringBuilder("<section><h2>Which joints limited the step</h2>");
    html.append("<p class=\"note\">Joint <b>").append(Html.escape(most)).append("</b> had ");
    html.append(Html.digits(100.0 * byJoint.getOrDefault(most, 0L) / total()));
    html.append(" % of the rejected steps whose joint is known. Steps rejected at all tolerances");
    html.append(" together, because of the error or the equations of a joint's states.</p>");
    html.append("<div class=\"wide\"><table><tr><th>method");
    joints.forEach(joint -> html.append("<th>").append(Html.escape(joint)));
    html.append(byJoint.size() > MOST_JOINTS ? "<th>others" : "");
    byMethod.forEach((method, counts) -> html.append(row(method, joints, counts)));
    return html.append("</table></div></section>").toString();
  }

  private String row(String method, List<String> joints, Map<String, Long> counts) {
    StringBuilder row = new StringBuilder("<tr><td>").append(Html.escape(method));
    long largest = counts.values().stream().mapToLong(count -> count).max().orElse(0);
    long shown = 0;
    for (String joint : joints) {
      long count = counts.getOrDefault(joint, 0L);
      shown += count;
      String css = count == 0 ? "none" : count == largest ? "good" : "";
      row.append("<td class=\"").append(css).append("\">").append(count);
    }
    if (byJoint.size() > MOST_JOINTS) {
      long all = counts.values().stream().mapToLong(count -> count).sum();
      row.append("<td>").append(all - shown);
    }
    return row.toString();
  }
}
