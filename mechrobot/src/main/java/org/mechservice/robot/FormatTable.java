package org.mechservice.robot;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Collection;
import java.util.EnumMap;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.NearestName;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.diagnosis.Quoted;
import org.mechservice.mechml.document.Attribute;
import org.mechservice.mechml.document.Element;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * The closed world of a format: every element and attribute of its published schema with what the
 * import does with it. The tables are the resources {@code mjcf.table}, {@code sdf.table} and
 * {@code urdf.table}; the first one explains their form.
 *
 * <p>No name passes that is not in the table: MuJoCo refuses such a file, and so does the import;
 * the programs that read URDF and SDF pass over unknown names, and here they are losses of the
 * first grade, because nobody knows what they would have meant.
 */
final class FormatTable {
  private static final Pattern ELEMENT = Pattern.compile("(\\S*) ?/ (\\S+) = (.+)");
  private static final Pattern VALUES = Pattern.compile("\"([^\"]*)\"|(\\S+)");
  private static final String ANY = "*";
  private static final Map<RobotFormat, FormatTable> TABLES = new EnumMap<>(RobotFormat.class);

  /** What the import does with an element or attribute. */
  private enum Verdict {
    READ(Optional.empty()),
    HARMLESS(Optional.empty()),
    MOTION(Optional.of(LossGrade.MOTION)),
    CONTACT(Optional.of(LossGrade.CONTACT)),
    PICTURE(Optional.of(LossGrade.PICTURE));

    private final Optional<LossGrade> grade;

    Verdict(Optional<LossGrade> grade) {
      this.grade = grade;
    }
  }

  /**
   * A line of the table.
   *
   * @param harmless values that say nothing
   * @param words what it is, for messages; may be empty
   */
  private record Entry(Verdict verdict, List<String> harmless, String words) {
    private static final Pattern FORM =
        Pattern.compile("(\\w+)(?: unless (.*?))?(?:: (.*))?", Pattern.DOTALL);

    static Entry of(String text) {
      Matcher found = FORM.matcher(text.strip());
      if (!found.matches()) {
        throw new IllegalStateException("no entry of a table of a format: " + text);
      }
      List<String> values = new ArrayList<>();
      Matcher value = VALUES.matcher(Objects.requireNonNullElse(found.group(2), ""));
      while (value.find()) {
        values.add(Objects.requireNonNullElse(value.group(1), Objects.toString(value.group(2))));
      }
      return new Entry(
          Verdict.valueOf(found.group(1).toUpperCase(Locale.ROOT)),
          values,
          Objects.requireNonNullElse(found.group(3), ""));
    }

    Optional<LossGrade> gradeOf(String value) {
      return verdict.grade.filter(grade -> !harmless.contains(value.strip()));
    }

    String sentence(String subject) {
      return subject + "left out" + (words.isEmpty() ? "" : ": " + words);
    }
  }

  /** An element with its attributes. */
  private record Row(Entry own, Map<String, Entry> attributes) {}

  private final RobotFormat format;
  private final Map<String, Row> rows = new HashMap<>();
  private final Map<String, TreeSet<String>> children = new HashMap<>();

  private FormatTable(RobotFormat format, List<String> lines) {
    this.format = format;
    List<Row> open = new ArrayList<>();
    for (String line : lines) {
      if (line.isBlank() || line.startsWith("#")) {
        continue;
      }
      if (line.startsWith(" ")) {
        int bar = line.indexOf('|');
        int colon = line.indexOf(": ", bar);
        String names = line.substring(bar + 1, colon < 0 ? line.length() : colon);
        Entry entry =
            Entry.of(line.substring(0, bar).strip() + (colon < 0 ? "" : line.substring(colon)));
        for (String name : names.strip().split(" ", -1)) {
          open.forEach(row -> row.attributes.put(name, entry));
        }
        continue;
      }
      Matcher found = ELEMENT.matcher(line);
      if (!found.matches()) {
        throw new IllegalStateException("no line of a table of a format: " + line);
      }
      open.clear();
      for (String parent : found.group(1).split(",", -1)) {
        for (String name : found.group(2).split(",", -1)) {
          Row row = new Row(Entry.of(found.group(3)), new LinkedHashMap<>());
          rows.put(parent + "/" + name, row);
          children.computeIfAbsent(parent, key -> new TreeSet<>()).add(name);
          open.add(row);
        }
      }
    }
  }

