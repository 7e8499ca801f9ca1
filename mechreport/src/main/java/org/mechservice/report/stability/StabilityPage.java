package org.mechservice.report.stability;

import java.util.List;
import java.util.Locale;
import org.mechservice.report.Machine;
import org.mechservice.report.page.PageFrame;

/** The page of the suite: each case with its bound, its outcome, and which method failed how. */
final class StabilityPage {
  private StabilityPage() {}

  /** Returns the page, with a sentence on when runs were stopped. */
  static String of(List<CaseOutcome> outcomes, String stopped) {
    StringBuilder html = new StringBuilder();
    html.append("<h1>Stiff, singular, huge, tiny</h1>");
    html.append(summary(outcomes));
    html.append("<section><h2>Cases</h2><table><tr><th>case<th>outcome<th>judged by<th>bound");
    html.append("<th>worst<th>methods that meet it<th>fewest steps");
    outcomes.forEach(outcome -> html.append(line(outcome)));
    html.append("</table></section><section><h2>Method by method</h2>");
    html.append("<p class=\"note\">Steps, and in brackets how many times the fewest.</p>");
    outcomes.stream().filter(o -> !o.methods().isEmpty()).forEach(o -> html.append(detail(o)));
    html.append(
        format(
            "</section><p class=\"note\">%s Error: the largest |x −"
                + " x<sub>ref</sub>| / (1 + |x<sub>ref</sub>|) in SI units; energy: the largest"
                + " change, work deducted, as a part of its scale. A case is judged as far as its"
                + " reference is known to a thousandth of the bound. %s</p>",
            stopped, String.join(" · ", Machine.facts())));
    return PageFrame.of("Stiff, singular, huge, tiny", html.toString());
  }

  private static String summary(List<CaseOutcome> outcomes) {
    long good = outcomes.stream().filter(CaseOutcome::asExpected).count();
    long wrong = count(outcomes, MethodOutcome.Verdict.SILENTLY_WRONG);
    long anonymous = count(outcomes, MethodOutcome.Verdict.ANONYMOUS);
    long runs = outcomes.stream().mapToLong(outcome -> outcome.methods().size()).sum();
    return format(
        "<section class=\"advice\"><p><b>%d of %d cases end as expected.</b> Of %d runs, %d met"
            + " their bound, %d ended with a message that says why, %d were stopped when their time"
            + " was over, %d ended well and missed the bound, %d ended without a"
            + " message.</p></section>",
        good,
        outcomes.size(),
        runs,
        count(outcomes, MethodOutcome.Verdict.MET),
        count(outcomes, MethodOutcome.Verdict.SAID_WHY),
        count(outcomes, MethodOutcome.Verdict.TOO_LONG),
        wrong,
        anonymous);
  }

  private static long count(List<CaseOutcome> outcomes, MethodOutcome.Verdict verdict) {
    return outcomes.stream().mapToLong(outcome -> outcome.count(verdict)).sum();
  }

  private static String line(CaseOutcome outcome) {
    ExtremeCase wanted = outcome.wanted();
    boolean moves = wanted.judge() != ExtremeCase.JudgedBy.MESSAGE;
    double worst =
        outcome.methods().stream()
            .mapToDouble(MethodOutcome::measured)
            .filter(value -> !Double.isNaN(value))
            .max()
            .orElse(Double.NaN);
    String verdict =
        outcome.asExpected()
            ? "<td class=\"best\">as expected"
            : "<td class=\"flag\">not as expected";
    String said =
        outcome.refusal().isEmpty()
            ? ""
            : "<br><span class=\"note\">" + escape(shortened(outcome.refusal())) + "</span>";
    return format(
        "\n"
            + "<tr><td class=\"text\"><b>%s</b><br><span"
            + " class=\"note\">%s</span>%s%s<td>%s<td>%s<td>%s<td>%d of %d<td>%s",
        escape(wanted.name()),
        escape(wanted.hard()),
        said,
        verdict,
        wanted.judge().name().toLowerCase(Locale.ROOT),
        moves ? format("%.0e", wanted.bound()) : "–",
        figure(worst),
        outcome.count(MethodOutcome.Verdict.MET),
        outcome.methods().size(),
        outcome.fewestSteps() == 0 ? "–" : Long.toString(outcome.fewestSteps()));
  }

  private static String detail(CaseOutcome outcome) {
    StringBuilder html = new StringBuilder();
    html.append("<details").append(outcome.asExpected() ? "" : " open");
    html.append("><summary>").append(escape(outcome.wanted().name())).append("</summary>");
    if (!outcome.judge().isEmpty()) {
      html.append("<p class=\"note\">").append(escape(outcome.judge())).append("</p>");
    }
    outcome
        .warnings()
        .forEach(said -> html.append("<p class=\"note\">").append(escape(said)).append("</p>"));
    html.append("<table><tr><th>method<th>outcome<th>measured<th>energy<th>steps<th>rejected");
    html.append("<th>evaluations");
    for (MethodOutcome method : outcome.methods()) {
      html.append(row(method, outcome.fewestSteps()));
    }
    return html.append("</table></details>").toString();
  }

  private static String row(MethodOutcome outcome, long fewest) {
    String name = escape(outcome.method().name());
    var run = outcome.run();
    if (!run.completed()) {
      boolean bad = outcome.verdict() == MethodOutcome.Verdict.ANONYMOUS;
      return format(
          "\n<tr><td>%s<td class=\"text %s\" colspan=\"3\">%s<td>%d<td>%d<td>%d",
          name,
          bad ? "flag" : "",
          escape(shortened(run.cause())),
          run.steps(),
          run.rejected(),
          run.evaluations());
    }
    String times = fewest > 0 ? format(" (%.1f×)", (double) run.steps() / (double) fewest) : "";
    return format(
        "\n<tr><td>%s<td class=\"%s\">%s<td>%s<td>%s<td>%d%s<td>%d<td>%d",
        name,
        outcome.verdict() == MethodOutcome.Verdict.MET ? "good" : "flag",
        outcome.verdict().name().toLowerCase(Locale.ROOT).replace('_', ' '),
        figure(outcome.measured()),
        figure(run.energyDrift()),
        run.steps(),
        times,
        run.rejected(),
        run.evaluations());
  }

  private static String figure(double value) {
    return Double.isNaN(value) ? "–" : format("%.1e", value);
  }

  private static String shortened(String text) {
    return text.length() > 260 ? text.substring(0, 257) + "…" : text;
  }

  private static String escape(String text) {
    return PageFrame.escaped(text);
  }

  private static String format(String pattern, Object... values) {
    return String.format(Locale.ROOT, pattern, values);
  }
}
