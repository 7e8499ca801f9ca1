package org.mechservice.benchmarks.paper;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.OptionalDouble;
import java.util.function.ToDoubleFunction;
import org.mechservice.report.Machine;
import org.mechservice.report.page.PageFrame;

/** The paper's tables with our figures beside its own. */
final class PaperPage {
  private static final int EQUAL_ERRORS = 2;

  private PaperPage() {}

  static String of(
      Map<PaperFigures.Scene, Map<String, Double>> setUp,
      Map<PaperFigures.Scene, PaperReport.RunPair> runs,
      List<PaperReport.DampingPoint> sweep) {
    String content =
        "<h1>The paper's tables, measured again</h1><p class=\"sub\">Rodríguez et al., Multibody"
            + " System Dynamics 10 (2003): Pentium II and III at 400 to 500 MHz, JDK 1.2.2. Sizes"
            + " compare directly; times tell a shape.</p>"
            + shape(runs, sweep)
            + tableOne(setUp)
            + tableTwo(runs)
            + crossover(sweep)
            + "<p class=\"note\">"
            + String.join(" · ", Machine.facts())
            + " · DTR with DE against RR-JF with ode15sR, relative tolerance 1e-5, absolute 1e-7;"
            + " processor time, median of 11 runs, in turns, after as many as it takes until they"
            + " get no faster. RR-JF runs in compact form where the service generates no code for"
            + " it.</p>";
    return PageFrame.of("The paper's tables, measured again", content);
  }

  private static String shape(
      Map<PaperFigures.Scene, PaperReport.RunPair> runs, List<PaperReport.DampingPoint> sweep) {
    double free = gain(Objects.requireNonNull(runs.get(PaperFigures.Scene.DRIVER)));
    PaperReport.RunPair stiff = Objects.requireNonNull(runs.get(PaperFigures.Scene.DAMPED_DRIVER));
    double damped = gain(stiff);
    StringBuilder html = new StringBuilder("<section class=\"advice\"><h2>The shape</h2>");
    html.append(
        format(
            "<p>Driver without damping: the <b>%s</b> method wins by %.2f× (paper, Java: explicit,"
                + " 2.0×; C++: explicit, 1.4×).</p>",
            free < 1 ? "explicit" : "implicit", Math.max(free, 1 / free)));
    html.append(
        format(
            "<p>Driver with C = K/100: the <b>%s</b> method wins by %.1f× in time (paper, Java:"
                + " implicit, 25×; C++: implicit, 32×) and by %.1f× in evaluations of the forces"
                + " (%d against %d).</p>",
            damped < 1 ? "explicit" : "implicit",
            Math.max(damped, 1 / damped),
            ratio(stiff.explicit().run().evaluations(), stiff.implicit().run().evaluations()),
            stiff.explicit().run().evaluations(),
            stiff.implicit().run().evaluations()));
    for (int i = 0; i < EQUAL_ERRORS; i++) {
      EqualErrors.Ratio judged = stiff.equalErrors().get(0).ratios().get(i);
      EqualErrors.Ratio tighter = stiff.equalErrors().get(1).ratios().get(i);
      html.append(
          format(
              "<p>Driver with C = K/100 at equal error %s: the implicit method needs <b>%s</b>"
                  + " times fewer evaluations of the forces and <b>%s</b> times less time (paper:"
                  + " 25 times less time at one tolerance); %s and %s times with absolute"
                  + " tolerances of a hundredth of the relative ones.</p>",
              power(judged.error()),
              known(judged.evaluations()),
              known(judged.seconds()),
              known(tighter.evaluations()),
              known(tighter.seconds())));
    }
    html.append("<p>").append(crossoverSentence(sweep)).append("</p>");
    return html.append("</section>").toString();
  }

  private static double ratio(long a, long b) {
    return (double) a / (double) b;
  }

  /** Explicit time over implicit time: above 1 the implicit method wins. */
  private static double gain(PaperReport.RunPair runs) {
    return runs.explicit().seconds() / runs.implicit().seconds();
  }