  /** Returns the table of a format. */
  static synchronized FormatTable of(RobotFormat format) {
    return TABLES.computeIfAbsent(format, one -> new FormatTable(one, lines(one)));
  }

  private static List<String> lines(RobotFormat format) {
    String name = format.title().toLowerCase(Locale.ROOT) + ".table";
    try (InputStream in =
        Objects.requireNonNull(FormatTable.class.getResourceAsStream(name), name)) {
      return new String(in.readAllBytes(), StandardCharsets.UTF_8).lines().toList();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Returns whether the table has an element. */
  boolean knows(String parent, String name) {
    return row(parent, name).isPresent();
  }

  /** Returns whether the import looks into an element. */
  boolean looksInto(String parent, String name) {
    return row(parent, name).filter(row -> row.own.verdict == Verdict.READ).isPresent();
  }

  /** Returns whether the table has an attribute, or the element is not looked into. */
  boolean knows(String parent, String name, String attribute) {
    return row(parent, name)
        .filter(row -> row.own.verdict != Verdict.READ || row.attributes.containsKey(attribute))
        .isPresent();
  }

  /**
   * Reports names that the table lacks: errors in MJCF, losses of the first grade elsewhere.
   *
   * @param element the outermost element of a file
   */
  void checkNames(Element element, Diagnostics diagnostics, ImportLosses losses) {
    checkNames("", element, diagnostics, losses);
  }

  private void checkNames(
      String parent, Element element, Diagnostics diagnostics, ImportLosses losses) {
    Optional<Row> row = row(parent, element.name());
    if (row.isEmpty()) {
      unknown(
          MessageCode.UNKNOWN_ELEMENT,
          element,
          Phrase.of("<%s>", Quoted.plain(element.name())),
          NearestName.suggestion(element.name(), children.getOrDefault(parent, new TreeSet<>())),
          diagnostics,
          losses);
      return;
    }
    if (row.get().own.verdict != Verdict.READ) {
      return;
    }
    for (Attribute attribute : element.attributes()) {
      Collection<String> known = row.get().attributes.keySet();
      if (!known.contains(attribute.name())) {
        unknown(
            MessageCode.UNKNOWN_ATTRIBUTE,
            element,
            "attribute " + Quoted.plain(attribute.name()),
            NearestName.suggestion(attribute.name(), known),
            diagnostics,
            losses);
      }
    }
    element.children().forEach(child -> checkNames(element.name(), child, diagnostics, losses));
  }

  private void unknown(
      MessageCode code,
      Element element,
      String what,
      String suggestion,
      Diagnostics diagnostics,
      ImportLosses losses) {
    String said = what + " is not known in " + format.title() + suggestion;
    if (format == RobotFormat.MJCF) {
      diagnostics.error(
          code,
          element.position(),
          element.label() + ": " + said + (suggestion.isEmpty() ? "; leave it out" : ""));
    } else {
      losses.motion(element, said + " and is left out");
    }
  }

  /** Reports what the table says is left out; names that it lacks are reported elsewhere. */
  void reportLosses(Element element, ImportLosses losses) {
    reportLosses("", element, losses);
  }

  private void reportLosses(String parent, Element element, ImportLosses losses) {
    Optional<Row> found = row(parent, element.name());
    if (found.isEmpty()) {
      return;
    }
    Row row = found.get();
    row.own
        .gradeOf(element.text())
        .ifPresent(grade -> losses.add(grade, element, row.own.sentence("")));
    if (row.own.verdict != Verdict.READ) {
      return;
    }
    for (Attribute attribute : element.attributes()) {
      Optional.ofNullable(row.attributes.get(attribute.name()))
          .ifPresent(
              entry ->
                  entry
                      .gradeOf(attribute.value())
                      .ifPresent(
                          grade ->
                              losses.add(
                                  grade,
                                  element,
                                  entry.sentence(
                                      attribute.name()
                                          + " "
                                          + Quoted.of(attribute.value())
                                          + " is "))));
    }
    element.children().forEach(child -> reportLosses(element.name(), child, losses));
  }

  private Optional<Row> row(String parent, String name) {
    return Optional.ofNullable(rows.get(parent + "/" + name))
        .or(() -> Optional.ofNullable(rows.get(ANY + "/" + name)));
  }
}
