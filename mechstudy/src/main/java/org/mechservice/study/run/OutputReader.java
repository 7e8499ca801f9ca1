package org.mechservice.study.run;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import org.mechservice.mechml.diagnosis.NearestName;
import org.mechservice.mechml.document.Element;
import org.mechservice.mechml.unit.Unit;
import org.mechservice.study.PointModel;
import org.mechservice.study.Reduction;

/** Reads what is kept of each run of a study, and which outputs end it. */
final class OutputReader {
  private final StudyDocument document;

  OutputReader(StudyDocument document) {
    this.document = document;
  }

  /** Returns what is kept of each run, one for each output that can be read. */
  List<Reduction> reductions() {
    Element root = document.root();
    List<Element> outputs = root.children("output");
    List<Reduction> reductions = new ArrayList<>();
    if (outputs.isEmpty()) {
      document.error(root, "the study has no output; write such as <output of=\"max(height.a)\"/>");
    }
    for (Element output : outputs) {
      String text =
          document.required(output, "of", "a reduction of a column, such as max(height.a)");
      if (text.isEmpty()) {
        continue;
      }
      try {
        reductions.add(Reduction.parse(text));
      } catch (IllegalArgumentException e) {
        document.error(output, "of=\"" + text + "\": " + e.getMessage());
      }
    }
    return reductions;
  }

  /**
   * Returns the columns of the table.
   *
   * @param reductions one for each output
   */
  List<StudyOutput> columns(List<Reduction> reductions, PointModel points) {
    List<Element> outputs = document.root().children("output");
    List<StudyOutput> columns = new ArrayList<>();
    Set<String> taken = new HashSet<>();
    for (int i = 0; i < points.names().size(); i++) {
      Reduction origin = points.origins().get(i);
      Element element = outputs.get(reductions.indexOf(origin));
      String column = points.names().get(i);
      String name = named(element, origin, points.columns().get(i), column);
      if (!taken.add(name)) {
        document.error(element, "there are two outputs \"" + name + "\"; give one another name");
      }
      try {
        columns.add(column(element, name, column, points.units().get(i)));
      } catch (StudyRefusal e) {
        document.error(element, element.label() + ": " + e.getMessage());
      }
    }
    return columns;
  }

  /**
   * Returns the name of a value: as its output says, with the column for {@code *} and the time of
   * a series.
   *
   * @param column that is reduced
   * @param of what the value is of the run
   */
  private static String named(Element output, Reduction origin, String column, String of) {
    Optional<String> given = output.attribute("name").map(String::strip);
    if (given.isEmpty()) {
      return of;
    }
    String time = origin.kind() == Reduction.Kind.SERIES ? of.substring(column.length()) : "";
    return (origin.isOfAll() ? given.get().replace("*", column) : given.get()) + time;
  }

  private static StudyOutput column(Element element, String name, String of, String si)
      throws StudyRefusal {
    OptionalDouble failing =
        element.attribute("failing").isPresent()
            ? OptionalDouble.of(StudyValue.number(element, "failing"))
            : OptionalDouble.empty();
    Optional<String> wanted = element.attribute("unit").map(String::strip);
    if (wanted.isEmpty()) {
      return new StudyOutput(name, of, si, Unit.ONE, failing);
    }
    Unit scale = StudyValue.unit(wanted.get());
    if (!scale.dimension().equals(StudyValue.unit(si).dimension())) {
      throw new StudyRefusal(
          "unit \""
              + wanted.get()
              + "\" is one of "
              + scale.dimension()
              + "; "
              + of
              + " is in "
              + si);
    }
    return new StudyOutput(name, of, wanted.get(), scale, failing);
  }

  /** Returns when the study ends before its last point. */
  StopRule stop(List<StudyOutput> columns) {
    List<Element> given = document.root().children("stop");
    if (given.isEmpty()) {
      return StopRule.NONE;
    } else if (given.size() > 1) {
      document.error(
          given.get(1),
          "the study has two elements <stop>; write failures, output and error in one");
      return StopRule.NONE;
    }
    Element stop = given.get(0);
    try {
      int failures =
          stop.attribute("failures").isPresent() ? StudyValue.whole(stop, "failures", 1) : 0;
      if (stop.attribute("output").isEmpty() && stop.attribute("error").isEmpty()) {
        if (failures == 0) {
          throw new StudyRefusal(
              "it says nothing; write failures=\"10\", or output=\"NAME\" error=\"0.01\"");
        }
        return new StopRule(failures, -1, 0);
      }
      String name = document.required(stop, "output", "the output whose mean is to be known");
      List<String> names = columns.stream().map(StudyOutput::name).toList();
      if (!names.contains(name)) {
        throw new StudyRefusal(
            "there is no output \""
                + name
                + '"'
                + NearestName.suggestion(name, names)
                + "; there are "
                + String.join(", ", names));
      }
      double error = StudyValue.number(stop, "error");
      if (error <= 0) {
        throw new StudyRefusal("error is above 0");
      }
      return new StopRule(failures, names.indexOf(name), error);
    } catch (StudyRefusal e) {
      document.error(stop, "stop: " + e.getMessage());
      return StopRule.NONE;
    }
  }
}
