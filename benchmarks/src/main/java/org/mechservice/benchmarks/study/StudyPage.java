package org.mechservice.benchmarks.study;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.mechservice.report.Machine;
import org.mechservice.report.page.PageFrame;
import org.mechservice.report.page.SolverChart;

/** The page of a study being put together: words first, then diagrams, then tables. */
public final class StudyPage {
  private final String name;
  private final List<String> words = new ArrayList<>();
  private final StringBuilder diagrams = new StringBuilder();
  private final List<Table> tables = new ArrayList<>();
  private final List<String> notes = new ArrayList<>();
  private String title = "";

  StudyPage(String name) {
    this.name = name;
  }

  /** Sets the heading. */
  void title(String text) {
    title = text;
  }

  /** Adds a finding in words, with its numbers. */
  void finds(String pattern, Object... values) {
    words.add(String.format(Locale.ROOT, pattern, values));
  }

  /** Adds a sentence on how it was measured. */
  void notes(String pattern, Object... values) {
    notes.add(String.format(Locale.ROOT, pattern, values));
  }

  /** Adds a diagram. */
  void shows(String heading, SolverChart chart) {
    diagrams.append("<section><h2>").append(PageFrame.escaped(heading)).append("</h2>");
    diagrams.append(chart.html()).append("</section>");
  }

  /** Begins a table, which is a part of the CSV file, too. */
  Table table(String heading, String... columns) {
    Table table = new Table(heading, columns);
    tables.add(table);
    return table;
  }

  /** Rows of text and numbers. */
  static final class Table {
    private final String heading;
    private final String[] columns;
    private final List<Object[]> rows = new ArrayList<>();

    private Table(String heading, String... columns) {
      this.heading = heading;
      this.columns = columns;
    }

    /** Adds a row, a value a column: text, or a number shown with three digits. */
    void row(Object... values) {
      rows.add(values);
    }

    private String html() {
      StringBuilder html = new StringBuilder("<section><h2>");
      html.append(PageFrame.escaped(heading)).append("</h2><div class=\"wide\"><table><tr>");
      for (String column : columns) {
        html.append("<th>").append(PageFrame.escaped(column));
      }
      for (Object[] row : rows) {
        html.append("\n<tr>");
        for (Object value : row) {
          boolean text = value instanceof String words && words.length() > 24;
          html.append(text ? "<td class=\"text\">" : "<td>");
          html.append(PageFrame.escaped(shown(value)));
        }
      }
      return html.append("</table></div></section>").toString();
    }

    private String csv() {
      StringBuilder csv = new StringBuilder("# ").append(heading).append('\n');
      csv.append(String.join(",", columns)).append('\n');
      for (Object[] row : rows) {
        List<String> cells = new ArrayList<>();
        for (Object value : row) {
          String text = String.valueOf(value);
          boolean quoted = text.contains(",") || text.contains("\n");
          cells.add(quoted ? '"' + text.replace('"', '\'').replace('\n', ' ') + '"' : text);
        }
        csv.append(String.join(",", cells)).append('\n');
      }
      return csv.toString();
    }
  }

  /** Returns a value as the pages show it. */
  static String shown(Object value) {
    if (!(value instanceof Double number)) {
      return String.valueOf(value);
    }
    double size = Math.abs(number);
    if (number.isNaN()) {
      return "–";
    } else if (number.isInfinite()) {
      return number > 0 ? "∞" : "−∞";
    } else if (number == 0) {
      return "0";
    }
    boolean plain = size >= 1e-2 && size < 1e5;
    return String.format(
        Locale.ROOT,
        plain ? (size >= 100 ? "%.0f" : size >= 10 ? "%.1f" : "%.3g") : "%.1e",
        number);
  }

  /** Writes page and figures. */
  Path write(Path folder) throws IOException {
    Files.createDirectories(folder);
    StringBuilder html = new StringBuilder();
    html.append("<h1>").append(PageFrame.escaped(title)).append("</h1>");
    html.append("<section class=\"advice\">");
    words.forEach(text -> html.append("<p>").append(PageFrame.escaped(text)).append("</p>"));
    html.append("</section>").append(diagrams);
    StringBuilder csv = new StringBuilder();
    for (Table table : tables) {
      html.append(table.html());
      csv.append(table.csv());
    }
    html.append("<section><h2>How this was measured</h2><ul>");
    notes.forEach(text -> html.append("<li>").append(PageFrame.escaped(text)));
    html.append("<li>").append(PageFrame.escaped(String.join(" · ", Machine.facts())));
    html.append("<li>The figures: <a href=\"").append(name).append(".csv\">");
    html.append(name).append(".csv</a></ul></section>");
    Files.writeString(folder.resolve(name + ".csv"), csv.toString(), StandardCharsets.UTF_8);
    Path page = folder.resolve(name + ".html");
    Files.writeString(page, PageFrame.of(title, html.toString()), StandardCharsets.UTF_8);
    return page;
  }
}