  private static String crossoverSentence(List<PaperReport.DampingPoint> sweep) {
    OptionalDouble inTime = crossoverDamping(sweep, PaperPage::gain);
    OptionalDouble inEvaluations = crossoverDamping(sweep, PaperPage::fewer);
    String where =
        inTime.isPresent()
            ? format(
                "Between them: from a damping of <b>C/K = %.2g s</b> on the implicit method is the"
                    + " faster one",
                inTime.getAsDouble())
            : "Within the dampings looked at, one method is the faster one throughout";
    String counted =
        inEvaluations.isPresent()
            ? format(
                "; from %.2g s on it needs fewer evaluations of the forces",
                inEvaluations.getAsDouble())
            : "";
    return where + counted + " (driver with joint springs alone, 0.25 s).";
  }

  /** Explicit over implicit evaluations. */
  private static double fewer(PaperReport.RunPair runs) {
    return ratio(runs.explicit().run().evaluations(), runs.implicit().run().evaluations());
  }

  /** Returns where the costs cross, interpolated in logarithms. */
  static OptionalDouble crossoverDamping(
      List<PaperReport.DampingPoint> sweep, ToDoubleFunction<PaperReport.RunPair> gain) {
    for (int i = 1; i < sweep.size(); i++) {
      double before = Math.log(gain.applyAsDouble(sweep.get(i - 1).runs()));
      double after = Math.log(gain.applyAsDouble(sweep.get(i).runs()));
      if (before < 0 && after >= 0) {
        double from = Math.log(Math.max(sweep.get(i - 1).ratio(), sweep.get(i).ratio() / 10));
        double to = Math.log(sweep.get(i).ratio());
        return OptionalDouble.of(Math.exp(from + (to - from) * before / (before - after)));
      }
    }
    return OptionalDouble.empty();
  }

  private static String tableOne(Map<PaperFigures.Scene, Map<String, Double>> setUp) {
    StringBuilder html = new StringBuilder("<section><h2>Table I: sizes and set-up times</h2>");
    html.append("<table><tr><th>");
    setUp.keySet().forEach(scene -> html.append("<th>").append(scene.label).append("<th>paper"));
    for (PaperFigures.SetUpLine line : PaperFigures.TABLE_I) {
      html.append("<tr><td>").append(line.label()).append(", ").append(line.unit());
      int column = 0;
      for (Map<String, Double> figures : setUp.values()) {
        double ours = figures.getOrDefault(line.key(), Double.NaN);
        boolean size = line.unit().equals("kB");
        html.append("<td><b>");
        html.append(
            Double.isNaN(ours) ? "–" : format(size ? "%.1f" : "%.4f", size ? ours / 1000 : ours));
        html.append("</b><td>").append(printed(line.paper().get(column++), size ? 1 : 2));
      }
    }
    html.append("</table><p class=\"note\">Medians of ").append(PaperReport.SET_UPS);
    html.append(" set-ups of a warm service after ").append(PaperReport.WARM_SET_UPS);
    html.append(", each of a model that it has not met; wall-clock times, which other work on the");
    html.append(" machine lengthens. tcc is what writing and loading class files takes; no Java");
    html.append(" compiler runs. The solver's code is fetched once per user.</p></section>");
    return html.toString();
  }

  /** A figure of the paper with the digits it was printed with. */
  private static String printed(double figure, int decimals) {
    return String.format(Locale.ROOT, "%." + decimals + "f", figure);
  }

