package org.mechservice.report.page;

import java.util.List;
import java.util.Locale;
import org.mechservice.report.measure.Spectrum;

/** The eigenvalues of a stiff or fast scene, along the run. */
final class SpectrumTable {
  private static final int ROWS = 5;

  private SpectrumTable() {}

  static String of(Spectrum spectrum) {
    StringBuilder html = new StringBuilder();
    html.append("<section><h2>Eigenvalues along the run</h2>");
    html.append(
        "<p class=\"note\">Of the linearised equations in the independent coordinates. Modes: the"
            + " fastest at the time it is fastest.</p>");
    html.append("<div class=\"two\"><table><tr><th>mode<th>real, 1/s<th>imaginary, rad/s");
    html.append("<th>damping ratio<th>joint");
    List<Spectrum.Mode> modes = fastest(spectrum).modes();
    for (int i = 0; i < Math.min(ROWS, modes.size()); i++) {
      Spectrum.Mode mode = modes.get(i);
      html.append(
          String.format(
              Locale.ROOT,
              "<tr><td>%d<td>%s<td>%s<td>%s<td>%s",
              i + 1,
              Html.number(mode.real()),
              mode.imaginary() == 0 ? "0" : "± " + Html.number(mode.imaginary()),
              Html.number(mode.damping()),
              Html.escape(mode.joint())));
    }
    html.append("</table><table><tr><th>t, s<th>fastest decay, 1/s<th>highest frequency, rad/s");
    for (Spectrum.Sample sample : spectrum.samples()) {
      html.append(
          String.format(
              Locale.ROOT,
              "<tr><td>%s<td>%s<td>%s",
              Html.number(sample.time()),
              Html.number(
                  -sample.modes().stream().mapToDouble(Spectrum.Mode::real).min().orElse(0)),
              Html.number(
                  sample.modes().stream().mapToDouble(Spectrum.Mode::imaginary).max().orElse(0))));
    }
    return html.append("</table></div></section>").toString();
  }

  private static Spectrum.Sample fastest(Spectrum spectrum) {
    return spectrum.samples().stream()
        .max((a, b) -> Double.compare(a.modes().get(0).modulus(), b.modes().get(0).modulus()))
        .orElseThrow();
  }
}