  private static String tableTwo(Map<PaperFigures.Scene, PaperReport.RunPair> runs) {
    StringBuilder html =
        new StringBuilder("<section><h2>Table II: run times, s</h2><div class=\"wide\"><table>");
    html.append("<tr><th>");
    for (PaperFigures.Scene scene : runs.keySet()) {
      String label = scene == PaperFigures.Scene.DRIVER ? "driver, C = 0" : scene.label;
      html.append("<th colspan=\"2\">").append(label);
    }
    html.append("<tr><th>explicit / implicit");
    runs.keySet().forEach(scene -> html.append("<th>explicit<th>implicit"));
    for (PaperFigures.RunLine line : PaperFigures.TABLE_II) {
      html.append("<tr><td>").append(line.label());
      for (int i = 0; i < line.explicit().size(); i++) {
        html.append("<td>").append(printed(line.explicit().get(i), 2));
        html.append("<td>").append(printed(line.implicit().get(i), 2));
      }
    }
    html.append("<tr><td><b>here, DTR-DE / RR-JF-ode15sR</b>");
    for (PaperReport.RunPair pair : runs.values()) {
      html.append(
          format(
              "<td><b>%.4f</b><td><b>%.4f</b>",
              pair.explicit().seconds(), pair.implicit().seconds()));
    }
    html.append("<tr><td>quartiles about it");
    for (PaperReport.RunPair pair : runs.values()) {
      html.append("<td>").append(quartiles(pair.explicit()));
      html.append("<td>").append(quartiles(pair.implicit()));
    }
    html.append("<tr><td>evaluations");
    for (PaperReport.RunPair pair : runs.values()) {
      html.append(
          format(
              "<td>%d<td>%d",
              pair.explicit().run().evaluations(), pair.implicit().run().evaluations()));
    }
    html.append("<tr><td>error");
    for (PaperReport.RunPair pair : runs.values()) {
      html.append("<td>").append(error(pair.explicit()));
      html.append("<td>").append(error(pair.implicit()));
    }
    html.append("</table><table><tr><th>explicit ÷ implicit at equal error");
    for (PaperFigures.Scene scene : runs.keySet()) {
      html.append("<th>").append(scene.label).append(": evaluations<th>time");
    }
    for (int i = 0; i < EQUAL_ERRORS; i++) {
      html.append(equalErrorRow(runs, 0, i)).append(equalErrorRow(runs, 1, i));
    }
    return html.append("</table></div><p class=\"note\">Errors are |x − x<sub>ref</sub>| / (1 +")
        .append(" |x<sub>ref</sub>|), the largest of all output times. With absolute tolerances as")
        .append(" large as the relative ones (atol = rtol, SI) a run weighs its errors as they are")
        .append(" judged. –: one of the two does not reach the error.</p></section>")
        .toString();
  }

  private static String equalErrorRow(
      Map<PaperFigures.Scene, PaperReport.RunPair> runs, int weighing, int error) {
    EqualErrors first = runs.values().iterator().next().equalErrors().get(weighing);
    StringBuilder row = new StringBuilder("<tr><td>");
    row.append(power(first.ratios().get(error).error()));
    row.append(
        first.absolutePart() == EqualErrors.AS_JUDGED
            ? ", atol = rtol"
            : format(", atol = rtol / %.0f", 1 / first.absolutePart()));
    for (PaperReport.RunPair pair : runs.values()) {
      EqualErrors.Ratio ratio = pair.equalErrors().get(weighing).ratios().get(error);
      row.append("<td>").append(known(ratio.evaluations()));
      row.append("<td>").append(known(ratio.seconds()));
    }
    return row.toString();
  }

  private static String quartiles(PaperReport.Timed timed) {
    double median = timed.seconds();
    return format(
        "%+.0f … %+.0f %%", 100 * (timed.low() / median - 1), 100 * (timed.high() / median - 1));
  }

  private static String error(PaperReport.Timed timed) {
    double error = timed.run().errors().largest();
    return Double.isNaN(error) ? "–" : format("%.1e", error);
  }

  private static String known(double ratio) {
    return Double.isNaN(ratio) ? "–" : format("%.1f", ratio);
  }

  private static String power(double error) {
    return format("%.0e", error).replace("e-0", "e-");
  }

  private static String crossover(List<PaperReport.DampingPoint> sweep) {
    StringBuilder html =
        new StringBuilder("<section><h2>Where the implicit method takes over</h2>");
    html.append(
        "<table><tr><th>C/K, s<th>explicit, ms<th>evaluations<th>implicit,"
            + " ms<th>evaluations<th>time ratio");
    for (PaperReport.DampingPoint point : sweep) {
      PaperReport.RunPair pair = point.runs();
      double gain = gain(pair);
      html.append(
          format(
              "<tr><td>%s<td>%.2f<td>%d<td>%.2f<td>%d<td class=\"%s\">%.2f",
              point.ratio() == 0 ? "0" : power(point.ratio()),
              1e3 * pair.explicit().seconds(),
              pair.explicit().run().evaluations(),
              1e3 * pair.implicit().seconds(),
              pair.implicit().run().evaluations(),
              gain > 1 ? "best" : "",
              gain));
    }
    return html.append("</table></section>").toString();
  }

  private static String format(String pattern, Object... values) {
    return String.format(Locale.ROOT, pattern, values);
  }
}
